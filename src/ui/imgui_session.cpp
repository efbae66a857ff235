// The order of ImGui's own examples: context, fonts, window backend, OpenGL backend, and back in the same way.
#include "ui/imgui_session.h"

#include <backends/imgui_impl_opengl3.h>
#include <imgui.h>

namespace tyg {
namespace {

constexpr float kTextPixels = 18;

}  // namespace

ImGuiSession::ImGuiSession(Window& window, double uiScale)
    : window_(window), scale_(static_cast<float>(uiScale * window.contentScale())) {
  IMGUI_CHECKVERSION();
  ImGui::CreateContext();
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  fonts_.size = kTextPixels * scale_;
  fonts_.text = addFont(*io.Fonts, fonts_.size);
  fonts_.large = addFont(*io.Fonts, fonts_.size * kLargeRatio);
  io.Fonts->Build();  // texts are measured before the first frame
  window_.attachOverlay();
  ImGui_ImplOpenGL3_Init("#version 330 core");
}

ImGuiSession::~ImGuiSession() {
  ImGui_ImplOpenGL3_Shutdown();
  window_.detachOverlay();
  ImGui::DestroyContext();
}

void ImGuiSession::beginFrame() {
  ImGui_ImplOpenGL3_NewFrame();
  window_.beginOverlayFrame();
}

void ImGuiSession::endFrame() {
  ImGui::Render();
  ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

bool imGuiTakes(const WindowEvent& event) {
  const ImGuiIO& io = ImGui::GetIO();
  switch (event.kind) {
    case WindowEvent::Kind::Press:
      return !isMouse(event.key) && io.WantCaptureKeyboard;
    case WindowEvent::Kind::Scroll:
      return io.WantCaptureMouse;
    default:
      return false;
  }
}

}  // namespace tyg
