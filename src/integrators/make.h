// How the table of methods makes a method: the function that each method's file gives it.
// Must not know: any method.
#pragma once

#include <memory>
#include <type_traits>

#include "core/simulation/integrator.h"
#include "tyg/method.h"

namespace tyg {

/// A `Stepper<T>`, from scene and sheet or, where it asks for no more, from the sheet's layout.
template <template <class> class Stepper, class T>
std::unique_ptr<Integrator<T>> make(const Scene& scene, const Sheet& sheet) {
  if constexpr (std::is_constructible_v<Stepper<T>, const Scene&, const Sheet&>) {
    return std::make_unique<Stepper<T>>(scene, sheet);
  } else {
    return std::make_unique<Stepper<T>>(Layout(sheet));
  }
}

}  // namespace tyg
