// Both runs are advanced to the same time, and both sheets are drawn into one framebuffer by the same camera.
#include "app/output/two_cloths.h"

#include <stdexcept>
#include <vector>

#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"
#include "ui/captions.h"
#include "util/visible_text.h"
#include "view/body_shapes.h"

namespace tyg {
namespace {

// Blue and vermilion of Okabe and Ito (2008): the colour-blind tell them apart. The first is wide, so that it shows on
// both sides of the second where the two agree.
constexpr std::array<std::uint8_t, 3> kBlue{0x56, 0xB4, 0xE9}, kOrange{0xD5, 0x5E, 0x00};
constexpr float kWide = 4, kNarrow = 1.5F;  // pixels

glm::vec3 unit(const std::array<std::uint8_t, 3>& colour) {
  return glm::vec3(colour[0], colour[1], colour[2]) / 255.0F;
}

/// A cloth at a time.
struct Cloth {
  Sheet sheet;             ///< with what was cut
  std::vector<float> xyz;  ///< m
};
Cloth clothAt(const Scene& scene, double time) {
  Simulation simulation(scene, findMethod(scene.integrator));
  if (time > 0) simulation.advanceTo(time);
  if (simulation.status() != Status::Ok)
    throw InputError(oneLine(scene.title) + ": its run fails before the time of the picture");
  std::vector<float> xyz(3 * static_cast<std::size_t>(simulation.sheet().count()));
  simulation.copyPositions(xyz);
  return {simulation.sheet(), std::move(xyz)};
}

std::unique_ptr<Offscreen> openOffscreen(glm::ivec2 size) {
  try {
    return makeOffscreen(size.x, size.y);
  } catch (const std::runtime_error& error) {
    throw InputError(error.what());
  }
}

}  // namespace

Picture overlaid(const Overlaid& first, const Overlaid& second, double time, const std::string& title,
                 glm::ivec2 size) {
  const Cloth oneCloth = clothAt(first.scene, time), otherCloth = clothAt(second.scene, time);
  const std::vector<float>&one = oneCloth.xyz, &other = otherCloth.xyz;
  std::vector<glm::vec3> points;
  for (const std::vector<float>* xyz : {&one, &other}) {
    for (std::size_t i = 0; i < xyz->size(); i += 3) points.emplace_back((*xyz)[i], (*xyz)[i + 1], (*xyz)[i + 2]);
  }
  std::vector<Body> bodies;
  placeBodies(first.scene, time, bodies);
  addBodyPoints(bodies, boxAround(one).with(boxAround(other)), points);
  Camera camera;
  camera.watch(boxAround(one).with(boxAround(other)));
  camera.frame(points, static_cast<float>(size.x) / static_cast<float>(size.y));

  const auto offscreen = openOffscreen(size);
  SheetRenderer oneSheet(oneCloth.sheet), otherSheet(otherCloth.sheet);
  DrawOptions draw;
  draw.background = Background::Light;
  draw.pins = false;
  draw.bodies = bodies;
  draw.mesh = unit(kBlue);
  draw.lineWidth = kWide;
  oneSheet.draw(one, camera, size, draw);
  draw.mesh = unit(kOrange);
  draw.lineWidth = kNarrow;
  draw.over = true;
  otherSheet.draw(other, camera, size, draw);
  Picture picture = offscreen->readPixels();
  writeLegend(picture, {{title}, {first.words, true, kBlue}, {second.words, true, kOrange}});
  return picture;
}

}  // namespace tyg
