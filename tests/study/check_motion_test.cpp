// `tyg check` on motions of a program that shares no code with Tyg: every mistake with every method that students
// write, right programs of every kind, few digits, steps that are too long.
#include <gtest/gtest.h>

#include <fmt/core.h>

#include <cctype>

#include "random_check.h"

namespace tyg::test {
namespace {

/// A sheet in which every mistake of the table makes a difference, but one of the two about axial damping.
Scene checkedScene(Damping damping) {
  Scene scene = emptyWorld(4, 5);
  scene.name = "four by five";
  scene.spacing = 0.1, scene.particleMass = 0.02;
  scene.start = Start::Flat;
  scene.gravity = {0, -9.81, 0};
  scene.structural = {300, 0.1}, scene.shear = {200, 0.08}, scene.bend = {50, 0.05};
  scene.damping = damping;
  scene.drag = 0.01;
  scene.pins = {{"top-left"}, {"top-right"}};
  scene.pushes = {{{"bottom-left"}, {0.1, 0.2, 0.4}, 0.02, 0.04}};
  scene.dt = 0.002, scene.duration = 0.2;
  return scene;
}

/// A step that every model of that scene is stable with, and that leads to the edges of the push.
double stepFor(const std::string& method, const Mistake& mistake) {
  const bool light = mistake.name == "mass of a particle shared by the sheet";
  return (method == "explicit-euler" ? 2e-4 : 2e-3) / (light ? 10 : 1);
}

std::string saidOf(const MotionCheck& check) { return verdictWords(check); }

/// The rows of a run of Tyg itself.
std::string rowsOf(const SampledMotion& motion) {
  std::string text = "t,particle,x,y,z\n";
  for (std::size_t k = 0; k < motion.times.size(); ++k) {
    for (std::size_t i = 0; i < motion.positions[k].size(); ++i) {
      const Vec3& at = motion.positions[k][i];
      text += fmt::format("{:.17g},{},{:.17g},{:.17g},{:.17g}\n", motion.times[k], i, at.x, at.y, at.z);
    }
  }
  return text;
}

class EveryMistake : public testing::TestWithParam<int> {};

TEST_P(EveryMistake, IsNamedRightlyWithEveryMethodThatStudentsWrite) {
  const Mistake& mistake = mistakes()[std::size_t(GetParam())];
  const bool aboutAxial = mistake.name == "relative for axial damping";
  Scene scene = checkedScene(aboutAxial ? Damping::Axial : Damping::Relative);
  for (const char* method : {"explicit-euler", "symplectic-euler", "leapfrog", "rk4", "heun"}) {
    const std::vector<const Mistake*> possible = possibleMistakes(scene, method);
    if (std::ranges::find(possible, &mistake) == possible.end()) continue;
    const double h = stepFor(method, mistake);
    scene.dt = std::string_view(method) == "symplectic-euler" ? 3e-3 : h;  // one step has to be looked for
    const int every = std::string_view(method) == "rk4" ? 1 : 5;
    const OwnProgram program(scene, {std::string(mistake.name)}, method, h);
    const int steps = int(std::lround(scene.duration / h));
    const MotionCheck check = checkedText(scene, ownRows(program, h, steps, every));
    ASSERT_TRUE(check.mistaken) << method << ": " << saidOf(check);
    EXPECT_EQ(mistakeName(check), mistake.name) << method << ": " << saidOf(check);
    const bool severalAreOne = mistake.name == "forces kept stale across stages";
    if (!severalAreOne) {
      EXPECT_EQ(check.mistaken->way.name(), method) << saidOf(check);
    }
    EXPECT_NEAR(check.mistaken->dt, h, 1e-9 * h) << saidOf(check);
    EXPECT_LE(check.mistaken->distance, 1e-9 * check.size) << saidOf(check);
    EXPECT_GT(check.withoutMistake, check.mistaken->distance) << saidOf(check);
    EXPECT_NE(saidOf(check).find(mistake.cure), std::string::npos) << saidOf(check);
  }
}

INSTANTIATE_TEST_SUITE_P(Check, EveryMistake, testing::Range(0, int(mistakes().size())), [](const auto& instance) {
  std::string name;
  for (const char c : mistakes()[std::size_t(instance.param)].name) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0) name += c;
  }
  return name;
});

TEST(Check, NamesMethodAndStepOfRightPrograms) {
  const Scene scene = checkedScene(Damping::Axial);
  for (const char* method : {"explicit-euler", "symplectic-euler", "leapfrog", "rk4", "heun", "midpoint"}) {
    for (const double h : {2e-4, 1e-3}) {
      const MotionCheck check =
          checkedText(scene, ownRows(OwnProgram(scene, {}, method, h), h, int(std::lround(scene.duration / h)), 10));
      EXPECT_EQ(check.verdict, MotionCheck::Verdict::Right) << method << ": " << saidOf(check);
      ASSERT_TRUE(check.right && check.right->exact) << method;
      EXPECT_EQ(check.right->way.name(), method);
      EXPECT_NEAR(check.right->dt, h, 1e-9 * h) << method;
      EXPECT_EQ(mistakeName(check), "");
    }
  }
}

