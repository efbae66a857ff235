// A picture that lacks its end is told from a whole one, wherever it was cut.
#include "util/whole_picture.h"

#include <gtest/gtest.h>

#include "files.h"
#include "tyg/input_error.h"

namespace tyg {
namespace {

using namespace std::string_literals;

const std::string kPng =
    "\x89PNG\r\n\x1A\n"
    "\0\0\0\2IHDRab....\0\0\0\0IEND\xAE\x42\x60\x82"s;
const std::string kGif =
    "GIF89a\1\0\1\0\x80\0\0......!\xFE\2ab\0"
    ",\0\0\0\0\1\0\1\0\0\2\3abc\1d\0;"s;
const std::string kMp4 =
    "\0\0\0\x0C"
    "ftypisom\0\0\0\x09moov.\0\0\0\1mdat\0\0\0\0\0\0\0\x13..."s;
const std::string kSvg = "<?xml version=\"1.0\"?>\n<svg><g></g></svg>\n";

class WholePicture : public testing::Test {
 protected:
  bool isWhole(const std::string& ending, const std::string& bytes) {
    return isWholePicture(folder_.write("a" + ending, bytes));
  }
  const Folder folder_;
};

TEST_F(WholePicture, EachFormatIsWholeOnlyUpToItsLastByte) {
  for (const auto& [ending, bytes] :
       {std::pair(".png"s, kPng), std::pair(".gif"s, kGif), std::pair(".mp4"s, kMp4), std::pair(".svg"s, kSvg)}) {
    EXPECT_TRUE(isWhole(ending, bytes)) << ending;
    const std::size_t last = ending == ".svg" ? bytes.size() - 1 : bytes.size();  // the line break may be missing
    for (std::size_t count = 0; count < last; ++count) {
      EXPECT_FALSE(isWhole(ending, bytes.substr(0, count))) << ending << " of " << count << " bytes";
    }
    EXPECT_FALSE(isWhole(ending, bytes + "more")) << ending;
  }
}

TEST_F(WholePicture, OneFormatIsNotAnotherAndAMovieHasFramesAndAnIndex) {
  EXPECT_FALSE(isWhole(".png", kGif));
  EXPECT_FALSE(isWhole(".txt", kPng));
  EXPECT_FALSE(isWhole(".mp4",
                       "\0\0\0\x0C"
                       "ftypisom"s));
  EXPECT_FALSE(isWhole(".mp4", "\0\0\0\x09moov.\0\0\0\x08mdat"s));
  EXPECT_FALSE(isWholePicture(folder_ / "nothing.png"));
}

TEST_F(WholePicture, OneThatIsNotWholeKeepsAllFromBeingReplaced) {
  folder_.write("a.svg", "old"), folder_.write("a.png", "old");
  {
    WholeFile svg(folder_ / "a.svg"), png(folder_ / "a.png");
    svg.write(kSvg);
    png.write(kPng.substr(0, 20));
    EXPECT_THROW(keepPictures({&svg, &png}), InputError);
  }
  EXPECT_EQ(contentsOf(folder_ / "a.svg") + contentsOf(folder_ / "a.png"), "oldold");
  WholeFile svg(folder_ / "a.svg"), png(folder_ / "a.png");
  svg.write(kSvg);
  png.write(kPng);
  keepPictures({&svg, &png});
  EXPECT_EQ(contentsOf(folder_ / "a.svg") + contentsOf(folder_ / "a.png"), kSvg + kPng);
}

}  // namespace
}  // namespace tyg
