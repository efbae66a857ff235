// Lays out the planes, fills in the start shape, and hashes the state, particle by particle.
#include "core/forces/state.h"

#include <cstring>

namespace tyg {
namespace {

std::ptrdiff_t roundUp(std::ptrdiff_t value, std::ptrdiff_t multiple) {
  return (value + multiple - 1) / multiple * multiple;
}

}  // namespace

Layout::Layout(const Sheet& sheet) : columns(sheet.columns), rows(sheet.rows) {
  // One more vector of padding to the right lets a row read two places past its last whole vector.
  stride = roundUp(columns, kLanes) + kLanes;
  // Two rows of padding below; then planes start on different cache sets, because a row of all three is in use at once.
  plane = roundUp(stride * (rows + 2), 512) + 5 * kLanes;
}

template <class T>
State<T> startState(const Sheet& sheet) {
  State<T> state{Layout(sheet)};
  for (int particle = 0; particle < sheet.count(); ++particle) {
    state.position.set(particle, sheet.startPosition(particle));
  }
  return state;
}

template <class T>
std::uint64_t hashOf(const State<T>& state) {
  std::uint64_t hash = 14695981039346656037U;
  const auto mix = [&hash](T number) {
    unsigned char bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 1099511628211U;
  };
  const Layout& layout = state.position.layout();
  for (int particle = 0; particle < layout.columns * layout.rows; ++particle) {
    const std::ptrdiff_t i = layout.at(particle);
    for (const VectorField<T>* field : {&state.position, &state.velocity}) {
      mix(field->x()[i]), mix(field->y()[i]), mix(field->z()[i]);
    }
  }
  return hash;
}

template State<float> startState(const Sheet&);
template State<double> startState(const Sheet&);
template std::uint64_t hashOf(const State<float>&);
template std::uint64_t hashOf(const State<double>&);

}  // namespace tyg
