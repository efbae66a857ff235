// `tyg render` as people use it: pictures, sequences, refusals.
#include <gtest/gtest.h>

#include "app/program.h"
#include "gfx/picture.h"

namespace tyg {
namespace {

TEST(Render, DrawsAPictureThatShowsTheCloth) {
  const Folder folder;
  const auto file = folder / "curtain.png";
  const Outcome outcome = tyg("render curtain --at 0.3 --size 320x200 --out " + file.string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const Picture picture = readPicture(file);
  EXPECT_EQ(picture.width, 320);
  EXPECT_EQ(picture.height, 200);
  int blue = 0;  // the springs' colour; neither sky nor ground comes near it
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) blue += picture.rgba[i + 2] > picture.rgba[i] + 40 ? 1 : 0;
  EXPECT_GT(blue, 1500);
}

TEST(Render, WritesOnePicturePerFrameIntoAFolder) {
  const Folder folder;
  const auto frames = folder / "frames";
  const Outcome outcome = tyg("render flag --from 0 --to 0.2 --fps 10 --size 160x100 --out " + frames.string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(std::filesystem::exists(frames / "frame_00000.png"));
  EXPECT_TRUE(std::filesystem::exists(frames / "frame_00002.png"));
  EXPECT_FALSE(std::filesystem::exists(frames / "frame_00003.png"));
  EXPECT_NE(contentsOf(frames / "frame_00000.png"), contentsOf(frames / "frame_00002.png")) << "nothing moved";
}

TEST(Render, TheSameMomentGivesTheSameBytes) {
  const Folder folder;
  for (const char* name : {"a.png", "b.png"}) tyg("render poke --size 160x100 --out " + (folder / name).string());
  EXPECT_EQ(contentsOf(folder / "a.png"), contentsOf(folder / "b.png"));
  EXPECT_FALSE(contentsOf(folder / "a.png").empty());
}

TEST(Render, AFailedSimulationLeavesNoFileAndSaysWhy) {
  const Folder folder;
  const Outcome outcome =
      tyg("render curtain --integrator rk4 --dt 0.05 --at 1.5 --out " + (folder / "lost.png").string());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(holds(outcome.err, "rk4")) << outcome.err;
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(Render, RefusesOutputsThatDoNotFitBeforeItComputes) {
  const Folder folder;
  EXPECT_EQ(tyg("render curtain --at 1 --out " + (folder / "a.mp4").string()).code, 2);
  EXPECT_EQ(tyg("render curtain --from 0 --to 1 --out " + (folder / "a.png").string()).code, 2);
  EXPECT_EQ(tyg("render curtain --at 1 --from 0 --out " + (folder / "a.png").string()).code, 2);
  EXPECT_EQ(tyg("render curtain --out /nowhere/a.png").code, 2);
  EXPECT_EQ(tyg("render curtain --size 0x5").code, 2);
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(Render, MakesAMovie) {
  const Folder folder;
  const Outcome outcome = tyg("render curtain --from 0 --to 0.1 --size 64x48 --out " + (folder / "a.mp4").string());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(contentsOf(folder / "a.mp4").substr(4, 4), "ftyp");
}

TEST(Render, EndingsMayBeLargeLettersAndTooFewFramesAreToldSo) {
  const Folder folder;
  EXPECT_EQ(tyg("render curtain --size 64x48 --out " + (folder / "a.PNG").string()).code, 0);
  const Outcome short_ = tyg("render curtain --from 0 --to 0.01 --out " + (folder / "a.mp4").string());
  EXPECT_EQ(short_.code, 2);
  EXPECT_TRUE(holds(short_.err, "less than one frame")) << short_.err;
}

TEST(View, WithoutADisplayDrawsFilesAndReplacesNone) {
  const Folder folder;
  const std::string bare = "cd " + (folder / "").string() + " && env -u DISPLAY -u WAYLAND_DISPLAY";
  for (int k = 0; k < 2; ++k) {
    const Outcome outcome = tyg("view curtain --duration 0.02 --size 64x48", bare);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
  }
  EXPECT_EQ(readPicture(folder / "curtain.png").width, 64);
  EXPECT_EQ(readPicture(folder / "curtain-2.png").width, 64);
  EXPECT_EQ(folder.fileCount(), 2U);
}

TEST(Render, WithoutFfmpegAMovieIsRefusedAndAFolderOffered) {
  const Folder folder;
  const Outcome outcome = tyg("render curtain --out " + (folder / "a.mp4").string(), "PATH=/nowhere");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_TRUE(holds(outcome.err, "ffmpeg")) << outcome.err;
}

}  // namespace
}  // namespace tyg
