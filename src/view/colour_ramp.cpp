// The colours of the scales; Growing follows the order of hues of viridis (van der Walt and Smith 2015).
#include "view/colour_ramp.h"

namespace tyg {
namespace {

constexpr RampColours kGrowingOnDark{rgb(0x4a5ea0), rgb(0x2f86b4), rgb(0x35ad8c), rgb(0xa8cc4c), rgb(0xffe75a)};
constexpr RampColours kGrowingOnLight{rgb(0xa9c3d6), rgb(0x5ba3b8), rgb(0x2d7590), rgb(0x3c4c8c), rgb(0x440154)};
constexpr RampColours kBalancedOnDark{rgb(0x3fb8ff), rgb(0x4f87ad), rgb(0x737a85), rgb(0xd08440), rgb(0xffa62e)};
constexpr RampColours kBalancedOnLight{rgb(0x005fae), rgb(0x6a9cc4), rgb(0xaab0b8), rgb(0xdb8a4c), rgb(0xb83a00)};

}  // namespace

const RampColours& coloursOf(Ramp ramp, Background background) {
  const bool dark = background == Background::Dark;
  if (ramp == Ramp::Growing) return dark ? kGrowingOnDark : kGrowingOnLight;
  return dark ? kBalancedOnDark : kBalancedOnLight;
}

}  // namespace tyg
