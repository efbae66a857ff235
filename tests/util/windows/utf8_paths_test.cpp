// Paths are made from UTF-8 and become UTF-8 again.
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "files.h"

namespace tyg {
namespace {

TEST(Utf8Paths, LettersBeyondOldCodePagesBecomeOneUnitEachAndComeBack) {
  const std::string text = "svårt-ж-☃";
  const std::filesystem::path path(text);
  EXPECT_EQ(path.native(), L"sv\u00e5rt-\u0436-\u2603");
  EXPECT_EQ(path.string(), text);
  EXPECT_EQ(path, std::filesystem::path(u8"svårt-ж-☃"));
}

TEST(Utf8Paths, WhatIsNoUtf8IsRefused) {
  for (const char* wrong : {"\xE5", "a\xC3", "\xC3(", "\xF0\x9F\x98\x80"}) {
    EXPECT_THROW((void)std::filesystem::path(wrong), std::filesystem::filesystem_error);
  }
}

TEST(Utf8Paths, FilesAreFoundUnderTheirNames) {
  const Folder folder;
  folder.write("svårt-ж.txt", "text");
  EXPECT_TRUE(std::filesystem::exists(folder.path() / std::filesystem::path(u8"svårt-ж.txt")));
  EXPECT_EQ(contentsOf(folder / "svårt-ж.txt"), "text");
}

}  // namespace
}  // namespace tyg
