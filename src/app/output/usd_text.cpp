// Numbers are written as they are, in every locale alike.
#include "app/output/usd_text.h"

#include <cmath>

namespace tyg {
namespace {

float linear(float onScreen) {
  return onScreen <= 0.04045F ? onScreen / 12.92F : std::pow((onScreen + 0.055F) / 1.055F, 2.4F);
}

}  // namespace

std::string usdColour(const glm::vec3& onScreen) {
  return fmt::format(
      "        color3f[] primvars:displayColor = [({:.5f}, {:.5f}, {:.5f})] (\n            interpolation = "
      "\"constant\"\n"
      "        )\n",
      linear(onScreen.x), linear(onScreen.y), linear(onScreen.z));
}

}  // namespace tyg
