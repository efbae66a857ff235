// One sentence, so that summaries and messages say the same.
#include "app/reports/device_report.h"

#include <fmt/core.h>

#include "util/visible_text.h"

namespace tyg {

std::string sentenceOn(const DeviceReport& report) {
  if (report.device == "cpu") return "";
  const std::string card = "graphics card " + oneLine(report.name);
  const std::string after = fmt::format("after {} step{}", report.steps, report.steps == 1 ? "" : "s");
  if (report.sameBits) return fmt::format("{}: the same bits as the processor (compared {})", card, after);
  if (report.strays == 0) {
    return fmt::format("{}: the same bits as the processor for the cloth, but not for its energies (compared {})", card,
                       after);
  }
  return fmt::format("{}: not the same bits as the processor; {} a particle is {:.3g} m off", card, after,
                     report.strays);
}

}  // namespace tyg
