// Closed forms, and comparisons of lengths.
#include "core/scene/bodies.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/forces/term.h"
#include "core/forces/terms/contact.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// The largest 2 k (1 - cos q) + 2 kb (1 - cos 2q) over all q.
double largestAlongAxis(double k, double bend) { return k <= 4 * bend ? 2 * k + 4 * bend + k * k / (4 * bend) : 4 * k; }

double smallestRadius(const Scene& scene) {
  double smallest = kInfinity;
  for (const Body& body : scene.bodies) {
    if (body.shape != Shape::Plane) smallest = std::min(smallest, body.radius);
  }
  return smallest;
}

}  // namespace

double largestStiffness(const Scene& scene) {
  const bool wide = scene.columns > 1, tall = scene.rows > 1;
  if (!wide && !tall) return 0;
  const double bend = std::max(scene.columns, scene.rows) > 2 ? scene.bend.ks : 0;
  const double structural = scene.structural.ks, shear = wide && tall ? scene.shear.ks : 0;
  if (!wide || !tall) return largestAlongAxis(structural, bend);
  return std::max(largestAlongAxis(structural, shear + bend), largestAlongAxis(structural + shear, bend));
}

void fillContact(Scene& scene) {
  Contact& contact = scene.contact;
  if (contact.stiffness == 0) contact.stiffness = largestStiffness(scene) / 4;
  if (contact.layer == 0) contact.layer = scene.spacing / 20;
  if (contact.grip == 0) contact.grip = std::sqrt(contact.stiffness * scene.particleMass) / 2;
}

std::optional<UnfitBody> unfitBody(const Scene& scene) {
  const auto text = [](const Vec3& v) { return fmt::format("[{:g}, {:g}, {:g}]", v.x, v.y, v.z); };
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Body& body = scene.bodies[k];
    const auto unfit = [&](std::string_view key, std::string found, std::string allowed) {
      return UnfitBody{k, key, std::move(found), std::move(allowed)};
    };
    if (body.shape == Shape::Plane) {
      if (body.normal == Vec3{}) return unfit("normal", "[0, 0, 0]", "a direction");
      continue;
    }
    const bool isBox = body.shape == Shape::Box;
    if (!(body.radius >= scene.spacing)) {
      return unfit(isBox ? "rounding" : "radius", fmt::format("{:g} m", body.radius),
                   fmt::format("the spacing of the sheet, {:g} m, or more: only its particles touch bodies, and a "
                               "smaller one would pass between them",
                               scene.spacing));
    }
    if (body.shape == Shape::Capsule && body.axis == Vec3{}) {
      return unfit("to", "the same place as from", "another place; a ball has one middle");
    }
    if (isBox && !(std::min({body.half.x, body.half.y, body.half.z}) >= body.radius)) {
      return unfit("half", text(body.half),
                   fmt::format("the rounding of the edges, {:g} m, or more along each axis", body.radius));
    }
  }
  return {};
}

bool touchesBodies(const Scene& scene) { return hasTerm(scene, ContactTerm::kTerm) && !scene.bodies.empty(); }

void refuseUnfitBodies(const Scene& scene) {
  if (!touchesBodies(scene)) return;
  const std::string name = scene.name.empty() ? "" : scene.name + ": ";
  if (const auto unfit = unfitBody(scene)) {
    throw InputError(fmt::format("{}body {}, key {}: found {}, allowed {}", name, unfit->body + 1, unfit->key,
                                 unfit->found, unfit->allowed));
  }
  if (!(scene.contact.layer > 0) || !(scene.contact.grip > 0)) {
    throw InputError(fmt::format("{}contact: found a layer of {:g} m and a grip of {:g} N s/m, allowed above 0", name,
                                 scene.contact.layer, scene.contact.grip));
  }
}

bool fitsBodies(const Scene& scene) { return !touchesBodies(scene) || !unfitBody(scene); }

std::string_view nameOf(Shape shape) {
  constexpr std::array<std::string_view, 4> kNames{"plane", "ball", "capsule", "box"};
  return kNames.at(std::size_t(shape));
}

std::string wordsFor(const Scene& scene, std::size_t body) {
  const Body& own = scene.bodies.at(body);
  if (!own.name.empty()) return oneLine(own.name);
  const std::string shape(nameOf(own.shape));
  return std::ranges::count(scene.bodies, own.shape, &Body::shape) > 1 ? fmt::format("{} {}", shape, body + 1) : shape;
}

std::string bodiesInWords(const Scene& scene) {
  return scene.bodies.size() == 1 ? "the " + wordsFor(scene, 0) : "the bodies";
}

Scene withoutBody(Scene scene, std::size_t body) {
  const std::string name = scene.bodies.at(body).name;
  scene.bodies.erase(scene.bodies.begin() + std::ptrdiff_t(body));
  if (!name.empty()) std::erase_if(scene.moves, [&](const Move& move) { return move.body == name; });
  if (scene.bodies.empty()) scene.contact = {};
  return scene;
}

Scene withoutBodies(Scene scene) {
  while (!scene.bodies.empty()) scene = withoutBody(std::move(scene), 0);
  scene.contact = {};
  return scene;
}

double largestTolerance(const Scene& scene) { return touchesBodies(scene) ? scene.contact.layer / 1000 : kInfinity; }

double usedTolerance(const Scene& scene) { return std::min(scene.tolerance, largestTolerance(scene)); }

std::string largestToleranceInWords(const Scene& scene) {
  return fmt::format("up to a thousandth of the layer of contact, {:g} m: coarser steps would miss it",
                     largestTolerance(scene));
}

/// The smaller root of a h^2 + v h = r / 2, without the cancellation where a is small.
double stepThatMeetsBodies(const Scene& scene, double speed, double acceleration) {
  if (!touchesBodies(scene)) return kInfinity;
  const double way = smallestRadius(scene) / 2;
  if (!std::isfinite(way)) return kInfinity;
  const double root = speed + std::sqrt(speed * speed + 4 * acceleration * way);
  return root > 0 ? 2 * way / root : kInfinity;
}

}  // namespace tyg
