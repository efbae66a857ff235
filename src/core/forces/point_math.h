// Arithmetic for terms, of one place at a time, as LaneMath has it for whole registers. Must not know: any term.
#pragma once

#include <cmath>

namespace tyg {

template <class T>
struct Point {
  T x = 0, y = 0, z = 0;
  friend Point operator+(const Point& a, const Point& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend Point operator-(const Point& a, const Point& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend Point operator*(T a, const Point& b) { return {a * b.x, a * b.y, a * b.z}; }
};

template <class T>
struct PointMath {
  static T all(T number) { return number; }
  static Point<T> all3(const T (&numbers)[3]) { return {numbers[0], numbers[1], numbers[2]}; }
  static T root(T a) { return std::sqrt(a); }
  static T size(T a) { return std::abs(a); }
  static T larger(T a, T b) { return a > b ? a : b; }
  static T smaller(T a, T b) { return a < b ? a : b; }
  static T signOf(T a) { return a < 0 ? T(-1) : T(1); }
  static T atLeast(T a, T b) { return a >= b ? T(1) : T(0); }
  static T nearestWhole(T a) { return std::nearbyint(a); }
  static T dot(const Point<T>& a, const Point<T>& b) { return (a.x * b.x + a.y * b.y) + a.z * b.z; }
  static Point<T> cross(const Point<T>& a, const Point<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
  }
};

}  // namespace tyg
