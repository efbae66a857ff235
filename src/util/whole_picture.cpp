// Each format is a row of parts that say how long they are. PNG: W3C (2003), Portable Network Graphics, 5. GIF: version
// 89a (CompuServe 1990). MP4: ISO/IEC 14496-12, 4.2.
#include "util/whole_picture.h"

#include <cstdint>
#include <fstream>
#include <string>
#include <system_error>

#include <fmt/core.h>

#include "tyg/input_error.h"
#include "util/file_names.h"

namespace tyg {
namespace {

/// Reads a file from its beginning; going past its end is remembered.
class PartReader {
 public:
  explicit PartReader(const std::filesystem::path& path) : in_(path, std::ios::binary) {
    std::error_code error;
    size_ = std::filesystem::file_size(path, error);
    if (error) size_ = 0;
  }

  [[nodiscard]] bool good() const { return in_.good() && at_ <= size_; }
  [[nodiscard]] bool atEnd() const { return in_.good() && at_ == size_; }
  [[nodiscard]] std::uint64_t left() const { return size_ - at_; }

  std::string text(std::size_t count) {
    std::string bytes(count, '\0');
    in_.read(bytes.data(), static_cast<std::streamsize>(count));
    at_ += count;
    return bytes;
  }
  /// A whole number of so many bytes, the highest first.
  std::uint64_t number(std::size_t count) {
    std::uint64_t value = 0;
    for (const char byte : text(count)) value = value << 8U | static_cast<unsigned char>(byte);
    return value;
  }
  void skip(std::uint64_t count) {
    if (!good() || count > left()) return void(at_ = size_ + 1);
    at_ += count;
    in_.seekg(static_cast<std::streamoff>(at_));
  }

 private:
  std::ifstream in_;
  std::uint64_t size_ = 0, at_ = 0;
};

bool isWholePng(PartReader& in) {
  constexpr std::uint64_t kChecksum = 4;
  if (in.text(8) != "\x89PNG\r\n\x1A\n") return false;
  while (in.good() && !in.atEnd()) {
    const std::uint64_t length = in.number(4);
    const std::string kind = in.text(4);
    in.skip(length + kChecksum);
    if (kind == "IEND") return in.atEnd();
  }
  return false;
}

void skipColours(PartReader& in, std::uint64_t flags) {
  if ((flags & 0x80U) != 0) in.skip(std::uint64_t{3} << ((flags & 7U) + 1));
}

void skipBlocks(PartReader& in) {
  for (std::uint64_t length = in.number(1); in.good() && length > 0; length = in.number(1)) in.skip(length);
}

bool isWholeGif(PartReader& in) {
  constexpr std::uint64_t kExtension = 0x21, kImage = 0x2C, kEnd = 0x3B;
  if (!in.text(6).starts_with("GIF8")) return false;
  in.skip(4);  // width, height
  const std::uint64_t flags = in.number(1);
  in.skip(2);  // background, ratio of sides
  skipColours(in, flags);
  while (in.good() && !in.atEnd()) {
    const std::uint64_t part = in.number(1);
    if (part == kEnd) return in.atEnd();
    if (part != kExtension && part != kImage) return false;
    if (part == kImage) {
      in.skip(8);  // place, size
      skipColours(in, in.number(1));
    }
    in.skip(1);  // which extension, or the size of codes
    skipBlocks(in);
  }
  return false;
}

bool isWholeMp4(PartReader& in) {
  bool index = false, frames = false;
  while (in.good() && !in.atEnd()) {
    std::uint64_t length = in.number(4), head = 8;
    const std::string kind = in.text(4);
    if (length == 1) length = in.number(8), head = 16;
    if (length < head) return false;
    index = index || kind == "moov";
    frames = frames || (kind == "mdat" && length > head);
    in.skip(length - head);
  }
  return in.atEnd() && index && frames;
}

bool isWholeSvg(PartReader& in) {
  constexpr std::uint64_t kTail = 64;
  if (in.left() > kTail) in.skip(in.left() - kTail);
  std::string tail = in.text(static_cast<std::size_t>(in.left()));
  tail.erase(tail.find_last_not_of(" \r\n") + 1);
  return tail.ends_with("</svg>");
}

}  // namespace

bool isWholePicture(const std::filesystem::path& path) {
  PartReader in(path);
  const std::string ending = endingOf(path);
  return (ending == ".svg" && isWholeSvg(in)) || (ending == ".png" && isWholePng(in)) ||
         (ending == ".gif" && isWholeGif(in)) || (ending == ".mp4" && isWholeMp4(in));
}

void keepPictures(std::initializer_list<WholeFile*> files) {
  for (const WholeFile* file : files) {
    if (isWholePicture(file->temporary())) continue;
    throw InputError(fmt::format(
        "cannot write '{}': the program that draws it left an unfinished file; allowed is a disk with space "
        "for it. What was there before is still there",
        file->path().string()));
  }
  for (WholeFile* file : files) file->keep();
}

}  // namespace tyg
