// --device: what a run on the graphics card reports, what is refused, and what happens where there is no card. Tests
// that need OpenGL 4.3 are skipped where it is not there.
#include <fmt/core.h>

#include <sstream>
#include <utility>

#include "app/program.h"
#include "gfx/contexts/offscreen.h"

namespace tyg {
namespace {

// No driver for EGL is found then, and OSMesa offers less than it could.
constexpr const char* kNoCard = "__EGL_VENDOR_LIBRARY_DIRS=/none MESA_GL_VERSION_OVERRIDE=3.3";

class RunOnCard : public testing::Test {
 protected:
  void SetUp() override {
    const Outcome here = tyg("run drop --duration 0.01 --device gpu");
    if (here.err.find("no graphics card serves here") != std::string::npos) GTEST_SKIP() << here.err;
  }
};

TEST_F(RunOnCard, GivesTheHashOfTheProcessor) {
  const std::string what = "run poke --duration 0.2 --integrator leapfrog --precision float --json --device ";
  const Outcome card = tyg(what + "gpu"), processor = tyg(what + "cpu");
  EXPECT_EQ(card.code, 0) << card.err;
  EXPECT_EQ(card.err, "");
  EXPECT_EQ(jsonValue(card.out, "hash"), jsonValue(processor.out, "hash"));
  EXPECT_EQ(jsonValue(card.out, "device"), "\"gpu\"");
  EXPECT_EQ(jsonValue(processor.out, "device"), "\"cpu\"");
  EXPECT_EQ(jsonValue(card.out, "same_bits"), "true");
  EXPECT_EQ(jsonValue(card.out, "stray_m"), "0.0");
  EXPECT_NE(jsonValue(card.out, "device_name"), "\"\"");
  EXPECT_EQ(jsonValue(processor.out, "device_name"), "\"\"");
}

TEST_F(RunOnCard, TakesFloatWhereNobodyAskedForDouble) {
  EXPECT_EQ(jsonValue(tyg("run drop --duration 0.05 --device gpu --json").out, "precision"), "\"float\"");
  const Outcome asked = tyg("run drop --duration 0.05 --device gpu --precision double");
  EXPECT_EQ(asked.code, 2);
  EXPECT_NE(asked.err.find("precision: found double, allowed on the graphics card is float"), std::string::npos);
}

TEST_F(RunOnCard, SaysWhatTheCardIs) {
  const Outcome outcome = tyg("run drop --duration 0.05 --device gpu");
  EXPECT_NE(outcome.out.find("\ndevice        graphics card "), std::string::npos) << outcome.out;
  EXPECT_NE(outcome.out.find("the same bits as the processor (compared after 64 steps)"), std::string::npos);
}

TEST_F(RunOnCard, RefusesWhatTheCardDoesNotTake) {
  const Outcome method = tyg("run drop --device gpu --integrator imex");
  EXPECT_EQ(method.code, 2);
  EXPECT_NE(method.err.find("allowed on the graphics card: symplectic-euler, leapfrog, rk4"), std::string::npos);
}

TEST_F(RunOnCard, WritesTheSamplesOfTheProcessor) {
  const Folder folder;
  const std::string what = "run hammock --duration 0.1 --precision float --samples 3 --out ";
  for (const std::string device : {"cpu", "gpu"}) {
    EXPECT_EQ(tyg(fmt::format("{}{} --device {}", what, (folder / (device + ".csv")).string(), device)).code, 0);
  }
  EXPECT_EQ(contentsOf(folder / "gpu.csv"), contentsOf(folder / "cpu.csv"));
  EXPECT_NE(contentsOf(folder / "cpu.csv"), "");
}

/// The file of a small picture, and what was said.
std::pair<std::string, std::string> drawnOn(const std::string& device, const char* before = "") {
  const Folder folder;
  const auto file = folder / "a.png";
  const std::string what = "render poke --at 0.2 --size 160x120 --precision float --device ";
  const Outcome drawn = tyg(what + device + " --out " + file.string(), before);
  EXPECT_EQ(drawn.code, 0) << drawn.err;
  return {contentsOf(file), drawn.err};
}

// Where a real card draws, lines are smoothed in its own way.
TEST_F(RunOnCard, DrawsThePictureOfTheProcessor) {
  const auto [file, said] = drawnOn("gpu");
  EXPECT_EQ(said, "");
  EXPECT_NE(file, "");
  const std::string name = jsonValue(tyg("run drop --duration 0.01 --device gpu --json").out, "device_name");
  const bool drawsAlike = name.find("llvmpipe") != std::string::npos;
  EXPECT_TRUE(!drawsAlike || file == drawnOn("cpu").first);
}

TEST(RenderWithoutCard, SaysWhyAndDrawsThePictureOfTheProcessor) {
  const char* before = offscreenKinds().front() == OffscreenKind::OsMesa ? kNoCard : "MESA_GL_VERSION_OVERRIDE=3.3";
  const auto [file, said] = drawnOn("gpu", before);
  EXPECT_NE(said.find("tyg render: no graphics card serves here: "), std::string::npos) << said;
  EXPECT_NE(file, "");
  EXPECT_TRUE(file == drawnOn("cpu", before).first);
}

TEST_F(RunOnCard, OfAChartTakesTheTimedRunsInFloatOfTheMethodsThatTheCardKnows) {
  const Folder folder;
  const std::string out = (folder / "chart").string();
  const Outcome chart = tyg("chart drop --quick --methods leapfrog,bs32 --horizon 0.1 --device gpu --out " + out);
  EXPECT_EQ(chart.code, 0) << chart.err;
  std::istringstream rows(contentsOf(folder / "chart" / "rows.csv"));
  int onCard = 0, beside = 0;
  for (std::string row; std::getline(rows, row);) {
    const bool wanted = row.find(",leapfrog,float,") != std::string::npos;
    EXPECT_EQ(row.ends_with(",gpu"), wanted) << row;
    (wanted ? onCard : beside) += 1;
  }
  EXPECT_GT(onCard, 1);
  EXPECT_GT(beside, 1);
}

constexpr const char* kAdvise = "advise drop --duration 0.1 --methods leapfrog,rk4 --error 1% ";

TEST_F(RunOnCard, OfAdviceIsOneMoreChoice) {
  const Outcome outcome = tyg(std::string(kAdvise) + "--json --precision float --device gpu");
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_NE(jsonValue(outcome.out, "device_name"), "\"\"");
  EXPECT_NE(jsonValue(outcome.out, "other_device_frame_s"), "null");
  const Outcome inDouble = tyg(std::string(kAdvise) + "--precision double --device gpu");
  EXPECT_EQ(inDouble.code, 2);
  EXPECT_NE(inDouble.err.find("precision: found double, allowed on the graphics card is float"), std::string::npos);
}

TEST(AdviceWithoutCard, SaysNothingOfCardsUnlessItIsAsked) {
  const Outcome unasked = tyg(kAdvise, kNoCard);
  EXPECT_EQ(unasked.code, 0) << unasked.err;
  EXPECT_EQ(unasked.err, "");
  EXPECT_EQ(unasked.out.find("card"), std::string::npos) << unasked.out;
  const Outcome asked = tyg(std::string(kAdvise) + "--device gpu", kNoCard);
  EXPECT_EQ(asked.code, 0);
  EXPECT_NE(asked.err.find("tyg advise: no graphics card serves here: "), std::string::npos) << asked.err;
  EXPECT_EQ(asked.out.find("card"), std::string::npos) << asked.out;
}

TEST(RunWithoutCard, SaysWhyAndTakesTheProcessor) {
  const Outcome outcome = tyg("run drop --duration 0.05 --device gpu --json", kNoCard);
  EXPECT_EQ(outcome.code, 0);
  EXPECT_NE(outcome.err.find("tyg run: no graphics card serves here: "), std::string::npos) << outcome.err;
  EXPECT_NE(outcome.err.find("; the processor moves the cloth"), std::string::npos);
  EXPECT_EQ(jsonValue(outcome.out, "device"), "\"cpu\"");
}

TEST(RunWithoutCard, RefusesADeviceThatThereIsNot) {
  const Outcome outcome = tyg("run drop --device fpga");
  EXPECT_EQ(outcome.code, 2);
  EXPECT_NE(outcome.err.find("found 'fpga', allowed is cpu, gpu"), std::string::npos) << outcome.err;
}

}  // namespace
}  // namespace tyg
