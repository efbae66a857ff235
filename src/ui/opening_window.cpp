// What the person does while the cloth is set up waits in the window's queue, but for the first few frames.
#include "ui/opening_window.h"

#include <fmt/core.h>
#include <imgui.h>

#include "ui/overlay.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

/// A cloth of more particles takes seconds to set up.
constexpr int kSlow = 512 * 512;
/// Some screens show a window only after a few frames.
constexpr int kFramesToAppear = 4;

std::unique_ptr<Window> openWindow(const OpeningOptions& options, const std::string& title) {
  const WindowOptions wanted{.title = title, .size = options.size};
  return options.library == WindowLibrary::Glut ? openGlutWindow(wanted) : openGlfwWindow(wanted);
}

}  // namespace

std::string windowTitle(const Scene& scene) { return "Tyg: " + oneLine(scene.title); }

OpeningWindow::OpeningWindow(const OpeningOptions& options, const Scene& scene)
    : window_(openWindow(options, windowTitle(scene))), imgui_(*window_, options.uiScale) {
  if (scene.columns * scene.rows <= kSlow) return;
  announce(fmt::format("Preparing {} x {} particles. This may take a minute.", scene.columns, scene.rows));
}

void OpeningWindow::announce(const std::string& words) {
  for (int frame = 0; frame < kFramesToAppear; ++frame) {
    (void)window_->events(0);
    imgui_.beginFrame();
    const ImVec2 corner = ImGui::GetIO().DisplaySize;
    const TextFonts& fonts = imgui_.fonts();
    const TextWriter writer{ImGui::GetBackgroundDrawList(), fonts.text, fonts.size, Background::Light};
    writer.list->AddRectFilled({0, 0}, corner, IM_COL32_WHITE);
    const float wrap = 0.8F * corner.x;
    const ImVec2 extent = writer.extent(words, wrap);
    writer.write({0.5F * (corner.x - extent.x), 0.5F * (corner.y - extent.y)}, IM_COL32_BLACK, words, wrap);
    ImGuiSession::endFrame();
    window_->swap();
  }
}

}  // namespace tyg
