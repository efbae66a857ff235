// Folders appear whole or not at all, and keep what is not theirs.
#include "util/whole_folder.h"

#include <gtest/gtest.h>

#include "files.h"
#include "tyg/input_error.h"

namespace tyg::test {
namespace {

namespace fs = std::filesystem;

bool isText(const std::string& name) { return name.ends_with(".txt"); }

std::size_t filesIn(const fs::path& folder) {
  return std::size_t(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST(WholeFolder, IsThereWithAllItsFilesOnceItIsKept) {
  const Folder folder;
  WholeFolder written(folder / "new", isText);
  written.write("a.txt", "one"), written.write("b.txt", "two");
  EXPECT_FALSE(fs::exists(folder / "new"));
  written.keep();
  EXPECT_EQ(contentsOf(folder / "new/a.txt") + contentsOf(folder / "new/b.txt"), "onetwo");
  EXPECT_EQ(filesIn(folder / "new"), 2U);
  EXPECT_EQ(folder.fileCount(), 1U) << "nothing else is left";
}

TEST(WholeFolder, LeavesNothingWhereItIsNotKept) {
  const Folder folder;
  { WholeFolder(folder / "new", isText).write("a.txt", "one"); }
  EXPECT_EQ(folder.fileCount(), 0U);
}

TEST(WholeFolder, ReplacesAllThatAnEarlierResultLeft) {
  const Folder folder;
  folder.write("a.txt", "old"), folder.write("z.txt", "old");
  {
    WholeFolder dropped(folder.path(), isText);
    dropped.write("a.txt", "lost");
  }
  EXPECT_EQ(contentsOf(folder / "a.txt"), "old");
  WholeFolder written(folder.path() / "", isText);
  written.write("a.txt", "new");
  written.keep();
  EXPECT_EQ(contentsOf(folder / "a.txt"), "new");
  EXPECT_EQ(folder.fileCount(), 1U);
}

TEST(WholeFolder, RefusesToReplaceWhatIsNotItsOwn) {
  const Folder folder;
  folder.write("a.txt", "old"), folder.write("thesis.doc", "mine");
  EXPECT_THROW(WholeFolder(folder.path(), isText), InputError);
  EXPECT_THROW(WholeFolder(folder / "a.txt", isText), InputError) << "no folder";
  EXPECT_THROW(WholeFolder(folder / "nowhere/new", isText), InputError);
  EXPECT_EQ(folder.fileCount(), 2U);
}

TEST(WholeFolder, ClearsWhatAKilledOneLeftAndNothingThatIsInUse) {
  const Folder folder;
  fs::create_directory(folder / ".tyg-folder-new-1");
  folder.write(".tyg-folder-new-1/a.txt", "half");
  WholeFolder first(folder / "new", isText), second(folder / "new", isText);
  first.write("a.txt", "first"), second.write("a.txt", "second");
  EXPECT_EQ(folder.fileCount(), 2U);
  first.keep();
  EXPECT_EQ(contentsOf(folder / "new/a.txt"), "first");
}

}  // namespace
}  // namespace tyg::test
