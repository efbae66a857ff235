// `tyg advise`: what it says, the file it writes, what it refuses.
#include <sstream>

#include "app/program.h"
#include "tyg/methods.h"
#include "tyg/scene.h"

namespace tyg {
namespace {

const std::string kSmall = "advise curtain --sheet 5x5 --duration 0.2 ";

TEST(Advise, SaysWhatWasPromisedAndAchievedWithinEightyColumns) {
  const Outcome outcome = tyg(kSmall + "--error 1mm");
  EXPECT_EQ(outcome.code, 0) << outcome.err << outcome.out;
  for (const char* part : {"promised", "achieved", "The promise holds.", "ten times", "--integrator"}) {
    EXPECT_TRUE(holds(outcome.out, part)) << part << " in\n" << outcome.out;
  }
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 80U) << line;
}

TEST(Advise, WritesASceneWithItsChoiceThatRuns) {
  const Folder folder;
  const std::string file = (folder / "advised.toml").string();
  const Outcome outcome = tyg(kSmall + "--error 0.1% --json --write " + file);
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const Scene scene = loadScene(file, methodNames());
  EXPECT_EQ(jsonValue(outcome.out, "integrator"), "\"" + scene.integrator + "\"");
  EXPECT_EQ(jsonValue(outcome.out, "held"), "true");
  EXPECT_NE(jsonValue(outcome.out, "achieved_error_m"), "null");
  EXPECT_EQ(tyg("run " + file).code, 0);
}

TEST(Advise, ABudgetThatNothingMeetsIsAnsweredWithTheNearest) {
  const Outcome outcome = tyg(kSmall + "--budget 0.001us");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(holds(outcome.out, "cannot be met")) << outcome.out;
  EXPECT_TRUE(holds(outcome.out, "--integrator")) << outcome.out;
}

TEST(Advise, WrongRequestsAreRefused) {
  for (const char* wrong :
       {"", "--error 1mm --budget 4ms", "--error -1", "--budget 4m", "--budget 4mm", "--error 1ms"}) {
    const Outcome outcome = tyg(std::string("advise curtain ") + wrong);
    EXPECT_EQ(outcome.code, 2) << wrong;
    EXPECT_TRUE(holds(outcome.err, "allowed is")) << outcome.err;
  }
}

}  // namespace
}  // namespace tyg
