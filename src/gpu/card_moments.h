// What acts on a sheet at some moments and changes with time: winds with their gusts, and bodies where they are.
// Must not know: what the moments are of.
#pragma once

#include <array>
#include <vector>

#include "core/forces/terms/all_terms.h"
#include "gpu/card_buffer.h"

namespace tyg {

/// As kernels/air.glsl and kernels/contact.glsl expect it, in the precision in which they compute.
template <class T>
struct CardMoments {
  struct Moment {
    std::array<T, 3> steadyWind{};  ///< m/s
    int firstGust = 0, endGust = 0, firstSolid = 0, endSolid = 0;
  };
  AllTerms::Numbers<T> numbers{};  ///< what does not change with time
  std::vector<T> gusts, solids;    ///< of all moments
  std::vector<Moment> moments;     ///< in order

  /// The next moment; what the terms know of it is worked out by themselves.
  void add(const AllTerms::Numbers<T>& now);
};

/// The same on the card.
template <class T>
class MomentsOnCard {
 public:
  explicit MomentsOnCard(Card& card);
  void write(CardMoments<T> moments);
  [[nodiscard]] const CardMoments<T>& moments() const { return moments_; }
  /// Tells a program in use of one of the moments.
  void tell(Kernel& kernel, std::size_t moment) const;

 private:
  CardBuffer gusts_, solids_;
  CardMoments<T> moments_;
};

}  // namespace tyg
