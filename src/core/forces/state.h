// The moving state as structure of arrays: one plane of numbers per component, rows padded for the vector units.
// Must not know: what moves it. A copy is a snapshot.
#pragma once

#include <cstddef>
#include <cstdint>

#include "tyg/sheet.h"
#include "util/aligned.h"

namespace tyg {

/// Where particle (column, row) lies in a plane: row * stride + column. Rows are padded to whole vectors, two rows
/// of padding follow the last one; padding holds finite numbers, carries no force and never moves.
struct Layout {
  static constexpr int kLanes = 16;  ///< rows are computed in multiples of this many particles
  int columns = 1, rows = 1;
  std::ptrdiff_t stride = 0;  ///< numbers from one row to the next
  std::ptrdiff_t plane = 0;   ///< numbers from one component to the next

  Layout() = default;
  explicit Layout(const Sheet& sheet);
  [[nodiscard]] std::ptrdiff_t at(int particle) const { return (particle / columns) * stride + particle % columns; }
  bool operator==(const Layout&) const = default;
};

/// A vector per particle as three planes x, y, z. Zero after construction.
template <class T>
class VectorField {
 public:
  VectorField() = default;
  explicit VectorField(const Layout& layout) : layout_(layout), numbers_(static_cast<std::size_t>(3 * layout.plane)) {}

  [[nodiscard]] const Layout& layout() const { return layout_; }
  T* x() { return numbers_.data(); }
  T* y() { return numbers_.data() + layout_.plane; }
  T* z() { return numbers_.data() + 2 * layout_.plane; }
  [[nodiscard]] const T* x() const { return numbers_.data(); }
  [[nodiscard]] const T* y() const { return numbers_.data() + layout_.plane; }
  [[nodiscard]] const T* z() const { return numbers_.data() + 2 * layout_.plane; }

  [[nodiscard]] Vec3 get(int particle) const {
    const std::ptrdiff_t i = layout_.at(particle);
    return {double(x()[i]), double(y()[i]), double(z()[i])};
  }
  void set(int particle, const Vec3& value) {
    const std::ptrdiff_t i = layout_.at(particle);
    x()[i] = T(value.x), y()[i] = T(value.y), z()[i] = T(value.z);
  }
  [[nodiscard]] std::size_t bytes() const { return numbers_.size() * sizeof(T); }  ///< of memory
  bool operator==(const VectorField&) const = default;

 private:
  Layout layout_;
  AlignedVector<T> numbers_;
};

/// Positions (m) and velocities (m/s) of all particles.
template <class T>
struct State {
  VectorField<T> position, velocity;
  State() = default;
  explicit State(const Layout& layout) : position(layout), velocity(layout) {}
  [[nodiscard]] std::size_t bytes() const { return position.bytes() + velocity.bytes(); }  ///< of memory
  bool operator==(const State&) const = default;
};

/// The start shape at rest.
template <class T>
State<T> startState(const Sheet& sheet);

/// 64-bit FNV-1a (Fowler, Noll, Vo 1991) over x, y, z, vx, vy, vz of each particle in index order, in precision T.
template <class T>
std::uint64_t hashOf(const State<T>& state);

}  // namespace tyg
