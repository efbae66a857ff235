// The viewer's log: the header that scripts rely on, whole lines at any moment, numbers that read back.
#include "viewer/view_log.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <string>

#include "files.h"

namespace tyg {
namespace {

constexpr const char* kHeader =
    "frame,wall_s,sim_s,state,integrator,dt,eye_x,eye_y,eye_z,picked,pushes,kinetic_J,alarm,tool,held,pins,cuts\n";

class ViewLogTest : public testing::Test {
 protected:
  [[nodiscard]] std::string contents() const { return contentsOf(path_); }
  const Folder folder_;
  const std::filesystem::path path_ = folder_ / "view.csv";
};

TEST_F(ViewLogTest, AnEmptyLogHoldsTheHeader) {
  const ViewLog log(path_);
  EXPECT_EQ(contents(), kHeader);
}

TEST_F(ViewLogTest, EachLineIsThereAsSoonAsItIsWritten) {
  ViewLog log(path_);
  log.write({.frame = 7,
             .wall = 0.5,
             .time = 0.25,
             .state = "running",
             .integrator = "rk4",
             .dt = 0.002,
             .eye = {1, -2, 3.5},
             .picked = 210,
             .pushes = 2,
             .kinetic = 0.75,
             .alarm = "ok",
             .tool = "cut",
             .held = 3,
             .pins = 4,
             .cuts = 5});
  EXPECT_EQ(contents(), std::string(kHeader) + "7,0.5,0.25,running,rk4,0.002,1,-2,3.5,210,2,0.75,ok,cut,3,4,5\n");
}

TEST_F(ViewLogTest, NumbersReadBackToTheSameValue) {
  ViewLog log(path_);
  const double awkward = 0.1 + 0.2;
  ViewLogLine line;
  line.frame = 1;
  line.wall = awkward;
  log.write(line);
  const std::string text = contents();
  const std::size_t wall = text.find("1,", text.find('\n')) + 2;
  EXPECT_EQ(std::stod(text.substr(wall)), awkward);
}

TEST_F(ViewLogTest, TheWidestLineFits) {
  ViewLog log(path_);
  const double widest = -std::numeric_limits<double>::denorm_min() * 12345;
  log.write({.frame = std::numeric_limits<std::int64_t>::min(),
             .wall = widest,
             .time = widest,
             .state = "waiting",
             .integrator = "symplectic-euler",
             .dt = widest,
             .eye = {widest, widest, widest},
             .picked = std::numeric_limits<int>::min(),
             .pushes = std::numeric_limits<int>::min(),
             .kinetic = widest,
             .alarm = "not-finite",
             .tool = "hand",
             .held = std::numeric_limits<int>::min(),
             .pins = std::numeric_limits<int>::min(),
             .cuts = std::numeric_limits<int>::min()});
  EXPECT_TRUE(contents().ends_with(",-2147483648\n"));
}

TEST_F(ViewLogTest, ANewLogReplacesAnOldOne) {
  folder_.write("view.csv", "something else\n");
  const ViewLog log(path_);
  EXPECT_EQ(contents(), kHeader);
}

TEST_F(ViewLogTest, AFileThatCannotBeWrittenIsRefusedByName) {
  try {
    const ViewLog log("/no/such/folder/view.csv");
    FAIL() << "it was accepted";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("/no/such/folder/view.csv"), std::string::npos);
  }
}

TEST_F(ViewLogTest, AFullDiskIsReported) {
  if (!std::filesystem::exists("/dev/full")) GTEST_SKIP() << "this system has no /dev/full";
  EXPECT_THROW(
      {
        ViewLog log("/dev/full");
        log.write({});
      },
      InputError);
}

}  // namespace
}  // namespace tyg
