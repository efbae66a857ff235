// The window by freeglut. It calls back without a place for our data, ends the process where it meets trouble, and
// says nothing of lost focus: GlutSystem asks first, and watches the focus.
// Must not know: the cloth, what a key means.
#include <glad/gl.h>
// glad first: freeglut must not bring an OpenGL header of its own.
#include <GL/freeglut.h>
#include <backends/imgui_impl_glut.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>
#include <vector>

#include "ui/windows/glut_system.h"
#include "ui/windows/overlay_inputs.h"
#include "ui/windows/window.h"

namespace tyg {
namespace {

constexpr std::size_t kEventsToExpect = 256;
/// Of keys, as ImGui's part for GLUT counts them.
constexpr int kDelete = 127, kSpecial = 256;
/// Between looks at the focus while a key is down.
constexpr std::chrono::milliseconds kNap{5};

/// Nothing may be thrown through freeglut's C frames, and it cannot go on: this is where it ends.
[[noreturn]] void endHere(const char* reason) {
  std::fprintf(stderr,
               "tyg view: this display gives no OpenGL 3.3 window (freeglut: %s); tyg render draws without one\n",
               reason);
  std::_Exit(1);
}
void onGlutError(const char* format, va_list arguments) {
  std::array<char, 512> text{};
  std::vsnprintf(text.data(), text.size(), format, arguments);
  endHere(text.data());
}

class GlutWindow;
GlutWindow* theWindow = nullptr;

class GlutWindow final : public Window {
 public:
  explicit GlutWindow(const WindowOptions& options) : system_(endHere) {
    if (theWindow != nullptr) throw WindowError("only one window at a time");
    events_.reserve(kEventsToExpect);
    open(options);
    theWindow = this;
    setCallbacks();
  }
  ~GlutWindow() override {
    theWindow = nullptr;
    if (!closed_) glutDestroyWindow(window_);
    glutExit();
  }
  GlutWindow(const GlutWindow&) = delete;
  GlutWindow& operator=(const GlutWindow&) = delete;

  std::span<const WindowEvent> events(double seconds) override {
    using Clock = std::chrono::steady_clock;
    const auto deadline = Clock::now() + std::chrono::duration<double>(seconds);
    events_.clear();
    for (;;) {
      glutMainLoopEvent();
      if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
      watchFocus();
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(deadline - Clock::now());
      if (closed_ || !events_.empty() || left.count() <= 0) return events_;
      GlutSystem::wait(keysDown_ > 0 ? std::min(kNap, left) : left);
    }
  }
  void swap() override {
    if (!closed_) glutSwapBuffers();
  }
  void toggleFullScreen() override {
    if (!closed_) glutFullScreenToggle();
  }
  void setTitle(const std::string& title) override {
    if (!closed_) glutSetWindowTitle(title.c_str());
  }
  [[nodiscard]] Extent framebuffer() const override {
    if (closed_ || hidden_) return {};
    return {.width = glutGet(GLUT_WINDOW_WIDTH), .height = glutGet(GLUT_WINDOW_HEIGHT)};
  }
  [[nodiscard]] double contentScale() const override { return 1; }
  [[nodiscard]] bool closeRequested() const override { return closed_; }
  [[nodiscard]] Finder finder() const override { return GlutSystem::find; }
  void beforeContextEnds(std::function<void()> work) override { beforeContextEnds_ = std::move(work); }

  void attachOverlay() override {
    ImGui_ImplGLUT_Init();
    const Extent size = framebuffer();
    ImGui_ImplGLUT_ReshapeFunc(size.width, size.height);
    overlay_ = true;
  }
  void beginOverlayFrame() override {
    inputs_.give(ImGui::GetIO());
    ImGui_ImplGLUT_NewFrame();
    if constexpr (IMGUI_VERSION_NUM >= 18960) ImGui::NewFrame();  // older ones start the frame in the line above
  }
  void detachOverlay() override {
    overlay_ = false;
    ImGui_ImplGLUT_Shutdown();
  }
  [[nodiscard]] bool overlayBehind() const override { return inputs_.waiting(); }

