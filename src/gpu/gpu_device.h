// The graphics card as a device that moves cloth, with the same bits as the processor: a few methods, in float.
// Must not know: OpenGL's contexts, windows, the command line.
#pragma once

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "core/simulation/device.h"
#include "gpu/opened_context.h"

namespace tyg {

class Card;

class GpuDevice final : public Device {
 public:
  /// Throws std::runtime_error that says why there is no OpenGL 4.3 here.
  explicit GpuDevice(const ContextOpener& open);
  /// The same in the context that is current in this thread. Pictures are drawn there from the positions as they were
  /// computed. To be used, and destroyed with all that it made, in this thread while the context is there.
  explicit GpuDevice(GlFinder find);
  ~GpuDevice() override;

  [[nodiscard]] std::unique_ptr<Integrator<float>> make(const Method& method, const Scene& scene,
                                                        const Sheet& sheet) override;
  /// What its driver calls it.
  [[nodiscard]] const std::string& name() const;
  /// Whether the driver lets the processor do the work of a card.
  [[nodiscard]] bool isProcessor() const;
  /// So far, from the card's memory to the processor's.
  [[nodiscard]] std::size_t bytesRead() const;

 private:
  std::shared_ptr<Card> card_;
};

/// The names of the methods that it knows.
std::vector<std::string_view> gpuMethods();

}  // namespace tyg
