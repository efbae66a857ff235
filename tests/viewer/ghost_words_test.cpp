// What the ghost panel says.
#include "viewer/ghost_words.h"

#include <gtest/gtest.h>

#include "tyg/methods.h"

namespace tyg {
namespace {

bool says(const Sentence& sentence, const char* words) { return sentence.text.find(words) != std::string::npos; }

/// Undamped and thrown into folds: what is a billionth of the size at the start is seen soon.
Simulation chaos() {
  Scene scene = loadScene("poke", methodNames());
  scene.structural = {6000, 0}, scene.shear = {2000, 0}, scene.bend = {0, 0};
  scene.gravity = {0, 3, -9};
  scene.dt = 0.001;
  scene.columns = scene.rows = 8;
  return {scene, findMethod("leapfrog"), {.threads = 1}};
}
double stillClock() { return 0; }

TEST(GhostWords, OfADistanceThatNeverMeantAnythingNameNoHorizonAndWriteLengthsOut) {
  Simulation live = chaos();
  live.tick(6000);
  Ghost ghost(live, nullptr);
  ghost.follow(live, 1e9, stillClock);
  const Sentence meaning = meaningWords(ghost);
  EXPECT_TRUE(says(meaning, "Since they first met, at 6.00 s, the distance has never been")) << meaning.text;
  EXPECT_FALSE(says(meaning, "horizon"));
  EXPECT_TRUE(says(meaning, "mm by now)") || says(meaning, " m by now)")) << meaning.text;
  EXPECT_EQ(meaning.text.find("e+"), std::string::npos) << meaning.text;
  Simulation still = chaos();
  Ghost early(still, nullptr);
  for (early.follow(still, 1e9, stillClock); still.time() < 3; early.follow(still, 1e9, stillClock)) still.tick(3000);
  EXPECT_EQ(meaningWords(early).text.rfind("The distance has never been", 0), 0U) << meaningWords(early).text;
}

TEST(GhostWords, TellCatchingUpFromBeingTooSlow) {
  Simulation live = chaos();
  Ghost ghost(live, nullptr);
  double now = 0;
  const auto slowMachine = [&now] { return now += 0.1; };
  live.tick(1000);
  ghost.follow(live, 0.05, slowMachine);
  EXPECT_TRUE(says(progressWords(ghost), "catching up: at 0.01 s of 1.00 s")) << progressWords(ghost).text;
  EXPECT_TRUE(says(distanceWords(ghost), "not ready yet"));
  for (int frame = 0; frame < 30; ++frame) live.tick(100), ghost.follow(live, 0.05, slowMachine);
  EXPECT_TRUE(says(progressWords(ghost), "cannot compute both")) << progressWords(ghost).text;
  ghost.follow(live, 1e9, stillClock);
  EXPECT_EQ(progressWords(ghost).text, "");
  EXPECT_TRUE(says(distanceWords(ghost), "RMS"));
}

}  // namespace
}  // namespace tyg
