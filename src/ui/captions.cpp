// Letters copied from ImGui's font atlas, pixel by pixel.
#include "ui/captions.h"

#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "ui/fonts.h"
#include "util/utf8.h"

namespace tyg {
namespace {

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kInk{0x10, 0x14, 0x18};

class LegendWriter {
 public:
  explicit LegendWriter(Picture& picture)
      : picture_(picture), size_(std::max(14.0F, std::round(float(picture.height) / 36))) {
    font_ = addFont(atlas_, size_, true);
    atlas_.GetTexDataAsAlpha8(&alpha_, &alphaWidth_, &alphaHeight_);
    size_ = font_->FontSize;
  }

  [[nodiscard]] float size() const { return size_; }

  void stroke(float x, float y, float length, const Rgb& colour) {
    const float thick = size_ / 4;
    for (float row = 0; row < thick; ++row) {
      for (float column = 0; column < length; ++column) blend(int(x + column), int(y + row), colour, 255);
    }
  }

  void text(float x, float y, const std::string& text) {
    for (std::string_view left = text; !left.empty();) {
      const Utf8Character letter = firstCharacter(left);
      left.remove_prefix(letter.length);
      const ImFontGlyph* glyph = font_->FindGlyph(static_cast<ImWchar>(letter.code));
      if (glyph == nullptr) continue;
      if (glyph->Visible != 0) draw(*glyph, x, y);
      x += glyph->AdvanceX;
    }
  }

 private:
  void draw(const ImFontGlyph& glyph, float x, float y) {
    const int left = int(std::lround(x + glyph.X0)), top = int(std::lround(y + glyph.Y0));
    const int fromX = int(std::lround(glyph.U0 * float(alphaWidth_)));
    const int fromY = int(std::lround(glyph.V0 * float(alphaHeight_)));
    const int width = int(std::lround(glyph.U1 * float(alphaWidth_))) - fromX;
    const int height = int(std::lround(glyph.V1 * float(alphaHeight_))) - fromY;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        blend(left + column, top + row, kInk, alpha_[(fromY + row) * alphaWidth_ + fromX + column]);
      }
    }
  }

  void blend(int x, int y, const Rgb& colour, int alpha) {
    if (x < 0 || y < 0 || x >= picture_.width || y >= picture_.height) return;
    auto* pixel = &picture_.rgba[4 * (std::size_t(y) * std::size_t(picture_.width) + std::size_t(x))];
    for (std::size_t k = 0; k < colour.size(); ++k) {
      pixel[k] = static_cast<std::uint8_t>((pixel[k] * (255 - alpha) + colour.at(k) * alpha + 127) / 255);
    }
  }

  Picture& picture_;
  float size_;
  ImFontAtlas atlas_;
  ImFont* font_ = nullptr;
  unsigned char* alpha_ = nullptr;
  int alphaWidth_ = 0, alphaHeight_ = 0;
};

}  // namespace

void writeLegend(Picture& picture, const std::vector<Caption>& lines) {
  LegendWriter writer(picture);
  const float size = writer.size(), left = size, stroke = 2 * size;
  float y = size;
  for (const Caption& line : lines) {
    if (line.stroke) writer.stroke(left, y + 0.45F * size, stroke, line.colour);
    writer.text(left + (line.stroke ? stroke + 0.6F * size : 0), y, line.text);
    y += 1.5F * size;
  }
}

}  // namespace tyg
