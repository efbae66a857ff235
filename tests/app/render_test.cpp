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

TEST(Render, FollowsTheLookOfTheSceneUnlessItIsToldOtherwise) {
  const Folder folder;
  const auto picture = [&](const std::string& options) {
    const auto file = folder / "a.png";
    const Outcome outcome = tyg("render " + options + " --at 0.02 --size 160x100 --out " + file.string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return contentsOf(file);
  };
  const std::string flag = picture("flag"), curtain = picture("curtain");
  EXPECT_EQ(picture("flag --look surface"), flag);
  EXPECT_EQ(picture("flag --show lines"), picture("flag --look lines"));
  EXPECT_NE(picture("flag --look lines"), flag);
  EXPECT_NE(picture("flag --look both"), flag);
  EXPECT_EQ(picture("curtain --look lines"), curtain);
  EXPECT_NE(picture("curtain --look surface"), curtain);
  const Outcome refused = tyg("render flag --look face");
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(holds(refused.err, "face") && holds(refused.err, "surface")) << refused.err;
}

TEST(Render, NamesAPictureOfTheSceneThatItCannotRead) {
  const Folder folder;
  std::string text = contentsOf(std::filesystem::path(TYG_SOURCE_DIR) / "src/scenes/curtain.toml");
  text.insert(text.find("[run]"), "[look]\nshow = \"surface\"\nimage = \"cloth.png\"\n");
  std::ofstream(folder / "a.toml") << text;
  const std::string render =
      "render " + (folder / "a.toml").string() + " --at 0.02 --out " + (folder / "a.png").string();
  const Outcome missing = tyg(render);
  EXPECT_EQ(missing.code, 2);
  EXPECT_TRUE(holds(missing.err, (folder / "cloth.png").string())) << missing.err;
  std::ofstream(folder / "cloth.png") << "not a picture";
  const Outcome wrong = tyg(render);
  EXPECT_EQ(wrong.code, 2);
  EXPECT_TRUE(holds(wrong.err, "allowed a PNG or JPEG picture")) << wrong.err;
  writePng({.width = 1, .height = 1, .rgba = {255, 0, 0, 255}}, folder / "cloth.png");
  EXPECT_EQ(tyg(render).code, 0);
  EXPECT_EQ(tyg("run " + (folder / "a.toml").string() + " --duration 0.02").code, 0) << "a run needs no picture";
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

TEST(Render, AndExportSayWhereTheirFramesGoPastTheEndOfTheRun) {
  const Folder folder;
  const std::string picture = "render curtain --duration 0.1 --size 64x48 --out " + (folder / "a.png").string();
  const std::string frames = "export curtain --duration 0.1 --out " + (folder / "a.usda").string();
  for (const std::string& past : {picture + " --at 0.25", frames + " --to 0.25"}) {
    const Outcome outcome = tyg(past);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_TRUE(holds(outcome.err, "0.25 s is after the end of the run at 0.1 s")) << outcome.err;
  }
  for (const std::string& within : {picture + " --at 0.1", frames + " --to 0.1", frames}) {
    EXPECT_FALSE(holds(tyg(within).err, "after the end")) << within;
  }
}

TEST(Render, AndExportSayWhereNoFrameIsDueAtTheEndThatWasAskedFor) {
  const Folder folder;
  const std::string frames = "export curtain --fps 13 --out " + (folder / "a.usda").string();
  const Outcome outcome = tyg(frames + " --from 0.1 --to 0.75");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "the last frame is at 0.715385 s, because none is due at 0.75 s")) << outcome.err;
  EXPECT_EQ(tyg(frames + " --from 0.1 --to 1.1").err, "");
}

TEST(Render, ShowsAllOfALargeSheet) {
  const Folder folder;
  for (const char* sheet : {"101x101", "200x200", "256x256"}) {
    const auto file = folder / "a.png";
    const Outcome outcome = tyg(std::string("render curtain --sheet ") + sheet +
                                " --look surface --at 0 --size 320x180 --out " + file.string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    const Picture picture = readPicture(file);
    const auto isCloth = [&](int x, int y) {  // blue, or a pin; neither sky nor ground comes near them
      const std::uint8_t* p = &picture.rgba[4 * (std::size_t(y) * 320 + std::size_t(x))];
      return p[2] > p[0] + 40 || p[0] > p[2] + 40;
    };
    for (int y = 0; y < 180; ++y) EXPECT_FALSE(isCloth(0, y) || isCloth(319, y)) << sheet << ", row " << y;
    for (int x = 0; x < 320; ++x) EXPECT_FALSE(isCloth(x, 0) || isCloth(x, 179)) << sheet << ", column " << x;
  }
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
  const Outcome tooShort = tyg("render curtain --from 0 --to 0.01 --out " + (folder / "a.mp4").string());
  EXPECT_EQ(tooShort.code, 2);
  EXPECT_TRUE(holds(tooShort.err, "less than one frame")) << tooShort.err;
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
