// Files appear whole or not at all, and a place that cannot be written is known beforehand.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "files.h"
#include "tyg/scene.h"
#include "util/refusal_of.h"
#include "util/whole_file.h"

namespace tyg::test {
namespace {

namespace fs = std::filesystem;

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

TEST(WholeFile, RefusesFoldersFilesAsFoldersAndNoName) {
  const Folder folder;
  folder.write("file", "");
  EXPECT_TRUE(holds(refusalOf(folder / ""), "it names a folder")) << refusalOf(folder / "");
  EXPECT_TRUE(holds(refusalOf((folder / "").parent_path()), "it names a folder"));
  EXPECT_TRUE(holds(refusalOf(folder / "file" / "a.csv"), "is not a folder")) << refusalOf(folder / "file" / "a.csv");
  EXPECT_TRUE(holds(refusalOf(""), "no name was given"));
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
