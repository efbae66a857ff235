// A line is put together in a fixed buffer and flushed, so that a frame allocates nothing for it.
#include "viewer/view_log.h"

#include <fmt/core.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>

namespace tyg {
namespace {

constexpr const char* kHeader =
    "frame,wall_s,sim_s,state,integrator,dt,eye_x,eye_y,eye_z,picked,pushes,kinetic_J,alarm,tool,held,pins,cuts\n";

/// Comma-separated fields in a fixed buffer. Numbers read back to the same value, whatever the locale.
class Fields {
 public:
  template <class Number>
  Fields& number(Number value) {
    comma();
    end_ = std::to_chars(end_, text_.data() + text_.size(), value).ptr;
    return *this;
  }
  Fields& word(std::string_view value) {
    comma();
    end_ += value.copy(end_, static_cast<std::size_t>(text_.data() + text_.size() - end_));
    return *this;
  }
  std::string_view line() {
    *end_++ = '\n';
    return {text_.data(), static_cast<std::size_t>(end_ - text_.data())};
  }

 private:
  void comma() {
    if (end_ != text_.data()) *end_++ = ',';
  }
  std::array<char, 1024> text_{};  // 17 fields of at most 25 characters and short names
  char* end_ = text_.data();
};

}  // namespace

ViewLog::ViewLog(const std::filesystem::path& path) : path_(path), file_(path, std::ios::binary) {
  if (!(file_ << kHeader << std::flush)) {
    throw InputError(
        fmt::format("--log: '{}' cannot be written ({}); allowed is a file in a folder that may be written to",
                    path.string(), std::strerror(errno)));
  }
}

void ViewLog::write(const ViewLogLine& line) {
  Fields fields;
  fields.number(line.frame).number(line.wall).number(line.time).word(line.state).word(line.integrator);
  fields.number(line.dt).number(line.eye.x).number(line.eye.y).number(line.eye.z);
  fields.number(line.picked).number(line.pushes).number(line.kinetic).word(line.alarm);
  fields.word(line.tool).number(line.held).number(line.pins).number(line.cuts);
  const std::string_view text = fields.line();
  if (!(file_ << text << std::flush)) {
    throw InputError(fmt::format("--log: '{}' cannot be written any more ({})", path_.string(), std::strerror(errno)));
  }
}

}  // namespace tyg
