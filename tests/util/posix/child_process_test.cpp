// Other programs: what goes in and out, how they end, and that none is left running. Small shell scripts stand for
// them.
#include "util/child_process.h"

#include <gtest/gtest.h>

#include <cerrno>
#include <csignal>
#include <system_error>

#include "files.h"

namespace tyg {
namespace {

using Kind = ChildProcess::Ending::Kind;

constexpr double kLong = 60, kShort = 0.2;  // s
constexpr std::size_t kMuch = 1'000'000;    // bytes: more than any socket or pipe holds

std::vector<std::string> shell(const std::string& script) { return {"sh", "-c", script}; }

/// Does the process of this number, as a shell prints it, still run? One that has ended may be listed as a zombie.
bool runs(const std::string& number) {
  const std::string state = contentsOf("/proc/" + std::to_string(std::stoi(number)) + "/stat");
  return !state.empty() && !holds(state, ") Z");
}

TEST(ChildProcess, ReadsWhatItIsFedAndPrintsOnBothOutputs) {
  ChildProcess child(shell("cat; echo error >&2; exit 3"));
  EXPECT_TRUE(child.write("hello\n", kLong));
  EXPECT_EQ(child.wait(kLong).status, 3);
  EXPECT_EQ(child.printed(), "hello\nerror\n");
}

TEST(ChildProcess, OneThatPrintsMuchBeforeItReadsDoesNotBlock) {
  ChildProcess child(shell("head -c 1000000 /dev/zero >&2; wc -c"));
  EXPECT_TRUE(child.write(std::string(kMuch, 'x'), kLong));
  EXPECT_TRUE(child.wait(kLong).good());
  EXPECT_EQ(child.printed().substr(kMuch), "1000000\n");
}

TEST(ChildProcess, OneThatEndsEarlyIsNoticedAndItsLastWordsAreKept) {
  ChildProcess child(shell("echo enough; exit 1"));
  while (child.write(std::string(kMuch, 'x'), kLong)) {
  }
  EXPECT_EQ(child.wait(kLong).status, 1);
  EXPECT_EQ(child.printed(), "enough\n");
}

TEST(ChildProcess, RunsInTheFolderThatIsNamed) {
  const Folder folder;
  ChildProcess child(shell("touch here"), folder.path());
  EXPECT_TRUE(child.wait(kLong).good());
  EXPECT_TRUE(std::filesystem::exists(folder / "here"));
}

TEST(ChildProcess, WhereThereIsNoSuchProgramTheErrorSaysSo) {
  try {
    const ChildProcess child({"tyg-no-such-program"});
    ADD_FAILURE() << "it started";
  } catch (const std::system_error& error) {
    EXPECT_EQ(error.code().value(), ENOENT);
  }
  EXPECT_FALSE(isOnPath("tyg-no-such-program"));
  EXPECT_TRUE(isOnPath("sh"));
}

TEST(ChildProcess, OneThatIsStoppedDoesNotGoOnAndNorDoesWhatItStarted) {
  const ChildProcess* running = nullptr;
  ChildProcess child(shell("sleep 100 & echo $!; wait"), {}, [&] { return running->printed().ends_with('\n'); });
  running = &child;
  EXPECT_EQ(child.wait(kLong).kind, Kind::Stopped);
  while (runs(child.printed())) {  // until the signal has reached it
  }
}

TEST(ChildProcess, OneThatHangsIsEndedWhenItsTimeIsOver) {
  ChildProcess child(shell("echo here; exec sleep 100"));
  const ChildProcess::Ending ending = child.wait(kShort);
  EXPECT_EQ(ending.kind, Kind::TooLate);
  EXPECT_FALSE(ending.good());
  EXPECT_EQ(child.printed(), "here\n");
}

TEST(ChildProcess, OneThatClosesItsOutputsAndGoesOnHasADeadlineToo) {
  ChildProcess child(shell("exec <&- >&- 2>&- sleep 100"));
  EXPECT_EQ(child.wait(kShort).kind, Kind::TooLate);
}

TEST(ChildProcess, OneThatLeavesAnotherBehindHasEndedAllTheSame) {
  ChildProcess child(shell("sleep 100 & echo $!"));
  EXPECT_TRUE(child.wait(kLong).good());
  ::kill(std::stoi(child.printed()), SIGKILL);
}

TEST(ChildProcess, OneThatTakesNothingIsGivenUp) {
  ChildProcess child(shell("exec sleep 100"));
  EXPECT_FALSE(child.write(std::string(kMuch, 'x'), kShort));
}

TEST(ChildProcess, WritingEndsWhenItIsStopped) {
  ChildProcess child(shell("exec sleep 100"), {}, [] { return true; });
  EXPECT_FALSE(child.write(std::string(kMuch, 'x'), kLong));
}

TEST(ChildProcess, OneThatNobodyWaitsForIsEnded) {
  const Folder folder;
  const std::string file = (folder / "number").string();
  {
    const ChildProcess child(shell("echo $$ >'" + file + "'; exec sleep 100"));
    while (contentsOf(file).empty()) {
    }
  }
  EXPECT_FALSE(runs(contentsOf(file)));
}

}  // namespace
}  // namespace tyg
