// Only six numbers come back at once; they also tell whether all others are finite.
#include "gpu/card_positions.h"

#include <bit>
#include <cstdint>
#include <utility>

namespace tyg {
namespace {

/// Undoes inOrder() of kernels/gather.glsl.
float fromOrder(std::uint32_t order) {
  constexpr std::uint32_t kSign = 0x80000000;
  return std::bit_cast<float>((order & kSign) != 0 ? order & ~kSign : ~order);
}

}  // namespace

CardPositions::CardPositions(std::shared_ptr<Card> card, CardSheet& sheet, int count)
    : card_(std::move(card)), xyz_(*card_) {
  card_->run([&] {
    constexpr std::uint32_t kMost = 0xffffffff;
    std::array<std::uint32_t, 6> extremes{kMost, kMost, kMost, 0, 0, 0};
    CardBuffer onCard(*card_);
    onCard.write(extremes.data(), sizeof extremes);
    xyz_.reserve(3 * sizeof(float) * std::size_t(count));
    sheet.gather(xyz_, onCard);
    onCard.read(extremes.data(), sizeof extremes);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      low_.at(axis) = fromOrder(extremes.at(axis)), high_.at(axis) = fromOrder(extremes.at(axis + 3));
    }
    card_->refuseErrors();
  });
}

void CardPositions::read(std::span<float> xyz) const {
  card_->run([&] { xyz_.read(xyz.data(), xyz.size_bytes()); });
}

}  // namespace tyg
