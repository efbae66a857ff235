// Where the particles of a sheet are, for whoever draws it. Must not know: how it is drawn, who computed them.
#pragma once

#include <functional>
#include <span>
#include <utility>

namespace tyg {

/// In memory, or in a buffer of the OpenGL context that draws, from where they are read only where somebody asks.
class DrawnPositions {
 public:
  using Reader = std::function<std::span<const float>()>;

  explicit DrawnPositions(std::span<const float> xyz) : xyz_(xyz) {}
  /// `buffer` holds what `read` gives.
  DrawnPositions(unsigned buffer, Reader read) : buffer_(buffer), read_(std::move(read)) {}

  /// The name of the buffer; 0: they are in memory.
  [[nodiscard]] unsigned buffer() const { return buffer_; }
  /// x, y, z of each particle, m.
  [[nodiscard]] std::span<const float> xyz() const { return read_ ? read_() : xyz_; }

 private:
  std::span<const float> xyz_;
  unsigned buffer_ = 0;
  Reader read_;
};

}  // namespace tyg
