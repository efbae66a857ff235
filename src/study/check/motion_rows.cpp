// One pass over the lines gives numbers; sorted by time and particle they give the motion. What is refused is refused
// where it stands, so that a person finds the place.
#include "study/check/motion_rows.h"

#include <fmt/core.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "study/check/motion_fit.h"
#include "tyg/sheet.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

/// One particle at one time.
struct Entry {
  double t = 0;
  int particle = 0;
  Vec3 at;
  int line = 0;
};

std::string_view trimmed(std::string_view text) {
  const auto isEdge = [](char c) { return c == ' ' || c == '\t' || c == '\r' || c == '"'; };
  while (!text.empty() && isEdge(text.front())) text.remove_prefix(1);
  while (!text.empty() && isEdge(text.back())) text.remove_suffix(1);
  return text;
}

/// What a field shows in a message: not more of it than a line holds.
std::string shown(std::string_view field) {
  constexpr std::size_t kMost = 30;
  const std::string line = oneLine(std::string(field.substr(0, kMost)));
  return field.size() > kMost ? line + "..." : line;
}

/// How finely the numbers of a column are printed.
class Digits {
 public:
  void add(std::string_view number) {
    int significant = 0, decimals = 0, exponent = 0;
    bool behindPoint = false;
    for (std::size_t i = 0; i < number.size(); ++i) {
      const char c = number[i];
      if (c == 'e' || c == 'E') {
        std::string_view power = number.substr(i + 1);
        if (power.starts_with('+')) power.remove_prefix(1);
        std::from_chars(power.data(), power.data() + power.size(), exponent);
        break;
      }
      if (c == '.') behindPoint = true;
      if (c < '0' || c > '9') continue;
      if (behindPoint) ++decimals;
      if (significant > 0 || c != '0') ++significant;
    }
    significant_ = std::max(significant_, significant);
    decimals_ = std::max(decimals_, decimals - exponent);
  }
  /// One unit of the last digit of a number of this size: of a fixed number of decimals or of significant digits,
  /// whichever is coarser.
  [[nodiscard]] double unitAt(double size) const {
    const double fixed = std::pow(10.0, -decimals_);
    if (!(size > 0) || significant_ == 0) return fixed;
    return std::max(fixed, std::pow(10.0, std::floor(std::log10(size)) + 1 - significant_));
  }

 private:
  int significant_ = 0, decimals_ = 0;
};

class Reader {
 public:
  Reader(std::string_view text, const std::string& fileName, const Scene& scene)
      : rest_(text), file_(oneLine(fileName)), scene_(scene), sheet_(makeSheet(scene)) {}

  GivenMotion read() {
    readHeader();
    while (nextLine()) wide_ ? readWide() : readLong();
    if (entries_.empty()) refuse("no row below the header", "one row a particle and time");
    sortEntries();
    GivenMotion motion = gathered();
    refuseOtherMotion(motion, scene_, file_);
    return motion;
  }

 private:
  [[noreturn]] void refuse(const std::string& found, const std::string& allowed, std::string_view column = {}) const {
    refuseAt(std::max(line_, 1), found, allowed, column);
  }
  [[noreturn]] void refuseAt(int line, const std::string& found, const std::string& allowed,
                             std::string_view column = {}) const {
    const std::string where = column.empty() ? "" : fmt::format(", column {}", shown(column));
    throw InputError(fmt::format("{}: line {}{}: found {}; allowed: {}", file_, line, where, found, allowed));
  }

  /// The next line that holds something, as fields.
  bool nextLine() {
    while (!rest_.empty()) {
      const std::string_view line = rest_.substr(0, rest_.find('\n'));
      rest_.remove_prefix(std::min(rest_.size(), line.size() + 1));
      ++line_;
      const std::string_view content = trimmed(line);
      if (content.empty() || content.starts_with('#')) continue;
      fields_.clear();
      for (std::string_view left = line;;) {
        const std::size_t comma = left.find(',');
        fields_.push_back(trimmed(left.substr(0, comma)));
        if (comma == std::string_view::npos) break;
        left.remove_prefix(comma + 1);
      }
      return true;
    }
    return false;
  }

