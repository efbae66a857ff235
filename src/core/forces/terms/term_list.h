// A list of force terms as types: what the row kernels are put together from at compile time.
// Must not know: any term.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>

namespace tyg {

/// Where a row kernel meets a term.
enum class TermPlace {
  Springs,    ///< fused: the springs of one family, from particle to particle
  Always,     ///< added to every sum of springs, zero or not
  Particles,  ///< where a row is finished: addTo() changes the force on a particle
  Blocks,     ///< before a block of a row is finished: addToBlock() changes the forces on its particles
  Cells,      ///< where a row's springs are gathered: cornerForce() is added to each corner of the cell below right
};

/// A form of energy that terms store in the sheet. Terms that name the same one share its sum.
struct EnergyStore {
  std::string_view name;      ///< of the energy, as people read it: `elastic`
  std::string_view holder;    ///< what stores it: `springs`
  bool startsAtZero = false;  ///< it has no natural zero, and counts from the shape at the start of a run
  bool isInEvery = true;      ///< it is spoken of in every scene, and not only where a term has it
};

template <std::size_t most>
struct EnergyStores {
  std::array<EnergyStore, most> list{};
  std::size_t count = 0;

  /// Its place in the list; `count` where it is not there.
  [[nodiscard]] constexpr std::size_t indexOf(const EnergyStore& store) const {
    std::size_t index = 0;
    while (index < count && list[index].name != store.name) ++index;
    return index;
  }
};

/// The corners of a cell: a particle, its right neighbour, and the two below them.
template <class Vector>
struct Corners {
  Vector here, right, below, belowRight;
};

/// What a term computes anew at every moment, where it does.
template <class Term, class T>
struct MomentOf {};
template <class Term, class T>
requires requires { typename Term::template Moment<T>; }
struct MomentOf<Term, T> {
  typename Term::template Moment<T> moment;
};

template <class... Term>
struct TermList {
  static constexpr bool kEmpty = sizeof...(Term) == 0;

  /// What all terms know of a scene, in precision T.
  template <class T>
  struct Numbers : Term::template Numbers<T>... {};

  /// What the terms compute anew at every moment.
  template <class T>
  struct Moment : MomentOf<Term, T>... {};

  /// Calls `visit.operator()<Term>()` for each term, in order.
  template <class Visit>
  [[gnu::always_inline]] static constexpr void forEach([[maybe_unused]] const Visit& visit) {
    (visit.template operator()<Term>(), ...);
  }

  /// What brings energy by terms, by name: each term's own, in order.
  static constexpr std::size_t kSupplies = (std::size_t{0} + ... + (requires { Term::kSupply; } ? 1 : 0));
  static consteval std::array<std::string_view, kSupplies> supplies() {
    std::array<std::string_view, kSupplies> names{};
    std::size_t count = 0;
    forEach([&]<class Each>() {
      if constexpr (requires { Each::kSupply; }) names[count++] = Each::kSupply;
    });
    return names;
  }

  /// The stores of these terms, each once, in order.
  static consteval EnergyStores<sizeof...(Term)> stores() {
    EnergyStores<sizeof...(Term)> all;
    forEach([&]<class Each>() {
      if constexpr (requires { Each::kStore; }) {
        if (all.indexOf(Each::kStore) == all.count) all.list[all.count++] = Each::kStore;
      }
    });
    return all;
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
