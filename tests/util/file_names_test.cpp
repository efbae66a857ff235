// Names for files that nobody named: nothing that is there loses its name.
#include "util/file_names.h"

#include <gtest/gtest.h>

#include <array>

#include "files.h"

namespace tyg {
namespace {

TEST(FreeName, TakesNoOtherFilesPlace) {
  const Folder folder;
  EXPECT_EQ(freeName(folder.path(), "a", ".toml"), folder / "a.toml");
  folder.write("a.toml", "x");
  EXPECT_EQ(freeName(folder.path(), "a", ".toml"), folder / "a-2.toml");
  folder.write("a-2.toml", "x");
  EXPECT_EQ(freeName(folder.path(), "a", ".toml"), folder / "a-3.toml");
}

TEST(FreeStem, IsFreeWithEveryEnding) {
  constexpr std::array<std::string_view, 2> kEndings{".png", ".csv"};
  const Folder folder;
  EXPECT_EQ(freeStem(folder.path(), "a", kEndings, FirstName::Numbered), "a-1");
  folder.write("a-1.csv", "x");
  EXPECT_EQ(freeStem(folder.path(), "a", kEndings, FirstName::Numbered), "a-2");
  folder.write("a.mp4", "x");
  EXPECT_EQ(freeStem(folder.path(), "a", kEndings, FirstName::Plain), "a");
}

}  // namespace
}  // namespace tyg
