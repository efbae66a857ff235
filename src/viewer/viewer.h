// The viewer without its window: takes each input to the part that it is for, and takes all parts through each frame.
// Must not know: window libraries, OpenGL. Time comes from the clock it is given.
#pragma once

#include <optional>
#include <string>
#include <utility>

#include "viewer/held_keys.h"
#include "viewer/input_event.h"
#include "viewer/motion_review.h"
#include "viewer/pace_meter.h"
#include "viewer/run_control.h"
#include "viewer/scene_control.h"
#include "viewer/tools.h"
#include "viewer/view_control.h"
#include "viewer/view_log.h"

namespace tyg {

class Viewer final : private RunListener {
 public:
  using Clock = RunControl::Clock;

  /// Sets the scene up, waiting. Throws InputError where the scene does not fit together.
  Viewer(const Scene& scene, const Settings& settings, Clock clock);

  void handle(const WindowEvent& event);
  /// What the key of this action does, for buttons. Those that need a cursor or a number do nothing.
  void perform(InputAction action);
  /// Opens a file as one that is dropped onto the window: a scene, the log of a run, which is then played, or a motion
  /// of the scene that is open (.csv). Changes nothing and warns where it is none of these; then false.
  bool open(const std::string& path);
  /// A panel that has something new to show and is to be opened; told once.
  [[nodiscard]] std::optional<InputAction> takeWantedPanel() { return std::exchange(wantedPanel_, std::nullopt); }
  /// Size of the window, and what of it is not free for the cloth; see ViewControl::resize.
  void resize(Extent pixels, const Insets& insets);
  /// As the key does it that goes through lines, surface and both.
  void show(Show how) { view_.show(how); }
  /// Once a frame: moves the camera and the cloth to the present time.
  void frame();

  [[nodiscard]] RunControl& run() { return run_; }
  [[nodiscard]] const RunControl& run() const { return run_; }
  [[nodiscard]] SceneControl& scenes() { return scenes_; }
  [[nodiscard]] const SceneControl& scenes() const { return scenes_; }
  [[nodiscard]] const ViewControl& view() const { return view_; }
  [[nodiscard]] Tools& tools() { return tools_; }
  [[nodiscard]] const Tools& tools() const { return tools_; }
  [[nodiscard]] MotionReview& review() { return review_; }
  [[nodiscard]] Notes& notes() { return notes_; }
  [[nodiscard]] const Notes& notes() const { return notes_; }

  [[nodiscard]] bool leaving() const { return leaving_; }
  [[nodiscard]] bool idle() const;                                ///< nothing moves until the next input
  [[nodiscard]] bool keyHeld() const { return keys_.repeats(); }  ///< one that acts again and again
  [[nodiscard]] const Pace& pace() const { return pace_.pace(); }
  /// It runs, and this machine does not keep up with the wanted speed.
  [[nodiscard]] bool behind() const;
  /// The present frame for the log, without its number and wall time.
  [[nodiscard]] ViewLogLine logLine() const;

 private:
  std::int64_t beforeTicks(Simulation& simulation, std::int64_t due) override;
  [[nodiscard]] bool actsAt(std::int64_t tick) const override { return tools_.actsAt(tick); }
  void settingsReturned() override { scenes_.followSimulation(); }
  void runBegan() override;

  void dispatch(const WindowEvent& event);
  /// What dragging the left button does, by the keys that were down when it went down, and by what was below it.
  enum class LeftDrag { Tool, Beside, Orbit, Look, Approach };
  void press(const Input& input, const WindowEvent& event);
  void pressLeft(const WindowEvent& event);
  void releaseLeft();
  void release(KeyCode key);
  void moveCursor(glm::vec2 cursor);
  void act(InputAction action);
  void openFile(const std::string& path);
  void followCloth();

  Clock clock_;
  Notes notes_;
  RunControl run_;
  SceneControl scenes_;
  ViewControl view_;
  Tools tools_;
  MotionReview review_;
  std::optional<InputAction> wantedPanel_;
  HeldKeys keys_;
  PaceMeter pace_;
  std::vector<Body> bodies_;  ///< where they are at the shown time
  glm::vec2 cursor_{0};
  LeftDrag leftDrag_ = LeftDrag::Tool;
  glm::vec2 pressedAt_{0};    ///< pixels, where the left button went down
  glm::vec3 orbitsAbout_{0};  ///< m
  double pressedTime_ = 0;    ///< s, of the clock
  int sheet_ = 0;             ///< of scenes_.sheetsSoFar(), the one that the view and the tools are of
  double lastFrame_ = 0;      ///< s, of the clock
  bool woken_ = false;        ///< this frame ends an idle time
  bool leaving_ = false;
};

}  // namespace tyg
