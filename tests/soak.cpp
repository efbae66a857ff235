// Hours of random input to the viewer and its panels, without a window: keys, clicks, drags, wheel, resizes, scenes.
//   soak [HOURS [SEED]]      default 2 hours; meant for a build with the address sanitizer
// Time is the viewer's own: frames follow each other without waiting, and what a frame may take of a second it takes of
// a twentieth of one. Ends with exit code 1 where a position is not finite, a restarted cloth does not move, or memory
// keeps growing. Must not know: how panels are drawn; ImGui draws into nothing.
#include <imgui.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>

#include "tyg/methods.h"
#include "ui/frame_capture.h"
#include "ui/hud.h"
#include "ui/input_router.h"
#include "ui/panels/panels.h"
#include "view/picking.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr double kFrame = 1.0 / 60, kHurry = 20;
constexpr long kFramesPerTelling = 36000;  // ten minutes of the viewer's time
constexpr int kFramesPerScene = 3000, kFramesToMove = 60;
/// Of the largest memory in the first half of a run, that the second half may have more, and MB besides: the last ten
/// seconds of a large sheet take up to 128 MB, and the address sanitizer keeps 256 MB of what was freed.
constexpr double kGrowth = 1.25, kSlackMegabytes = 400;

class Soak {
 public:
  explicit Soak(unsigned seed) : random_(seed), viewer_(loadScene("curtain", methodNames()), {.threads = 1}, clock()) {
    ImGui::CreateContext();
    ImGui::GetIO().IniFilename = nullptr;
    unsigned char* pixels = nullptr;
    int width = 0, height = 0;
    ImGui::GetIO().Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    panels_ = std::make_unique<Panels>(18.0F, viewer_);
    const TextFonts fonts{ImGui::GetIO().Fonts->Fonts[0], ImGui::GetIO().Fonts->Fonts[0], 18};
    hud_ = std::make_unique<Hud>(fonts);
    router_ = windowRouter(*panels_, *hud_, capture_, viewer_);
    viewer_.resize(size_, insets());
  }
  ~Soak() {
    panels_.reset();
    ImGui::DestroyContext();
  }
  Soak(const Soak&) = delete;
  Soak& operator=(const Soak&) = delete;

  /// Empty, or what was wrong.
  std::string run(long frames) {
    double before = 0, after = 0;  // MB, the most in each half
    for (long k = 0; k < frames; ++k) {
      if (k % kFramesPerScene == 0) {
        if (std::string trouble = begin(); !trouble.empty()) return trouble;
      }
      if (chance(0.5)) randomInput();
      frame();
      for (const float number : viewer_.run().shown().positions()) {
        if (!std::isfinite(number)) return "a shown position is not finite in frame " + std::to_string(k);
      }
      if (!trouble_.empty()) return trouble_;
      if (k % 600 == 0) (k < frames / 2 ? before : after) = std::max(k < frames / 2 ? before : after, megabytes());
      if (k % kFramesPerTelling == 0 && k > 0) tell(k);
    }
    std::printf(
        "%ld frames, %.0f s of the viewer's time, %ld inputs, %d pushes, grabs, pins and cuts, %ld replays, %ld "
        "freezes; memory at "
        "most %.0f MB, then %.0f MB\n",
        frames, double(frames) * kFrame, inputs_, viewer_.tools().record().uses, replays_, freezes_, before, after);
    return after > kGrowth * before + kSlackMegabytes ? "memory keeps growing" : "";
  }

