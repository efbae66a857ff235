// `tyg limit`: its table, its JSON, its exit codes, and what it refuses.
#include <string>

#include "app/program.h"

namespace tyg {
namespace {

const std::string kCurtain = "limit --ks 1200,900,200 --kd 0.1 --mass 18g ";

TEST(Limit, SaysWhatTheReportsClothMayTake) {
  const Outcome outcome = tyg(kCurtain);
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_TRUE(holds(outcome.out, "rk4                4.26 ms    3.45 ms  stiffness of structural and shear springs"))
      << outcome.out;
  EXPECT_TRUE(holds(outcome.out, "nothing: stable at any step")) << outcome.out;
}

TEST(Limit, OfTheBuiltInCurtainIsTheSameAsThatOfTheScene) {
  const Outcome run = tyg("run curtain --duration 0.01 --integrator leapfrog --json");
  const Outcome limit = tyg("limit --ks 1200,900,200 --kd 0.1 --mass 0.018 --methods leapfrog --json");
  EXPECT_EQ(jsonValue(limit.out, "methods/0/stable_dt"), jsonValue(run.out, "stable_dt"));
  EXPECT_EQ(jsonKeys(limit.out),
            (std::vector<std::string>{"methods", "integrator", "stable_dt", "certified_dt", "set_by", "springs"}));
}

TEST(Limit, EndsWithOneWhereAStepDoesNotHoldAndSaysWhatWouldMakeItHold) {
  const Outcome good = tyg(kCurtain + "--dt 4ms --methods rk4");
  EXPECT_EQ(good.code, 0) << good.err;
  EXPECT_FALSE(holds(good.out, "Any one of these")) << good.out;
  const Outcome bad = tyg(kCurtain + "--dt 5ms --methods rk4");
  EXPECT_EQ(bad.code, 1) << bad.err;
  EXPECT_TRUE(holds(bad.out, "rk4: steps of 4.25 ms (divided by 1.18), all ks divided by 1.37")) << bad.out;
  EXPECT_TRUE(holds(bad.out, "Methods that hold 5 ms on this sheet as it is: xpbd, backward-euler.")) << bad.out;
}

TEST(Limit, InJsonGivesTheChangesAndNullWhereThereIsNone) {
  const Outcome outcome = tyg("limit --ks 500 --mass 1g --sheet 1x30 --dt 1ms --methods explicit-euler,rk4 --json");
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_EQ(jsonValue(outcome.out, "methods/0/holds"), "false");
  EXPECT_EQ(jsonValue(outcome.out, "methods/0/stable_dt"), "0.0");
  EXPECT_EQ(jsonValue(outcome.out, "methods/0/changes/mass"), "null");
  EXPECT_EQ(jsonValue(outcome.out, "methods/1/holds"), "true");
  EXPECT_EQ(jsonValue(outcome.out, "methods/1/changes"), "null");
  EXPECT_EQ(jsonValue(outcome.out, "holds"), "false");
}

TEST(Limit, NamesOnlySpringsWithDampingWhereDampingSetsTheLimit) {
  const Outcome springs = tyg("limit --ks 1200,900,200 --kd 5,0,0 --mass 18g --methods leapfrog");
  EXPECT_TRUE(holds(springs.out, "damping of structural springs")) << springs.out;
  const Outcome drag = tyg("limit --ks 100 --drag 100 --mass 18g --methods leapfrog");
  EXPECT_TRUE(holds(drag.out, "drag on the particles")) << drag.out;
  const Outcome both = tyg("limit --ks 100 --kd 1 --drag 100 --mass 18g --methods leapfrog --json");
  EXPECT_EQ(jsonValue(both.out, "methods/0/set_by"), "\"drag\"");
}

TEST(Limit, RefusesWhatIsMissingOrIsNoNumber) {
  for (const auto& [arguments, said] :
       {std::pair{"limit --mass 18g", "found no --ks"}, std::pair{"limit --ks 100", "found no --mass"},
        std::pair{"limit --ks 1,2,3,4 --mass 1g", "one to three numbers"},
        std::pair{"limit --ks 1,,3 --mass 1g", "one to three numbers"},
        std::pair{"limit --ks 100 --mass -1", "found '-1'"}, std::pair{"limit --ks 1e40 --mass 1", "1e+40"},
        std::pair{"limit --ks 100 --mass 1g --methods rk5", "--integrator or --methods: found \"rk5\""},
        std::pair{"limit --ks 100 --mass 1g --dt 0", "above 0"}}) {
    const Outcome outcome = tyg(arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_TRUE(holds(outcome.err, said)) << arguments << "\n" << outcome.err;
  }
}

}  // namespace
}  // namespace tyg
