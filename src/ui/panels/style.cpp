// One table of colours for each background, and ImGui's own widgets dressed in them.
#include "ui/panels/style.h"

#include <imgui.h>

#include <cmath>

#include "study/charts/method_style.h"

namespace tyg {
namespace {

constexpr Colours kOnDark{.text = IM_COL32(232, 236, 242, 255),
                          .dim = IM_COL32(148, 156, 170, 255),
                          .accent = IM_COL32(126, 190, 255, 255),
                          .good = IM_COL32(84, 200, 160, 255),
                          .warning = IM_COL32(255, 186, 96, 255),
                          .past = IM_COL32(240, 96, 40, 255),
                          .shade = IM_COL32(12, 14, 20, 190),
                          .panel = IM_COL32(22, 26, 34, 236),
                          .field = IM_COL32(44, 50, 62, 255)};
constexpr Colours kOnLight{.text = IM_COL32(28, 32, 40, 255),
                           .dim = IM_COL32(96, 104, 118, 255),
                           .accent = IM_COL32(0, 92, 190, 255),
                           .good = IM_COL32(0, 122, 88, 255),
                           .warning = IM_COL32(176, 76, 0, 255),
                           .past = IM_COL32(200, 66, 0, 255),
                           .shade = IM_COL32(255, 255, 255, 210),
                           .panel = IM_COL32(250, 251, 253, 240),
                           .field = IM_COL32(226, 230, 238, 255)};

ImVec4 unpacked(Colour colour, float share = 1) {
  ImVec4 result = ImGui::ColorConvertU32ToFloat4(colour);
  result.w *= share;
  return result;
}

Colour between(Colour one, Colour other) {
  const ImVec4 a = unpacked(one), b = unpacked(other);
  return ImGui::ColorConvertFloat4ToU32({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2, (a.w + b.w) / 2});
}

}  // namespace

const Colours& coloursOn(Background background) { return background == Background::Dark ? kOnDark : kOnLight; }

Colour seriesColour(std::size_t k, Background background) {
  // A longer list goes on with the second colour, halfway to the colour of text, so that it repeats none.
  const bool isLater = k >= kSeriesColours;
  const SeriesColour& both = colourOfSeries(isLater ? k + 1 : k);
  const std::uint32_t rgb = background == Background::Dark ? both.onDark : both.onLight;
  const Colour colour = IM_COL32(rgb >> 16 & 255, rgb >> 8 & 255, rgb & 255, 255);
  return isLater ? between(colour, coloursOn(background).text) : colour;
}

Colour faded(Colour colour, float share) { return ImGui::ColorConvertFloat4ToU32(unpacked(colour, share)); }

std::string unitText(std::string_view unit) {
  if (unit == "1") return {};
  std::string text;
  for (const char sign : unit) {
    const bool isPower = !text.empty() && text.back() != ' ';
    if (isPower && (sign == '2' || sign == '3')) {
      text += sign == '2' ? "\u00b2" : "\u00b3";
    } else {
      text += sign;
    }
  }
  return text;
}

void applyStyle(Background background, float size) {
  const Colours& colours = coloursOn(background);
  ImGuiStyle& style = ImGui::GetStyle();
  background == Background::Dark ? ImGui::StyleColorsDark(&style) : ImGui::StyleColorsLight(&style);
  const auto set = [&style](ImGuiCol place, Colour colour, float share = 1) {
    style.Colors[place] = unpacked(colour, share);
  };
  set(ImGuiCol_Text, colours.text), set(ImGuiCol_TextDisabled, colours.dim);
  set(ImGuiCol_WindowBg, colours.panel), set(ImGuiCol_ChildBg, colours.panel, 0);
  set(ImGuiCol_PopupBg, colours.panel | IM_COL32_A_MASK);  // it lies over other text
  set(ImGuiCol_TitleBg, colours.panel), set(ImGuiCol_TitleBgActive, colours.field);
  set(ImGuiCol_TitleBgCollapsed, colours.panel);
  set(ImGuiCol_Border, colours.dim, 0.35F), set(ImGuiCol_Separator, colours.dim, 0.35F);
  set(ImGuiCol_FrameBg, colours.field), set(ImGuiCol_FrameBgHovered, colours.accent, 0.25F);
  set(ImGuiCol_FrameBgActive, colours.accent, 0.4F);
  set(ImGuiCol_Button, colours.field), set(ImGuiCol_ButtonHovered, colours.accent, 0.35F);
  set(ImGuiCol_ButtonActive, colours.accent, 0.55F);
  set(ImGuiCol_Header, colours.accent, 0.25F), set(ImGuiCol_HeaderHovered, colours.accent, 0.35F);
  set(ImGuiCol_HeaderActive, colours.accent, 0.5F);
  // The value is written over the grab.
  set(ImGuiCol_SliderGrab, colours.accent, 0.35F), set(ImGuiCol_SliderGrabActive, colours.accent, 0.55F);
  set(ImGuiCol_CheckMark, colours.accent), set(ImGuiCol_TextSelectedBg, colours.accent, 0.35F);
  set(ImGuiCol_ScrollbarBg, colours.panel, 0), set(ImGuiCol_ScrollbarGrab, colours.dim, 0.5F);
  // Whole pixels: ImGui gives a window that fits its contents a scroll bar for a fraction of one.
  const auto sizes = [size](float times) { return std::round(times * size); };
  style.WindowRounding = style.FrameRounding = style.PopupRounding = sizes(0.3F);
  // ImGui 1.86 divides by zero where a rounded rectangle is two pixels and a millionth long, as a scroll bar may be in
  // a window that somebody makes small.
  style.ScrollbarRounding = style.GrabRounding = 0;
  style.WindowPadding = {sizes(0.7F), sizes(0.5F)};
  style.FramePadding = {sizes(0.45F), sizes(0.2F)};
  style.ItemSpacing = {sizes(0.45F), sizes(0.25F)};
  style.ItemInnerSpacing = {sizes(0.4F), sizes(0.3F)};
  style.ScrollbarSize = sizes(0.8F);
  style.GrabMinSize = sizes(0.4F);
  style.WindowBorderSize = 1;
  style.WindowTitleAlign = {0, 0.5F};
  style.WindowMenuButtonPosition = ImGuiDir_None;
}

}  // namespace tyg
