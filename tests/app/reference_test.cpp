// `tyg reference`: its file in both forms, which `tyg check` calls right, its words, its JSON, and what it refuses.
#include <algorithm>
#include <sstream>
#include <string>
#include <vector>

#include "app/program.h"

namespace tyg {
namespace {

class ReferenceCommand : public testing::Test {
 protected:
  [[nodiscard]] std::string file(const std::string& name) const { return (folder_ / name).string(); }
  /// The numbers below a header, line by line, without the first `left` columns.
  static std::vector<std::string> numbersOf(const std::string& text, std::size_t left) {
    std::istringstream lines(text);
    std::string line, field;
    std::vector<std::string> numbers;
    std::getline(lines, line);
    while (std::getline(lines, line)) {
      std::istringstream fields(line);
      for (std::size_t k = 0; std::getline(fields, field, ','); ++k) {
        if (k >= left) numbers.push_back(field);
      }
    }
    return numbers;
  }
  const Folder folder_;
};

TEST_F(ReferenceCommand, WritesAMotionThatTheCheckCallsRightToRounding) {
  const Outcome made = tyg("reference four-particles --duration 2 --samples 40 --out " + file("exact.csv"));
  EXPECT_EQ(made.code, 0) << made.err;
  EXPECT_TRUE(holds(made.out, "exact.csv: 40 times up to 2 s, 4 particles")) << made.out;
  EXPECT_EQ(linesOf(file("exact.csv")), 1U + 40 * 4);
  const Outcome checked = tyg("check four-particles " + file("exact.csv") + " --within 1e-9 --json");
  EXPECT_EQ(checked.code, 0) << checked.out << checked.err;
  EXPECT_EQ(jsonValue(checked.out, "mistake"), "null");
  const Outcome told = tyg("check four-particles " + file("exact.csv"));
  EXPECT_TRUE(holds(told.out, "The truth is known only to the floor")) << told.out;
}

TEST_F(ReferenceCommand, WritesTheSameNumbersInTheWideForm) {
  const std::string options = "reference four-particles --duration 1 --samples 5 ";
  ASSERT_EQ(tyg(options + "--out " + file("long.csv")).code, 0);
  ASSERT_EQ(tyg(options + "--wide --out " + file("wide.csv")).code, 0);
  const std::string wide = contentsOf(file("wide.csv"));
  EXPECT_TRUE(wide.starts_with("t,x0,y0,z0,x1,y1,z1,x2,y2,z2,x3,y3,z3\n0.2")) << wide;
  EXPECT_EQ(numbersOf(wide, 1), numbersOf(contentsOf(file("long.csv")), 2));
  EXPECT_EQ(tyg("check four-particles " + file("wide.csv") + " --within 1e-9").code, 0);
}

TEST_F(ReferenceCommand, InJsonTellsHowFarTheMotionIsKnown) {
  const Outcome outcome = tyg("reference four-particles --duration 1 --json --out " + file("exact.csv"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  EXPECT_EQ(jsonKeys(outcome.out), (std::vector<std::string>{"scene", "file", "samples", "particles", "duration_s",
                                                             "size_m", "floor_m", "horizon_s"}));
  EXPECT_EQ(jsonValue(outcome.out, "samples"), "20");
  EXPECT_EQ(jsonValue(outcome.out, "horizon_s"), "1.0");
  EXPECT_LT(std::stod(jsonValue(outcome.out, "floor_m")), 1e-10);
}

TEST_F(ReferenceCommand, EndsWithTheLastCertainTimeWhereClothTears) {
  const Outcome outcome = tyg("reference tear --json --out " + file("tear.csv"));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const std::string last = contentsOf(file("tear.csv"));
  EXPECT_FALSE(last.empty());
  EXPECT_GT(std::stod(jsonValue(outcome.out, "duration_s")), 0);
}

TEST_F(ReferenceCommand, RefusesWhatItCannotWriteAndLeavesNoFileBehind) {
  for (const auto& [arguments, said] :
       {std::pair{"curtain --out " + file("no/folder.csv"), "folder.csv"},
        std::pair{std::string("curtain --samples 0"), "--samples"}, std::pair{std::string("nowhere"), "nowhere"}}) {
    const Outcome outcome = tyg("reference " + arguments);
    EXPECT_EQ(outcome.code, 2) << arguments;
    EXPECT_TRUE(holds(outcome.err, said)) << arguments << "\n" << outcome.err;
  }
  EXPECT_EQ(folder_.fileCount(), 0U);
}

}  // namespace
}  // namespace tyg
