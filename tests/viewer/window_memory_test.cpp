// What the window remembers: kept whole, read again, and ignored with a word where it is broken.
#include "viewer/window_memory.h"

#include <gtest/gtest.h>

#include "files.h"

namespace tyg {
namespace {

class WindowMemoryTest : public testing::Test {
 protected:
  const Folder folder_;
  const std::filesystem::path file_ = folder_ / "config" / "window";
};

TEST_F(WindowMemoryTest, KeepsWordsByTheirNamesUntilTheNextTime) {
  {
    WindowMemory memory(file_);
    EXPECT_EQ(memory.find("size"), std::nullopt);
    memory.keep("size", "640x400");
    memory.keep("background", "light");
    memory.keep("size", "800x600");
  }
  const WindowMemory later(file_);
  EXPECT_EQ(later.find("size"), "800x600");
  EXPECT_EQ(later.find("background"), "light");
  EXPECT_TRUE(later.trouble().empty());
}

TEST_F(WindowMemoryTest, IgnoresABrokenFileWithAWordAndWritesItAnew) {
  folder_.write("broken", "size = 640x400\nnonsense\n");
  WindowMemory memory(folder_ / "broken");
  EXPECT_EQ(memory.find("size"), std::nullopt);
  EXPECT_NE(memory.trouble().find("ignored"), std::string::npos);
  memory.keep("size", "800x600");
  EXPECT_TRUE(WindowMemory(folder_ / "broken").trouble().empty());
}

TEST_F(WindowMemoryTest, AWordThatIsOfNoUseIsForgottenAndTold) {
  folder_.write("odd", "size = huge\n");
  WindowMemory memory(folder_ / "odd");
  memory.refuse("size");
  EXPECT_EQ(memory.find("size"), std::nullopt);
  EXPECT_FALSE(memory.trouble().empty());
}

TEST_F(WindowMemoryTest, WithoutAFileNothingIsKept) {
  WindowMemory memory(std::nullopt);
  memory.keep("size", "640x400");
  EXPECT_EQ(memory.find("size"), std::nullopt);
}

TEST_F(WindowMemoryTest, AFolderThatCannotBeMadeIsNoTrouble) {
  folder_.write("config", "a file where a folder should be");
  WindowMemory memory(file_);
  memory.keep("size", "640x400");
  EXPECT_TRUE(memory.trouble().empty());
}

}  // namespace
}  // namespace tyg
