// Bodies that particles touch: a penalty whose stiffness is bounded, so that every method keeps a predictable limit.
// With delta the depth of a particle below a body's surface grown by the gap, l the layer, u = delta / l, c = u clamped
// to [0, 1], n the normal that points out of the body and v the velocity relative to it:
//   N = k l S(u),   S = c^4 ((c - 3) c + 2.5) + (max(u, 0) - c)       along n; its energy is k l^2 P(u)
//   -2 zeta sqrt(k m) w v_n,   w = S / (S + 1/2)                       damping along n
//   -c_f v_t,   c_f = mu N / sqrt(|v_t|^2 + (mu N / grip)^2)           friction: Coulomb's, but never more than `grip`
// S' is a smooth step and then 1: the force is three times continuously differentiable and never stiffer than k.
// Pinned particles feel nothing.
#pragma once

#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "core/forces/acting.h"
#include "core/forces/terms/term_list.h"
#include "tyg/sheet.h"

namespace tyg {

struct ForceTerm;

struct ContactTerm {
  static constexpr TermPlace kPlace = TermPlace::Blocks;
  static constexpr EnergyStore kStore{.name = "contact", .holder = "bodies", .isInEvery = false};
  static constexpr std::string_view kSupply = "bodies";
  static const ForceTerm kTerm;

  /// A body at a moment, grown by the gap.
  template <class T>
  struct Solid {
    Shape shape = Shape::Plane;
    T at[3] = {};        ///< m
    T axis[3] = {};      ///< of a plane: its normal; of a capsule: as Body has it, m; of a box: half of its core, m
    T perSquare = 0;     ///< of a capsule: 1 / |axis|^2, 1/m2
    T radius = 0;        ///< m; of a plane its distance from the origin along the normal
    T velocity[3] = {};  ///< m/s
  };
  template <class T>
  struct Numbers {
    T stiffness = 0, force = 0;                                ///< k, N/m; k l, N
    T layer = 0, perLayer = 0;                                 ///< m, 1/m
    T damping = 0;                                             ///< 2 zeta sqrt(k m), N s/m
    T friction = 0, slip = 0;                                  ///< mu; mu / grip, m/(N s)
    const Solid<T>*firstSolid = nullptr, *endSolid = nullptr;  ///< of the moment
  };
  /// Where the bodies are at a moment.
  template <class T>
  struct Moment {
    std::vector<Solid<T>> solids;
  };

  template <class T>
  static Numbers<T> numbersOf(const Scene& scene, const Sheet& sheet) {
    const Contact& contact = scene.contact;
    Numbers<T> numbers;
    if (!(contact.stiffness > 0) || scene.bodies.empty()) return numbers;
    numbers.stiffness = T(contact.stiffness), numbers.force = T(contact.stiffness * contact.layer);
    numbers.layer = T(contact.layer), numbers.perLayer = T(1 / contact.layer);
    numbers.damping = T(2 * contact.damping * std::sqrt(contact.stiffness * sheet.particleMass));
    numbers.friction = T(contact.friction), numbers.slip = T(contact.friction / contact.grip);
    return numbers;
  }
  /// Allocates nothing for as many bodies as before.
  template <class T>
  static void setMoment(const Scene& scene, const Acting& acting, double time, Moment<T>& moment, Numbers<T>& numbers);

  /// How deep a place is below the surface of a body, m, and the direction out of the body there.
  template <class Number, class Vector>
  struct Depth {
    Number below;
    Vector normal;
  };
  template <Shape shape, class Math, class Vector, class T>
  [[gnu::always_inline]] static auto depthOf(const Math& math, const Solid<T>& solid, const Vector& place) {
    if constexpr (shape == Shape::Plane) {
      const Vector normal = math.all3(solid.axis);
      return Depth<decltype(math.all(T(0))), Vector>{math.all(solid.radius) - math.dot(place, normal), normal};
    } else {
      const Vector from = place - math.all3(solid.at);
      if constexpr (shape == Shape::Box) {
        return depthInBox(math, solid, from);
      } else if constexpr (shape == Shape::Capsule) {
        const Vector axis = math.all3(solid.axis);
        const auto along = clamped(math, math.all(solid.perSquare) * math.dot(from, axis));
        return depthInBall(math, solid, from - along * axis);
      } else {
        return depthInBall(math, solid, from);
      }
    }
  }

  /// What a body does to a particle that touches it.
  template <class Number, class Vector>
  struct Touch {
    Vector normal;             ///< out of the body
    Number push;               ///< N, along the normal
    Number approach;           ///< m/s, along the normal; negative: towards the body
    Vector slip;               ///< m/s, along the surface
    Number damping, friction;  ///< N s/m, against the one and the other

