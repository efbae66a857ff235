// A ghost is drawn into the picture of the cloth, as lines alone, with the same renderer.
#include "ui/cloth_painter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/forces/terms/air.h"
#include "view/against_neighbours.h"
#include "view/body_shapes.h"
#include "view/wind_arrow.h"

namespace tyg {
namespace {

/// Pixels of height from which on lines may be wider than at scale 1: in a low window text is small too.
constexpr float kHeightAtScale1 = 360;

/// A ghost beside the cloth has the bodies beside them. A plane that is shifted along itself is there already.
void addShifted(std::vector<Body>& bodies, const glm::vec3& shift) {
  if (shift == glm::vec3(0)) return;
  constexpr double kAlong = 1e-6;  // m
  for (std::size_t k = 0, count = bodies.size(); k < count; ++k) {
    Body copy = bodies[k];
    const Vec3& normal = copy.normal;
    const double away = normal.x * shift.x + normal.y * shift.y + normal.z * shift.z;
    if (copy.shape == Shape::Plane && std::abs(away) < kAlong) continue;
    copy.at = {copy.at.x + shift.x, copy.at.y + shift.y, copy.at.z + shift.z};
    bodies.push_back(std::move(copy));
  }
}

}  // namespace

std::optional<ShownWind> shownWind(const Viewer& viewer) {
  const ShownState& shown = viewer.run().shown();
  const glm::vec3 middle = shown.box().centre();
  const Vec3 wind = windAt(viewer.run().simulation().scene(), shown.time(), {middle.x, middle.y, middle.z});
  if (wind == Vec3{}) return std::nullopt;
  const Insets& insets = viewer.view().insets();
  const Extent window = viewer.view().pixels();
  const float width = float(std::max(window.width, 1)), height = float(std::max(window.height, 1));
  // Longer than the place is high: only gales have such arrows, and hardly any blows upwards.
  const float half = 0.7F * float(insets.wind);
  return ShownWind{.velocity = wind,
                   .at = {(float(insets.left) + half) / width, (float(insets.top) - float(insets.wind) / 2) / height},
                   .longest = 2 * half / height};
}

/// What a hand holds is not drawn as a pin: the text over the picture draws a ring around it.
const Sheet& ClothPainter::withoutHeld(const ShownState& shown) {
  if (shown.held().empty()) return shown.sheet();
  sheetWithoutHeld_ = shown.sheet();
  std::erase_if(sheetWithoutHeld_.pins, [&](int pin) { return std::ranges::binary_search(shown.held(), pin); });
  return sheetWithoutHeld_;
}

ClothPainter::ClothPainter(const Viewer& viewer, float scale, const std::shared_ptr<Programs>& programs)
    : programs_(programs),
      renderer_(std::make_unique<SheetRenderer>(viewer.run().simulation().sheet(), programs)),
      scale_(scale),
      sheet_(viewer.scenes().sheetsSoFar()) {}

void ClothPainter::draw(const Viewer& viewer, Panels& panels, Extent window) {
  if (sheet_ != viewer.scenes().sheetsSoFar()) *this = ClothPainter(viewer, scale_, programs_);
  ClothPicture picture{.options = viewer.view().drawOptions()};
  picture.options.wind = shownWind(viewer);
  picture.options.scale = std::min(scale_, std::max(1.0F, float(window.height) / kHeightAtScale1));
  followLook(viewer.scenes().scene(), picture.options);
  panels.paint(picture);
  if (viewer.run().showsBreaking() && picture.options.colouring.by == Colouring::By::Family) {
    against_.resize(viewer.run().shown().positions().size() / 3);
    againstNeighbours(viewer.run().shown().sheet(), viewer.run().shown().positions(), against_);
    picture.options.colouring = {
        .by = Colouring::By::Particle, .ramp = Ramp::Balanced, .low = -1, .high = 1, .values = against_};
  }
  placeBodies(viewer.run().simulation().scene(), viewer.run().shown().time(), bodies_);
  addShifted(bodies_, picture.ghostShift);
  picture.options.bodies = bodies_;
  const glm::ivec2 pixels{window.width, window.height};
  const Camera& camera = viewer.view().camera();
  const ShownState& shown = viewer.run().shown();
  renderer_->follow(withoutHeld(shown));
  renderer_->draw(shown.drawn(), camera, pixels, picture.options, viewer.tools().drawing().arrow);
  if (picture.ghostSheet == nullptr) return;
  if (picture.ghost.size() != 3 * static_cast<std::size_t>(shown.sheet().count())) return;
  if (!ghost_) ghost_ = std::make_unique<SheetRenderer>(*picture.ghostSheet, programs_);
  ghost_->follow(*picture.ghostSheet);
  const bool dark = picture.options.background == Background::Dark;
  ghost_->draw(picture.ghost, camera, pixels,
               {.pins = false,
                .background = picture.options.background,
                .scale = scale_,
                .mesh = dark ? rgb(0xf4f6f8) : rgb(0x20242a),
                .over = true,
                .opacity = picture.ghostOpacity,
                .bodies = bodies_});
}

}  // namespace tyg
