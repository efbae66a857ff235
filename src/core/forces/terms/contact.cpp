// What people and limits see of contact, and where bodies are at a moment.
#include "core/forces/terms/contact.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/forces/term.h"

namespace tyg {
namespace {

bool isThere(const Scene& scene) { return !scene.bodies.empty(); }

/// A number of the contact; a scene without bodies has none of them, and keeps what it does not show.
template <double Contact::*number>
constexpr Parameter parameterOf(std::string_view key, std::string_view label, std::string_view unit) {
  return {.key = key,
          .label = label,
          .unit = unit,
          .count = 1,
          .allowed = Allowed::Positive,
          .get =
              [](const Scene& scene) {
                return Vec3{isThere(scene) ? scene.contact.*number : 0, 0, 0};
              },
          .set =
              [](Scene& scene, const Vec3& value) {
                if (isThere(scene)) scene.contact.*number = value.x;
              },
          .decidesPresence = false,
          .exists = isThere,
          .digits = 3};
}

/// The place of one of the bodies of the scene.
template <std::size_t body>
constexpr Parameter placeParameter(std::string_view key, std::string_view label) {
  return {.key = key,
          .label = label,
          .unit = "m",
          .count = 3,
          .allowed = Allowed::Any,
          .get = [](const Scene& scene) { return body < scene.bodies.size() ? scene.bodies[body].at : Vec3{}; },
          .set =
              [](Scene& scene, const Vec3& value) {
                if (body < scene.bodies.size()) scene.bodies[body].at = value;
              },
          .decidesPresence = false,
          .exists = [](const Scene& scene) { return body < scene.bodies.size(); },
          .nameIn = [](const Scene& scene) -> std::string_view {
            return body < scene.bodies.size() ? std::string_view(scene.bodies[body].name) : std::string_view();
          },
          .ofList = true,
          .mostByHand = 10,
          .digits = 3};
}

constexpr std::array<Parameter, 11> parameters() {
  Parameter stiffness = parameterOf<&Contact::stiffness>("contact.stiffness", "contact", "N/m");
  stiffness.role = Role::Stiffness, stiffness.decidesPresence = true, stiffness.isShareOfSheet = true;
  stiffness.mostByHand = 1e5, stiffness.digits = 4;
  Parameter layer = parameterOf<&Contact::layer>("contact.layer", "layer", "m");
  layer.mostByHand = 0.1;
  Parameter damping = parameterOf<&Contact::damping>("contact.damping", "damping", "1");
  damping.allowed = Allowed::NotNegative, damping.role = Role::Damping, damping.mostByHand = 3;
  Parameter friction = parameterOf<&Contact::friction>("contact.friction", "friction", "1");
  friction.allowed = Allowed::NotNegative, friction.role = Role::Damping, friction.mostByHand = 2;
  Parameter grip = parameterOf<&Contact::grip>("contact.grip", "grip", "N s/m");
  grip.isShareOfSheet = true, grip.mostByHand = 100;
  grip.acts = [](const Scene& scene) { return scene.contact.friction > 0; };
  return {stiffness,
          layer,
          damping,
          friction,
          grip,
          placeParameter<0>("body.at", "body 1"),
          placeParameter<1>("body.2.at", "body 2"),
          placeParameter<2>("body.3.at", "body 3"),
          placeParameter<3>("body.4.at", "body 4"),
          placeParameter<4>("body.5.at", "body 5"),
          placeParameter<5>("body.6.at", "body 6")};
}
constexpr std::array kParameters = parameters();

ParticleHold holdOf(const Scene& scene) {
  const Contact& contact = scene.contact;
  return {.stiffness = contact.stiffness,
          .damping = 2 * contact.damping * std::sqrt(contact.stiffness * scene.particleMass),
          .across = contact.friction > 0 ? contact.grip : 0,
          .times = int(scene.bodies.size())};
}

Vec3 sum(const Vec3& a, double times, const Vec3& b) {
  return {a.x + times * b.x, a.y + times * b.y, a.z + times * b.z};
}

template <class T>
void put(const Vec3& from, T (&to)[3]) {
  to[0] = T(from.x), to[1] = T(from.y), to[2] = T(from.z);
}

}  // namespace

double gapOf(const Scene& scene, const Body& body) {
  if (scene.contact.gap) return *scene.contact.gap;
  return body.shape == Shape::Plane ? 0 : scene.spacing * scene.spacing / (4 * body.radius);
}

BodyMotion motionOf(const Scene& scene, const Body& body, double time, double sameTime) {
  BodyMotion motion;
  if (body.name.empty()) return motion;
  const double soon = time + sameTime;
  for (const Move& move : scene.moves) {
    if (move.body != body.name || soon < move.at) continue;
    if (soon >= move.at + move.duration) {
      motion.offset = sum(motion.offset, move.duration, move.velocity);
    } else {
      motion.offset = sum(motion.offset, -move.at, move.velocity);
      motion.velocity = sum(motion.velocity, 1, move.velocity);
    }
  }
  return motion;
}

Vec3 placeOf(const Scene& scene, std::size_t body, double time) {
  const Body& own = scene.bodies.at(body);
  const BodyMotion motion = motionOf(scene, own, time, 0);
  return sum(sum(own.at, 1, motion.offset), time, motion.velocity);
}

template <class T>
void ContactTerm::setMoment(const Scene& scene, const Acting& acting, double time, Moment<T>& moment,
                            Numbers<T>& numbers) {
  moment.solids.resize(numbers.force > 0 ? scene.bodies.size() : 0);
  for (std::size_t k = 0; k < moment.solids.size(); ++k) {
    const Body& body = scene.bodies[k];
    const BodyMotion motion = k < acting.bodies.size() ? acting.bodies[k] : BodyMotion{};
    Solid<T>& solid = moment.solids[k];
    solid.shape = body.shape;
    const Vec3 at = sum(sum(body.at, 1, motion.offset), time, motion.velocity);
    put(at, solid.at);
    put(motion.velocity, solid.velocity);
    solid.radius = T(body.radius + gapOf(scene, body));
    const Vec3& axis = body.axis;
    if (body.shape == Shape::Plane) {
      put(body.normal, solid.axis);
      const Vec3& normal = body.normal;
      solid.radius = T((at.x * normal.x + at.y * normal.y + at.z * normal.z) + gapOf(scene, body));
    } else if (body.shape == Shape::Capsule) {
      put(axis, solid.axis);
      solid.perSquare = T(1 / (axis.x * axis.x + axis.y * axis.y + axis.z * axis.z));
    } else if (body.shape == Shape::Box) {
      put(Vec3{body.half.x - body.radius, body.half.y - body.radius, body.half.z - body.radius}, solid.axis);
    }
  }
  numbers.firstSolid = moment.solids.data();
  numbers.endSolid = moment.solids.data() + moment.solids.size();
}
template void ContactTerm::setMoment(const Scene&, const Acting&, double, Moment<float>&, Numbers<float>&);
template void ContactTerm::setMoment(const Scene&, const Acting&, double, Moment<double>&, Numbers<double>&);

constinit const ForceTerm ContactTerm::kTerm{
    .name = "contact",
    .parameters = kParameters,
    .canSupply =
        [](const Scene& scene) {
          return scene.contact.stiffness > 0 && !scene.bodies.empty() &&
                 std::ranges::any_of(scene.moves, [](const Move& move) { return !move.body.empty(); });
        },
    .hold = holdOf};

}  // namespace tyg
