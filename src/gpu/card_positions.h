// The positions of a sheet on the card as pictures are drawn from them. Must not know: what moves the sheet, what
// draws.
#pragma once

#include <memory>

#include "core/simulation/device_positions.h"
#include "gpu/card_buffer.h"
#include "gpu/card_sheet.h"

namespace tyg {

class CardPositions final : public DevicePositions {
 public:
  /// Of the sheet of a card that draws, as it is now.
  CardPositions(std::shared_ptr<Card> card, CardSheet& sheet, int count);

  [[nodiscard]] unsigned buffer() const override { return xyz_.name(); }
  [[nodiscard]] const std::array<float, 3>& low() const override { return low_; }
  [[nodiscard]] const std::array<float, 3>& high() const override { return high_; }
  void read(std::span<float> xyz) const override;

 private:
  std::shared_ptr<Card> card_;  // before the buffers, which go first
  CardBuffer xyz_;
  std::array<float, 3> low_{}, high_{};
};

}  // namespace tyg
