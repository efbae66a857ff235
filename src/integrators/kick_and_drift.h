// The two halves of an update that several methods share: a kick changes velocities, a drift moves positions.
// Must not know: any method.
#pragma once

#include "core/forces/field_ops.h"
#include "core/forces/forces.h"

namespace tyg {

/// v' = v + h force / m.
template <class T>
void kick(Forces<T>& forces, State<T>& state, const VectorField<T>& force, double h) {
  const T step = T(h * forces.inverseMass());
  T* v = state.velocity.x();
  const T* f = force.x();
  forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) { v[i] += step * f[i]; });
}

/// x' = x + h v.
template <class T>
void drift(Forces<T>& forces, State<T>& state, double h) {
  const T step = T(h);
  T* x = state.position.x();
  const T* v = state.velocity.x();
  forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) { x[i] += step * v[i]; });
}

/// Both in one pass, the kick first: v' = v + h a(t, x, v); x' = x + h v' with a = force / m.
template <class T>
void kickAndDrift(Forces<T>& forces, State<T>& state, VectorField<T>& force, double t, double h) {
  forces.evaluate(t, state.position, state.velocity, force);
  forces.addPower(h);
  const T step = T(h), kick = T(h * forces.inverseMass());
  T *x = state.position.x(), *v = state.velocity.x();
  const T* f = force.x();
  forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
    v[i] += kick * f[i];
    x[i] += step * v[i];
  });
}

}  // namespace tyg