  void readHeader() {
    constexpr std::string_view kMark = "\xef\xbb\xbf";  // some programs begin a text with it
    if (rest_.starts_with(kMark)) rest_.remove_prefix(kMark.size());
    if (!nextLine()) refuse("an empty file", "a header t,particle,x,y,z or t,x0,y0,z0,x1,... and rows below it");
    for (const std::string_view field : fields_) {
      std::string name(field);
      std::ranges::transform(name, name.begin(), [](unsigned char c) { return char(c < 128 ? std::tolower(c) : c); });
      names_.push_back(name);
    }
    wide_ = column("particle") < 0 && column("x0") >= 0;
    for (const char* name : {"t", "particle", "x", "y", "z"}) {
      if (!wide_ && column(name) < 0) refuseHeader(name);
    }
    if (column("t") < 0) refuseHeader("t");
    if (wide_) {
      for (int particle = 0; particle < sheet_.count(); ++particle) addColumnsOf(particle);
      if (const std::string more = fmt::format("x{}", sheet_.count()); column(more) >= 0) {
        refuse("a column " + more, fmt::format("those of the particles 0 to {}, {}", sheet_.count() - 1, sheetWords()));
      }
    } else {
      order_ = {column("particle"), column("x"), column("y"), column("z")};
    }
    time_ = column("t");
  }
  void addColumnsOf(int particle) {
    for (const char axis : {'x', 'y', 'z'}) {
      const std::string name = fmt::format("{}{}", axis, particle);
      if (column(name) < 0) {
        refuse("no column " + name,
               fmt::format("t and x, y, z of the particles 0 to {}, {}", sheet_.count() - 1, sheetWords()));
      }
      order_.push_back(column(name));
    }
  }
  [[noreturn]] void refuseHeader(std::string_view missing) const {
    std::string found;
    for (const std::string& name : names_) found += (found.empty() ? "" : ", ") + shown(name);
    const bool semicolons = found.find(';') != std::string::npos;
    refuse(fmt::format("no column {} but {}", missing, shown(found)),
           semicolons ? "a comma between columns, and a point in numbers, below a header t,particle,x,y,z"
                      : "a header t,particle,x,y,z in any order, or t,x0,y0,z0,x1,...");
  }
  [[nodiscard]] int column(std::string_view name) const {
    const auto at = std::ranges::find(names_, name);
    return at == names_.end() ? -1 : int(at - names_.begin());
  }
  [[nodiscard]] std::string sheetWords() const {
    return fmt::format("the {} x {} particles of {}; for another sheet give --sheet CxR", sheet_.columns, sheet_.rows,
                       scene_.name);
  }

  [[nodiscard]] double number(int column) const {
    const std::string_view text = fields_[std::size_t(column)], name = names_[std::size_t(column)];
    std::string_view digits = text;
    if (digits.starts_with('+')) digits.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || end != digits.data() + digits.size()) {
      refuse(text.empty() ? "nothing" : "'" + shown(text) + "'", "a number with a point, such as 0.25 or 1e-3", name);
    }
    if (!std::isfinite(value)) {
      refuse(shown(text), "finite numbers; a program whose positions are none has exploded: hand in the times before",
             name);
    }
    return value;
  }
  double timeOf() {
    const double t = number(time_);
    if (t < 0) refuse(shown(fields_[std::size_t(time_)]), "times from 0 on, in s", "t");
    timeDigits_.add(fields_[std::size_t(time_)]);
    return t;
  }
  Vec3 positionOf(std::size_t first) {
    const auto coordinate = [&](std::size_t k) {
      const double value = number(order_[k]);
      digits_.add(fields_[std::size_t(order_[k])]);
      return value;
    };
    return {coordinate(first), coordinate(first + 1), coordinate(first + 2)};
  }
  void checkWidth() const {
    if (fields_.size() == names_.size()) return;
    refuse(fmt::format("{} fields", fields_.size()), fmt::format("{}, as in the header", names_.size()));
  }

  void readLong() {
    checkWidth();
    const double particle = number(order_[0]);
    if (particle != std::floor(particle) || particle < 0 || particle >= sheet_.count()) {
      refuse(shown(fields_[std::size_t(order_[0])]),
             fmt::format("whole numbers from 0 to {}, {}", sheet_.count() - 1, sheetWords()), "particle");
    }
    entries_.push_back({timeOf(), int(particle), positionOf(1), line_});
  }
  void readWide() {
    checkWidth();
    const double t = timeOf();
    for (int particle = 0; particle < sheet_.count(); ++particle) {
      entries_.push_back({t, particle, positionOf(3 * std::size_t(particle)), line_});
    }
  }

  void sortEntries() {
    const auto key = [](const Entry& entry) { return std::pair(entry.t, entry.particle); };
    if (!std::ranges::is_sorted(entries_, {}, key)) std::ranges::stable_sort(entries_, {}, key);
    for (std::size_t k = 1; k < entries_.size(); ++k) {
      if (key(entries_[k]) != key(entries_[k - 1])) continue;
      refuseAt(std::max(entries_[k].line, entries_[k - 1].line),
               fmt::format("particle {} at t = {:g} s again, which line {} has", entries_[k].particle, entries_[k].t,
                           std::min(entries_[k].line, entries_[k - 1].line)),
               "each particle once at each time");
    }
  }

  [[nodiscard]] GivenMotion gathered() const {
    GivenMotion motion;
    const auto count = std::size_t(sheet_.count());
    for (std::size_t begin = 0; begin < entries_.size();) {
      std::size_t end = begin;
      std::vector<Vec3> positions;
      double largest = 0;
      for (; end < entries_.size() && entries_[end].t == entries_[begin].t; ++end) {
        if (entries_[end].particle != int(end - begin)) refuseGap(begin, int(end - begin));
        const Vec3& at = entries_[end].at;
        largest = std::max({largest, std::abs(at.x), std::abs(at.y), std::abs(at.z)});
        positions.push_back(at);
      }
      if (end - begin < count) refuseGap(begin, int(end - begin));
      motion.times.push_back(entries_[begin].t);
      motion.positions.push_back(std::move(positions));
      motion.rounding.push_back(digits_.unitAt(largest));
      begin = end;
    }
    if (motion.times.back() == 0) refuse("no time but t = 0", "at least one time after it");
    motion.timeRounding = timeDigits_.unitAt(motion.times.back());
    return motion;
  }
  [[noreturn]] void refuseGap(std::size_t begin, int missing) const {
    std::size_t end = begin;
    int highest = 0;
    for (const Entry& entry : entries_) highest = std::max(highest, entry.particle);
    while (end < entries_.size() && entries_[end].t == entries_[begin].t) ++end;
    const bool never = highest < missing;
    refuseAt(entries_[end - 1].line,
             fmt::format("{} particles at t = {:g} s, {} is missing{}", end - begin, entries_[begin].t, missing,
                         never ? ", as everywhere in the file" : ""),
             fmt::format("all from 0 to {} at every time, {}", sheet_.count() - 1, sheetWords()));
  }

  std::string_view rest_;
  std::string file_;
  const Scene& scene_;
  Sheet sheet_;
  std::vector<std::string> names_;
  std::vector<std::string_view> fields_;
  std::vector<int> order_;  // columns: particle, x, y, z; or x0, y0, z0, x1, ...
  int line_ = 0, time_ = 0;
  bool wide_ = false;
  std::vector<Entry> entries_;
  Digits digits_, timeDigits_;
};

