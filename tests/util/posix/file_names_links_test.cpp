// Names that links have taken.
#include <gtest/gtest.h>

#include <filesystem>

#include "files.h"
#include "util/file_names.h"

namespace tyg {
namespace {

TEST(FreeName, IsNotThatOfALinkThatLeadsNowhere) {
  const Folder folder;
  std::filesystem::create_symlink("nowhere", folder / "a.toml");
  EXPECT_EQ(freeName(folder.path(), "a", ".toml"), folder / "a-2.toml");
}

}  // namespace
}  // namespace tyg
