// Motions read from CSV: both forms, any order, and what is said of files that are none.
#include "study/check/motion_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "test_systems.h"

namespace tyg::test {
namespace {

Scene pair() {
  Scene scene = emptyWorld(2, 1);
  scene.name = "pair", scene.spacing = 0.5, scene.duration = 2;
  return scene;
}

GivenMotion read(const std::string& text) { return readMotion(text, "mine.csv", pair()); }
std::string refusal(const std::string& text) {
  return messageOf([&] { read(text); });
}

const std::string kRows = "t,particle,x,y,z\n0,0,-0.25,0,0\n0,1,0.25,0,0\n0.1,0,-0.25,-0.05,0\n0.1,1,0.26,-0.05,0\n";

TEST(MotionRows, AreReadInAnyOrderOfColumnsAndRows) {
  const GivenMotion motion = read(kRows);
  EXPECT_EQ(motion.times, (std::vector<double>{0, 0.1}));
  EXPECT_EQ(motion.positions[1][1], (Vec3{0.26, -0.05, 0}));
  const GivenMotion other = read(
      "# mine\r\nParticle, z, more, y, x, T\r\n1,0,8,-0.05,0.26,0.1\r\n0,0,8,0,-0.25,0\r\n\r\n1,0,8,0,0.25,0\r\n"
      "0,0,8,-0.05,-0.25,+0.1\r\n");
  EXPECT_EQ(other.times, motion.times);
  EXPECT_EQ(other.positions, motion.positions);
  const GivenMotion wide = read("t,x0,y0,z0,x1,y1,z1\n0,-0.25,0,0,0.25,0,0\n0.1,-0.25,-0.05,0,0.26,-0.05,0\n");
  EXPECT_EQ(wide.positions, motion.positions);
}

TEST(MotionRows, TellHowFinelyTheyArePrinted) {
  EXPECT_DOUBLE_EQ(read(kRows).rounding[1], 0.01);
  EXPECT_DOUBLE_EQ(read("t,x0,y0,z0,x1,y1,z1\n0.1,-0.25,-0.0512345,0.00123456,0.26,-0.05,0\n").rounding[0], 1e-6);
  EXPECT_DOUBLE_EQ(read("t,x0,y0,z0,x1,y1,z1\n1e-1,-2.5e-1,0,0,2.501e-1,-5e-2,0\n").rounding[0], 1e-4);
}

TEST(MotionRows, GiveTheStepsThatLeadToTheirTimes) {
  GivenMotion motion;
  motion.timeRounding = 1e-6;
  for (int k = 1; k <= 30; ++k) motion.times.push_back(std::round(1e6 * k / 60) / 1e6);
  const std::vector<double> steps = stepsOnto(motion, {0.001, 0.0125});
  EXPECT_DOUBLE_EQ(steps.front(), 1.0 / 60);
  EXPECT_EQ(std::ranges::count(steps, 0.0125), 0);
  EXPECT_EQ(stepCounts(motion, 1.0 / 120).back(), 60);
  EXPECT_TRUE(stepCounts(motion, 0.0125).empty());
  motion.times = {0.03, 0.05, 0.1};
  motion.timeRounding = 1e-17;
  EXPECT_DOUBLE_EQ(stepsOnto(motion, {}).front(), 0.01);
}

TEST(MotionRows, ThatAreNoneAreRefusedWithWhatWasFoundAndWhatIsAllowed) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kRows;
    return text.replace(text.find(from), from.size(), to);
  };
  struct Wrong {
    std::string text;
    std::vector<std::string> said;
  };
  for (const Wrong& wrong : {
           Wrong{"", {"line 1", "empty file", "t,particle,x,y,z"}},
           Wrong{"t,particle,x,y,z\n", {"line 1", "no row"}},
           Wrong{"t;particle;x;y;z\n0;0;0;0;0\n", {"line 1", "no column t", "comma"}},
           Wrong{"t,particle,x,y\n", {"line 1", "no column z", "t,particle,x,y,z"}},
           Wrong{with("0.26,-0.05,0\n", "0.26,-0.05\n"), {"line 5", "4 fields", "5"}},
           Wrong{with("0.26", "0,26"), {"line 5", "6 fields"}},
           Wrong{with("0.26", "fast"), {"line 5", "column x", "'fast'", "number"}},
           Wrong{with("0.26", ""), {"line 5", "column x", "nothing"}},
           Wrong{with("0.26", "nan"), {"line 5", "column x", "nan", "finite"}},
           Wrong{with("0.26", "-inf"), {"line 5", "column x", "-inf", "finite"}},
           Wrong{with("0.1,1", "-0.1,1"), {"line 5", "column t", "-0.1"}},
           Wrong{with("0.1,1", "0.1,2"), {"line 5", "column particle", "found 2", "0 to 1", "2 x 1", "--sheet"}},
           Wrong{with("0.1,1", "0.1,0.5"), {"line 5", "column particle", "found 0.5"}},
           Wrong{with("0.1,1", "0.1,0"), {"line 5", "particle 0 at t = 0.1 s again", "line 4"}},
           Wrong{with("0.1,1,0.26,-0.05,0\n", ""), {"line 4", "1 particles at t = 0.1 s, 1 is missing", "0 to 1"}},
           Wrong{"t,particle,x,y,z\n0,0,-0.25,0,0\n0,1,0.25,0,0\n", {"no time but t = 0"}},
           Wrong{"t,particle,x,y,z\n0,0,-250,0,0\n0,1,250,0,0\n1,0,-250,0,0\n1,1,250,0,0\n", {"1000 times", "mm", "m"}},
           Wrong{"t,particle,x,y,z\n1,0,-25,0,0\n1,1,25,0,0\n", {"100 times", "cm"}},
           Wrong{with("0,0,-0.25,0,0", "0,0,-0.2,0,0"), {"particle 0 at (-0.2, 0, 0) m", "(-0.25, 0, 0) m"}},
           Wrong{"t,particle,x,y,z\n2000,0,-0.25,0,0\n2000,1,0.25,0,0\n", {"2000", "milliseconds", "--duration"}},
           Wrong{"t,x0,y0,z0\n1,0,0,0\n", {"no column x1", "0 to 1"}},
           Wrong{"t,x0,y0,z0,x1,y1,z1,x2\n1,0,0,0,0,0,0,0\n", {"column x2", "0 to 1"}},
       }) {
    const std::string message = refusal(wrong.text);
    EXPECT_NE(message.find("mine.csv"), std::string::npos) << wrong.text << "\n" << message;
    for (const std::string& words : wrong.said) {
      EXPECT_NE(message.find(words), std::string::npos) << wrong.text << "\nsaid: " << message << "\nnot: " << words;
    }
  }
}

}  // namespace
}  // namespace tyg::test
