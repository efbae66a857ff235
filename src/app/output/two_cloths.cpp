// Both runs are advanced to the same time, and both sheets are drawn into one framebuffer by the same camera.
#include "app/output/two_cloths.h"

#include <cmath>
#include <stdexcept>
#include <vector>

#include <glm/gtc/constants.hpp>

#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"
#include "ui/captions.h"
#include "util/visible_text.h"
#include "view/body_shapes.h"

namespace tyg {
namespace {

// Told apart by brightness too, so that they can be printed in grey. The first is wide, so that it shows on both sides
// of the second where the two agree.
constexpr std::array<std::uint8_t, 3> kPaleBlue{0x7A, 0xC0, 0xEC}, kDarkRed{0x8C, 0x24, 0x00};
constexpr float kWide = 4.5F, kNarrow = 1.6F;  // pixels
constexpr float kFade = 0.25F;                 // with distance: more would make one of them look like the other

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

glm::vec3 placeOf(const Cloth& cloth, int column, int row) {
  const auto at = 3 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(cloth.sheet.columns) +
                       static_cast<std::size_t>(column));
  return {cloth.xyz[at], cloth.xyz[at + 1], cloth.xyz[at + 2]};
}
/// The particle nearest to a place of the sheet: shares of its width and height, 0..1.
glm::vec3 placeOf(const Cloth& cloth, const glm::vec2& share) {
  const glm::vec2 last(cloth.sheet.columns - 1, cloth.sheet.rows - 1);
  const glm::ivec2 nearest(share * last + 0.5F);
  return placeOf(cloth, nearest.x, nearest.y);
}

/// The point of the first at which the two differ most.
glm::vec3 placeOfDifference(const Cloth& one, const Cloth& other) {
  constexpr int kSide = 12;
  glm::vec3 place(0);
  float most = -1;
  for (int k = 0; k < (kSide + 1) * (kSide + 1); ++k) {
    const glm::vec2 share = glm::vec2(k % (kSide + 1), k / (kSide + 1)) / float(kSide);
    const glm::vec3 here = placeOf(one, share);
    if (const float apart = glm::distance(here, placeOf(other, share)); apart > most) most = apart, place = here;
  }
  return place;
}

/// The particles of both but for parts that have come off and are far away from where the two differ most.
std::vector<float> aroundDifference(const Cloth& one, const Cloth& other) {
  constexpr double kWhole = 1.6;  // sizes of the sheet: it has no particle farther away as long as it is in one piece
  const auto reach = static_cast<float>(kWhole * one.sheet.size());
  const glm::vec3 place = placeOfDifference(one, other);
  std::vector<float> near;
  for (const std::vector<float>* xyz : {&one.xyz, &other.xyz}) {
    for (std::size_t i = 0; i < xyz->size(); i += 3) {
      const glm::vec3 point((*xyz)[i], (*xyz)[i + 1], (*xyz)[i + 2]);
      if (glm::distance(point, place) < reach) near.insert(near.end(), {point.x, point.y, point.z});
    }
  }
  return near;
}

/// Turns the camera to where the two lie farthest apart beside each other and the first is seen broadly.
void turnToDifference(const Cloth& one, const Cloth& other, Camera& camera) {
  constexpr int kSide = 12, kTurns = 6;
  std::vector<glm::vec3> differences, areas;
  for (int row = 0; row < kSide; ++row) {
    for (int column = 0; column < kSide; ++column) {
      const auto share = [](int x, int y) { return glm::vec2(x, y) / float(kSide); };
      const glm::vec3 here = placeOf(one, share(column, row));
      differences.push_back(placeOf(other, share(column, row)) - here);
      areas.push_back(
          glm::cross(placeOf(one, share(column + 1, row)) - here, placeOf(one, share(column, row + 1)) - here));
    }
  }
  const float yaw = camera.yaw(), pitch = camera.pitch();
  glm::vec2 best(yaw, pitch);
  float most = -1;
  for (const float down : {pitch, 0.4F * pitch, 2.0F * pitch}) {
    for (int turn = 0; turn < 4 * kTurns; ++turn) {
      camera.lookAlong(yaw + float(turn) * glm::half_pi<float>() / kTurns, down);
      float apart = 0, broad = 0;
      for (const glm::vec3& difference : differences) {
        const glm::vec3 along = glm::dot(difference, camera.forward()) * camera.forward();
        apart += glm::dot(difference - along, difference - along);
      }
      for (const glm::vec3& area : areas) broad += std::abs(glm::dot(area, camera.forward()));
      constexpr float kClearly = 1.05F;  // not turned away from the usual side for nothing
      if (const float worth = apart * broad; worth > kClearly * most) most = worth, best = {camera.yaw(), down};
    }
  }
  camera.lookAlong(best.x, best.y);
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
  const std::vector<float> xyz = aroundDifference(oneCloth, otherCloth);
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < xyz.size(); i += 3) points.emplace_back(xyz[i], xyz[i + 1], xyz[i + 2]);
  std::vector<Body> bodies;
  placeBodies(first.scene, time, bodies);
  addBodyPoints(bodies, boxAround(xyz), points);
  Camera camera;
  camera.watch(boxAround(xyz));
  turnToDifference(oneCloth, otherCloth, camera);
  camera.frame(points, static_cast<float>(size.x) / static_cast<float>(size.y));

  const auto offscreen = openOffscreen(size);
  SheetRenderer oneSheet(oneCloth.sheet), otherSheet(otherCloth.sheet);
  DrawOptions draw;
  draw.background = Background::Light;
  draw.pins = false;
  draw.bodies = bodies;
  draw.fade = kFade;
  draw.mesh = unit(kPaleBlue);
  draw.lineWidth = kWide;
  oneSheet.draw(oneCloth.xyz, camera, size, draw);
  draw.mesh = unit(kDarkRed);
  draw.lineWidth = kNarrow;
  draw.over = true;
  otherSheet.draw(otherCloth.xyz, camera, size, draw);
  Picture picture = offscreen->readPixels();
  writeLegend(picture, {{title}, {first.words, true, kPaleBlue}, {second.words, true, kDarkRed}});
  return picture;
}

}  // namespace tyg
