// A table of tiles, each one button with the picture and the words of a scene.
#include "ui/panels/gallery.h"

#include <imgui.h>

#include <algorithm>
#include <bit>
#include <cstdint>

#include "ui/panels/scene_pictures.h"
#include "util/wrapped.h"
#include "viewer/viewer.h"

namespace tyg {
namespace {

constexpr int kWidth = 480, kHeight = 300;  // pixels of a picture
constexpr float kTile = 10;                 // narrowest tile, in sizes of the text
constexpr double kWorkSeconds = 0.004;      // a frame, for pictures
constexpr float kSmall = 0.85F;             // of the text, for what a scene shows

/// Scenes that are meant to fail come in a group of their own.
bool isFailure(const ScenePictures::Entry& entry) { return entry.scene.name.starts_with("fail-"); }

/// A text below a picture, in as many lines as it takes.
class Caption {
 public:
  Caption(const std::string& text, float size, float width) : size_(size) {
    const auto widthOf = [size](std::string_view part) {
      return ImGui::GetFont()->CalcTextSizeA(size, 1e6F, 0, part.data(), part.data() + part.size()).x;
    };
    lines_ = wrapped(text, width, widthOf);
  }
  [[nodiscard]] float height() const { return ImGui::GetFont()->CalcTextSizeA(size_, 1e6F, 0, lines_.c_str()).y; }
  void draw(ImDrawList& list, ImVec2 at, Colour colour) const {
    list.AddText(ImGui::GetFont(), size_, at, colour, lines_.c_str());
  }

 private:
  float size_;
  std::string lines_;
};

class GalleryPanel final : public Panel {
 public:
  void follow(Viewer& viewer) override {
    pictures_.work(
        kWorkSeconds, [&viewer] { return viewer.run().now(); }, viewer.view().drawOptions().background);
  }
  [[nodiscard]] bool busy() const override { return !pictures_.finished(); }

  void draw(const PanelScope& scope) override {
    drawTiles(scope, false);
    if (std::ranges::none_of(pictures_.entries(), isFailure)) return;
    ImGui::Separator();
    ImGui::TextUnformatted("Failures");
    ImGui::SameLine();
    ImGui::TextDisabled("each breaks in its own way");
    drawTiles(scope, true);
  }

 private:
  void drawTiles(const PanelScope& scope, bool failures) {
    const float room = ImGui::GetContentRegionAvail().x;
    const int columns = std::max(1, static_cast<int>(room / (kTile * scope.size)));
    if (!ImGui::BeginTable(failures ? "failures" : "scenes", columns, ImGuiTableFlags_SizingStretchSame)) return;
    for (const ScenePictures::Entry& entry : pictures_.entries()) {
      if (isFailure(entry) != failures) continue;
      ImGui::TableNextColumn();
      drawTile(scope, entry);
    }
    ImGui::EndTable();
  }

  static void drawTile(const PanelScope& scope, const ScenePictures::Entry& entry) {
    const float width = ImGui::GetContentRegionAvail().x;
    const ImVec2 picture{width, width * kHeight / kWidth};
    const float line = ImGui::GetTextLineHeight();
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const Caption title(entry.scene.title, scope.size, width), shows(entry.scene.shows, kSmall * scope.size, width);
    const ImVec2 size{width, picture.y + title.height() + shows.height() + 0.6F * line};
    // The whole tile is the button; what it shows is drawn over it.
    const bool chosen = ImGui::InvisibleButton(entry.scene.name.c_str(), size);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const ImVec2 corner{at.x + width, at.y + picture.y};
    list.AddRectFilled(at, corner, scope.colours.field, 0.3F * scope.size);
    if (entry.picture) {
      // ImGui's OpenGL renderer takes the texture's name as a pointer.
      const auto texture = std::bit_cast<ImTextureID>(static_cast<std::uintptr_t>(entry.picture->name()));
      list.AddImageRounded(texture, at, corner, {0, 1}, {1, 0}, IM_COL32_WHITE, 0.3F * scope.size);
    } else {
      const char* said = entry.trouble.empty() ? "being drawn ..." : entry.trouble.c_str();
      list.AddText(ImGui::GetFont(), scope.size, {at.x + line, at.y + line}, scope.colours.dim, said, nullptr,
                   width - 2 * line);
    }
    const bool current = scope.viewer.scenes().scene().name == entry.scene.name;
    if (ImGui::IsItemHovered() || current) {
      list.AddRect(at, corner, faded(scope.colours.accent, current ? 1 : 0.6F), 0.3F * scope.size, 0, 2);
    }
    const float below = corner.y + 0.2F * line;
    title.draw(list, {at.x, below}, current ? scope.colours.accent : scope.colours.text);
    shows.draw(list, {at.x, below + title.height() + 0.05F * line}, scope.colours.dim);
    if (chosen) scope.viewer.scenes().use(entry.scene);
  }

  ScenePictures pictures_{kWidth, kHeight};
};

}  // namespace

std::unique_ptr<Panel> makeGalleryPanel() { return std::make_unique<GalleryPanel>(); }

}  // namespace tyg
