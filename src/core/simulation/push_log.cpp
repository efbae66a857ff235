// A push log as text, written and read back to the same bits.
// Must not know: files, windows, the simulation.
#include "tyg/push_log.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <system_error>

#include "core/scene/scene_writer.h"
#include "util/text.h"

namespace tyg {
namespace {

constexpr std::string_view kColumns = "tick,event,particle,fx,fy,fz,ticks,method,dt";
constexpr std::size_t kColumnCount = 9;
constexpr std::string_view kSceneMark = "##";
constexpr std::array<std::string_view, 8> kKeys = {"scene", "columns",   "rows",  "integrator",
                                                   "dt",    "precision", "ticks", "hash"};

/// An event that keeps numbers in the fields of a push's force: how many, and the lowest that they may be.
struct Change {
  LogEvent::Kind kind;
  std::string_view name;
  std::size_t count;
  bool positive, anySign;
};
constexpr std::array<Change, 6> kChanges{{{LogEvent::Kind::Structural, "structural", 2, false, false},
                                          {LogEvent::Kind::Shear, "shear", 2, false, false},
                                          {LogEvent::Kind::Bend, "bend", 2, false, false},
                                          {LogEvent::Kind::Gravity, "gravity", 3, false, true},
                                          {LogEvent::Kind::Drag, "drag", 1, false, false},
                                          {LogEvent::Kind::Tolerance, "tolerance", 1, true, false}}};

std::string lineOf(const LogEvent& event) {
  const std::string tick = std::to_string(event.tick);
  const std::array<double, 3> numbers{event.force.x, event.force.y, event.force.z};
  switch (event.kind) {
    case LogEvent::Kind::Push:
      return tick + ",push," + std::to_string(event.particle) + ',' + longNumber(event.force.x) + ',' +
             longNumber(event.force.y) + ',' + longNumber(event.force.z) + ',' + std::to_string(event.ticks) + ",,";
    case LogEvent::Kind::Method:
      return tick + ",method,,,,,," + event.method + ',';
    case LogEvent::Kind::Step:
      return tick + ",step,,,,,,," + longNumber(event.dt);
    default:
      break;
  }
  const auto change =
      std::find_if(kChanges.begin(), kChanges.end(), [&](const Change& c) { return c.kind == event.kind; });
  std::string line = tick + ',' + std::string(change->name) + ',';
  for (std::size_t k = 0; k < numbers.size(); ++k) line += ',' + (k < change->count ? longNumber(numbers[k]) : "");
  return line + ",,,";
}

/// Walks through the text line by line and knows where it is for messages.
class LogReader {
 public:
  LogReader(std::string_view text, const std::string& file) : rest_(text), file_(file) {}

  PushLog read() {
    readHead();
    while (nextLine()) readEvent();
    return log_;
  }

 private:
  using Fields = std::array<std::string_view, kColumnCount>;

  bool nextLine() {
    if (rest_.empty()) return false;
    const std::size_t end = rest_.find('\n');
    line_ = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    if (!line_.empty() && line_.back() == '\r') line_.remove_suffix(1);
    ++lineNumber_;
    return true;
  }

  [[noreturn]] void refuse(std::string_view what, std::string_view found, const std::string& allowed) const {
    throw InputError(file_ + ':' + std::to_string(std::max(1, lineNumber_)) + ": " + std::string(what) + ": found '" +
                     std::string(found) + "', allowed " + allowed);
  }

  template <class Number>
  [[nodiscard]] Number number(std::string_view what, std::string_view text, Number lowest, Number highest) const {
    Number value{};
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = end.ec == std::errc() && end.ptr == text.data() + text.size();
    if (!whole || !(value >= lowest && value <= highest)) {
      refuse(what, text, "a whole number from " + std::to_string(lowest) + " to " + std::to_string(highest));
    }
    return value;
  }

  [[nodiscard]] double finite(std::string_view what, std::string_view text, bool positive) const {
    double value = 0;
    const auto end = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = end.ec == std::errc() && end.ptr == text.data() + text.size();
    if (!whole || !std::isfinite(value) || (positive && value <= 0)) {
      refuse(what, text, positive ? "a finite number above 0" : "a finite number");
    }
    return value;
  }

