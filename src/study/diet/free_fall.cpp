// A particle falls along a straight line. How far a place is from a solid and convex body is a convex function along a
// line, so that halving finds the nearest place on the way.
#include "study/diet/free_fall.h"

#include <algorithm>

#include "core/forces/point_math.h"
#include "core/forces/term.h"
#include "core/forces/terms/contact.h"
#include "core/scene/bodies.h"
#include "tyg/sheet.h"

namespace tyg {
namespace {

using Solid = ContactTerm::Solid<double>;

double depthBelow(const Solid& solid, const Point<double>& at) {
  const PointMath<double> math;
  switch (solid.shape) {
    case Shape::Plane:
      return ContactTerm::depthOf<Shape::Plane>(math, solid, at).below;
    case Shape::Ball:
      return ContactTerm::depthOf<Shape::Ball>(math, solid, at).below;
    case Shape::Capsule:
      return ContactTerm::depthOf<Shape::Capsule>(math, solid, at).below;
    case Shape::Box:
      break;
  }
  return ContactTerm::depthOf<Shape::Box>(math, solid, at).below;
}

/// The largest depth below the surface on the way from `start` to `start + way`.
double deepestOnTheWay(const Solid& solid, const Point<double>& start, const Point<double>& way) {
  const auto depthAt = [&](double share) { return depthBelow(solid, start + share * way); };
  constexpr int kThirds = 60;  // (2/3)^60 is 3e-11 of the way
  double first = 0, last = 1;
  for (int k = 0; k < kThirds; ++k) {
    const double third = (last - first) / 3;
    if (depthAt(first + third) < depthAt(last - third)) {
      first += third;
    } else {
      last -= third;
    }
  }
  return std::max({depthAt(0), depthAt((first + last) / 2), depthAt(1)});
}

}  // namespace

bool mayFallOntoABody(const Scene& scene) {
  if (!touchesBodies(scene)) return false;
  if (!scene.moves.empty()) return true;
  const Sheet sheet = makeSheet(scene);
  constexpr double kMostWork = 1e6;  // particles times bodies: a tenth of a second or two
  if (double(sheet.count()) * double(scene.bodies.size()) > kMostWork) return true;
  ContactTerm::Numbers<double> numbers = ContactTerm::numbersOf<double>(scene, sheet);
  ContactTerm::Moment<double> moment;
  ContactTerm::setMoment(scene, {}, 0, moment, numbers);
  // The methods of first order fall farther than the truth, by a step; report-rk4 takes longer steps than it says, too.
  const double time = (1 + scene.dt) * (scene.duration + scene.dt);
  const auto point = [](const Vec3& v) { return Point<double>{v.x, v.y, v.z}; };
  const Point<double> way = time * time / (2 * scene.particleMass) * point(steadyForce(scene));
  return std::ranges::any_of(moment.solids, [&](const Solid& solid) {
    for (int i = 0; i < sheet.count(); ++i) {
      if (deepestOnTheWay(solid, point(sheet.startPosition(i)), way) > -scene.contact.layer) return true;
    }
    return false;
  });
}

}  // namespace tyg
