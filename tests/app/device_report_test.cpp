// What people read about the device that moved the cloth.
#include "app/reports/device_report.h"

#include <gtest/gtest.h>

namespace tyg {
namespace {

TEST(SentenceOnADevice, SaysWhetherItsBitsAreTheProcessors) {
  EXPECT_EQ(sentenceOn({}), "");
  DeviceReport report{.device = "gpu", .name = "a card", .steps = 64};
  EXPECT_EQ(sentenceOn(report), "graphics card a card: the same bits as the processor (compared after 64 steps)");
  report.sameBits = false;
  EXPECT_EQ(sentenceOn(report),
            "graphics card a card: the same bits as the processor for the cloth, but not for its energies (compared "
            "after 64 steps)");
  report.strays = 0.0125;
  EXPECT_EQ(sentenceOn(report),
            "graphics card a card: not the same bits as the processor; after 64 steps a particle is 0.0125 m off");
}

}  // namespace
}  // namespace tyg
