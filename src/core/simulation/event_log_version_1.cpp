// In version 1 a change of the world kept its numbers in the columns of a push's force.
#include "core/simulation/event_log_version_1.h"

#include <algorithm>
#include <array>
#include <limits>

namespace tyg {
namespace {

using Fields = std::array<std::string_view, 9>;
enum Column : std::size_t { kTick, kEvent, kParticle, kForce, kTicks = 6, kMethod, kStep };
constexpr std::array<std::string_view, 3> kForceNames{"fx", "fy", "fz"};

/// The parameters whose numbers follow one another from the column fx on.
struct WorldChange {
  std::string_view name;
  std::array<std::string_view, 2> keys;
};
constexpr std::array<WorldChange, 6> kChanges{{{"structural", {"springs.structural.ks", "springs.structural.kd"}},
                                               {"shear", {"springs.shear.ks", "springs.shear.kd"}},
                                               {"bend", {"springs.bend.ks", "springs.bend.kd"}},
                                               {"gravity", {"world.gravity", ""}},
                                               {"drag", {"world.drag", ""}},
                                               {"tolerance", {"run.tolerance", ""}}}};

/// Reads the fields of one line and knows which of them its event has used.
class Line {
 public:
  explicit Line(const LogLines& lines) : lines_(lines) {
    const auto commas = static_cast<std::size_t>(std::ranges::count(lines.line(), ','));
    if (commas + 1 != fields_.size()) {
      lines.refuse("line", lines.line(), fmt::format("nine fields {}", kVersion1Columns));
    }
    std::string_view rest = lines.line();
    for (std::string_view& field : fields_) field = LogLines::cut(rest, ',');
  }

  void read(EventLog& log) {
    const std::int64_t earliest = log.events.empty() ? 0 : log.events.back().tick;
    const std::int64_t tick = lines_.whole("tick", take(kTick), earliest, LogLines::kMostTicks);
    const std::string_view name = take(kEvent);
    if (name == "push") {
      log.events.push_back({tick, push(log.columns * log.rows)});
    } else if (name == "method") {
      log.events.push_back({tick, MethodEvent{lines_.name("method", take(kMethod))}});
    } else if (name == "step") {
      log.events.push_back({tick, StepEvent{lines_.number("dt", take(kStep), Allowed::Positive)}});
    } else {
      readWorldChange(name, tick, log);
    }
    refuseUnused();
  }

 private:
  std::string_view take(std::size_t column) {
    used_[column] = true;
    return fields_[column];
  }

  double force(std::size_t k, Allowed allowed) { return lines_.number(kForceNames[k], take(kForce + k), allowed); }

  PushEvent push(int particles) {
    PushEvent push;
    push.particle = lines_.whole("particle", take(kParticle), 0, particles - 1);
    push.force = {force(0, Allowed::Any), force(1, Allowed::Any), force(2, Allowed::Any)};
    push.ticks = lines_.whole("ticks", take(kTicks), 1, std::numeric_limits<int>::max());
    return push;
  }

  void readWorldChange(std::string_view name, std::int64_t tick, EventLog& log) {
    const auto change = std::ranges::find(kChanges, name, &WorldChange::name);
    if (change == kChanges.end()) {
      lines_.refuse("event", name, "push, method, step, structural, shear, bend, gravity, drag or tolerance");
    }
    std::size_t column = 0;
    for (const std::string_view key : change->keys) {
      const Parameter* parameter = findParameter(key);
      if (parameter == nullptr) continue;
      std::array<double, 3> numbers{};
      for (int k = 0; k < parameter->count; ++k) numbers.at(std::size_t(k)) = force(column++, parameter->allowed);
      log.events.push_back({tick, WorldEvent{std::string(key), {numbers[0], numbers[1], numbers[2]}}});
    }
  }

  /// A value in a column that the event does not use is a mistake somewhere: it is not passed over.
  void refuseUnused() const {
    for (std::size_t column = 0; column < fields_.size(); ++column) {
      if (!used_[column] && !fields_[column].empty()) {
        lines_.refuse(fmt::format("field {}", column + 1), fields_[column], "nothing");
      }
    }
  }

  const LogLines& lines_;
  Fields fields_;
  std::array<bool, std::tuple_size_v<Fields>> used_{};
};

}  // namespace

void readVersion1Event(const LogLines& lines, EventLog& log) { Line(lines).read(log); }

}  // namespace tyg
