// `tyg diet`: its files, its table, what it refuses.
#include <sstream>

#include "app/program.h"
#include "tyg/methods.h"
#include "tyg/scene.h"
#include "ui/captions.h"
#include "util/amounts.h"

namespace tyg {
namespace {

// A small sheet, a short run.
const std::string kSmall = "diet curtain --sheet 6x6 --duration 0.3 --dt 0.005 ";

TEST(DietCommand, WritesRowsALeanSceneThatRunsAndAPicture) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--within 2% --out " + (folder / "made").string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(contentsOf(folder / "made/diet.csv").rfind("part,change,columns,rows,integrator,precision,dt,", 0), 0U);
  EXPECT_EQ(contentsOf(folder / "made/overlay.png").substr(0, 4), "\x89PNG");
  const std::string lean = (folder / "made/lean.toml").string();
  EXPECT_NO_THROW(loadScene(lean, methodNames()));
  EXPECT_EQ(tyg("run " + lean).code, 0);
}

TEST(DietCommand, ItsTableFitsEightyColumns) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--out " + (folder / "").string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) {
    if (holds(line, (folder / "").string())) continue;  // names of files
    EXPECT_LE(line.size(), 80U) << line;
  }
  for (const char* word : {"no bend", "no shear", "float", "together", "What it leaves out"}) {
    EXPECT_TRUE(holds(outcome.out, word)) << word << " in\n" << outcome.out;
  }
  // So small a sheet's steps cost nearly the same in both.
  EXPECT_TRUE(holds(outcome.out, "leapfrog") || holds(outcome.out, "symplectic-euler")) << outcome.out;
}

TEST(DietCommand, ItsJsonIsOneObjectWithEveryPart) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--json --out " + (folder / "").string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(jsonValue(outcome.out, "scene"), "\"curtain\"");
  for (const char* path : {"written/rms_error_m", "alone/0/rms_error_m", "together/0/rms_error_m", "finer/0/change_m",
                           "too_lean", "within_m"}) {
    EXPECT_NE(jsonValue(outcome.out, path), "missing") << path;
  }
}

TEST(DietCommand, AToleranceBelowWhatRoundingMakesIsRefusedWithTheReason) {
  const Folder folder;
  const Outcome outcome = tyg(kSmall + "--within 1e-12mm --out " + (folder / "").string());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(holds(outcome.err, "try a larger one")) << outcome.err;
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(DietCommand, WrongTolerancesAreRefused) {
  for (const char* wrong : {"5s", "-1mm", "mm", "0%", "5 mm", "1e999m"}) {
    const Outcome outcome = tyg(std::string("diet curtain --within '") + wrong + "'");
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_TRUE(holds(outcome.err, "allowed")) << outcome.err;
  }
}

TEST(DietCommand, AnInterruptLeavesNothing) {
  const Folder folder;
  const Outcome outcome = tyg("diet curtain --sheet 60x60 --out " + (folder / "").string(),
                              "timeout --foreground --preserve-status --signal INT 1");
  EXPECT_EQ(outcome.code, 130) << outcome.err;
  EXPECT_TRUE(holds(outcome.err, "nothing was written")) << outcome.err;
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(DietCommand, SaysAsJsonTooWhyThereIsNoVerdict) {
  const Folder folder;
  const Outcome outcome = tyg("diet four-particles --within 0.0000000001um --json --out " + (folder / "").string());
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(jsonValue(outcome.out, "scene"), "\"four-particles\"");
  EXPECT_TRUE(holds(outcome.out, "rounding")) << outcome.out;
}

TEST(Amounts, UnitsAreUnderstood) {
  EXPECT_DOUBLE_EQ(parseLength("--within", "5mm", 2), 0.005);
  EXPECT_DOUBLE_EQ(parseLength("--within", "1%", 2), 0.02);
  EXPECT_DOUBLE_EQ(parseLength("--within", "2.5cm", 2), 0.025);
  EXPECT_DOUBLE_EQ(parseTime("--budget", "4ms"), 0.004);
  EXPECT_EQ(lengthText(0.0345), "34.5 mm");
  EXPECT_EQ(timeText(0.0000123), "12.3 us");
}

TEST(Captions, ALegendDarkensThePictureWhereItsLettersAre) {
  Picture picture{200, 100, std::vector<std::uint8_t>(200 * 100 * 4, 255)};
  writeLegend(picture, {{"Curtain"}, {"blue: x", true, {0, 0, 255}}});
  int dark = 0, blue = 0;
  for (std::size_t i = 0; i < picture.rgba.size(); i += 4) {
    dark += picture.rgba[i] < 100 && picture.rgba[i + 2] < 100 ? 1 : 0;
    blue += picture.rgba[i] < 50 && picture.rgba[i + 2] == 255 ? 1 : 0;
  }
  EXPECT_GT(dark, 100);
  EXPECT_LT(dark, 1500);
  EXPECT_GT(blue, 50);
}

}  // namespace
}  // namespace tyg
