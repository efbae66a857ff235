// Files appear whole or not at all, and a place that cannot be written is known beforehand.
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>

#include "files.h"
#include "tyg/scene.h"
#include "util/whole_file.h"

namespace tyg::test {
namespace {

namespace fs = std::filesystem;

std::string refusalOf(const fs::path& path) {
  try {
    checkWritable(path);
  } catch (const InputError& mistake) {
    return mistake.what();
  }
  return "nothing was refused";
}

TEST(WholeFile, ThatNeverEndsIsRefused) {
  try {
    (void)readWholeFile("/dev/zero", "cannot read", "a file");
    FAIL() << "it was read";
  } catch (const InputError& refusal) {
    EXPECT_STREQ(refusal.what(), "cannot read '/dev/zero': it has more than 268435456 bytes; allowed: a file");
  }
}

TEST(WholeFile, IsWrittenByteForByteAndAlone) {
  const Folder folder;
  const std::string bytes("one\r\n\0two", 9);
  writeWholeFile(folder / "a.csv", bytes);
  EXPECT_EQ(contentsOf(folder / "a.csv"), bytes);
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WholeFile, ReplacesWhatWasThere) {
  const Folder folder;
  folder.write("a.csv", "a longer old text");
  writeWholeFile(folder / "a.csv", "new");
  EXPECT_EQ(contentsOf(folder / "a.csv"), "new");
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

TEST(WholeFile, CheckingLeavesNoTrace) {
  const Folder folder;
  folder.write("old.csv", "old");
  checkWritable(folder / "old.csv");
  checkWritable(folder / "new.csv");
  EXPECT_EQ(contentsOf(folder / "old.csv"), "old");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WholeFile, RefusesAFolderThatIsNotThere) {
  const Folder folder;
  const std::string refusal = refusalOf(folder / "none" / "a.csv");
  EXPECT_TRUE(holds(refusal, "the folder '" + (folder / "none").string() + "' cannot be found")) << refusal;
  EXPECT_TRUE(holds(refusal, "allowed")) << refusal;
}

TEST(WholeFile, RefusesFoldersDevicesFilesAsFoldersAndNoName) {
  const Folder folder;
  folder.write("file", "");
  EXPECT_TRUE(holds(refusalOf(folder / ""), "it names a folder")) << refusalOf(folder / "");
  EXPECT_TRUE(holds(refusalOf((folder / "").parent_path()), "it names a folder"));
  EXPECT_TRUE(holds(refusalOf(folder / "file" / "a.csv"), "is not a folder")) << refusalOf(folder / "file" / "a.csv");
  EXPECT_TRUE(holds(refusalOf("/dev/null"), "not a plain file"));
  EXPECT_TRUE(holds(refusalOf(""), "no name was given"));
}

TEST(WholeFile, RefusesAFolderThatNobodyMayWriteTo) {
  const std::string refusal = refusalOf("/proc/self/a.csv");  // not even the superuser
  EXPECT_TRUE(holds(refusal, "cannot write '/proc/self/a.csv': ")) << refusal;
}

TEST(WholeFile, ThatCannotBeWrittenLeavesTheOldOne) {
  const Folder folder;
  const fs::path old = folder.write("old.csv", "old");
  {
    WholeFile file(old);
    EXPECT_THROW(file.keep(), InputError) << "nothing was written to its temporary file";
  }
  EXPECT_EQ(contentsOf(old), "old");
}

TEST(WholeFile, WrittenPieceByPieceAppearsOnlyWhenKept) {
  const Folder folder;
  {
    WholeFile file(folder / "movie.mp4");
    EXPECT_EQ(file.temporary().extension(), ".mp4");
    EXPECT_EQ(file.temporary().parent_path(), (folder / "movie.mp4").parent_path());
    std::ofstream(file.temporary()) << "frames";
    EXPECT_FALSE(fs::exists(folder / "movie.mp4"));
    file.keep();
  }
  EXPECT_EQ(contentsOf(folder / "movie.mp4"), "frames");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WholeFile, ThatIsNotKeptGoesAway) {
  const Folder folder;
  {
    const WholeFile file(folder / "movie.mp4");
    std::ofstream(file.temporary()) << "half of the frames";
  }
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(WholeFile, TwoWritersOfOneFileDoNotMixAndTheLastOneIsKept) {
  const Folder folder;
  WholeFile first(folder / "a.csv"), second(folder / "a.csv");
  EXPECT_NE(first.temporary(), second.temporary());
  first.write("of the first");
  second.write("of the ");
  first.keep();
  second.write("second");
  second.keep();
  EXPECT_EQ(contentsOf(folder / "a.csv"), "of the second");
  EXPECT_EQ(folder.fileCount(), 1U);
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

TEST(WholeFile, IsReadByteForByte) {
  const Folder folder;
  const std::string bytes("one\r\n\0two", 9);
  EXPECT_EQ(readWholeFile(folder.write("a.csv", bytes), "cannot read", "a file"), bytes);
  EXPECT_EQ(readWholeFile(folder.write("empty", ""), "cannot read", "a file"), "");
}

TEST(WholeFile, ThatCannotBeReadIsRefusedWithTheReasonAndWhatIsAllowed) {
  const Folder folder;
  const fs::path nowhere = folder / "nowhere";
  try {
    readWholeFile(nowhere, "--log: cannot read", "a log");
    ADD_FAILURE() << "it was read";
  } catch (const InputError& error) {
    EXPECT_EQ(error.what(), "--log: cannot read '" + nowhere.string() + "': No such file or directory; allowed: a log");
  }
  EXPECT_THROW(readWholeFile(folder.path(), "", ""), InputError);
}

TEST(WholeFile, MayHaveTheLongestName) {
  const Folder folder;
  const fs::path longest = folder / (std::string(251, 'n') + ".csv");
  writeWholeFile(longest, "new");
  EXPECT_EQ(contentsOf(longest), "new");
}

}  // namespace
}  // namespace tyg::test