/// The number with the fewest digits, or the inverse of a whole number, as near as this; else the number itself.
double roundest(double value, double within) {
  constexpr int kShort = 4, kDigits = 15;
  const auto rounded = [&](int digits) {
    return std::strtod(fmt::format("{:.{}e}", value, digits - 1).c_str(), nullptr);
  };
  const double inverse = 1 / std::max(1.0, std::round(1 / value));
  for (int digits = 1; digits <= kDigits; ++digits) {
    if (digits > kShort && std::abs(inverse - value) <= within) return inverse;
    if (std::abs(rounded(digits) - value) <= within) return rounded(digits);
  }
  return value;
}

/// The largest step that leads to every time; nothing where there is none.
std::optional<double> longestStep(const GivenMotion& motion) {
  double least = motion.times.front() > 0 ? motion.times.front() : motion.times.at(1), before = 0;
  for (const double time : motion.times) {
    if (time > before) least = std::min(least, time - before);
    before = time;
  }
  const double last = motion.times.back(), allowed = 2 * motion.timeRounding + 1e-12 * last;
  for (int part = 1; part <= 12; ++part) {  // steps of 3 and 5 of the program: their difference is 2
    const double steps = std::max(1.0, std::round(last / least * part));
    const double step = roundest(last / steps, allowed / steps);
    if (!stepCounts(motion, step).empty()) return step;
  }
  return std::nullopt;
}

}  // namespace

GivenMotion readMotion(std::string_view text, const std::string& fileName, const Scene& scene) {
  return Reader(text, fileName, scene).read();
}

std::vector<std::int64_t> stepCounts(const GivenMotion& motion, double dt) {
  constexpr double kMost = 1e15;  // whole numbers in double are exact up to there
  std::vector<std::int64_t> counts;
  for (const double time : motion.times) {
    const double steps = std::round(time / dt);
    if (!(steps <= kMost)) return {};
    if (std::abs(time - steps * dt) > std::min(dt / 4, motion.timeRounding + 1e-9 * std::min(dt, time))) return {};
    counts.push_back(std::int64_t(steps));
  }
  return counts;
}

std::vector<double> stepsOnto(const GivenMotion& motion, const std::vector<double>& usual) {
  constexpr double kMostTaken = 2e5, kShortest = 1e-4;  // s, where the times do not lie closer than ten of them
  std::vector<double> steps;
  const auto add = [&](double dt) {
    const auto isSame = [&](double other) { return std::abs(other - dt) <= 1e-9 * dt; };
    if (motion.times.back() / dt > kMostTaken || std::ranges::any_of(steps, isSame)) return;
    if (!stepCounts(motion, dt).empty()) steps.push_back(dt);
  };
  if (const std::optional<double> longest = longestStep(motion)) {
    for (const double part : {1,  2,  3,  4,  5,  6,  8,   10,  12,  15,  16,  20,  24,  25,  30,
                              32, 40, 50, 60, 64, 80, 100, 120, 125, 200, 250, 400, 500, 1000}) {
      if (*longest / part >= std::min(kShortest, *longest / 10) * (1 - 1e-9)) add(*longest / part);
    }
  }
  for (const double dt : usual) add(dt);
  std::ranges::sort(steps, std::greater<>());
  return steps;
}

}  // namespace tyg
