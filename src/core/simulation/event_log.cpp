// The head of a log, and the lines of version 2. A log is written and read in one pass, line after line.
#include "tyg/event_log.h"

#include <algorithm>
#include <array>

#include "core/simulation/event_kinds.h"
#include "core/simulation/event_log_version_1.h"
#include "core/simulation/log_lines.h"
#include "util/text.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

constexpr std::string_view kHeader = "tick,event,...";
constexpr std::string_view kSceneMark = "##";
constexpr std::array<std::string_view, 9> kKeys = {"version", "scene",     "columns", "rows", "integrator",
                                                   "dt",      "precision", "ticks",   "hash"};
constexpr std::array<std::string_view, 2> kOptionalKeys = {"version", "hash"};

/// Reads the columns of an event from the fields of a line.
class ColumnReader final : public EventColumns {
 public:
  ColumnReader(const LogLines& lines, std::string_view fields, int particles)
      : lines_(lines), rest_(fields), ended_(fields.empty()), particles_(particles) {}

  void particle(std::string_view name, int& index) override { index = lines_.whole(name, take(), 0, particles_ - 1); }
  void count(std::string_view name, int& number) override {
    number = lines_.whole(name, take(), 1, std::numeric_limits<int>::max());
  }
  void flag(std::string_view name, bool& value) override { value = lines_.whole(name, take(), 0, 1) == 1; }
  void number(std::string_view name, double& number, Allowed allowed) override {
    number = lines_.number(name, take(), allowed);
  }
  void word(std::string_view name, std::string& word, std::span<const std::string_view> allowed) override {
    word = lines_.name(name, take());
    if (!allowed.empty() && std::ranges::find(allowed, word) == allowed.end()) {
      lines_.refuse(name, word, joined(allowed));
    }
  }
  /// Whether every field was taken.
  [[nodiscard]] bool atEnd() const { return ended_; }

 private:
  /// The next field; an empty one after the last.
  std::string_view take() {
    ended_ = rest_.find(',') == std::string_view::npos;
    return LogLines::cut(rest_, ',');
  }

  const LogLines& lines_;
  std::string_view rest_;
  bool ended_;
  int particles_;
};

class LogReader {
 public:
  LogReader(std::string_view text, const std::string& file) : lines_(text, file) {}

  EventLog read() {
    readHead();
    while (lines_.next()) {
      if (version_ == 1) {
        readVersion1Event(lines_, log_);
      } else {
        readEvent();
      }
    }
    return log_;
  }

 private:
  [[nodiscard]] std::string_view header() const { return version_ == 1 ? kVersion1Columns : kHeader; }

  void readHead() {
    while (lines_.next() && lines_.line() != header()) readHeadLine();
    if (lines_.line() != header()) lines_.refuse("line", lines_.line(), fmt::format("the line {}", header()));
    for (std::size_t key = 0; key < kKeys.size(); ++key) {
      const bool optional = std::ranges::find(kOptionalKeys, kKeys[key]) != kOptionalKeys.end();
      if (!seen_[key] && !optional) {
        lines_.refuse(kKeys[key], "", fmt::format("a line '# {} = ...' above this", kKeys[key]));
      }
    }
  }

  void readHeadLine() {
    constexpr std::string_view kMark = "# ", kEquals = " = ";
    const std::string_view line = lines_.line();
    if (line.starts_with(kSceneMark)) {
      const std::string_view rest = line.substr(kSceneMark.size());
      log_.sceneText.append(rest.substr(rest.starts_with(' ') ? 1 : 0)).append("\n");
      return;
    }
    if (namesColumns(line)) return;
    const std::size_t equals = line.find(kEquals);
    if (!line.starts_with(kMark) || equals == std::string_view::npos) {
      lines_.refuse("line", line, fmt::format("'# key = value', or the line {}", header()));
    }
    const std::string_view key = line.substr(kMark.size(), equals - kMark.size());
    const auto known = std::ranges::find(kKeys, key);
    if (known == kKeys.end()) lines_.refuse("key", key, joined(kKeys));
    bool& before = seen_[static_cast<std::size_t>(known - kKeys.begin())];
    if (before) lines_.refuse(key, "a second time", "each key once");
    before = true;
    keep(key, line.substr(equals + kEquals.size()));
  }

