// What frames of the window cost, without a window: the cloth, the surroundings, the text over them and the panels,
// drawn by EGL without a display.
//   frames [--samples N] [--frames N] [--out DIR] [NAME...]
// Prints a table of milliseconds of processor time, of all threads together; asserts nothing. With --samples, frames
// are drawn with so many samples a pixel and averaged, as a window with multisampling would do. --out keeps a picture
// of each row. NAMEs choose rows.
#include <glad/gl.h>
#include <imgui.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gfx/contexts/offscreen.h"
#include "tyg/methods.h"
#include "ui/cloth_painter.h"
#include "ui/hud.h"
#include "ui/imgui_session.h"
#include "ui/panels/panels.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

using enum InputAction;

/// A kind of frame. To measure another look, add a row, and what it needs to prepare().
struct Row {
  const char* name;
  const char* scene;
  Extent size{1280, 720};
  std::vector<InputAction> actions{};  ///< done before the first frame: panels that are opened, things that are shown
  std::vector<InputAction> panels{};
  int side = 0;          ///< particles along each edge of a sheet that waits for its start; 0: the scene's own, moving
  bool turning = false;  ///< the camera moves
  Look look{};
};
const std::vector<Row>& rows() {
  static const Look kWoven{.show = Show::Surface, .weave = Weave::Plain};
  static const std::vector<Row> kRows{
      {"curtain, keys shown", "curtain"},
      {"curtain, keys hidden", "curtain", {1280, 720}, {ShowHelp}},
      {"curtain, two panels", "curtain", {1280, 720}, {}, {OpenControl, OpenEnergy}},
      {"curtain, 1920x1080", "curtain", {1920, 1080}},
      {"curtain, light", "curtain", {1280, 720}, {ChangeBackground}},
      {"curtain, the camera turns", "curtain", {1280, 720}, {}, {}, 0, true},
      {"ball, a floor and a body", "ball"},
      {"curtain, 64x64 particles", "curtain", {1280, 720}, {}, {}, 64},
      {"curtain, 256x256 particles", "curtain", {1280, 720}, {}, {}, 256},
      {"surface, 64x64 particles", "curtain", {1280, 720}, {}, {}, 64, false, {.show = Show::Surface}},
      {"woven surface, 64x64 particles", "curtain", {1280, 720}, {}, {}, 64, false, kWoven},
      {"woven surface, 256x256 particles", "curtain", {1280, 720}, {}, {}, 256, false, kWoven},
  };
  return kRows;
}

/// A screen that is not there.
class NoWindow final : public Window {
 public:
  explicit NoWindow(Extent size) : size_(size) {}
  std::span<const WindowEvent> events(double) override { return {}; }
  void swap() override { glFinish(); }
  void setTitle(const std::string&) override {}
  void toggleFullScreen() override {}
  [[nodiscard]] Extent framebuffer() const override { return size_; }
  [[nodiscard]] double contentScale() const override { return 1; }
  [[nodiscard]] bool closeRequested() const override { return false; }
  [[nodiscard]] Finder finder() const override { return nullptr; }
  void attachOverlay() override { ImGui::GetIO().DisplaySize = {float(size_.width), float(size_.height)}; }
  void beginOverlayFrame() override {
    ImGui::GetIO().DeltaTime = 1.0F / 60;
    ImGui::NewFrame();
  }
  void detachOverlay() override {}
  [[nodiscard]] bool overlayBehind() const override { return false; }

 private:
  Extent size_;
};

/// A framebuffer with several samples a pixel, or nothing.
class Samples {
 public:
  Samples(int samples, Extent size) : size_(size) {
    glGetIntegerv(GL_FRAMEBUFFER_BINDING, &window_);
    if (samples < 2) return;
    glGenFramebuffers(1, &framebuffer_);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
    attach(samples, GL_RGBA8, GL_COLOR_ATTACHMENT0);
    attach(samples, GL_DEPTH24_STENCIL8, GL_DEPTH_STENCIL_ATTACHMENT);
  }
  void average() const {
    if (framebuffer_ == 0) return;
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, GLuint(window_));
    glBlitFramebuffer(0, 0, size_.width, size_.height, 0, 0, size_.width, size_.height, GL_COLOR_BUFFER_BIT,
                      GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  }
  void bindAveraged() const { glBindFramebuffer(GL_FRAMEBUFFER, GLuint(window_)); }

 private:
  void attach(int samples, GLenum format, GLenum slot) const {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    glBindRenderbuffer(GL_RENDERBUFFER, name);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, size_.width, size_.height);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, slot, GL_RENDERBUFFER, name);
  }
  Extent size_;
  GLint window_ = 0;
  GLuint framebuffer_ = 0;
};

/// ms of processor time of all threads.
double processorTime() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}
double timeOf(const std::function<void()>& work) {
  const double before = processorTime();
  work();
  return processorTime() - before;
}
double medianOf(std::vector<double> numbers) {
  std::ranges::nth_element(numbers, numbers.begin() + std::ptrdiff_t(numbers.size() / 2));
  return numbers[numbers.size() / 2];
}

