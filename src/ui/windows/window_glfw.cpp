// The window by GLFW. Must not know: the cloth, what a key means.
#include <glad/gl.h>
// glad first: GLFW must not bring an OpenGL header of its own.
#include <GLFW/glfw3.h>
#include <backends/imgui_impl_glfw.h>
#include <imgui.h>

#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "ui/windows/overlay_inputs.h"
#include "ui/windows/window.h"

namespace tyg {
namespace {

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

/// With 4.3 a card computes in the window's context. Some drivers give no later version than they are asked for.
GLFWwindow* createWindow(const WindowOptions& options) {
  glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
  glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
  for (const int major : {4, 3}) {
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, major);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
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
  void toggleFullScreen() override {
    if (glfwGetWindowMonitor(window_) != nullptr) {
      glfwSetWindowMonitor(window_, nullptr, before_.x, before_.y, before_.width, before_.height, GLFW_DONT_CARE);
      return;
    }
    GLFWmonitor* const monitor = monitorBelow();
    const GLFWvidmode* const mode = monitor == nullptr ? nullptr : glfwGetVideoMode(monitor);
    if (mode == nullptr) return;
    glfwGetWindowPos(window_, &before_.x, &before_.y);
    glfwGetWindowSize(window_, &before_.width, &before_.height);
    glfwSetWindowMonitor(window_, monitor, 0, 0, mode->width, mode->height, mode->refreshRate);
  }
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
  [[nodiscard]] Finder finder() const override { return glfwGetProcAddress; }

  // Where ImGui has a queue of its own, it puts its own callbacks before ours and calls ours too.
  void attachOverlay() override {
    ImGui_ImplGlfw_InitForOpenGL(window_, !OverlayInputs::needed());
    if (!OverlayInputs::needed()) return;
    glfwSetCharCallback(window_, onText);
    glfwSetCursorEnterCallback(window_, onEnter);
  }
  void beginOverlayFrame() override {
    ImGui_ImplGlfw_NewFrame();
    inputs_.give(ImGui::GetIO());
    ImGui::NewFrame();
  }
  void detachOverlay() override { ImGui_ImplGlfw_Shutdown(); }
  [[nodiscard]] bool overlayBehind() const override { return inputs_.waiting(); }

 private:
  static GlfwWindow& of(GLFWwindow* window) { return *static_cast<GlfwWindow*>(glfwGetWindowUserPointer(window)); }

  /// The monitor on which the middle of the window is, else the first one.
  [[nodiscard]] GLFWmonitor* monitorBelow() const {
    int x = 0, y = 0, width = 0, height = 0, count = 0;
    glfwGetWindowPos(window_, &x, &y);
    glfwGetWindowSize(window_, &width, &height);
    GLFWmonitor** const monitors = glfwGetMonitors(&count);
    for (int k = 0; k < count; ++k) {
      int left = 0, top = 0;
      glfwGetMonitorPos(monitors[k], &left, &top);
      const GLFWvidmode* const mode = glfwGetVideoMode(monitors[k]);
      const int across = x + width / 2 - left, down = y + height / 2 - top;
      if (mode != nullptr && across >= 0 && across < mode->width && down >= 0 && down < mode->height) {
        return monitors[k];
      }
    }
    return glfwGetPrimaryMonitor();
  }

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
    of(window).tellOverlay(key, action == GLFW_PRESS, modifiers);
    const auto kind = action == GLFW_PRESS ? WindowEvent::Kind::Press : WindowEvent::Kind::Release;
    const bool shift = (modifiers & GLFW_MOD_SHIFT) != 0;
    of(window).events_.push_back({.kind = kind,
                                  .key = keyCode(key, scancode, shift),
                                  .control = (modifiers & GLFW_MOD_CONTROL) != 0,
                                  .shift = shift});
  }
  static void onButton(GLFWwindow* window, int button, int action, int modifiers) {
    of(window).inputs_.button(button, action == GLFW_PRESS);
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
    of(window).inputs_.move(float(x), float(y));
    of(window).events_.push_back(of(window).at(WindowEvent::Kind::Move, 0, x, y));
  }
  static void onScroll(GLFWwindow* window, double, double notches) {
    of(window).inputs_.wheel(float(notches));
    of(window).events_.push_back({.kind = WindowEvent::Kind::Scroll, .key = kWheel, .notches = notches});
  }
  static void onText(GLFWwindow* window, unsigned character) { of(window).inputs_.text(character); }
  static void onEnter(GLFWwindow* window, int entered) {
    constexpr float kOutside = -std::numeric_limits<float>::max();
    if (entered == 0) of(window).inputs_.move(kOutside, kOutside);
  }
  /// GLFW's modifiers do not yet know of the key itself.
  void tellOverlay(int key, bool down, int modifiers) {
    const auto held = [&](int left, int right, int bit) {
      return key == left || key == right ? down : (modifiers & bit) != 0;
    };
    inputs_.key(key, down, key >= GLFW_KEY_ESCAPE,
                {.control = held(GLFW_KEY_LEFT_CONTROL, GLFW_KEY_RIGHT_CONTROL, GLFW_MOD_CONTROL),
                 .shift = held(GLFW_KEY_LEFT_SHIFT, GLFW_KEY_RIGHT_SHIFT, GLFW_MOD_SHIFT),
                 .alt = held(GLFW_KEY_LEFT_ALT, GLFW_KEY_RIGHT_ALT, GLFW_MOD_ALT)});
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
  struct {
    int x = 0, y = 0, width = 0, height = 0;
  } before_;  ///< full screen, in GLFW's units
  std::vector<WindowEvent> events_;
  std::pair<double, double> cursor_;  ///< GLFW's units, as the events so far say
  OverlayInputs inputs_;
};

}  // namespace

std::unique_ptr<Window> openGlfwWindow(const WindowOptions& options) { return std::make_unique<GlfwWindow>(options); }

}  // namespace tyg
