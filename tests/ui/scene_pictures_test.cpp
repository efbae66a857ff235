// Pictures of all scenes: made a little at a time, and drawn in a real context.
#include "ui/panels/scene_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "gfx/contexts/offscreen.h"

namespace tyg {
namespace {

/// A clock that a look at makes a millisecond later: work ends after a known number of looks.
ScenePictures::Clock tickingClock(double& now) {
  return [&now] { return now += 1e-3; };
}

TEST(ScenePictures, StopWhenTheirTimeIsOverAndGoOnWhereTheyWere) {
  ScenePictures pictures(64, 40);
  double now = 0;
  int turns = 0;
  while (!pictures.finished() && turns < 10000) pictures.work(3e-3, tickingClock(now), Background::Dark), ++turns;
  EXPECT_TRUE(pictures.finished());
  EXPECT_GT(turns, int(pictures.entries().size()));
  for (const auto& entry : pictures.entries()) {
    EXPECT_TRUE(entry.simulated) << entry.scene.name;
    EXPECT_TRUE(entry.trouble.empty()) << entry.scene.name << ": " << entry.trouble;
  }
}

TEST(ScenePictures, EachSceneHasAPictureOfItsOwnOnBothGrounds) {
  const auto offscreen = makeOffscreen(64, 64);
  ScenePictures pictures(96, 60);
  double now = 0;
  const auto make = [&](Background background) {
    do pictures.work(1, tickingClock(now), background);
    while (!pictures.finished());
    std::set<unsigned> names;
    for (const auto& entry : pictures.entries()) {
      ASSERT_TRUE(entry.picture) << entry.scene.name << ": " << entry.trouble;
      EXPECT_EQ(entry.drawnOn, background) << entry.scene.name;
      names.insert(entry.picture->name());
    }
    EXPECT_EQ(names.size(), pictures.entries().size());
  };
  make(Background::Dark);
  make(Background::Light);
}

}  // namespace
}  // namespace tyg
