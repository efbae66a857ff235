// Every number of a scene is held against the same two bounds, under the key that a scene file has for it.
#include "core/scene/scene_range.h"

#include <fmt/core.h>

#include <cmath>
#include <string_view>

#include "core/forces/term.h"

namespace tyg {
namespace {

class RangeCheck {
 public:
  explicit RangeCheck(std::string_view scene) : scene_(scene) {}

  void number(std::string_view key, double value) const {
    check(key, value, value == 0 || std::abs(value) >= kSmallestNumber, "0 and ");
  }
  void positive(std::string_view key, double value) const { check(key, value, value >= kSmallestNumber, ""); }
  void vector(std::string_view key, const Vec3& value) const {
    for (const double part : {value.x, value.y, value.z}) check(key, part, true, "0 and ");
  }

  [[noreturn]] void refuseNegative(std::string_view key, double value) const {
    throw InputError(fmt::format("{}{}key {}: found {:g}, allowed are numbers of at least 0", scene_,
                                 scene_.empty() ? "" : ": ", key, value));
  }

 private:
  void check(std::string_view key, double value, bool isLargeEnough, std::string_view zero) const {
    if (isLargeEnough && std::abs(value) <= kLargestNumber) return;  // false for NaN
    throw InputError(fmt::format("{}{}key {}: found {:g}, allowed are {}numbers of a size from {:g} to {:g}", scene_,
                                 scene_.empty() ? "" : ": ", key, value, zero, kSmallestNumber, kLargestNumber));
  }

  std::string_view scene_;
};

}  // namespace

void refuseExtremeParameters(const Scene& scene) {
  const RangeCheck check(scene.name);
  for (const ForceTerm* term : forceTerms()) {
    for (const Parameter& parameter : term->parameters) {
      const Vec3 value = parameter.get(scene);
      if (parameter.allowed != Allowed::Any && value.x < 0) check.refuseNegative(parameter.key, value.x);
      parameter.count == 1 ? check.number(parameter.key, value.x) : check.vector(parameter.key, value);
    }
  }
}

void refuseExtremes(const Scene& scene) {
  const RangeCheck check(scene.name);
  check.positive("sheet.spacing", scene.spacing);
  check.positive("sheet.particle_mass", scene.particleMass);
  check.positive("run.duration", scene.duration);
  refuseExtremeParameters(scene);
  for (const Displacement& displacement : scene.displacements) check.vector("displace.by", displacement.by);
  for (const Wind& wind : scene.winds) {
    check.vector("wind.velocity", wind.velocity);
    check.vector("wind.gust", wind.gust);
    check.number("wind.wavelength", wind.wavelength);
    check.number("wind.at", wind.at);
    if (wind.duration != Wind{}.duration) check.number("wind.for", wind.duration);
  }
  for (const Body& body : scene.bodies) {
    check.vector("body.at", body.at);
    check.vector("body.half", body.half);
    check.vector("body.to", body.axis);
    check.number(body.shape == Shape::Box ? "body.rounding" : "body.radius", body.radius);
  }
  check.number("contact.gap", scene.contact.gap.value_or(0));
  for (const Move& move : scene.moves) {
    check.vector("move.velocity", move.velocity);
    check.number("move.at", move.at);
    check.number("move.for", move.duration);
  }
  check.number("tear.toughness", scene.tear.toughness);
  for (const auto& [line, at] : scene.cuts) {
    check.vector("cut.from", {line.fromColumn, line.fromRow, 0});
    check.vector("cut.to", {line.toColumn, line.toRow, 0});
    check.number("cut.at", at);
  }
  for (const Lamp& lamp : scene.lamps) {
    check.vector("lamp.direction", lamp.direction);
    check.vector("lamp.at", lamp.at.value_or(Vec3{}));
  }
  for (const Push& push : scene.pushes) {
    check.vector("push.force", push.force);
    check.number("push.at", push.at);
    check.number("push.for", push.duration);
  }
}

}  // namespace tyg