TEST(Check, BlamesNoMistakeThatMakesNoDifference) {
  // Held pins stay where they are by any of these methods, whatever a program does with them within a step.
  const Scene scene = loadScene("four-particles", methodNames());
  for (const char* method : {"symplectic-euler", "explicit-euler"}) {
    for (const double h : {1e-3, 2.5e-3}) {
      Scene run = scene;
      run.dt = h, run.duration = 1;
      const MotionCheck check = checkedText(scene, rowsOf(sampledRun(run, findMethod(method), sampleTimes(run))));
      EXPECT_EQ(mistakeName(check), "") << method << " " << h << ": " << saidOf(check);
      EXPECT_EQ(check.verdict, MotionCheck::Verdict::Right) << method << " " << h << ": " << saidOf(check);
    }
  }
}

TEST(Check, KnowsLeapfrogWhereAPushBeginsLater) {
  const Scene scene = checkedScene(Damping::Relative);
  Scene run = scene;
  run.dt = 1e-3;
  const MotionCheck tygs = checkedText(scene, rowsOf(sampledRun(run, findMethod("leapfrog"), sampleTimes(run))));
  const MotionCheck students = checkedText(scene, ownRows(OwnProgram(scene, {}, "leapfrog", 1e-3), 1e-3, 200, 10));
  for (const MotionCheck* check : {&tygs, &students}) {
    ASSERT_TRUE(check->right && check->right->exact) << saidOf(*check);
    EXPECT_EQ(check->right->way.name(), "leapfrog");
    EXPECT_NEAR(check->right->dt, 1e-3, 1e-12);
  }
}

TEST(Check, NamesNoMethodThatTheDigitsDoNotProve) {
  const Scene scene = checkedScene(Damping::Relative);
  const MotionCheck check = checkedText(scene, ownRows(OwnProgram(scene, {}, "leapfrog", 2e-3), 2e-3, 100, 5, "%.3f"));
  EXPECT_EQ(check.verdict, MotionCheck::Verdict::Right) << saidOf(check);
  EXPECT_NE(saidOf(check).find("does not tell which method"), std::string::npos) << saidOf(check);
  EXPECT_EQ(saidOf(check).find("leapfrog"), std::string::npos) << saidOf(check);
}

TEST(Check, FindsTheReportsRungeKutta) {
  Scene scene = checkedScene(Damping::Relative);
  const MotionCheck check = checkedText(scene, ownRows(OwnProgram(scene, {}, "report-rk4", 2e-3), 2e-3, 100, 5));
  EXPECT_EQ(mistakeName(check), "the report's Runge-Kutta") << saidOf(check);
}

TEST(Check, CallsARunByAnyMethodOfTheTableRight) {
  Scene scene = checkedScene(Damping::Relative);
  scene.pushes.clear();
  for (const Method& method : methods()) {
    if (method.name == "report-rk4") continue;
    scene.dt = method.name == "explicit-euler" ? 2e-4 : 1e-3;
    const MotionCheck check = checkedText(scene, rowsOf(sampledRun(scene, method, sampleTimes(scene))));
    EXPECT_EQ(check.verdict, MotionCheck::Verdict::Right) << method.name << ": " << saidOf(check);
    ASSERT_TRUE(check.right) << method.name;
    EXPECT_EQ(check.right->way.name(), method.name) << saidOf(check);
  }
}

TEST(Check, IsNotConfusedBySixPrintedDigits) {
  const Scene scene = checkedScene(Damping::Relative);
  for (const char* format : {"%.6f", "%.6g"}) {
    for (const char* mistake : {"", "each spring applied twice", "damping left out", "shear springs left out"}) {
      const std::vector<std::string> made = *mistake ? std::vector<std::string>{mistake} : std::vector<std::string>{};
      const MotionCheck check =
          checkedText(scene, ownRows(OwnProgram(scene, made, "symplectic-euler", 2e-3), 2e-3, 100, 5, format));
      EXPECT_EQ(mistakeName(check), mistake) << format << ": " << saidOf(check);
      const Explanation* of = check.explanation();
      ASSERT_TRUE(of != nullptr && of->exact) << format << ": " << saidOf(check);
      EXPECT_EQ(of->way.name(), "symplectic-euler") << format << ": " << saidOf(check);
      EXPECT_NEAR(of->dt, 2e-3, 1e-12) << format;
    }
  }
}

TEST(Check, FindsTwoMistakesAtOnce) {
  const Scene scene = checkedScene(Damping::Relative);
  const std::vector<std::string> made{"gravity doubled", "damping left out"};
  const MotionCheck check = checkedText(scene, ownRows(OwnProgram(scene, made, "leapfrog", 2e-3), 2e-3, 100, 1));
  EXPECT_EQ(mistakeName(check), "gravity doubled and damping left out") << saidOf(check);
}