    [[gnu::always_inline]] [[nodiscard]] Vector force() const {
      return (push - damping * approach) * normal - friction * slip;
    }
  };
  /// `isFree` is 0 for a pinned particle, else 1. Without `rubs` there is no friction.
  template <Shape shape, bool rubs, class Math, class Number, class Vector, class T>
  [[gnu::always_inline]] static Touch<Number, Vector> touchOf(const Math& math, const Solid<T>& solid,
                                                              const Vector& place, const Vector& velocity,
                                                              const Number& isFree, const Numbers<T>& numbers) {
    const auto depth = depthOf<shape>(math, solid, place);
    const Number s = isFree * stepOf(math, math.all(numbers.perLayer) * depth.below);
    const Vector relative = velocity - math.all3(solid.velocity);
    Touch<Number, Vector> touch{.normal = depth.normal,
                                .push = math.all(numbers.force) * s,
                                .approach = math.dot(relative, depth.normal),
                                .slip = {},
                                .damping = {},
                                .friction = {}};
    if constexpr (rubs) touch.slip = relative - touch.approach * depth.normal;
    const auto against = againstOf<rubs>(
        math, s, touch.push, [&] { return math.dot(touch.slip, touch.slip); }, numbers);
    touch.damping = against.damping, touch.friction = against.friction;
    return touch;
  }
  /// The force of a level plane, whose normal points straight up or down: what touchOf() says, with nothing to project,
  /// and nothing to subtract from the velocity where the plane does not move.
  template <bool rubs, bool moves, class Vector, class Math, class Number, class T>
  [[gnu::always_inline]] static Vector forceOfFloor(const Math& math, const Solid<T>& solid, const Vector& place,
                                                    const Vector& velocity, const Number& isFree,
                                                    const Numbers<T>& numbers) {
    const Number up = math.all(solid.axis[1]);
    const Number s = isFree * stepOf(math, math.all(numbers.perLayer) * (math.all(solid.radius) - up * place.y));
    Vector relative = velocity;
    if constexpr (moves) relative = velocity - math.all3(solid.velocity);
    const Number push = math.all(numbers.force) * s;
    const auto against = againstOf<rubs>(
        math, s, push, [&] { return relative.x * relative.x + relative.z * relative.z; }, numbers);
    const Number along = up * push - against.damping * relative.y, friction = against.friction;
    if constexpr (!rubs) return {math.all(0), along, math.all(0)};
    return {-(friction * relative.x), along, -(friction * relative.z)};
  }
  /// The stiffness of a body's push, which pushes to the depth `below`, N/m.
  template <class Math, class Number, class T>
  static Number stiffnessAt(const Math& math, const Number& below, const Numbers<T>& numbers) {
    const Number c = clamped(math, math.all(numbers.perLayer) * below);
    return math.all(numbers.stiffness) * ((c * c * c) * ((math.all(T(6)) * c - math.all(T(15))) * c + math.all(T(10))));
  }

  /// Adds what the bodies do to the forces of a block of particles. A body that the block is far from is passed over;
  /// what bits that changes does not depend on the vectors' width, since blocks do not.
  template <class Block, class T>
  static void addToBlock(const Block& block, const Numbers<T>& numbers) {
    forReached(block, numbers, [&]<Shape shape, bool rubs>(const Solid<T>& reached) {
      const auto math = block.math();
      const Numbers<T> known = numbers;  // on the stack, where no store can alias them
      const Solid<T> solid = reached;
      if (shape == Shape::Plane && solid.axis[0] == 0 && solid.axis[2] == 0) {
        const auto addFloor = [&]<bool moves>() {
          block.add([&]<class Vector>(const Vector& place, const Vector& velocity, const auto& isFree) {
            return forceOfFloor<rubs, moves, Vector>(math, solid, place, velocity, isFree, known);
          });
        };
        const bool moves = solid.velocity[0] != 0 || solid.velocity[1] != 0 || solid.velocity[2] != 0;
        return moves ? addFloor.template operator()<true>() : addFloor.template operator()<false>();
      }
      block.add([&](const auto& place, const auto& velocity, const auto& isFree) {
        return touchOf<shape, rubs>(math, solid, place, velocity, isFree, known).force();
      });
    });
  }

  /// Energy of the particles of one row, J.
  template <class Row>
  static double storedIn(const Row& row, const Numbers<double>& numbers) {
    double sum = 0;
    forReached(row, numbers, [&]<Shape shape, bool>(const Solid<double>& solid) {
      const auto math = row.math();
      sum += row.sumOverFree([&](const auto& place, const auto& /*velocity*/, const auto& isFree) {
        return isFree * potentialOf(math, math.all(numbers.perLayer) * depthOf<shape>(math, solid, place).below);
      });
    });
    return numbers.force * numbers.layer * sum;
  }

