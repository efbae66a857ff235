// One sentence, so that summaries and messages say the same.
#include "app/reports/device_report.h"

#include <fmt/core.h>

#include "gpu/same_bits.h"
#include "util/visible_text.h"

namespace tyg {

std::string sentenceOn(const DeviceReport& report) {
  if (report.device == "cpu") return "";
  const std::string card = "graphics card " + oneLine(report.name);
  if (report.sameBits) {
    return fmt::format("{}: the same bits as the processor (compared after {} steps)", card, kStepsCompared);
  }
  if (report.strays == 0) {
    return fmt::format(
        "{}: the same bits as the processor for the cloth, but not for its energies (compared after {} steps)", card,
        kStepsCompared);
  }
  return fmt::format("{}: not the same bits as the processor; after {} steps a particle is {:.3g} m off", card,
                     kStepsCompared, report.strays);
}

}  // namespace tyg
