// Colours of several curves, as people see them who lack one kind of cones.
#include "ui/panels/style.h"

#include <gtest/gtest.h>
#include <imgui.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <set>

namespace tyg {
namespace {

/// Machado, Oliveira and Fernandes (2009), severity 1, in linear RGB; transposed, as glm takes columns.
const std::array kEyes{
    glm::mat3(1),
    glm::mat3(0.152286F, 0.114503F, -0.003882F, 1.052583F, 0.786281F, -0.048116F, -0.204868F, 0.099216F, 1.051998F),
    glm::mat3(0.367322F, 0.280085F, -0.011820F, 0.860646F, 0.672501F, 0.042940F, -0.227968F, 0.047413F, 0.968881F)};

glm::vec3 linear(Colour colour) {
  const auto one = [colour](unsigned shift) {
    return std::pow((float((colour >> shift) & 0xffU) / 255 + 0.055F) / 1.055F, 2.4F);
  };
  return {one(0), one(8), one(16)};
}

/// CIE 1976 L*a*b*.
glm::vec3 seen(const glm::vec3& rgb) {
  const glm::mat3 toXyz(0.4339F, 0.2126F, 0.0177F, 0.3762F, 0.7152F, 0.1095F, 0.1899F, 0.0722F, 0.8728F);  // of white
  const glm::vec3 xyz = toXyz * glm::clamp(rgb, 0.0F, 1.0F);
  const glm::vec3 f(std::cbrt(xyz.x), std::cbrt(xyz.y), std::cbrt(xyz.z));
  return {116 * f.y - 16, 500 * (f.x - f.y), 200 * (f.y - f.z)};
}

TEST(Style, ASquareInAUnitIsWrittenAsOne) {
  EXPECT_EQ(unitText("m/s2"), "m/s\u00b2");
  EXPECT_EQ(unitText("kg/m3"), "kg/m\u00b3");
  EXPECT_EQ(unitText("N s/m"), "N s/m");
  EXPECT_EQ(unitText("2 m"), "2 m");
  EXPECT_EQ(unitText(""), "");
}

TEST(Style, SevenSeriesAreToldApartByTheColourBlind) {
  constexpr float kClear = 16;  // 2.3 is just noticeable side by side; thin lines far apart need much more
  for (const Background background : {Background::Dark, Background::Light}) {
    for (const glm::mat3& eyes : kEyes) {
      for (std::size_t a = 0; a < 7; ++a) {
        for (std::size_t b = 0; b < a; ++b) {
          const auto of = [&](std::size_t k) { return seen(eyes * linear(seriesColour(k, background))); };
          EXPECT_GT(glm::distance(of(a), of(b)), kClear) << a << " and " << b;
        }
      }
    }
  }
}

TEST(Style, NineSeriesAreOfDifferentColoursAndNoneIsPale) {
  for (const Background background : {Background::Dark, Background::Light}) {
    std::set<Colour> colours;
    for (std::size_t k = 0; k < 9; ++k) {
      const Colour colour = seriesColour(k, background);
      EXPECT_EQ(colour >> IM_COL32_A_SHIFT, 255U) << k;
      colours.insert(colour);
    }
    EXPECT_EQ(colours.size(), 9U);
  }
}

TEST(Style, LeavesTheCornersOfWhatMayBeTwoPixelsLongSquare) {
  ImGui::CreateContext();
  applyStyle(Background::Dark, 18);
  const ImGuiStyle style = ImGui::GetStyle();
  ImGui::DestroyContext();
  EXPECT_EQ(style.ScrollbarRounding, 0);
  EXPECT_EQ(style.GrabRounding, 0);
}

}  // namespace
}  // namespace tyg