Scene sceneOf(const Row& row) {
  Scene scene = loadScene(row.scene, methodNames());
  if (row.look != Look{}) scene.look = row.look;
  return row.side > 0 ? withSheet(scene, row.side, row.side) : scene;
}

class Frames {
 public:
  Frames(const Row& row, int samples)
      : row_(row),
        offscreen_(makeOffscreen(OffscreenKind::Egl, row.size.width, row.size.height)),
        window_(row.size),
        samples_(samples, row.size),
        imgui_(window_, 1),
        viewer_(sceneOf(row), {.threads = 1}, [this] { return now_; }),
        painter_(viewer_),
        hud_(imgui_.fonts()),
        panels_(imgui_.fonts().size, viewer_) {
    for (const InputAction action : row.actions) viewer_.perform(action);
    for (const InputAction action : row.panels) panels_.toggle(action);
    if (row.side == 0) viewer_.perform(StartOrPause);
    if (row.turning) viewer_.handle({.kind = WindowEvent::Kind::Press, .key = kRightButton});
  }

  void simulate() {
    now_ += 1.0 / 60;
    const int keys = viewer_.view().showsHelp() ? hud_.keysWidth(row_.size) : 0;
    const auto at = [&](Edge edge) { return panels_.width(edge) > 0 ? int(panels_.width(edge)) : keys; };
    viewer_.resize(row_.size, {.left = at(Edge::Left), .right = at(Edge::Right), .beside = panels_.beside()});
    viewer_.frame();
    panels_.follow(viewer_);
    if (row_.turning) viewer_.handle({.kind = WindowEvent::Kind::Move, .x = 120 * now_});
  }
  void drawCloth() { painter_.draw(viewer_, panels_, row_.size); }
  void drawText() {
    imgui_.beginFrame();
    hud_.draw(viewer_, panels_);
    panels_.draw(viewer_);
    ImGuiSession::endFrame();
  }
  void show() {
    samples_.average();
    window_.swap();
  }
  [[nodiscard]] Picture picture() const {
    samples_.bindAveraged();
    return offscreen_->readPixels();
  }

 private:
  const Row& row_;
  double now_ = 0;  ///< s
  std::unique_ptr<Offscreen> offscreen_;
  NoWindow window_;
  Samples samples_;
  ImGuiSession imgui_;
  Viewer viewer_;
  ClothPainter painter_;
  Hud hud_;
  Panels panels_;
};

struct Options {
  int samples = 1, frames = 120;
  std::optional<std::string> pictures;
  std::vector<std::string> names;
};

void measure(const Row& row, const Options& options) {
  constexpr int kWarmUp = 30;
  Frames frames(row, options.samples);
  std::vector<double> simulating, cloth, whole;
  for (int k = -kWarmUp; k < options.frames; ++k) {
    const double simulated = timeOf([&] { frames.simulate(); });
    // Whole frames and frames of the cloth alone take turns.
    const bool withText = k % 2 == 0;
    const double drawn = timeOf([&] {
      frames.drawCloth();
      if (withText) frames.drawText();
      frames.show();
    });
    if (k < 0) continue;
    simulating.push_back(simulated);
    (withText ? whole : cloth).push_back(drawn);
  }
  const double all = medianOf(whole), ofCloth = medianOf(cloth);
  std::printf("| %s | %.1f | %.1f | %.1f | %.1f |\n", row.name, all, ofCloth, all - ofCloth, medianOf(simulating));
  std::fflush(stdout);
  if (options.pictures) {
    frames.drawCloth(), frames.drawText(), frames.show();
    writePng(frames.picture(), *options.pictures + "/" + row.name + ".png");
  }
}

int run(int count, char** arguments) {
  Options options;
  for (int k = 1; k < count; ++k) {
    const std::string argument = arguments[k];
    const bool more = k + 1 < count;
    if (argument == "--samples" && more) {
      options.samples = std::atoi(arguments[++k]);
    } else if (argument == "--frames" && more) {
      options.frames = std::max(2, std::atoi(arguments[++k]));
    } else if (argument == "--out" && more) {
      options.pictures = arguments[++k];
    } else {
      options.names.push_back(argument);
    }
  }
  std::printf("| ms of processor time a frame | drawn | of that cloth | text and panels | simulated besides |\n");
  std::printf("|---|---|---|---|---|\n");
  for (const Row& row : rows()) {
    const auto chosen = [&](const std::string& name) { return std::string(row.name).find(name) != std::string::npos; };
    if (options.names.empty() || std::ranges::any_of(options.names, chosen)) measure(row, options);
  }
  return 0;
}

}  // namespace
}  // namespace tyg

int main(int count, char** arguments) {
  try {
    return tyg::run(count, arguments);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "frames: %s\n", error.what());
    return 1;
  }
}
