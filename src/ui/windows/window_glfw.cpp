// The window by GLFW. Must not know: the cloth, what a key means.
#include <glad/gl.h>
// glad first: GLFW must not bring an OpenGL header of its own.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <array>
#include <utility>
#include <vector>

#include "ui/windows/window.h"

namespace tyg {
namespace {

constexpr int kSamples = 4;
constexpr std::size_t kEventsToExpect = 256;

std::string glfwComplaint() {
  const char* text = nullptr;
  return glfwGetError(&text) == GLFW_NO_ERROR || text == nullptr ? "no reason given" : text;
}

/// GLFW itself, for as long as a window needs it.
class Library {
 public:
  Library() {
    if (glfwInit() != GLFW_TRUE) throw NoDisplay("no display to open a window on (" + glfwComplaint() + ")");
  }
  ~Library() { glfwTerminate(); }
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
};

/// Letters follow the person's keyboard layout; digits, space, Tab and Escape are where they are on any.
KeyCode keyCode(int key, int scancode, bool shift) {
  if (key == GLFW_KEY_ESCAPE) return kEscapeKey;
  if (key == GLFW_KEY_TAB) return kTabKey;
  if (key >= GLFW_KEY_F1 && key < GLFW_KEY_F1 + kFunctionKeys) {
    return functionKey(key - GLFW_KEY_F1 + 1);
  }
  constexpr std::array kArrows{kRightKey, kLeftKey, kDownKey, kUpKey};  // GLFW's order
  if (key >= GLFW_KEY_RIGHT && key <= GLFW_KEY_UP) return kArrows[static_cast<std::size_t>(key - GLFW_KEY_RIGHT)];
  if (key == GLFW_KEY_ENTER || key == GLFW_KEY_KP_ENTER) return kEnterKey;
  if (key == GLFW_KEY_SPACE || (key >= GLFW_KEY_0 && key <= GLFW_KEY_9)) return static_cast<KeyCode>(key);
  const char* name = key == GLFW_KEY_UNKNOWN ? nullptr : glfwGetKeyName(key, scancode);
  if (name != nullptr && name[0] != 0 && name[1] == 0) {
    if (shift && name[0] == '/') return '?';
    return name[0] >= 'a' && name[0] <= 'z' ? static_cast<KeyCode>(name[0] - 'a' + 'A') : name[0];
  }
  return key > GLFW_KEY_SPACE && key <= GLFW_KEY_GRAVE_ACCENT ? static_cast<KeyCode>(key) : KeyCode{0};
}

KeyCode buttonCode(int button) {
  constexpr std::array kButtons{kLeftButton, kRightButton, kMiddleButton};  // GLFW's order
  return button >= 0 && button < 3 ? kButtons[static_cast<std::size_t>(button)] : KeyCode{0};
}

GLFWwindow* createWindow(const WindowOptions& options) {
  glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
  glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  for (const int samples : {kSamples, 0}) {  // some displays have no multisampling
    glfwWindowHint(GLFW_SAMPLES, samples);
    GLFWwindow* window =
        glfwCreateWindow(options.size.width, options.size.height, options.title.c_str(), nullptr, nullptr);
    if (window != nullptr) return window;
  }
  throw WindowError("this display gives no OpenGL 3.3 window (" + glfwComplaint() + ")");
}

class GlfwWindow final : public Window {
 public:
  explicit GlfwWindow(const WindowOptions& options) : window_(createWindow(options)) {
    events_.reserve(kEventsToExpect);
    glfwMakeContextCurrent(window_);
    if (gladLoadGL(glfwGetProcAddress) == 0) {
      glfwDestroyWindow(window_);
      throw WindowError("this display's OpenGL 3.3 functions cannot be loaded");
    }
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(window_, this);
    glfwGetCursorPos(window_, &cursor_.first, &cursor_.second);
    glfwSetKeyCallback(window_, onKey);
    glfwSetMouseButtonCallback(window_, onButton);
    glfwSetCursorPosCallback(window_, onMove);
    glfwSetScrollCallback(window_, onScroll);
    glfwSetWindowFocusCallback(window_, onFocus);
    glfwSetWindowRefreshCallback(window_, onExposed);
    glfwSetDropCallback(window_, onDrop);
  }
  ~GlfwWindow() override { glfwDestroyWindow(window_); }
  GlfwWindow(const GlfwWindow&) = delete;
  GlfwWindow& operator=(const GlfwWindow&) = delete;

