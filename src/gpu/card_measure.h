// The energies of a sheet on the card and the powers in it, with the processor's bits: rows are summed up there, and
// the sums of the rows here. Must not know: methods.
#pragma once

#include <vector>

#include "core/simulation/device_state.h"
#include "gpu/card_moments.h"
#include "gpu/card_sheet.h"

namespace tyg {

/// Made, used and destroyed in the card's thread. What it measures is what the card's programs see as positions and
/// velocities at the time: see CardSheet::showState() and CardActing::afterPass.
class CardMeasure {
 public:
  CardMeasure(Card& card, const CardSheet& sheet);

  /// To be called before what follows: the numbers of the moments that are measured, as Forces::energyNumbersAt() gives
  /// them.
  void use(CardMoments<double> moments) { moments_.write(std::move(moments)); }
  /// At the first moment.
  [[nodiscard]] StoredEnergy energy();
  /// Begins to work out the power at a moment. powers() waits for all of them, in order; pins are not counted.
  void beginPower(std::size_t moment);
  [[nodiscard]] std::vector<Power> powers();
  [[nodiscard]] DeviceState<float>::Largest largest();

 private:
  enum class Measured { Energy, Power };
  Kernel& kernelOf(Measured what);
  void run(Kernel& kernel, std::size_t moment);

  Card& card_;
  const CardSheet& sheet_;
  MomentsOnCard<double> moments_;
  CardBuffer rows_, largest_;
};

}  // namespace tyg
