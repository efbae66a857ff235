// The update that the symplectic Euler family shares: first the velocity, then the position with the new velocity.
#pragma once

#include "core/forces/field_ops.h"
#include "core/forces/forces.h"

namespace tyg {

/// v' = v + h a(x, v); x' = x + h v' with a = force / m.
template <class T>
void kickAndDrift(Forces<T>& forces, State<T>& state, VectorField<T>& force, double h) {
  forces.evaluate(state.position, state.velocity, force);
  forces.dissipate(h);
  const T step = T(h), kick = T(h * forces.inverseMass());
  T *x = state.position.x(), *v = state.velocity.x();
  const T* f = force.x();
  forNumbers(forces.workers(), forces.layout(), [=](std::ptrdiff_t i) {
    v[i] += kick * f[i];
    x[i] += step * v[i];
  });
}

}  // namespace tyg