  std::span<const WindowEvent> events(double seconds) override {
    events_.clear();
    glfwPollEvents();
    if (events_.empty() && seconds > 0) glfwWaitEventsTimeout(seconds);
    return events_;
  }
  void swap() override { glfwSwapBuffers(window_); }
  void setTitle(const std::string& title) override { glfwSetWindowTitle(window_, title.c_str()); }

  [[nodiscard]] Extent framebuffer() const override {
    Extent extent;
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != 0) return extent;
    glfwGetFramebufferSize(window_, &extent.width, &extent.height);
    return extent;
  }
  [[nodiscard]] double contentScale() const override {
    float x = 1, y = 1;
    glfwGetWindowContentScale(window_, &x, &y);
    return y > 0 ? y : 1;
  }
  [[nodiscard]] bool closeRequested() const override { return glfwWindowShouldClose(window_) != 0; }

  // ImGui puts its own callbacks before ours and calls ours too.
  void attachOverlay() override { ImGui_ImplGlfw_InitForOpenGL(window_, true); }
  void beginOverlayFrame() override {
    ImGui_ImplGlfw_NewFrame();
    ImGui::NewFrame();
  }
  void detachOverlay() override { ImGui_ImplGlfw_Shutdown(); }

 private:
  static GlfwWindow& of(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }

  /// GLFW counts in window units, which are more than a pixel on some screens.
  [[nodiscard]] WindowEvent at(WindowEvent::Kind kind, KeyCode key, double x, double y) const {
    int width = 0, height = 0;
    glfwGetWindowSize(window_, &width, &height);
    const Extent pixels = framebuffer();
    const double across = width > 0 ? double(pixels.width) / width : 1;
    const double down = height > 0 ? double(pixels.height) / height : 1;
    return {.kind = kind, .key = key, .x = x * across, .y = y * down};
  }

  static void onKey(GLFWwindow* window, int key, int scancode, int action, int modifiers) {
    if (action == GLFW_REPEAT) return;
    const auto kind = action == GLFW_PRESS ? WindowEvent::Kind::Press : WindowEvent::Kind::Release;
    const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    of(window).events_.push_back({.kind = kind,
                                  .key = keyCode(key, scancode, shift),
                                  .control = (modifiers & GLFW_MOD_CONTROL) != 0,
                                  .shift = shift});
  }
  static void onButton(GLFWwindow* window, int button, int action, int modifiers) {
    // Not glfwGetCursorPos, which tells where the cursor is now: a quick hand has dragged it on since.
    const auto [x, y] = of(window).cursor_;
    const auto kind = action == GLFW_PRESS ? WindowEvent::Kind::Press : WindowEvent::Kind::Release;
    WindowEvent event = of(window).at(kind, buttonCode(button), x, y);
    event.control = (modifiers & GLFW_MOD_CONTROL) != 0;
    event.shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    of(window).events_.push_back(event);
  }
  static void onMove(GLFWwindow* window, double x, double y) {
    of(window).cursor_ = {x, y};
    of(window).events_.push_back(of(window).at(WindowEvent::Kind::Move, 0, x, y));
  }
  static void onScroll(GLFWwindow* window, double, double notches) {
    of(window).events_.push_back({.kind = WindowEvent::Kind::Scroll, .key = kWheel, .notches = notches});
  }
  static void onFocus(GLFWwindow* window, int focused) {
    if (focused == 0) of(window).events_.push_back({.kind = WindowEvent::Kind::FocusLost});
  }
  static void onExposed(GLFWwindow* window) { of(window).events_.push_back({.kind = WindowEvent::Kind::Exposed}); }
  static void onDrop(GLFWwindow* window, int count, const char** paths) {
    if (count > 0) of(window).events_.push_back({.kind = WindowEvent::Kind::Drop, .path = paths[0]});
  }

  Library library_;
  GLFWwindow* window_;
  std::vector<WindowEvent> events_;
  std::pair<double, double> cursor_;  ///< GLFW's units, as the events so far say
};

}  // namespace

std::unique_ptr<Window> openGlfwWindow(const WindowOptions& options) { return std::make_unique<GlfwWindow>(options); }

}  // namespace tyg
