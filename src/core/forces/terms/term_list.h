// A list of force terms as types: what the row kernels are put together from at compile time.
// Must not know: any term.
#pragma once

#include <type_traits>

namespace tyg {

/// Where a row kernel meets a term.
enum class TermPlace {
  Springs,    ///< fused: the springs of one family, from particle to particle
  Always,     ///< added to every sum of springs, zero or not
  Particles,  ///< where a row is finished: addTo() changes the force on a particle
  Cells,      ///< where a row's springs are gathered: cornerForce() is added to each corner of the cell below right
};

template <class... Term>
struct TermList {
  static constexpr bool kEmpty = sizeof...(Term) == 0;

  /// What all terms know of a scene, in precision T.
  template <class T>
  struct Numbers : Term::template Numbers<T>... {};

  /// Calls `visit.operator()<Term>()` for each term, in order.
  template <class Visit>
  [[gnu::always_inline]] static constexpr void forEach([[maybe_unused]] const Visit& visit) {
    (visit.template operator()<Term>(), ...);
  }

  /// How many terms there are of a place: each has a bit, in order.
  static consteval unsigned count(TermPlace place) { return (0U + ... + (Term::kPlace == place ? 1U : 0U)); }
};

/// The terms of a list that meet the kernels at one place and whose bits are set, as another list.
template <TermPlace place, unsigned bits, class List, class... Chosen>
struct ChosenTerms {
  using Type = TermList<Chosen...>;
};
template <TermPlace place, unsigned bits, class First, class... Rest, class... Chosen>
struct ChosenTerms<place, bits, TermList<First, Rest...>, Chosen...> {
  static constexpr bool kHere = First::kPlace == place;
  using With = ChosenTerms<place, bits / 2, TermList<Rest...>, Chosen..., First>;
  using Without = ChosenTerms<place, kHere ? bits / 2 : bits, TermList<Rest...>, Chosen...>;
  using Type = typename std::conditional_t<kHere && bits % 2 == 1, With, Without>::Type;
};

}  // namespace tyg