 private:
  void open(const WindowOptions& options) {
    int count = 1;
    std::array<char, 4> name{"tyg"};
    std::array<char*, 2> arguments{name.data(), nullptr};
    glutInitErrorFunc(onGlutError);
    glutInit(&count, arguments.data());
    glutSetOption(GLUT_ACTION_ON_WINDOW_CLOSE, GLUT_ACTION_CONTINUE_EXECUTION);
    glutInitContextVersion(3, 3);
    glutInitContextProfile(GLUT_CORE_PROFILE);
    glutInitDisplayMode(GLUT_RGBA | GLUT_DOUBLE | GLUT_DEPTH);
    glutInitWindowSize(options.size.width, options.size.height);
    window_ = glutCreateWindow(options.title.c_str());
    system_.opened();
    if (gladLoadGL(GlutSystem::find) == 0) throw WindowError("this display's OpenGL 3.3 functions cannot be loaded");
  }

  static void setCallbacks() {
    glutIgnoreKeyRepeat(1);
    glutDisplayFunc([] { theWindow->events_.push_back({.kind = WindowEvent::Kind::Exposed}); });
    glutReshapeFunc([](int width, int height) {
      if (theWindow->overlay_) ImGui_ImplGLUT_ReshapeFunc(width, height);
    });
    glutWindowStatusFunc([](int status) { theWindow->hidden_ = status == GLUT_HIDDEN; });
    glutCloseFunc([] {
      if (theWindow != nullptr) theWindow->close();
    });
    glutKeyboardFunc([](unsigned char key, int x, int y) {
      theWindow->tellOverlay(key, true, [&] { ImGui_ImplGLUT_KeyboardFunc(key, x, y); });
      theWindow->key(WindowEvent::Kind::Press, key);
    });
    glutKeyboardUpFunc([](unsigned char key, int x, int y) {
      theWindow->tellOverlay(key, false, [&] { ImGui_ImplGLUT_KeyboardUpFunc(key, x, y); });
      theWindow->key(WindowEvent::Kind::Release, key);
    });
    glutSpecialFunc([](int key, int x, int y) {
      theWindow->tellOverlay(kSpecial + key, true, [&] { ImGui_ImplGLUT_SpecialFunc(key, x, y); });
      theWindow->specialKey(WindowEvent::Kind::Press, key);
    });
    glutSpecialUpFunc([](int key, int x, int y) {
      theWindow->tellOverlay(kSpecial + key, false, [&] { ImGui_ImplGLUT_SpecialUpFunc(key, x, y); });
      theWindow->specialKey(WindowEvent::Kind::Release, key);
    });
    glutMouseFunc([](int button, int state, int x, int y) { theWindow->button(button, state, x, y); });
    glutMouseWheelFunc([](int wheel, int direction, int x, int y) {
      theWindow->inputs_.wheel(float(direction));
      if (theWindow->overlay_ && !OverlayInputs::needed()) ImGui_ImplGLUT_MouseWheelFunc(wheel, direction, x, y);
      theWindow->events_.push_back({.kind = WindowEvent::Kind::Scroll, .key = kWheel, .notches = double(direction)});
    });
    glutMotionFunc(onMove);
    glutPassiveMotionFunc(onMove);
  }