  void readHead() {
    std::array<bool, kKeys.size()> seen{};
    while (nextLine() && line_ != kColumns) readKey(seen);
    if (line_ != kColumns) refuse("line", line_, "the line " + std::string(kColumns));
    for (std::size_t key = 0; key < kKeys.size(); ++key) {
      const bool optional = kKeys[key] == "hash";
      if (!seen[key] && !optional)
        refuse(kKeys[key], "", "a line '# " + std::string(kKeys[key]) + " = ...' above this");
    }
  }

  void readKey(std::array<bool, kKeys.size()>& seen) {
    if (line_.starts_with(kSceneMark)) {
      const std::string_view rest = line_.substr(kSceneMark.size());
      log_.sceneText.append(rest.substr(rest.starts_with(' ') ? 1 : 0)).append("\n");
      return;
    }
    constexpr std::string_view kMark = "# ", kEquals = " = ";
    const std::size_t equals = line_.find(kEquals);
    if (line_.substr(0, kMark.size()) != kMark || equals == std::string_view::npos) {
      refuse("line", line_, "'# key = value', or the line " + std::string(kColumns));
    }
    const std::string_view key = line_.substr(kMark.size(), equals - kMark.size());
    const auto known = std::find(kKeys.begin(), kKeys.end(), key);
    if (known == kKeys.end()) refuse("key", key, "scene, columns, rows, integrator, dt, precision, ticks, hash");
    bool& before = seen[static_cast<std::size_t>(known - kKeys.begin())];
    if (before) refuse(key, "a second time", "each key once");
    before = true;
    keep(key, line_.substr(equals + kEquals.size()));
  }

  void keep(std::string_view key, std::string_view value) {
    constexpr std::int64_t kForever = std::numeric_limits<std::int64_t>::max();
    if (key == "scene") log_.scene = name(key, value);
    if (key == "columns") log_.columns = number(key, value, 1, kLargestCount);
    if (key == "rows") log_.rows = number(key, value, 1, kLargestCount);
    if (key == "integrator") log_.integrator = name(key, value);
    if (key == "dt") log_.dt = finite(key, value, true);
    if (key == "ticks") log_.ticks = number(key, value, std::int64_t{0}, kForever);
    if (key == "hash") log_.hash = hash(value);
    if (key == "precision") {
      if (value != "float" && value != "double") refuse(key, value, "float or double");
      log_.precision = value == "float" ? Precision::Float : Precision::Double;
    }
  }

  [[nodiscard]] std::string name(std::string_view what, std::string_view text) const {
    if (text.empty()) refuse(what, text, "a name");
    return std::string(text);
  }

  [[nodiscard]] std::string hash(std::string_view text) const {
    constexpr std::size_t kDigits = 16;
    if (text.size() > kDigits || text.find_first_not_of("0123456789abcdefABCDEF") != std::string_view::npos) {
      refuse("hash", text, "nothing or up to 16 hexadecimal digits");
    }
    return std::string(text);
  }

