// Methods, steps and scenes that are chosen while a cloth runs, without a window.
#include <gtest/gtest.h>

#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

TEST_F(ViewerTest, NumberKeysChangeTheMethodOfTheRunningCloth) {
  tap(' ');
  frames(3);
  for (std::size_t place = 0; place < 5; ++place) {
    tap(static_cast<KeyCode>('1' + place));
    EXPECT_EQ(&viewer_.run().simulation().method(), &methods()[place]);
  }
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
}

TEST_F(ViewerTest, ANumberWithoutAMethodChangesNothing) {
  const Method* before = &viewer_.scenes().method();
  tap('0');
  EXPECT_EQ(methods().size() > 9, before != &viewer_.scenes().method());
}

TEST_F(ViewerTest, RestartKeepsTheChosenMethod) {
  tap('4');
  tap('R');
  EXPECT_EQ(viewer_.run().simulation().method().name, "leapfrog");
}

TEST_F(ViewerTest, ARecordOfAnEditedSceneCarriesItAsItWasEdited) {
  Scene edited = curtain();
  edited.precision = Precision::Float;
  viewer_.scenes().use(edited);
  tap('4');
  edited = viewer_.scenes().scene();
  edited.structural.kd = 0.4;
  viewer_.scenes().use(edited);
  tap(' ');
  frames(20);
  edited.gravity = {0, -1.62, 0};
  viewer_.scenes().use(edited);
  frames(20);
  const EventLog log = parseEventLog(formatEventLog(viewer_.run().record()), "record");
  const Scene scene = parseScene(log.sceneText, "record", methodNames());
  Simulation again(scene, findMethod(log.integrator), {.threads = 1});
  again.replay(log, methods());
  again.tick(log.ticks);
  EXPECT_EQ(again.hash(), viewer_.run().simulation().hash());
  EXPECT_NE(scene, curtain());
}

TEST_F(ViewerTest, BracketsChangeTheStepAtOnceAndARestartKeepsIt) {
  const double dt = viewer_.run().simulation().dt();
  tap(' ');
  frames(3);
  tap(']'), tap(']');
  EXPECT_NEAR(viewer_.run().simulation().dt(), dt * 1.05 * 1.05, 1e-12);
  tap('['), tap('['), tap('[');
  const double smaller = viewer_.run().simulation().dt();
  EXPECT_NEAR(smaller, dt / 1.05, 1e-12);
  tap('R');
  EXPECT_EQ(viewer_.run().simulation().dt(), smaller);
}

TEST_F(ViewerTest, ASafeStepIsNineTenthsOfTheLimitWhereNothingFailed) {
  frames(1);
  for (int k = 0; k < 2; ++k) {
    tap('V'), frames(1);
    EXPECT_NEAR(viewer_.run().simulation().dt(), 0.9 * viewer_.run().margin().limit,
                0.05 * viewer_.run().margin().limit);
  }
  tap('M');
  EXPECT_EQ(viewer_.scenes().method().name, "rk4") << "a method that holds is a way out of a failure";
}

}  // namespace
}  // namespace tyg
