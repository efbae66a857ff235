// The viewer without its window: what each input does to the cloth and the camera, and what a frame shows.
// Must not know: window libraries, OpenGL, files. Time comes from the clock it is given.
#pragma once

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/input_table.h"
#include "app/view_log.h"
#include "app/window.h"
#include "gfx/sheet_renderer.h"
#include "tyg/simulation.h"
#include "view/camera.h"
#include "view/frame_clock.h"

namespace tyg {

/// Waiting: at time zero, never started. Frozen: the alarm went, or something was thrown; only a restart goes on.
enum class RunState { Waiting, Running, Paused, Frozen };
std::string_view nameOf(RunState state);

/// How the last half second went.
struct Pace {
  double framesPerSecond = 0;  ///< 0 before anything moved
  double simulating = 0;       ///< share of the frame spent simulating, 0..1
  double realTime = 1;         ///< simulated seconds per second
  bool behind = false;         ///< the machine did not keep up with real time
};

using StepText = std::array<char, 48>;
/// `step of 2 ms`, or `tolerance of 0.1 mm` for a method that chooses its own steps. Allocates nothing.
void describeStep(const Simulation& simulation, StepText& text);

class Viewer {
 public:
  using Clock = std::function<double()>;  ///< s, from any start

  /// Sets the scene up, waiting. Throws InputError where the scene does not fit together.
  Viewer(const Scene& scene, const Settings& settings, Clock clock);

  void handle(const WindowEvent& event);
  /// Size of the window. The first one that is not empty frames the cloth, as F does, leaving `margin` pixels free on
  /// the left and on the right (ignored where that would leave less than half the window).
  void resize(Extent pixels, int margin);
  /// Once a frame: moves the camera and the cloth to the present time.
  void frame();
  /// Freezes and shows the text: for what is thrown by those who draw and log.
  void freeze(std::string message);
  /// Shows the text until the next input.
  void note(std::string text) { note_ = std::move(text); }
  /// Called with the log of a run that has ended, at a restart.
  void onRunEnd(std::function<void(const PushLog&)> keep) { onRunEnd_ = std::move(keep); }

  [[nodiscard]] RunState state() const { return state_; }
  [[nodiscard]] bool leaving() const { return leaving_; }
  [[nodiscard]] bool idle() const;  ///< nothing moves until the next input
  [[nodiscard]] const Simulation& simulation() const { return simulation_; }
  [[nodiscard]] const Method& method() const { return *method_; }  ///< chosen; frozen: for the next run
  [[nodiscard]] const Camera& camera() const { return camera_; }
  [[nodiscard]] const DrawOptions& drawOptions() const { return draw_; }
  [[nodiscard]] bool showsHelp() const { return help_; }
  [[nodiscard]] const Pace& pace() const { return pace_; }
  [[nodiscard]] bool behind() const { return state_ == RunState::Running && pace_.behind; }
  [[nodiscard]] const std::string& message() const { return message_; }  ///< why it froze; empty else
  [[nodiscard]] const std::string& note() const { return note_; }
  /// x, y, z of the last good state, m, its time in s, and the box around it.
  [[nodiscard]] std::span<const float> positions() const { return positions_; }
  [[nodiscard]] double time() const { return time_; }
  [[nodiscard]] const Box& box() const { return box_; }
  /// The push to show: while it acts or is about to, and long enough to be seen.
  [[nodiscard]] std::optional<ShownPush> shownPush() const;

  /// The present frame for the log, without its number and wall time.
  [[nodiscard]] ViewLogLine logLine();
  /// The run so far: its ticks and hash filled in.
  [[nodiscard]] PushLog record() const;

 private:
  void press(const Input& input, const WindowEvent& event);
  void toggle(InputAction action);
  void startOrPause();
  void step();
  void restart();
  void choose(std::size_t place);
  void beginPush(glm::vec2 cursor);
  void keepPushing();
  void moveCursor(glm::vec2 cursor);
  void frameCloth();
  int run(int ticks, double seconds);
  void showState();
  void freezeOnAlarm();
  void measure(double frameSeconds, double simulatingSeconds);
  [[nodiscard]] bool held(InputAction action) const { return held_.at(static_cast<std::size_t>(action)); }
  [[nodiscard]] Motion motion() const;

  Scene scene_;
  Settings settings_;
  Clock clock_;
  const Method* method_;
  Simulation simulation_;
  FrameClock frameClock_;
  RunState state_ = RunState::Waiting;
  bool leaving_ = false;
  double lastFrame_ = 0;  ///< s, of the clock
  bool woken_ = false;    ///< this frame ends an idle time

  std::vector<float> positions_;
  double time_ = 0, kinetic_ = 0;
  Box box_;
  Pace pace_;
  double frameSeconds_ = 0, simulatingSeconds_ = 0;  ///< smoothed
  std::string message_, note_;
  std::function<void(const PushLog&)> onRunEnd_;

  Camera camera_;
  std::vector<glm::vec3> room_;  ///< to frame before anything moved
  Extent pixels_;
  int margin_ = 0;
  bool framed_ = false;
  glm::vec2 cursor_{0};
  std::array<bool, kInputActions> held_{};

  DrawOptions draw_;
  bool help_ = true;

  int picked_ = -1, pushes_ = 0;
  Vec3 force_;                ///< N, of the last push
  std::int64_t pushEnd_ = 0;  ///< tick
  double pushedAt_ = 0;       ///< s, of the clock
};

}  // namespace tyg
