// The last ten seconds: any tick of them can be gone back to and on from, with the same bits, within the memory
// allowed.
#include "viewer/history.h"

#include <gtest/gtest.h>

#include <vector>

#include "app/reports/run_report.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

/// A cloth with two pushes and changes of the method and the step by hand, followed tick by tick.
class HistoryTest : public testing::Test {
 protected:
  static constexpr std::int64_t kTicks = 900;  // 1.7 s

  HistoryTest() {
    history_.begin(simulation_);
    hashes_.push_back(simulation_.hash());
    while (simulation_.ticks() < kTicks) {
      if (simulation_.ticks() % 400 == 100) simulation_.push(210, {0, 0, 5}, 50);
      if (simulation_.ticks() == 300) simulation_.useMethod(findMethod("leapfrog"));
      if (simulation_.ticks() == 600) simulation_.useStep(0.0015);
      history_.tick(simulation_, 1);
      hashes_.push_back(simulation_.hash());
    }
  }
  void goTo(std::int64_t tick) {
    history_.turnTo(simulation_, tick);
    history_.tick(simulation_, history_.target() - simulation_.ticks());
  }
  [[nodiscard]] std::uint64_t hashAt(std::int64_t tick) const { return hashes_.at(static_cast<std::size_t>(tick)); }

  Simulation simulation_{loadScene("curtain", methodNames()), findMethod("rk4"), {.threads = 1}};
  History history_;
  std::vector<std::uint64_t> hashes_;  // of every tick
};

TEST_F(HistoryTest, EveryMomentComesBackWithTheSameBits) {
  for (const std::int64_t tick : {899, 700, 601, 600, 599, 301, 300, 150, 101, 100, 1, 0, 450, 451, 899}) {
    goTo(tick);
    EXPECT_EQ(simulation_.ticks(), tick);
    EXPECT_EQ(simulation_.hash(), hashAt(tick)) << tick;
    EXPECT_TRUE(history_.past());
  }
}

TEST_F(HistoryTest, TheWayBackToTheNewestMomentEndsWhereItBegan) {
  simulation_.push(3, {1, 0, 0}, 20);  // to act from the next tick on
  const EventLog record = history_.record(simulation_);
  goTo(50);
  EXPECT_EQ(history_.record(simulation_), record);
  goTo(kTicks);
  EXPECT_FALSE(history_.past());
  EXPECT_EQ(history_.record(simulation_), record);
  EXPECT_EQ(simulation_.log().events, record.events);
}

TEST_F(HistoryTest, TicksInThePastDoAgainWhatWasDoneAndThenGoOn) {
  goTo(80);
  history_.tick(simulation_, kTicks - 80 + 25);
  EXPECT_FALSE(history_.past());
  EXPECT_EQ(simulation_.ticks(), kTicks + 25);
  Simulation again(loadScene("curtain", methodNames()), findMethod("rk4"), {.threads = 1});
  again.replay(simulation_.log(), methods());
  again.tick(kTicks + 25);
  EXPECT_EQ(again.hash(), simulation_.hash());
}

TEST_F(HistoryTest, GoingOnFromAPastMomentForgetsWhatCameAfter) {
  goTo(450);
  history_.cut(simulation_);
  history_.tick(simulation_, 10);
  EXPECT_FALSE(history_.past());
  const EventLog record = history_.record(simulation_);
  EXPECT_EQ(record.ticks, 460);
  EXPECT_EQ(record.events.size(), 2U);  // the push at 100, the method at 300
  goTo(455);
  goTo(kTicks);
  EXPECT_EQ(simulation_.ticks(), 460);
}

TEST_F(HistoryTest, ATimeFindsItsTick) {
  EXPECT_EQ(history_.tickAt(-1, simulation_), 0);
  EXPECT_EQ(history_.tickAt(0.5, simulation_), 250);                // in steps of 2 ms
  EXPECT_NEAR(history_.tickAt(1.2 + 0.075, simulation_), 650, 60);  // where the step changed nearby
  EXPECT_EQ(history_.tickAt(100, simulation_), kTicks);
}

TEST_F(HistoryTest, AMomentOutsideWhatIsKeptIsTheNearestOneInside) {
  goTo(-5);
  EXPECT_EQ(simulation_.ticks(), 0);
  goTo(10 * kTicks);
  EXPECT_EQ(simulation_.ticks(), kTicks);
}

TEST(History, KeepsTenSecondsAndNotMuchMore) {
  Simulation simulation(loadScene("spring", methodNames()), findMethod("leapfrog"), {.threads = 1});
  History history;
  history.begin(simulation);
  while (simulation.time() < 25) history.tick(simulation, 7);
  EXPECT_LE(history.first().time, simulation.time() - History::kSeconds);
  EXPECT_GT(history.first().time, simulation.time() - History::kSeconds - 1);
}

TEST(History, TakesNoMoreMemoryThanItMay) {
  for (const std::size_t copies : {5, 12, 30}) {
    Simulation simulation(loadScene("curtain", methodNames()), findMethod("leapfrog"), {.threads = 1});
    const std::size_t allowed = copies * simulation.save().bytes();
    History history(allowed);
    history.begin(simulation);
    while (simulation.time() < 15) {
      history.tick(simulation, 5);
      ASSERT_LE(history.bytes(), allowed);
    }
    EXPECT_LE(history.first().time, simulation.time() - History::kSeconds);
    history.turnTo(simulation, history.first().ticks);
    EXPECT_EQ(simulation.ticks(), history.first().ticks);
  }
}

}  // namespace
}  // namespace tyg
