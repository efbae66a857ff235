// Motions that another program wrote, opened in the window: what is shown of them, what is found out, what is refused.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

#include "files.h"
#include "own_program.h"
#include "viewer/opened_file.h"
#include "viewer/review_words.h"
#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

using Stage = CheckProgress::Stage;
using Place = GivenGhost::Place;

constexpr double kStep = 0.002;  // s, of the program and of the cloth

Scene fourParticles() {
  Scene scene = loadScene("four-particles", methodNames());
  scene.integrator = "leapfrog", scene.dt = kStep;
  return scene;
}

class MotionReviewTest : public ViewerTest {
 protected:
  MotionReviewTest() : ViewerTest(fourParticles()) {}

  /// What a program with these mistakes writes: every tenth of a second from 0.1 s to 2 s.
  static std::string rows(std::vector<std::string> mistakes = {}) {
    return test::ownRows(test::OwnProgram(fourParticles(), std::move(mistakes), "leapfrog", kStep), kStep, 1000, 50);
  }
  void drop(const std::string& text, const std::string& name = "mine.csv") {
    viewer_.handle({.kind = Kind::Drop, .path = folder_.write(name, text).string()});
  }
  MotionReview& review() { return viewer_.review(); }
  /// Looks until the check has ended; far longer than any machine needs.
  const CheckProgress& ended() {
    for (int turn = 0; turn < 60000 && review().check().stage == Stage::Running; ++turn) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return review().check();
  }
  void runTo(double time) {
    while (viewer_.run().shown().time() < time) frames(1);
  }
  const Folder folder_;
};

TEST_F(MotionReviewTest, AMotionThatIsDroppedIsCheckedAndAsksForThePanelOnce) {
  drop(rows());
  ASSERT_TRUE(review().isOpen()) << viewer_.notes().text();
  EXPECT_EQ(review().name(), "mine.csv");
  EXPECT_EQ(viewer_.takeWantedPanel(), InputAction::OpenGhost);
  EXPECT_FALSE(viewer_.takeWantedPanel());
  const Sentence verdict = verdictSentence(ended());
  EXPECT_EQ(verdict.tone, Sentence::Tone::Good);
  EXPECT_TRUE(holds(verdict.text, "Right: your positions are those of leapfrog at 2 ms")) << verdict.text;
}

TEST_F(MotionReviewTest, AMistakeIsNamedWithItsCure) {
  drop(rows({"each spring applied twice"}));
  const Sentence verdict = verdictSentence(ended());
  EXPECT_EQ(verdict.tone, Sentence::Tone::Warning);
  EXPECT_TRUE(holds(verdict.text, "every spring applied twice")) << verdict.text;
  EXPECT_TRUE(holds(verdict.text, "Apply each spring once to each end.")) << verdict.text;
}

TEST_F(MotionReviewTest, WhatDoesNotFitIsRefusedWithWhatWasFoundAndTheMotionBeforeStays) {
  drop(rows());
  const int opened = review().opened();
  drop("t,particle,x,y,z\n1,0,0,0,0\n1,1,1,0,0\n1,2,0,1,0\n", "three.csv");
  EXPECT_TRUE(holds(viewer_.notes().text(), "three.csv: line 4: found 3 particles at t = 1 s, 3 is missing"))
      << viewer_.notes().text();
  drop("t;particle;x;y;z\n", "semicolons.csv");
  EXPECT_TRUE(holds(viewer_.notes().text(), "a comma between columns")) << viewer_.notes().text();
  EXPECT_TRUE(viewer_.notes().warns());
  EXPECT_EQ(review().name(), "mine.csv");
  EXPECT_EQ(review().opened(), opened);
}

TEST_F(MotionReviewTest, AStoppedCheckSaysSoAndCanBeMadeAgain) {
  drop(rows({"damping reversed", "gravity doubled"}));
  review().stopCheck();
  EXPECT_EQ(review().check().stage, Stage::Stopped);
  EXPECT_TRUE(holds(verdictSentence(review().check()).text, "stopped"));
  review().checkAgain(viewer_.scenes().scene());
  EXPECT_EQ(review().check().stage, Stage::Running);
  EXPECT_EQ(ended().stage, Stage::Done);
}

TEST_F(MotionReviewTest, TheDistanceIsMeasuredAtTheSamplesAndIsRoundingForTheSameMethod) {
  drop(rows());
  tap(' ');
  for (double time = 0.1; time < 1.9; time += 0.1) {
    runTo(time + 0.05);
    ASSERT_TRUE(review().ghost().gap());
    EXPECT_NEAR(review().ghost().gap()->time, time, 1e-9);
    EXPECT_LT(review().ghost().gap()->largest, 1e-11);
  }
  EXPECT_EQ(gapWords(review().ghost()).text, "distance at 1.800 s: none but by rounding");
}