  void close() {
    closed_ = true;
    try {
      if (beforeContextEnds_) beforeContextEnds_();
    } catch (...) {
      failure_ = std::current_exception();
    }
  }
  static void onMove(int x, int y) {
    theWindow->inputs_.move(float(x), float(y));
    if (theWindow->overlay_ && !OverlayInputs::needed()) ImGui_ImplGLUT_MotionFunc(x, y);
    theWindow->events_.push_back({.kind = WindowEvent::Kind::Move, .x = double(x), .y = double(y)});
  }
  void button(int button, int state, int x, int y) {
    constexpr std::array kButtons{kLeftButton, kMiddleButton, kRightButton};  // freeglut's order
    if (overlay_ && !OverlayInputs::needed()) ImGui_ImplGLUT_MouseFunc(button, state, x, y);
    if (button < 0 || button > 2) return;
    constexpr std::array kImGuiButtons{0, 2, 1};
    inputs_.move(float(x), float(y));
    inputs_.button(kImGuiButtons[static_cast<std::size_t>(button)], state == GLUT_DOWN);
    const auto kind = state == GLUT_DOWN ? WindowEvent::Kind::Press : WindowEvent::Kind::Release;
    const KeyCode code = kButtons[static_cast<std::size_t>(button)];
    const int modifiers = glutGetModifiers();
    events_.push_back({.kind = kind,
                       .key = code,
                       .x = double(x),
                       .y = double(y),
                       .control = (modifiers & GLUT_ACTIVE_CTRL) != 0,
                       .shift = (modifiers & GLUT_ACTIVE_SHIFT) != 0});
  }
  /// `direct` tells ImGui itself, where it has a queue. Codes are those of ImGui's part for GLUT.
  template <class Direct>
  void tellOverlay(int code, bool down, const Direct& direct) {
    if (!overlay_ || !OverlayInputs::needed()) return overlay_ ? direct() : void();
    const int modifiers = glutGetModifiers();
    const OverlayInputs::Modifiers held{.control = (modifiers & GLUT_ACTIVE_CTRL) != 0,
                                        .shift = (modifiers & GLUT_ACTIVE_SHIFT) != 0,
                                        .alt = (modifiers & GLUT_ACTIVE_ALT) != 0};
    const bool writes = code >= ' ' && code < kDelete;
    if (code >= 'a' && code <= 'z') {
      inputs_.key(code - 'a' + 'A', down, false, held);
    } else if (held.control && code >= 1 && code <= 26) {  // control and Z come as the 26th character
      inputs_.key(code - 1 + 'A', down, true, held);
    } else {
      inputs_.key(code, down, !writes, held);
    }
    if (down && (writes || (code > kDelete && code < kSpecial))) inputs_.text(static_cast<unsigned>(code));
  }
  void specialKey(WindowEvent::Kind kind, int key) {
    constexpr std::array kArrows{kLeftKey, kUpKey, kRightKey, kDownKey};  // freeglut's order
    KeyCode code = 0;
    if (key >= GLUT_KEY_F1 && key < GLUT_KEY_F1 + kFunctionKeys) code = functionKey(key - GLUT_KEY_F1 + 1);
    if (key >= GLUT_KEY_LEFT && key <= GLUT_KEY_DOWN) code = kArrows[static_cast<std::size_t>(key - GLUT_KEY_LEFT)];
    if (code == 0) return;
    count(kind);
    events_.push_back({.kind = kind, .key = code});
  }
  /// While any key is down the focus is watched.
  void count(WindowEvent::Kind kind) {
    keysDown_ = std::max(0, keysDown_ + (kind == WindowEvent::Kind::Press ? 1 : -1));
    if (keysDown_ == 1 && kind == WindowEvent::Kind::Press) focus_ = system_.focus();
  }
  void key(WindowEvent::Kind kind, unsigned char character) {
    const int modifiers = glutGetModifiers();
    const bool control = (modifiers & GLUT_ACTIVE_CTRL) != 0;
    // freeglut gives control and Z as the 26th character.
    if (control && character >= 1 && character <= 26) character = static_cast<unsigned char>(character + '@');
    const bool lower = character >= 'a' && character <= 'z';
    const auto code = static_cast<KeyCode>(lower ? character - 'a' + 'A' : character);
    // Control characters below space would read as mouse buttons.
    if (character < ' ' && code != kEscapeKey && code != kEnterKey && code != kTabKey) return;
    count(kind);
    events_.push_back({.kind = kind, .key = code, .control = control, .shift = (modifiers & GLUT_ACTIVE_SHIFT) != 0});
  }

  /// While a key is down, the focus must stay where it was when the key went down.
  void watchFocus() {
    if (keysDown_ == 0 || system_.focus() == focus_) return;
    keysDown_ = 0;
    events_.push_back({.kind = WindowEvent::Kind::FocusLost});
  }

  GlutSystem system_;
  int window_ = 0;
  std::function<void()> beforeContextEnds_;
  std::exception_ptr failure_;  // of that
  std::vector<WindowEvent> events_;
  OverlayInputs inputs_;
  std::uintptr_t focus_ = 0;
  int keysDown_ = 0;
  bool closed_ = false, hidden_ = false, overlay_ = false;
};

}  // namespace

std::unique_ptr<Window> openGlutWindow(const WindowOptions& options) { return std::make_unique<GlutWindow>(options); }

}  // namespace tyg
