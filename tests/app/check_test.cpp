// `tyg check`: its sentence, its JSON, its exit codes, its files, and what it refuses.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>

#include "app/program.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

/// A file of a run of four-particles by leapfrog, in a folder of its own.
class Check : public testing::Test {
 protected:
  void SetUp() override {
    const Outcome run =
        tyg("run four-particles --integrator leapfrog --dt 0.01 --duration 2 --samples 40 --out " + file());
    ASSERT_EQ(run.code, 0) << run.err;
  }
  [[nodiscard]] std::string file() const { return (folder_.path() / "mine.csv").string(); }
  [[nodiscard]] std::string folder(const std::string& name) const { return (folder_.path() / name).string(); }

 private:
  Folder folder_;
};

TEST_F(Check, SaysWhichMethodWithWhichStepAMotionIs) {
  const Outcome outcome = tyg("check four-particles " + file());
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.out, "Right: your positions are those of leapfrog at 10 ms: they agree to")) << outcome.out;
  EXPECT_TRUE(holds(outcome.out, "nearest method   leapfrog at 10 ms")) << outcome.out;
}

TEST_F(Check, NamesAMistakeOfAnotherScene) {
  const std::string scene = folder("heavy.toml"), made = folder("made.csv");
  std::ofstream(scene) << R"(title = "Four particles without shear springs"
[sheet]
columns = 2
rows = 2
spacing = 0.5
particle_mass = 0.1
pins = ["top-left", "top-right"]
[springs]
structural = { ks = 10, kd = 0.02 }
[[displace]]
particle = "bottom-left"
by = [-0.1, 0, 0]
[run]
duration = 2.0
integrator = "rk4"
dt = 0.01
)";
  ASSERT_EQ(tyg("run " + scene + " --samples 40 --out " + made).code, 0);
  const Outcome outcome = tyg("check four-particles " + made + " --within 1mm --json");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(jsonValue(outcome.out, "mistake"), "\"shear springs left out\"") << outcome.out;
  EXPECT_EQ(jsonValue(outcome.out, "within"), "false");
  EXPECT_EQ(jsonValue(outcome.out, "nearest/integrator"), "\"rk4\"");
  EXPECT_EQ(jsonValue(outcome.out, "nearest/dt"), "0.01");
}

TEST_F(Check, PrintsOneJsonObjectAndEndsWithOneWhereTheErrorIsLarger) {
  const Outcome good = tyg("check four-particles " + file() + " --within 1% --json");
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_EQ(jsonValue(good.out, "within"), "true");
  EXPECT_EQ(jsonValue(good.out, "mistake"), "null");
  EXPECT_EQ(jsonValue(good.out, "mistake_distance_m"), "null");
  EXPECT_EQ(jsonValue(good.out, "times/39/t"), "2.0");
  const std::vector<std::string> keys = jsonKeys(good.out);
  for (const char* key : {"scene", "error_m", "error_size", "times", "nearest", "integrator", "dt", "distance_m",
                          "mistake", "mistake_distance_m", "verdict", "within", "horizon_s", "stable_dt"}) {
    EXPECT_NE(std::ranges::find(keys, key), keys.end()) << key;
  }
  const Outcome bad = tyg("check four-particles " + file() + " --within 0.01um --json");
  EXPECT_EQ(bad.code, 1) << bad.err;
  EXPECT_EQ(jsonValue(bad.out, "within"), "false");
  EXPECT_EQ(jsonValue(tyg("check four-particles " + file() + " --json").out, "within"), "null");
}

TEST_F(Check, WritesRowsAndAChart) {
  const Outcome outcome = tyg("check four-particles " + file() + " --json --out " + folder("marked"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(jsonValue(outcome.out, "mistake"), "null") << "names of files belong to standard error";
  const std::string rows = contentsOf(folder("marked/check.csv"));
  EXPECT_TRUE(rows.starts_with("t,error_m,explained_m,floor_m\n0.05,")) << rows;
  EXPECT_EQ(std::ranges::count(rows, '\n'), 41);
  EXPECT_TRUE(fs::exists(folder("marked/check.gp")));
  EXPECT_EQ(fs::exists(folder("marked/check.svg")), fs::exists(folder("marked/check.png")));
}

TEST_F(Check, RefusesWhatItCannotReadOrCompare) {
  for (const auto& [arguments, said] :
       {std::pair{std::string("four-particles"), std::string("no FILE.csv")},
        std::pair{std::string("four-particles nowhere.csv"), std::string("nowhere.csv")},
        std::pair{"curtain " + file(), std::string("0 to 399")},
        std::pair{"four-particles " + file() + " --duration 1", std::string("times up to 2 s")},
        std::pair{"four-particles " + file() + " --dt 30ms", std::string("--dt")},
        std::pair{"four-particles " + file() + " --within -1", std::string("--within")},
        std::pair{"four-particles " + file() + " --out " + file(), std::string("--out")}}) {
    const Outcome outcome = tyg("check " + arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_TRUE(holds(outcome.err, said)) << arguments << "\n" << outcome.err;
    EXPECT_EQ(outcome.out, "") << arguments;
  }
}

}  // namespace
}  // namespace tyg