  /// W that damping and friction take from the particles of a row, and W that moving bodies bring.
  template <class Row>
  static std::array<double, 2> powersIn(const Row& row, const Numbers<double>& numbers) {
    std::array<double, 2> powers{};
    forReached(row, numbers, [&]<Shape shape, bool rubs>(const Solid<double>& solid) {
      const auto math = row.math();
      const auto [lost, brought] = row.sumsOverFree([&](const auto& place, const auto& velocity, const auto& isFree) {
        const auto touch = touchOf<shape, rubs>(math, solid, place, velocity, isFree, numbers);
        return std::array{
            touch.damping * touch.approach * touch.approach + touch.friction * math.dot(touch.slip, touch.slip),
            math.dot(touch.force(), math.all3(solid.velocity))};
      });
      powers[0] += lost, powers[1] += brought;
    });
    return powers;
  }

  /// Calls `visit(touch, stiffness)` for what each body does to one particle that is not pinned, with the stiffness of
  /// its push in N/m, for methods that solve with both.
  template <class Math, class Vector, class T, class Visit>
  static void forTouches(const Math& math, const Vector& place, const Vector& velocity, const Numbers<T>& numbers,
                         const Visit& visit) {
    for (const Solid<T>* solid = numbers.firstSolid; solid != numbers.endSolid; ++solid) {
      withShape(*solid, numbers, [&]<Shape shape, bool rubs>() {
        const T below = depthOf<shape>(math, *solid, place).below;
        if (!(below > 0)) return;
        visit(touchOf<shape, rubs>(math, *solid, place, velocity, T(1), numbers), stiffnessAt(math, below, numbers));
      });
    }
  }

 private:
  template <class T>
  static constexpr T kTinySpeed = sizeof(T) == sizeof(float) ? T(1e-30F) : T(1e-300);  // m2/s2, and m2

  template <class Math, class Number>
  [[gnu::always_inline]] static Number clamped(const Math& math, const Number& a) {
    return math.smaller(math.larger(a, math.all(0)), math.all(1));
  }
  /// S(u).
  template <class Math, class Number>
  [[gnu::always_inline]] static Number stepOf(const Math& math, const Number& u) {
    const Number c = clamped(math, u), square = c * c;
    return (square * square) * ((c - math.all(3)) * c + math.all(2.5F)) + (math.larger(u, math.all(0)) - c);
  }
  /// N s/m, along the normal and along the surface.
  template <class Number>
  struct Against {
    Number damping, friction;
  };
  /// `squaredSlip()`: of the speed along the surface, m2/s2. Both are fractions, and share one division.
  template <bool rubs, class Math, class Number, class SquaredSlip, class T>
  [[gnu::always_inline]] static Against<Number> againstOf(const Math& math, const Number& s, const Number& push,
                                                          const SquaredSlip& squaredSlip, const Numbers<T>& numbers) {
    const Number whole = s + math.all(T(0.5)), damping = math.all(numbers.damping) * s;
    if constexpr (!rubs) return {damping / whole, math.all(T(0))};
    const Number slow = math.all(numbers.slip) * push;
    const Number speed = math.root((squaredSlip() + slow * slow) + math.all(kTinySpeed<T>));
    const Number inverse = math.all(T(1)) / (whole * speed);
    return {damping * (speed * inverse), (math.all(numbers.friction) * push) * (whole * inverse)};
  }
  /// P(u), the integral of S: beyond the layer with S = 1/2 + (u - 1).
  template <class Math, class Number>
  [[gnu::always_inline]] static Number potentialOf(const Math& math, const Number& u) {
    const Number c = clamped(math, u), square = c * c, beyond = math.larger(u, math.all(0)) - c;
    const Number within = (square * square * c) * (math.all(0.5) - math.all(0.5) * c + math.all(1.0 / 7) * square);
    return within + math.all(0.5) * (beyond + beyond * beyond);
  }

