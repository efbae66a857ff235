// --device: the processor or the graphics card. Must not know: what is done with it.
#pragma once

#include <memory>
#include <string>

#include "app/reports/device_report.h"
#include "gpu/opened_context.h"
#include "tyg/scene.h"
#include "viewer/card_offer.h"

namespace tyg {

class Command;
class Device;

struct DeviceOptions {
  std::string device = "cpu";  ///< or `gpu`
  [[nodiscard]] bool asksForCard() const { return device == "gpu"; }
};
/// Adds --device to a command. `options` must live as long as `command`.
void addDeviceOption(Command& command, DeviceOptions& options);

/// What is to move the cloth.
struct ChosenDevice {
  std::shared_ptr<Device> device;  ///< null: the processor
  DeviceReport report;
};
/// The graphics card, compared with the processor on this scene's first steps, where it is asked for and there; where
/// there is none, says so on standard error and takes the processor. Throws InputError where the card does not take the
/// scene. `command` is what the message begins with. `drawing` finds the functions of the OpenGL context that is
/// current and draws; the card computes in there where that is as good as any other one.
ChosenDevice chosenDevice(const DeviceOptions& options, const Scene& scene, int threads, const std::string& command,
                          GlFinder drawing = nullptr);
/// The same for a study, whose errors are the processor's: a card with other bits is not taken. Where nothing was
/// chosen (an empty DeviceOptions::device), a real card is taken in silence, and a processor that stands in for one is
/// not.
ChosenDevice deviceForStudy(const DeviceOptions& options, const Scene& scene, const std::string& command);
/// The graphics card computes in float, which is what it is asked for where nobody said `double`.
void takeFloatOnCard(Scene& scene, const DeviceOptions& options, bool precisionGiven);

/// The same for the window, where somebody asks for the card. Throws std::runtime_error where none serves.
OfferedCard offeredCard(const Scene& scene, int threads, GlFinder drawing);

}  // namespace tyg