TEST_F(MotionReviewTest, TheDistanceOfAnotherMotionIsSaidWithItsTime) {
  drop(rows({"gravity doubled"}));
  EXPECT_EQ(gapWords(review().ghost()).text, "distance: measured at the motion's samples");
  tap(' ');
  runTo(0.25);
  const SampleGap gap = review().ghost().gap().value();
  EXPECT_GT(gap.rms, 0.01);
  EXPECT_GE(gap.largest, gap.rms);
  EXPECT_TRUE(gapWords(review().ghost()).text.starts_with("distance at 0.200 s: ")) << gapWords(review().ghost()).text;
  const std::span<const float> distances = review().ghost().distances();
  EXPECT_FLOAT_EQ(*std::ranges::max_element(distances), float(gap.largest));
}

TEST_F(MotionReviewTest, BetweenItsSamplesItMovesOnASmoothCurveThroughThem) {
  drop(rows());
  tap(' ');
  double farthest = 0;
  while (viewer_.run().shown().time() < 1.8) {
    frames(1);
    const std::span<const float> here = viewer_.run().shown().positions(), there = review().ghost().positions();
    if (review().ghost().place() != Place::Within) continue;
    for (std::size_t i = 0; i < here.size(); ++i) farthest = std::max(farthest, double(std::abs(here[i] - there[i])));
  }
  constexpr double kTenthOfASecond = 5e-3;  // m: at 9 1/s a tenth of a second is a seventh of a swing of 0.1 m
  EXPECT_LT(farthest, kTenthOfASecond);
  EXPECT_GT(farthest, 0);
}

TEST_F(MotionReviewTest, BeforeItsFirstSampleItIsHiddenAndAfterItsLastOneHeld) {
  drop(rows());
  EXPECT_EQ(review().ghost().place(), Place::Before);
  EXPECT_EQ(placeWords(review()).text, "mine.csv begins at 100 ms and is not shown before.");
  tap(' ');
  runTo(1);
  EXPECT_EQ(review().ghost().place(), Place::Within);
  EXPECT_EQ(placeWords(review()).text, "");
  runTo(2.1);
  EXPECT_EQ(review().ghost().place(), Place::After);
  EXPECT_EQ(placeWords(review()).text, "mine.csv ended at 2 s: its last positions are shown.");
  const auto last = std::vector<float>(review().ghost().positions().begin(), review().ghost().positions().end());
  EXPECT_FLOAT_EQ(last[9], float(review().ghost().motion().positions.back()[3].x));
}

TEST_F(MotionReviewTest, ANewStartForgetsTheDistanceAndAnotherSheetClosesTheMotion) {
  drop(rows());
  tap(' ');
  runTo(0.5);
  tap('R');
  ASSERT_TRUE(review().isOpen());
  EXPECT_FALSE(review().ghost().gap());
  viewer_.scenes().use(curtain());
  EXPECT_FALSE(review().isOpen());
  EXPECT_TRUE(holds(viewer_.notes().text(), "mine.csv: found 4 particles; allowed: the 20 x 20 of curtain"))
      << viewer_.notes().text();
}

TEST_F(MotionReviewTest, AChangeOfTheSceneIsToldAndOfTheMethodIsNot) {
  drop(rows());
  Scene wanted = viewer_.scenes().scene();
  wanted.integrator = "rk4", wanted.dt = 0.01;
  viewer_.scenes().use(wanted);
  EXPECT_EQ(otherSceneWords(review(), viewer_.scenes().scene()).text, "");
  wanted.gravity.y = -1.62;
  viewer_.scenes().use(wanted);
  EXPECT_FALSE(otherSceneWords(review(), viewer_.scenes().scene()).text.empty());
  review().checkAgain(viewer_.scenes().scene());
  EXPECT_EQ(otherSceneWords(review(), viewer_.scenes().scene()).text, "");
}

TEST(OpenedFile, IsALogByItsFirstLinesAMotionByItsEndingAndElseAScene) {
  const Folder folder;
  const auto kindOf = [&](const char* name, const char* text) {
    return readOpened(folder.write(name, text).string()).kind;
  };
  EXPECT_EQ(kindOf("run.csv", "# version = 2\ntick,event,...\n"), OpenedFile::Kind::Log);
  EXPECT_EQ(kindOf("mine.CSV", "t,particle,x,y,z\n"), OpenedFile::Kind::Motion);
  EXPECT_EQ(kindOf("cloth.toml", "title = \"Mine\"\n"), OpenedFile::Kind::Scene);
  EXPECT_THROW(readOpened((folder / "missing.csv").string()), InputError);
}

TEST(OpenedFile, ListsWhatCanBeOpenedAndReadsPathsAsTheyArePasted) {
  const Folder folder;
  for (const char* name : {"b.csv", "a.toml", "notes.txt", ".hidden.csv"}) folder.write(name, "");
  EXPECT_EQ(openableFiles(folder.path()), (std::vector<std::string>{"a.toml", "b.csv"}));
  EXPECT_TRUE(openableFiles(folder / "missing").empty());
  EXPECT_EQ(typedPath(" '/home/me/my file.csv'\n"), "/home/me/my file.csv");
  EXPECT_EQ(typedPath("  "), "");
}

}  // namespace
}  // namespace tyg