  /// A line `# push: tick,push,...` is there for people.
  static bool namesColumns(std::string_view line) {
    return std::ranges::any_of(
        eventKinds(), [line](const EventKind& kind) { return line.starts_with(fmt::format("# {}: ", kind.name)); });
  }

  void keep(std::string_view key, std::string_view value) {
    if (key == "version") version_ = version(value);
    if (key == "scene") log_.scene = oneLine(lines_.name(key, value));
    if (key == "columns") log_.columns = lines_.whole(key, value, 1, kLargestCount);
    if (key == "rows") log_.rows = lines_.whole(key, value, 1, kLargestCount);
    if (key == "integrator") log_.integrator = lines_.name(key, value);
    if (key == "dt") log_.dt = lines_.number(key, value, Allowed::Positive);
    if (key == "ticks") log_.ticks = lines_.whole(key, value, std::int64_t{0}, LogLines::kMostTicks);
    if (key == "hash") log_.hash = hash(value);
    if (key == "precision") {
      if (value != "float" && value != "double") lines_.refuse(key, value, "float or double");
      log_.precision = value == "float" ? Precision::Float : Precision::Double;
    }
  }

  [[nodiscard]] int version(std::string_view text) const {
    if (text != "2") lines_.refuse("version", text, "2, or no such line in a log of version 1");
    return 2;
  }

  [[nodiscard]] std::string hash(std::string_view text) const {
    constexpr std::size_t kDigits = 16;
    if (text.size() > kDigits || text.find_first_not_of("0123456789abcdefABCDEF") != std::string_view::npos) {
      lines_.refuse("hash", text, "nothing or up to 16 hexadecimal digits");
    }
    return std::string(text);
  }

  void readEvent() {
    std::string_view rest = lines_.line();
    const std::int64_t earliest = log_.events.empty() ? 0 : log_.events.back().tick;
    const std::string_view tick = LogLines::cut(rest, ','), name = LogLines::cut(rest, ',');
    Event& event = log_.events.emplace_back();
    event.tick = lines_.whole("tick", tick, earliest, LogLines::kMostTicks);
    const auto kind = std::ranges::find(eventKinds(), name, &EventKind::name);
    if (kind == eventKinds().end()) lines_.refuse("event", name, joined(eventKinds(), &EventKind::name));
    event.action = kind->make();
    ColumnReader reader(lines_, rest, log_.columns * log_.rows);
    kind->visit(event.action, reader);
    if (!reader.atEnd()) lines_.refuse("line", lines_.line(), "the columns " + columnNames(event.action));
  }

  LogLines lines_;
  int version_ = 1;  // until the head says more
  std::array<bool, kKeys.size()> seen_{};
  EventLog log_;
};

}  // namespace

std::string formatEventLog(const EventLog& log) {
  std::string text = fmt::format(
      "# version = 2\n# scene = {}\n# columns = {}\n# rows = {}\n# integrator = {}\n# dt = {}\n# precision = {}\n"
      "# ticks = {}\n# hash = {}\n",
      oneLine(log.scene), log.columns, log.rows, log.integrator, log.dt, nameOf(log.precision), log.ticks, log.hash);
  for (std::string_view rest = log.sceneText; !rest.empty();) {
    const std::string_view line = LogLines::cut(rest, '\n');
    text.append(kSceneMark).append(line.empty() ? "" : " ").append(line).append("\n");
  }
  for (std::size_t k = 0; k < eventKinds().size(); ++k) {
    const EventKind& kind = eventKinds()[k];
    if (std::ranges::none_of(log.events, [k](const Event& event) { return event.action.index() == k; })) continue;
    text += fmt::format("# {}: {}\n", kind.name, columnNames(kind.make()));
    if (!kind.note.empty()) text += fmt::format("# {}: {}\n", kind.name, kind.note);
  }
  text.append(kHeader).append("\n");
  for (const Event& event : log.events) {
    text += fmt::format("{},{}{}\n", event.tick, kindOf(event.action).name, columnValues(event.action));
  }
  return text;
}

EventLog parseEventLog(std::string_view text, const std::string& fileName) { return LogReader(text, fileName).read(); }

}  // namespace tyg
