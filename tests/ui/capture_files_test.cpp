// Files that the window keeps: numbered, complete, and good for doing a run again.
#include "ui/capture_files.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "files.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {
namespace {

class CaptureFilesTest : public testing::Test {
 protected:
  static Picture picture(int width, int height) {
    return {width, height, std::vector<std::uint8_t>(4 * std::size_t(width) * std::size_t(height), 200)};
  }
  const Folder folder_;
  CaptureFiles files_{folder_.path()};
};

TEST_F(CaptureFilesTest, AKeptRunDoneAgainEndsInTheSameBits) {
  const Scene scene = loadScene("curtain");
  Simulation live(scene, findMethod("rk4"), {.threads = 1});
  live.tick(40), live.push(190, {0, 0, 3}, 20), live.tick(10), live.useMethod(findMethod("leapfrog"));
  live.useStep(0.001), live.tick(50);
  EventLog log = live.log();
  log.ticks = live.ticks();
  files_.keep(picture(4, 4), log.sceneText, log);

  const Scene kept = parseScene(contentsOf(folder_ / "tyg-curtain-1.toml"), "kept", methodNames());
  Simulation again(kept, findMethod(kept.integrator), {.threads = 1});
  again.replay(parseEventLog(contentsOf(folder_ / "tyg-curtain-1.csv"), "kept"), methods());
  again.tick(100);
  EXPECT_EQ(again.hash(), live.hash());
}

TEST_F(CaptureFilesTest, NothingIsOverwritten) {
  const Scene scene = loadScene("curtain");
  const Simulation live(scene, findMethod("rk4"), {.threads = 1});
  folder_.write("tyg-curtain-1.mp4", "mine");
  const std::string said = files_.keep(picture(4, 4), live.log().sceneText, live.log());
  EXPECT_NE(said.find("tyg-curtain-2.png"), std::string::npos) << said;
  EXPECT_EQ(contentsOf(folder_ / "tyg-curtain-1.mp4"), "mine");
  EXPECT_EQ(readPicture(folder_ / "tyg-curtain-2.png").width, 4);
}

TEST_F(CaptureFilesTest, AFolderThatIsGoneIsAnError) {
  const Scene scene = loadScene("curtain");
  const Simulation live(scene, findMethod("rk4"), {.threads = 1});
  std::filesystem::remove_all(folder_.path());
  EXPECT_THROW(files_.keep(picture(4, 4), live.log().sceneText, live.log()), InputError);
}

TEST_F(CaptureFilesTest, AMovieKeepsTheRhythmOfTheClockAndEndsWhenTheWindowChangesItsSize) {
  if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  files_.beginMovie("curtain", 65, 49);
  EXPECT_TRUE(files_.film(picture(65, 49), 10.0).empty());
  EXPECT_TRUE(files_.film(picture(65, 49), 10.5).empty());
  EXPECT_NEAR(files_.filmed(), 0.5, 1 / CaptureFiles::kFramesPerSecond);
  EXPECT_TRUE(files_.film(picture(80, 60), 10.6).empty());
  EXPECT_TRUE(files_.finishing());
  EXPECT_THROW(files_.beginMovie("curtain", 80, 60), InputError) << "one at a time";
  const std::string said = files_.awaitMovie([] { return false; });
  EXPECT_NE(said.find("tyg-curtain-1.mp4"), std::string::npos) << said;
  EXPECT_FALSE(files_.filming());
  EXPECT_GT(std::filesystem::file_size(folder_ / "tyg-curtain-1.mp4"), 100U);
}

TEST_F(CaptureFilesTest, AnFfmpegThatHangsIsNotWaitedFor) {
  const Folder bin;
  const auto path = bin.write("ffmpeg", "#!/bin/sh\nexec sleep 1000\n");
  std::filesystem::permissions(path, std::filesystem::perms::owner_all);
  setenv("PATH", (bin.path().string() + ":" + std::getenv("PATH")).c_str(), 1);
  files_.beginMovie("curtain", 640, 480);
  for (int frame = 0; frame < 100; ++frame) EXPECT_TRUE(files_.film(picture(640, 480), frame / 10.0).empty());
  EXPECT_TRUE(files_.endMovie().empty());
  EXPECT_TRUE(files_.movieDone().empty()) << "not yet";
  EXPECT_NE(files_.awaitMovie([] { return true; }).find("given up"), std::string::npos);
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(CaptureFilesTest, AMovieThatIsNotEndedLeavesNoFile) {
  if (!haveFfmpeg()) GTEST_SKIP() << "ffmpeg is not installed";
  {
    CaptureFiles files(folder_.path());
    files.beginMovie("curtain", 64, 48);
    (void)files.film(picture(64, 48), 0);
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

}  // namespace
}  // namespace tyg
