// Other programs on Windows: what they print, how they end, and which are not there. The shell of Windows stands for
// them.
#include "util/child_process.h"

#include <gtest/gtest.h>

#include <system_error>

namespace tyg {
namespace {

constexpr double kLong = 60;  // s

TEST(ChildProcess, ReadsWhatItPrintsOnBothOutputsAndItsStatus) {
  ChildProcess child({"cmd", "/c", "echo hello&echo error 1>&2&exit 3"});
  EXPECT_EQ(child.wait(kLong).status, 3);
  EXPECT_NE(child.printed().find("hello"), std::string::npos) << child.printed();
  EXPECT_NE(child.printed().find("error"), std::string::npos) << child.printed();
}

TEST(ChildProcess, GivesItsInputToTheProgram) {
  ChildProcess child({"cmd", "/q"});
  EXPECT_TRUE(child.write("exit 7\r\n", kLong));
  EXPECT_EQ(child.wait(kLong).status, 7);
}

TEST(ChildProcess, IsEndedWhereSomebodySaysSo) {
  ChildProcess child({"cmd", "/c", "for /l %i in (0,0,1) do rem"}, {}, [] { return true; });
  EXPECT_EQ(child.wait(kLong).kind, ChildProcess::Ending::Kind::Stopped);
}

TEST(ChildProcess, OneThatIsNotThereIsToldSo) {
  EXPECT_FALSE(isOnPath("no-such-program-of-tyg"));
  EXPECT_TRUE(isOnPath("cmd"));
  try {
    const ChildProcess child({"no-such-program-of-tyg"});
    FAIL() << "it was started";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code(), std::errc::no_such_file_or_directory);
  }
}

}  // namespace
}  // namespace tyg
