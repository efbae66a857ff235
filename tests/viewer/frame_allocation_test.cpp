// The frame loop allocates nothing, but for a copy of the cloth every quarter of a simulated second.
#include <gtest/gtest.h>

#include "counted_allocations.h"
#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

TEST_F(ViewerTest, AFrameAllocatesNothingButForTheCopiesOfTheLastSeconds) {
  tap(' ');
  press('W');  // the camera moves too
  frames(60);  // the first frames may set up what a scene needs
  const double from = viewer_.run().shown().time();
  int allocating = 0;
  for (int frame = 0; frame < 120; ++frame) {
    const long before = allocations;
    frames(1);
    if (allocations != before) ++allocating;
  }
  EXPECT_GT(viewer_.run().shown().time(), from + 1);
  EXPECT_LE(allocating, 1 + int((viewer_.run().shown().time() - from) / 0.25));
}

}  // namespace
}  // namespace tyg
