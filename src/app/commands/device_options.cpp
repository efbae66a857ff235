// The card's room gets its OpenGL context from here, because it must not know how one is made.
#include "app/commands/device_options.h"

#include <iostream>
#include <stdexcept>

#include "app/commands/command_options.h"
#include "app/commands/option_checks.h"
#include "gfx/contexts/compute_context.h"
#include "gpu/gpu_device.h"
#include "gpu/same_bits.h"
#include "tyg/input_error.h"
#include "tyg/methods.h"
#include "util/text.h"

namespace tyg {

void addDeviceOption(Command& command, DeviceOptions& options) {
  command
      .option(
          "--device", options.device,
          "What moves the cloth: the processor (cpu), or the graphics card (gpu), which needs OpenGL 4.3, computes in "
          "float and knows " +
              joined(gpuMethods()) + " [cpu]")
      .check([](const std::string& text) {
        return checkOneOf(text, {"cpu", "gpu"});
      })
      .typeName("cpu|gpu");
}

namespace {

OpenedContext openContext() {
  std::shared_ptr<ComputeContext> context = makeComputeContext();
  return {context, context->find()};
}

/// Null where the context that draws offers too little.
std::shared_ptr<GpuDevice> cardThatDraws(GlFinder drawing) {
  try {
    return drawing == nullptr ? nullptr : std::make_shared<GpuDevice>(drawing);
  } catch (const std::runtime_error&) {
    return nullptr;
  }
}

/// A window may be drawn by the processor on a machine that has a card: then the card computes beside it.
std::shared_ptr<GpuDevice> openCard(GlFinder drawing) {
  auto here = cardThatDraws(drawing);
  if (here && !here->isProcessor()) return here;
  try {
    auto other = std::make_shared<GpuDevice>(openContext);
    if (!here || !other->isProcessor()) return other;
  } catch (const std::runtime_error&) {
    if (!here) throw;
  }
  return here;
}

ChosenDevice compared(const std::shared_ptr<GpuDevice>& card, const Scene& scene, int threads) {
  const BitsCompared bits = compareBits(scene, findMethod(scene.integrator), card, threads);
  return {card,
          {.device = "gpu", .name = card->name(), .steps = bits.steps, .sameBits = bits.same, .strays = bits.strays}};
}

}  // namespace

OfferedCard offeredCard(const Scene& scene, int threads, GlFinder drawing) {
  const ChosenDevice chosen = compared(openCard(drawing), scene, threads);
  return {chosen.device, sentenceOn(chosen.report)};
}

ChosenDevice chosenDevice(const DeviceOptions& options, const Scene& scene, int threads, const std::string& command,
                          GlFinder drawing) {
  if (!options.asksForCard()) return {};
  try {
    ChosenDevice chosen = compared(openCard(drawing), scene, threads);
    if (!chosen.report.sameBits) std::cerr << command << ": " << sentenceOn(chosen.report) << std::endl;
    return chosen;
  } catch (const InputError&) {
    throw;
  } catch (const std::runtime_error& error) {
    std::cerr << command << ": no graphics card serves here: " << error.what() << "; the processor moves the cloth"
              << std::endl;
    return {};
  }
}

/// A study is of several methods; the comparison, of one that a card knows.
ChosenDevice deviceForStudy(const DeviceOptions& options, const Scene& scene, const std::string& command) {
  Scene compare = scene;
  compare.precision = Precision::Float;
  compare.integrator = "leapfrog";
  if (options.device.empty()) {
    try {
      const auto card = openCard(nullptr);
      if (card->isProcessor()) return {};
      ChosenDevice chosen = compared(card, compare, 1);
      return chosen.report.sameBits ? chosen : ChosenDevice{};
    } catch (const std::runtime_error&) {
      return {};
    }
  }
  ChosenDevice chosen = chosenDevice(options, compare, 1, command);
  if (chosen.report.sameBits) return chosen;
  std::cerr << command << ": errors would not be the card's, so the processor takes all runs" << std::endl;
  return {};
}

void takeFloatOnCard(Scene& scene, const DeviceOptions& options, bool precisionGiven) {
  if (options.asksForCard() && !precisionGiven) scene.precision = Precision::Float;
}

}  // namespace tyg