 private:
  static double real() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  }
  Viewer::Clock clock() {
    return [this] { return frameTime_ + kHurry * (real() - frameStart_); };
  }
  static double megabytes() {
    std::ifstream in("/proc/self/statm");
    double pages = 0, resident = 0;
    in >> pages >> resident;
    return resident * double(sysconf(_SC_PAGESIZE)) / 1e6;
  }
  void tell(long frames) const {
    std::fprintf(stderr, "soak: %.0f minutes of the viewer's time, %ld inputs, %.0f MB, %s\n",
                 double(frames) * kFrame / 60, inputs_, megabytes(), viewer_.scenes().scene().name.c_str());
  }
  bool chance(double share) { return std::uniform_real_distribution<double>(0, 1)(random_) < share; }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }

  [[nodiscard]] Insets insets() const {
    return {.left = int(panels_->width(Edge::Left)),
            .right = int(panels_->width(Edge::Right)),
            .beside = panels_->beside()};
  }

  void frame() {
    frameTime_ = std::max(frameTime_ + kFrame, frameTime_ + kHurry * (real() - frameStart_));
    frameStart_ = real();
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {float(size_.width), float(size_.height)};
    io.DeltaTime = float(kFrame);
    viewer_.resize(size_, insets());
    viewer_.frame();
    panels_->follow(viewer_);
    ImGui::NewFrame();
    hud_->draw(viewer_, *panels_);
    panels_->draw(viewer_);
    ImGui::Render();
    freezes_ += viewer_.run().state() == RunState::Frozen && !frozen_ ? 1 : 0;
    frozen_ = viewer_.run().state() == RunState::Frozen;
  }

  /// Another scene, started: it must move, or break as scenes that are meant to do.
  std::string begin() {
    const auto scenes = builtinScenes();
    Scene scene = loadScene(std::string(scenes[std::size_t(below(int(scenes.size())))].name), methodNames());
    if (chance(0.3)) scene.columns = std::max(1, scene.columns / 2);
    if (scene != viewer_.scenes().scene()) viewer_.scenes().use(scene);
    key('R'), frame();
    key(' ');
    for (double k = 0; k * viewer_.run().frameClock().speed() < kFramesToMove; ++k) frame();
    if (viewer_.run().state() == RunState::Running && !(viewer_.run().shown().time() > 0))
      return scene.name + " does not move";
    return {};
  }

  void send(const WindowEvent& event) { (void)router_.route(event); }
  void key(KeyCode code) {
    send({.kind = WindowEvent::Kind::Press, .key = code, .control = chance(0.1), .shift = chance(0.1)});
    send({.kind = WindowEvent::Kind::Release, .key = code});
  }

  void randomInput() {
    ++inputs_;
    switch (below(10)) {
      case 8:
      case 9:
        return useTool();
      case 0:
      case 1:
      case 2: {
        const Input& input = inputTable()[std::size_t(below(int(inputTable().size())))];
        if (isMouse(input.key) || input.action == InputAction::Leave) return;
        return key(input.key);
      }
      case 3:
        return mouse(kLeftButton);
      case 4:
        return mouse(kRightButton);
      case 5:
        return send({.kind = WindowEvent::Kind::Scroll, .notches = double(below(7) - 3)});
      case 6:
        if (chance(0.05)) size_ = {below(1900), below(1060)};  // nothing at all now and then, as when minimised
        if (chance(0.05)) send({.kind = WindowEvent::Kind::FocusLost});
        return;
      default:
        if (chance(0.2))
          viewer_.run().turnToTime(viewer_.run().timeline().first + chance(0.5) * (viewer_.run().shown().time() / 2));
        return;
    }
  }

  /// One of the tools, on the cloth or across it: from one particle to another, and for a while.
  void useTool() {
    if (size_.width <= 0 || size_.height <= 0) return;
    key(functionKey(2 + below(int(toolTable().size()))));
    const glm::vec2 from = somewhereOnTheCloth(), to = somewhereOnTheCloth();
    send({.kind = WindowEvent::Kind::Press, .key = kLeftButton, .x = from.x, .y = from.y});
    const int steps = 1 + below(8);
    for (int k = 1; k <= steps; ++k) {
      const glm::vec2 at = glm::mix(from, to, float(k) / float(steps));
      send({.kind = WindowEvent::Kind::Move, .x = at.x, .y = at.y});
      if (chance(0.2)) send({.kind = WindowEvent::Kind::Scroll, .notches = double(below(7) - 3)});
      frame();
    }
    send({.kind = WindowEvent::Kind::Release, .key = kLeftButton, .x = to.x, .y = to.y});
    if (chance(0.3)) send({.kind = WindowEvent::Kind::Press, .key = 'Z', .control = true, .shift = chance(0.3)});
    if (chance(0.02)) checkReplay();
  }
  [[nodiscard]] glm::vec2 somewhereOnTheCloth() {
    const std::span<const float> xyz = viewer_.run().shown().positions();
    const float* p = &xyz[3 * std::size_t(below(int(xyz.size() / 3)))];
    const glm::vec2 place = placeInWindow(viewer_.view().camera(), {p[0], p[1], p[2]}, {size_.width, size_.height});
    return std::isfinite(place.x + place.y) ? place : glm::vec2(0);  // it may be beside the eye
  }
  /// The run so far must come to the same bits again.
  void checkReplay() {
    const EventLog log = viewer_.run().record();
    if (viewer_.run().state() == RunState::Frozen || log.ticks > 20000) return;
    Simulation again(viewer_.run().simulation().startScene(), findMethod(log.integrator),
                     {.threads = 1, .keepGoing = true});
    again.replay(log, methods());
    again.tick(log.ticks);
    if (hashText(again) != log.hash) trouble_ = "a record does not replay to the same bits";
    ++replays_;
  }

  /// A click, or a drag over some frames.
  void mouse(KeyCode button) {
    ImGuiIO& io = ImGui::GetIO();
    double x = below(std::max(1, size_.width)), y = below(std::max(1, size_.height));
    io.MousePos = {float(x), float(y)};
    frame();
    io.MouseDown[button == kLeftButton ? 0 : 1] = true;
    send({.kind = WindowEvent::Kind::Press, .key = button, .x = x, .y = y});
    for (int k = below(6); k > 0; --k) {
      x += below(81) - 40, y += below(81) - 40;
      io.MousePos = {float(x), float(y)};
      send({.kind = WindowEvent::Kind::Move, .x = x, .y = y});
      frame();
    }
    io.MouseDown[button == kLeftButton ? 0 : 1] = false;
    send({.kind = WindowEvent::Kind::Release, .key = button, .x = x, .y = y});
  }

  std::mt19937 random_;
  double frameTime_ = 0, frameStart_ = real();
  Viewer viewer_;
  std::unique_ptr<Panels> panels_;
  std::unique_ptr<Hud> hud_;
  FrameCapture capture_{std::filesystem::temp_directory_path()};  ///< writes nothing: no frame is read back
  InputRouter router_;
  Extent size_{1280, 720};
  std::string trouble_;
  long inputs_ = 0, freezes_ = 0, replays_ = 0;
  bool frozen_ = false;
};

}  // namespace
}  // namespace tyg

int main(int count, char** words) {
  const double hours = count > 1 ? std::atof(words[1]) : 2;
  const unsigned seed = count > 2 ? unsigned(std::atoi(words[2])) : 1;
  tyg::Soak soak(seed);
  const std::string trouble = soak.run(std::lround(hours * 3600 / tyg::kFrame));
  if (trouble.empty()) return 0;
  std::fprintf(stderr, "soak: %s (seed %u)\n", trouble.c_str(), seed);
  return 1;
}
