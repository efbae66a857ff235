// Files appear whole or not at all where links lead elsewhere, a process is killed, or nothing more fits.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <string>

#include "files.h"
#include "tyg/scene.h"
#include "util/refusal_of.h"
#include "util/whole_file.h"

namespace tyg::test {
namespace {

namespace fs = std::filesystem;

TEST(WholeFile, RefusesDevices) { EXPECT_TRUE(holds(refusalOf("/dev/null"), "not a plain file")); }

TEST(WholeFile, ThatNeverEndsIsRefused) {
  try {
    (void)readWholeFile("/dev/zero", "cannot read", "a file");
    FAIL() << "it was read";
  } catch (const InputError& refusal) {
    EXPECT_STREQ(refusal.what(), "cannot read '/dev/zero': it has more than 268435456 bytes; allowed: a file");
  }
}

TEST(WholeFile, ReplacesWhatALinkPointsToAndKeepsTheLink) {
  const Folder folder;
  folder.write("real.csv", "old");
  fs::create_symlink(folder / "real.csv", folder / "link.csv");
  writeWholeFile(folder / "link.csv", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "link.csv"));
  EXPECT_EQ(contentsOf(folder / "real.csv"), "new");
}

TEST(WholeFile, MakesWhatALinkPointsToWhereItIsNotThereYet) {
  const Folder folder;
  fs::create_symlink("second.csv", folder / "first.csv");
  fs::create_symlink("real.csv", folder / "second.csv");
  writeWholeFile(folder / "first.csv", "new");
  EXPECT_TRUE(fs::is_symlink(folder / "first.csv"));
  EXPECT_TRUE(fs::is_symlink(folder / "second.csv"));
  EXPECT_EQ(contentsOf(folder / "real.csv"), "new");
}

TEST(WholeFile, ALinkThatLeadsBackToItselfIsRefusedAndStays) {
  const Folder folder;
  fs::create_symlink("second", folder / "first");
  fs::create_symlink("first", folder / "second");
  EXPECT_TRUE(holds(refusalOf(folder / "first"), "a link that leads back to itself")) << refusalOf(folder / "first");
  EXPECT_TRUE(holds(refusalOf(folder / "first" / "a.csv"), "cannot be found"));
  EXPECT_TRUE(fs::is_symlink(folder / "first"));
}

TEST(WholeFile, RefusesAFolderThatNobodyMayWriteTo) {
  const std::string refusal = refusalOf("/proc/self/a.csv");  // not even the superuser
  EXPECT_TRUE(holds(refusal, "cannot write '/proc/self/a.csv': ")) << refusal;
}

TEST(WholeFile, WhatAKilledProcessHasLeftIsClearedByTheNextWriterOfTheSameFile) {
  const Folder folder;
  if (const pid_t child = fork(); child == 0) {
    WholeFile file(folder / "a.csv");
    file.write("half");
    (void)std::raise(SIGKILL);
  } else {
    waitpid(child, nullptr, 0);
  }
  ASSERT_EQ(folder.fileCount(), 1U);
  writeWholeFile(folder / "b.csv", "another");
  EXPECT_EQ(folder.fileCount(), 2U);
  writeWholeFile(folder / "a.csv", "whole");
  EXPECT_EQ(folder.fileCount(), 2U);
}

/// As long as this lives, no file grows beyond `bytes`: writing fails as it does on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    setrlimit(RLIMIT_FSIZE, &before_);
    (void)std::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  void (*handler_)(int) = std::signal(SIGXFSZ, SIG_IGN);  // the signal would end the program
  rlimit before_{};
};

/// What is said about `count` bytes that do not fit.
std::string refusalOfWriting(const fs::path& path, std::size_t count) {
  const FullDisk full(100);
  try {
    writeWholeFile(path, std::string(count, 'x'));
  } catch (const InputError& mistake) {
    return mistake.what();
  }
  return "nothing was refused";
}

TEST(WholeFile, ThatDoesNotFitLeavesTheOldOneAndNothingElse) {
  const Folder folder;
  const fs::path old = folder.write("old.csv", "old");
  for (const std::size_t count : {1000, 1000000}) {  // noticed when the file is closed, and while it is written
    EXPECT_TRUE(holds(refusalOfWriting(old, count), "File too large")) << refusalOfWriting(old, count);
    EXPECT_TRUE(holds(refusalOfWriting(folder / "new.csv", count), "File too large"));
  }
  EXPECT_EQ(contentsOf(old), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
  writeWholeFile(old, std::string(1000, 'x'));
  EXPECT_EQ(contentsOf(old), std::string(1000, 'x'));
}

}  // namespace
}  // namespace tyg::test