TEST(Check, SaysThatAStepIsTooLongWhereARightProgramExplodes) {
  Scene scene = checkedScene(Damping::Relative);
  scene.dt = 0.02, scene.pushes.clear();
  const MotionCheck check = checkedText(scene, ownRows(OwnProgram(scene, {}, "symplectic-euler", 0.02), 0.02, 8, 1));
  EXPECT_EQ(check.verdict, MotionCheck::Verdict::Right) << saidOf(check);
  EXPECT_TRUE(check.stepIsTooLong());
  for (const char* words : {"The program is right, but its step is longer than", "take a shorter step"}) {
    EXPECT_NE(saidOf(check).find(words), std::string::npos) << saidOf(check);
  }
}

TEST(Check, CallsAMotionFarOutsideTheSheetExplodedWithoutLongNumbers) {
  const Scene scene = checkedScene(Damping::Relative);
  std::string text = "t,x0,y0,z0";
  for (int particle = 1; particle < 20; ++particle) text += fmt::format(",x{0},y{0},z{0}", particle);
  for (int k = 1; k <= 20; ++k) {
    text += fmt::format("\n{:g}", 0.01 * k);
    for (int number = 0; number < 60; ++number) text += fmt::format(",{:g}", std::pow(1e7, k) * ((7 * number) % 11));
  }
  const MotionCheck check =
      checkMotion(scene, readMotion(text + "\n", "motion.csv", scene), {.dt = 0.01, .threads = 1, .observer = {}});
  EXPECT_EQ(check.verdict, MotionCheck::Verdict::Unexplained) << saidOf(check);
  EXPECT_TRUE(saidOf(check).starts_with("Your cloth has exploded: ")) << saidOf(check);
  EXPECT_LT(saidOf(check).size(), 400U) << saidOf(check);
}

TEST(Check, CallsAnUnknownMethodRightByItsError) {
  const Scene scene = checkedScene(Damping::Relative);
  // The mean of two programs is no method of anybody, and as right as they are.
  OwnProgram coarse(scene, {}, "rk4", 2e-3), fine(scene, {}, "leapfrog", 1e-3);
  std::string text = "t,particle,x,y,z\n";
  for (int k = 1; k <= 100; ++k) {
    coarse.step(), fine.step(), fine.step();
    for (std::size_t i = 0; i < coarse.count(); ++i) {
      const Vec3 mean = 0.5 * (coarse.at(i) + fine.at(i));
      text += fmt::format("{:.17g},{},{:.17g},{:.17g},{:.17g}\n", k * 2e-3, i, mean.x, mean.y, mean.z);
    }
  }
  const MotionCheck check = checkedText(scene, text);
  EXPECT_EQ(check.verdict, MotionCheck::Verdict::OtherMethod) << saidOf(check);
  EXPECT_EQ(mistakeName(check), "");
}

TEST(Check, OfRandomProgramsAccusesNoRightOneAndNamesMistakes) {
  for (unsigned seed = 1001; seed <= 1003; ++seed) {
    for (const int mistakes : {0, 1}) {
      const RandomCheck check = randomCheck(seed, mistakes);
      EXPECT_FALSE(check.accused) << check.what << "\n" << check.said;
      EXPECT_TRUE(check.named) << check.what << "\n" << check.said;
    }
  }
}

TEST(Check, ComesToTheSameWhateverTheNumberOfThreads) {
  const Scene scene = checkedScene(Damping::Relative);
  const auto rowsWith = [&](const std::vector<std::string>& made) {
    return ownRows(OwnProgram(scene, made, "leapfrog", 2e-3), 2e-3, 100, 10);
  };
  const std::string two = rowsWith({"gravity doubled", "damping left out"});
  const std::string three = rowsWith({"gravity doubled", "damping reversed", "shear springs left out"});
  for (const std::string& text : {rowsWith({}), two, three}) {
    const GivenMotion motion = readMotion(text, "motion.csv", scene);
    const std::optional<double> dt = text == three ? std::optional(2e-3) : std::nullopt;  // all steps would take long
    const MotionCheck alone = checkMotion(scene, motion, {.dt = dt, .threads = 1, .observer = {}});
    const MotionCheck many = checkMotion(scene, motion, {.dt = dt, .threads = 3, .observer = {}});
    EXPECT_EQ(verdictWords(many), verdictWords(alone));
    EXPECT_EQ(many.explained, alone.explained);
    EXPECT_EQ(many.withoutMistake, alone.withoutMistake);
  }
}

TEST(Check, StopsWhereTheObserverSaysSo) {
  const Scene scene = checkedScene(Damping::Relative);
  const GivenMotion motion =
      readMotion(ownRows(OwnProgram(scene, {"damping reversed"}, "rk4", 2e-3), 2e-3, 100, 5), "motion.csv", scene);
  for (const double at : {0.0, 0.4}) {
    const CheckOptions options{.dt = {}, .threads = 1, .observer = [at](double done) { return done < at; }};
    EXPECT_TRUE(checkMotion(scene, motion, options).stopped) << at;
  }
}

}  // namespace
}  // namespace tyg::test
