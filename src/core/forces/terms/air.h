// Air that the cloth moves through, and wind: a force on every cell, along its normal (flat plates at small angles,
// Hoerner 1965), a quarter of it on each corner:
//   F = 1/2 rho C |u| (u.A) A / |A|,   u = wind(t, x) - v,   A = 1/2 (x_f - x_a) x (x_e - x_b)
// with v and x the means of the four corners, A the vector area of the cell. Per cell, not per particle: a normal at a
// particle would need rows that a pass in place has already moved.
#pragma once

#include <array>
#include <vector>

#include "core/forces/acting.h"
#include "core/forces/terms/term_list.h"
#include "tyg/sheet.h"

namespace tyg {

struct ForceTerm;

struct AirTerm {
  static constexpr TermPlace kPlace = TermPlace::Cells;
  static constexpr std::string_view kSupply = "wind";
  static const ForceTerm kTerm;

  /// The gusts of one of the winds that blow at a moment. They travel with it (Taylor's frozen turbulence, 1938).
  template <class T>
  struct Gusts {
    T amplitude[3] = {};  ///< m/s
    T wave[3] = {};       ///< the direction of the wind over the wavelength, 1/m
    T phase = 0;          ///< at the origin, as a share of a period
  };
  template <class T>
  struct Numbers {
    T factor = 0;                                              ///< rho C / 16, kg/m3
    T tinyArea = 0;                                            ///< m4, keeps a cell without area from dividing by zero
    T steady[3] = {};                                          ///< all winds of the moment without their gusts, m/s
    const Gusts<T>*firstGusts = nullptr, *endGusts = nullptr;  ///< of the moment
  };
  /// What changes from moment to moment.
  template <class T>
  struct Moment {
    std::vector<Gusts<T>> gusts;
  };

  template <class T>
  static Numbers<T> numbersOf(const Scene& scene, const Sheet& sheet) {
    constexpr double kTiny = sizeof(T) == sizeof(float) ? 1e-12 : 1e-20;  // a share of a cell's area, squared
    return {T(scene.air.density * scene.air.coefficient / 16),
            T(kTiny * sheet.spacing * sheet.spacing * sheet.spacing * sheet.spacing)};
  }
  /// The winds that blow, at this time (s). Allocates nothing for as many winds as before.
  template <class T>
  static void setMoment(const Scene& scene, const Acting& acting, double time, Moment<T>& moment, Numbers<T>& numbers);

  /// What the air does to a cell.
  template <class Vector>
  struct OnCell {
    Vector corner;      ///< force on each corner, N
    Vector wind, past;  ///< the wind there, and the velocity at which it passes the cell, m/s
  };
  template <class Math, class Vector, class T>
  [[gnu::always_inline]] static OnCell<Vector> onCell(const Math& math, const Corners<Vector>& x,
                                                      const Corners<Vector>& v, const Numbers<T>& numbers) {
    const auto quarter = math.all(T(0.25));
    Vector wind = math.all3(numbers.steady);
    if (numbers.firstGusts != numbers.endGusts) [[unlikely]] {  // out of the way of steady winds
      const Vector centre = quarter * ((x.here + x.right) + (x.below + x.belowRight));
      for (const Gusts<T>* gusts = numbers.firstGusts; gusts != numbers.endGusts; ++gusts) {
        wind = wind + gustOf(math, *gusts, centre);
      }
    }
    const Vector past = wind - quarter * ((v.here + v.right) + (v.below + v.belowRight));
    const Vector twiceArea = math.cross(x.belowRight - x.here, x.below - x.right);
    // |u| (u.A) / |A| with one root
    const auto ratio = math.dot(past, past) / (math.dot(twiceArea, twiceArea) + math.all(numbers.tinyArea));
    return {(math.all(numbers.factor) * (math.dot(past, twiceArea) * math.root(ratio))) * twiceArea, wind, past};
  }
  template <class Math, class Vector, class T>
  [[gnu::always_inline]] static Vector cornerForce(const Math& math, const Corners<Vector>& x, const Corners<Vector>& v,
                                                   const Numbers<T>& numbers) {
    return onCell(math, x, v, numbers).corner;
  }

  /// The vector g of a cell such that -g g' is what a corner's velocity changes of the force on a corner, with the
  /// normal and the speed held: 1/4 sqrt(1/2 rho C |A| |u|) along the normal, in sqrt(N s/m).
  template <class Math, class Vector, class T>
  static Vector rootOfDamping(const Math& math, const Corners<Vector>& x, const Corners<Vector>& v,
                              const Numbers<T>& numbers) {
    const Vector twiceArea = math.cross(x.belowRight - x.here, x.below - x.right);
    const Vector past = onCell(math, x, v, numbers).past;
    const auto speed = math.root(math.dot(past, past));
    const auto size = math.root(math.dot(twiceArea, twiceArea) + math.all(numbers.tinyArea));
    return (math.all(T(0.5)) * math.root(math.all(numbers.factor) * speed / size)) * twiceArea;
  }

  /// W that the air takes from the cells below a row and from the wind, and W that the wind brings.
  template <class Row>
  static std::array<double, 2> powersIn(const Row& row, const Numbers<double>& numbers) {
    if (!(numbers.factor > 0)) return {};
    const auto math = row.math();
    const auto four = math.all(4);
    return row.sumsOverCells([&](const auto& x, const auto& v) {
      const auto air = onCell(math, x, v, numbers);
      return std::array{four * math.dot(air.corner, air.past), four * math.dot(air.corner, air.wind)};
    });
  }

  /// gust s(p), p = phase - wave.x, s of period 1, mean 0 and amplitude 1, three times continuously differentiable:
  /// s(p) = 2 S7(1 - 2 |p - round(p)|) - 1, S7(q) = q^4 (35 - 84 q + 70 q^2 - 20 q^3).
  template <class Math, class Vector, class T>
  [[gnu::always_inline]] static Vector gustOf(const Math& math, const Gusts<T>& gusts, const Vector& at) {
    const auto p = math.all(gusts.phase) - math.dot(math.all3(gusts.wave), at);
    const auto q = math.all(T(1)) - math.all(T(2)) * math.size(p - math.nearestWhole(p));
    const auto q2 = q * q;
    const auto inner = (math.all(T(35)) - math.all(T(84)) * q) + q2 * (math.all(T(70)) - math.all(T(20)) * q);
    const auto s = math.all(T(2)) * ((q2 * q2) * inner) - math.all(T(1));
    return s * math.all3(gusts.amplitude);
  }
};

/// The wind at a place (m) and a time (s), for people to see, m/s; none where the scene has no air.
Vec3 windAt(const Scene& scene, double time, const Vec3& place);

}  // namespace tyg
