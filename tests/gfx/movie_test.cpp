// Movies that ffmpeg refuses, or that are given up: a small script stands for ffmpeg.
#include "gfx/movie.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "files.h"
#include "tyg/input_error.h"

namespace tyg {
namespace {

constexpr MovieForm kForm{.width = 64, .height = 64, .fps = 30, .patience = 60};

class FakeFfmpeg : public testing::Test {
 protected:
  void use(const std::string& script) {
    const auto path = bin_.write("ffmpeg", "#!/bin/sh\n" + script);
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    setenv("PATH", (bin_.path().string() + ":" + std::getenv("PATH")).c_str(), 1);
  }
  const Folder bin_, folder_;
  const Picture frame_{64, 64, std::vector<std::uint8_t>(64 * 64 * 4)};
};

TEST_F(FakeFfmpeg, ThatPrintsMuchAndGivesUpIsAnErrorAndNoDeadlock) {
  use("head -c 1000000 /dev/zero >&2; exit 1\n");
  Movie movie(folder_ / "a.mp4", kForm);
  EXPECT_THROW(
      {
        for (int frame = 0; frame < 1000; ++frame) movie.add(frame_);
        movie.finish();
      },
      InputError);
}

TEST_F(FakeFfmpeg, WhatItPrintsIsTheReason) {
  use("echo no codec >&2; exit 1\n");
  try {
    Movie(folder_ / "a.mp4", kForm).finish();
    ADD_FAILURE() << "it was made";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(), "ffmpeg could not make the movie: no codec\n");
  }
  EXPECT_EQ(folder_.fileCount(), 0U);
}

TEST_F(FakeFfmpeg, ThatLeavesHalfAFileAndExitsWithZeroReplacesNothing) {
  use("for file; do :; done; printf '\\000\\000\\000\\020ftypisom\\000\\000\\000\\000\\000\\001' >\"${file#file:}\"\n");
  folder_.write("a.mp4", "an earlier one");
  Movie movie(folder_ / "a.mp4", kForm);
  EXPECT_THROW(movie.finish(), InputError);
  EXPECT_EQ(contentsOf(folder_ / "a.mp4"), "an earlier one");
}

TEST_F(FakeFfmpeg, ThatTakesNothingIsGivenUp) {
  use("exec sleep 1000\n");
  MovieForm hasty = kForm;
  hasty.patience = 0.2;
  Movie movie(folder_ / "a.mp4", hasty);
  EXPECT_THROW(
      {
        for (int frame = 0; frame < 1000; ++frame) movie.add(frame_);
      },
      InputError);
}

TEST_F(FakeFfmpeg, ThatIsStoppedIsNoErrorAndNoMovie) {
  use("exec sleep 1000\n");
  {
    Movie movie(folder_ / "a.mp4", kForm, [] { return true; });
    for (int frame = 0; frame < 1000; ++frame) movie.add(frame_);
    EXPECT_FALSE(movie.finish());
  }
  EXPECT_EQ(folder_.fileCount(), 0U);
}

TEST_F(FakeFfmpeg, AMovieThatIsGivenUpLeavesNoFileAndDoesNotWait) {
  use("for file; do :; done; touch \"${file#file:}\"; exec sleep 1000\n");
  {
    Movie movie(folder_ / "a.mp4", kForm);
    while (folder_.fileCount() == 0) {
    }
  }
  EXPECT_EQ(folder_.fileCount(), 0U);
}

}  // namespace
}  // namespace tyg