  template <class Math, class Vector, class T>
  [[gnu::always_inline]] static auto depthInBall(const Math& math, const Solid<T>& solid, const Vector& from) {
    const auto distance = math.root(math.dot(from, from) + math.all(kTinySpeed<T>));
    return Depth<decltype(math.all(T(0))), Vector>{math.all(solid.radius) - distance,
                                                   (math.all(T(1)) / distance) * from};
  }
  /// Outside of the core the nearest place of the core is the middle of a ball; inside, the nearest face counts.
  template <class Math, class Vector, class T>
  [[gnu::always_inline]] static auto depthInBox(const Math& math, const Solid<T>& solid, const Vector& from) {
    using Number = decltype(math.all(T(0)));
    const Number zero = math.all(T(0)), one = math.all(T(1));
    const Vector half = math.all3(solid.axis);
    const Vector side{math.signOf(from.x), math.signOf(from.y), math.signOf(from.z)};
    const Vector out{side.x * from.x - half.x, side.y * from.y - half.y, side.z * from.z - half.z};
    const Vector past{side.x * math.larger(out.x, zero), side.y * math.larger(out.y, zero),
                      side.z * math.larger(out.z, zero)};
    const Number most = math.larger(math.larger(out.x, out.y), out.z);
    const Number distance = math.root(math.dot(past, past) + math.all(kTinySpeed<T>));
    // 1 for the axis of the nearest face, where the place is inside the core.
    const Number inside = math.atLeast(zero, most), x = inside * math.atLeast(out.x, most);
    const Number y = (inside - x) * math.atLeast(out.y, most), z = (inside - x) - y;
    const Vector face{x * side.x, y * side.y, z * side.z};
    return Depth<Number, Vector>{math.all(solid.radius) - (distance + math.smaller(most, zero)),
                                 (one / distance) * past + face};
  }

  /// The ranges of a block along each axis, worked out when they are asked for: upwards alone mostly tells enough.
  template <class Block>
  class RangesOf {
   public:
    explicit RangesOf(const Block& block) : block_(block) {}
    const auto& along(int axis) {
      if (!isKnown_[axis]) ranges_[axis] = block_.range(axis);
      isKnown_[axis] = true;
      return ranges_[axis];
    }

   private:
    const Block& block_;
    bool isKnown_[3] = {};
    decltype(std::declval<const Block&>().range(0)) ranges_[3];
  };
  /// Whether a body reaches into the box of these ranges.
  template <class T, class Ranges>
  static bool reaches(const Solid<T>& solid, Ranges& ranges) {
    constexpr int kUpwardsFirst[] = {1, 0, 2};
    T lowest = -solid.radius;  // of a plane: how far above it the box begins
    for (const int axis : kUpwardsFirst) {
      const T at = solid.at[axis], along = solid.axis[axis];
      if (solid.shape == Shape::Plane) {
        if (along != 0) lowest += along * (along > 0 ? ranges.along(axis).low : ranges.along(axis).high);
        continue;
      }
      T first = at, last = at;
      if (solid.shape == Shape::Box) first -= along, last += along;
      if (solid.shape == Shape::Capsule) (along < 0 ? first : last) += along;
      const auto& range = ranges.along(axis);
      if (!(range.low < last + solid.radius && range.high > first - solid.radius)) return false;
    }
    return solid.shape != Shape::Plane || lowest < 0;
  }

  /// Calls `visit.operator()<shape, rubs>(solid)` for each body that reaches the particles.
  template <class Particles, class T, class Visit>
  [[gnu::always_inline]] static void forReached(const Particles& particles, const Numbers<T>& numbers,
                                                const Visit& visit) {
    RangesOf<Particles> ranges(particles);
    for (const Solid<T>* solid = numbers.firstSolid; solid != numbers.endSolid; ++solid) {
      if (!reaches(*solid, ranges)) continue;
      withShape(*solid, numbers, [&]<Shape shape, bool rubs>() { visit.template operator()<shape, rubs>(*solid); });
    }
  }

  template <class T, class Visit>
  [[gnu::always_inline]] static void withShape(const Solid<T>& solid, const Numbers<T>& numbers, const Visit& visit) {
    const auto withFriction = [&]<Shape shape>() {
      numbers.friction > 0 ? visit.template operator()<shape, true>() : visit.template operator()<shape, false>();
    };
    switch (solid.shape) {
      case Shape::Plane:
        return withFriction.template operator()<Shape::Plane>();
      case Shape::Ball:
        return withFriction.template operator()<Shape::Ball>();
      case Shape::Capsule:
        return withFriction.template operator()<Shape::Capsule>();
      case Shape::Box:
        return withFriction.template operator()<Shape::Box>();
    }
  }
};

/// Where a body of the scene is at a time (s), m, for people to see: Body::at with its motions.
Vec3 placeOf(const Scene& scene, std::size_t body, double time);
/// How far its motions have moved a body and how fast they move it from a time on, s; those within `sameTime` count as
/// begun or ended.
BodyMotion motionOf(const Scene& scene, const Body& body, double time, double sameTime);
/// The gap of a body, m: the one named, or else what a flat cell sinks into it.
double gapOf(const Scene& scene, const Body& body);

}  // namespace tyg
