// Scenes and logs that are dropped onto the window.
#include <gtest/gtest.h>

#include "files.h"
#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

class DroppedFilesTest : public ViewerTest {
 protected:
  void drop(const std::filesystem::path& file) { viewer_.handle({.kind = Kind::Drop, .path = file.string()}); }
  const Folder folder_;
};

TEST_F(DroppedFilesTest, ASceneIsOpened) {
  folder_.write("tiny.toml", R"(title = "Tiny"
sheet = { columns = 3, rows = 2, spacing = 0.1, particle_mass = 0.01, pins = ["top-left"] }
springs = { structural = { ks = 100, kd = 0.1 } }
run = { duration = 1, integrator = "rk4", dt = 0.002 })");
  drop(folder_ / "tiny.toml");
  EXPECT_EQ(viewer_.run().simulation().sheet().columns, 3) << viewer_.notes().text();
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
}

TEST_F(DroppedFilesTest, ALogIsPlayedUpToItsEndWithTheSameBitsAndCanBeGoneBackIn) {
  tap(' '), frames(60);
  pressOnCloth(), moveTo(placeOf(210) + glm::dvec2(60, -40));
  frames(30);
  release(kLeftButton);
  tap('['), frames(30);
  const EventLog log = viewer_.run().record();
  folder_.write("run.csv", formatEventLog(log));
  tap('R');
  drop(folder_ / "run.csv");
  EXPECT_EQ(viewer_.run().state(), RunState::Running) << viewer_.notes().text();
  const double end = viewer_.run().timeline().newest;
  for (int frame = 0; frame < 600 && viewer_.run().state() == RunState::Running; ++frame) frames(1);
  EXPECT_EQ(viewer_.run().state(), RunState::Paused);
  EXPECT_EQ(viewer_.run().simulation().ticks(), log.ticks);
  EXPECT_NEAR(viewer_.run().simulation().time(), end, 1e-9);
  EXPECT_EQ(hashText(viewer_.run().simulation()), log.hash);
  EXPECT_EQ(viewer_.scenes().scene().dt, viewer_.run().simulation().dt());
  viewer_.run().turnToTime(end / 2);
  frames(30);
  EXPECT_NEAR(viewer_.run().shown().time(), end / 2, 0.01);
}

TEST_F(DroppedFilesTest, WhatIsNeitherIsToldAndChangesNothing) {
  folder_.write("words.txt", "hello");
  drop(folder_ / "words.txt");
  EXPECT_FALSE(viewer_.notes().text().empty());
  drop(folder_ / "missing.toml");
  EXPECT_FALSE(viewer_.notes().text().empty());
  EXPECT_EQ(viewer_.run().simulation().sheet().columns, 20);
}

}  // namespace
}  // namespace tyg
