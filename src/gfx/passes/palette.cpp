// Two palettes in the hexadecimal notation of image editors.
#include "gfx/passes/palette.h"

namespace tyg {
namespace {

constexpr Palette kDark{.background = rgb(0x14181f),
                        .sky = rgb(0x1b212b),
                        .ground = rgb(0x0e1116),
                        .grid = rgb(0x46505f),
                        .structural = rgb(0x8fd3ff),
                        .shear = rgb(0xe69f00),
                        .bend = rgb(0x009e73),
                        .particle = rgb(0xf2f6fa),
                        .pin = rgb(0xff7a1f),
                        .push = rgb(0xf0e442),
                        .wind = rgb(0xcc79a7),
                        .cloth = rgb(0x7fb4d8),
                        .onCloth = rgb(0x10202e),
                        .body = rgb(0x857a6e),
                        .floor = rgb(0x1f232a),
                        .floorGrid = rgb(0x4a5260),
                        .shadow = 0.62F};
constexpr Palette kLight{.background = rgb(0xf6f7f8),
                         .sky = rgb(0xfafbfc),
                         .ground = rgb(0xeceef0),
                         .grid = rgb(0xa9b0b8),
                         .structural = rgb(0x005a94),
                         .shear = rgb(0xc07f00),
                         .bend = rgb(0x009e73),
                         .particle = rgb(0x101418),
                         .pin = rgb(0xd55e00),
                         .push = rgb(0xb0306a),
                         .wind = rgb(0x7a5fb0),
                         .cloth = rgb(0x6ea6cf),
                         .onCloth = rgb(0x102a40),
                         .body = rgb(0xdfd3c0),
                         .floor = rgb(0xe9e7e2),
                         .floorGrid = rgb(0xb5b1aa),
                         .shadow = 0.3F};

}  // namespace

const Palette& paletteOf(Background background) { return background == Background::Dark ? kDark : kLight; }

}  // namespace tyg
