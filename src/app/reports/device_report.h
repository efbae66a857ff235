// What moved the cloth, for summaries and JSON. Must not know: how it was chosen.
#pragma once

#include <string>

namespace tyg {

struct DeviceReport {
  std::string device = "cpu";  ///< as --device has it
  std::string name{};          ///< of a graphics card, as its driver calls it
  int steps = 0;               ///< that were compared
  bool sameBits = true;        ///< as the processor, in the steps that were compared
  double strays = 0;           ///< m, after these steps, where they are not the same; 0 where only energies are not
};

/// One sentence about a graphics card; empty for the processor.
std::string sentenceOn(const DeviceReport& report);

}  // namespace tyg