  [[nodiscard]] Fields split() const {
    Fields fields;
    const auto count = static_cast<std::size_t>(std::count(line_.begin(), line_.end(), ',')) + 1;
    if (count != fields.size()) refuse("line", line_, "nine fields " + std::string(kColumns));
    std::string_view rest = line_;
    for (std::string_view& field : fields) {
      const std::size_t end = rest.find(',');
      field = rest.substr(0, end);
      rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
    return fields;
  }

  void readEvent() {
    const Fields fields = split();
    const std::int64_t earliest = log_.events.empty() ? 0 : log_.events.back().tick;
    LogEvent event;
    event.tick = number("tick", fields[0], earliest, std::numeric_limits<std::int64_t>::max());
    if (fields[1] == "push") {
      readPush(fields, event);
    } else if (fields[1] == "method") {
      event.kind = LogEvent::Kind::Method;
      event.method = name("method", fields[7]);
    } else if (fields[1] == "step") {
      event.kind = LogEvent::Kind::Step;
      event.dt = finite("dt", fields[8], true);
    } else {
      readChange(fields, event);
    }
    refuseStrays(fields, event.kind);
    log_.events.push_back(event);
  }

  void readPush(const Fields& fields, LogEvent& event) const {
    event.kind = LogEvent::Kind::Push;
    event.particle = number("particle", fields[2], 0, log_.columns * log_.rows - 1);
    event.force = {finite("fx", fields[3], false), finite("fy", fields[4], false), finite("fz", fields[5], false)};
    event.ticks = number("ticks", fields[6], 1, std::numeric_limits<int>::max());
  }

  void readChange(const Fields& fields, LogEvent& event) const {
    const auto change =
        std::find_if(kChanges.begin(), kChanges.end(), [&](const Change& c) { return c.name == fields[1]; });
    if (change == kChanges.end()) {
      refuse("event", fields[1], "push, method, step, structural, shear, bend, gravity, drag or tolerance");
    }
    event.kind = change->kind;
    constexpr std::array<std::string_view, 3> kNames{"fx", "fy", "fz"};
    std::array<double, 3> numbers{};
    for (std::size_t k = 0; k < change->count; ++k) {
      numbers[k] = finite(kNames[k], fields[3 + k], change->positive);
      if (numbers[k] < 0 && !change->anySign) refuse(kNames[k], fields[3 + k], "a finite number from 0");
    }
    event.force = {numbers[0], numbers[1], numbers[2]};
  }

  /// A number in a field that its event does not use is a mistake somewhere: it is not passed over.
  void refuseStrays(const Fields& fields, LogEvent::Kind kind) const {
    const auto change = std::find_if(kChanges.begin(), kChanges.end(), [&](const Change& c) { return c.kind == kind; });
    const std::size_t numbers = change == kChanges.end() ? 0 : change->count;
    for (std::size_t field = 2; field < fields.size(); ++field) {
      const bool pushField = field <= 6;
      const bool used = (pushField && kind == LogEvent::Kind::Push) || (field == 7 && kind == LogEvent::Kind::Method) ||
                        (field == 8 && kind == LogEvent::Kind::Step) || (field >= 3 && field < 3 + numbers);
      if (!used && !fields[field].empty()) refuse("field " + std::to_string(field + 1), fields[field], "nothing");
    }
  }

  std::string_view rest_, line_;
  const std::string& file_;
  int lineNumber_ = 0;
  PushLog log_;
};

}  // namespace

PushLog beginLog(const Scene& scene, std::string_view integrator) {
  PushLog log;
  log.scene = scene.name;
  log.columns = scene.columns, log.rows = scene.rows;
  log.integrator = integrator;
  log.dt = scene.dt;
  log.precision = scene.precision;
  Scene begun = scene;
  begun.integrator = integrator;
  log.sceneText = sceneToToml(begun);
  return log;
}

std::string formatPushLog(const PushLog& log) {
  std::string text = "# scene = " + log.scene + "\n# columns = " + std::to_string(log.columns) +
                     "\n# rows = " + std::to_string(log.rows) + "\n# integrator = " + log.integrator +
                     "\n# dt = " + longNumber(log.dt) + "\n# precision = " + nameOf(log.precision) +
                     "\n# ticks = " + std::to_string(log.ticks) + "\n# hash = " + log.hash + '\n';
  for (std::string_view rest = log.sceneText; !rest.empty();) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    text.append(kSceneMark).append(end > 0 ? " " : "").append(rest.substr(0, end)).append("\n");
    rest.remove_prefix(std::min(end + 1, rest.size()));
  }
  text += std::string(kColumns) + '\n';
  for (const LogEvent& event : log.events) text += lineOf(event) + '\n';
  return text;
}

PushLog parsePushLog(std::string_view text, const std::string& fileName) { return LogReader(text, fileName).read(); }

void refuseUnfitLog(const PushLog& log, const PushLog& own) {
  const auto size = [](const PushLog& l) { return std::to_string(l.columns) + "x" + std::to_string(l.rows); };
  if (size(log) != size(own)) {
    throw InputError("replay: found a log of a " + size(log) + " sheet, allowed: one of this " + size(own) + " sheet");
  }
  if (log.precision != own.precision || log.integrator != own.integrator || log.dt != own.dt) {
    throw InputError("replay: found a log with another integrator, step or precision; allowed: the same as here");
  }
  for (const LogEvent& event : log.events) {
    if (event.kind == LogEvent::Kind::Push && (event.particle < 0 || event.particle >= own.columns * own.rows)) {
      throw InputError("replay: found a push on particle " + std::to_string(event.particle) + ", allowed: 0 to " +
                       std::to_string(own.columns * own.rows - 1));
    }
  }
}

}  // namespace tyg
