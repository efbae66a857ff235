// Each kind has one function that goes through its columns; naming, writing and checking them are visitors of it.
#include "core/simulation/event_kinds.h"

#include <fmt/core.h>

#include <array>
#include <vector>

#include "core/scene/scene_writer.h"

namespace tyg {
namespace {

void visitColumns(PushEvent& push, EventColumns& columns) {
  columns.particle("particle", push.particle);
  columns.number("fx_N", push.force.x, Allowed::Any);
  columns.number("fy_N", push.force.y, Allowed::Any);
  columns.number("fz_N", push.force.z, Allowed::Any);
  columns.count("ticks", push.ticks);
}

void visitColumns(MethodEvent& change, EventColumns& columns) { columns.word("method", change.method, {}); }

void visitColumns(StepEvent& change, EventColumns& columns) { columns.number("dt_s", change.dt, Allowed::Positive); }

std::span<const std::string_view> parameterKeys() {
  static const std::vector<std::string_view> kKeys = [] {
    std::vector<std::string_view> keys;
    for (const Parameter& parameter : liveParameters()) keys.push_back(parameter.key);
    return keys;
  }();
  return kKeys;
}

/// A parameter that is a single number has no columns value_y and value_z.
void visitColumns(WorldEvent& change, EventColumns& columns) {
  columns.word("parameter", change.parameter, parameterKeys());
  const Parameter* parameter = findParameter(change.parameter);
  const Allowed allowed = parameter != nullptr ? parameter->allowed : Allowed::Any;
  columns.number("value", change.value.x, allowed);
  if (parameter != nullptr && parameter->count == 1) return;
  columns.number("value_y", change.value.y, allowed);
  columns.number("value_z", change.value.z, allowed);
}

void visitColumns(PinEvent& pin, EventColumns& columns) {
  columns.particle("particle", pin.particle);
  columns.flag("pinned", pin.pinned);
}

void visitColumns(GrabEvent& grab, EventColumns& columns) {
  columns.particle("particle", grab.particle);
  columns.number("vx_m_s", grab.velocity.x, Allowed::Any);
  columns.number("vy_m_s", grab.velocity.y, Allowed::Any);
  columns.number("vz_m_s", grab.velocity.z, Allowed::Any);
}

void visitColumns(ReleaseEvent& release, EventColumns& columns) { columns.particle("particle", release.particle); }

void visitColumns(CutEvent& cut, EventColumns& columns) {
  columns.number("from_column", cut.line.fromColumn, Allowed::Any);
  columns.number("from_row", cut.line.fromRow, Allowed::Any);
  columns.number("to_column", cut.line.toColumn, Allowed::Any);
  columns.number("to_row", cut.line.toRow, Allowed::Any);
}

void visitColumns(MendEvent& mend, EventColumns& columns) { columns.count("cuts", mend.cuts); }

template <class E>
constexpr EventKind kind(std::string_view name, std::string_view note = "") {
  return {name, note, [] { return EventAction(E{}); },
          [](EventAction& action, EventColumns& columns) { visitColumns(std::get<E>(action), columns); }};
}

constexpr std::array kKinds{kind<PushEvent>("push"),
                            kind<MethodEvent>("method"),
                            kind<StepEvent>("step"),
                            kind<WorldEvent>("world",
                                             "a parameter that is a single number has value alone; the unit is that of "
                                             "the parameter"),
                            kind<PinEvent>("pin"),
                            kind<GrabEvent>("grab"),
                            kind<ReleaseEvent>("release"),
                            kind<CutEvent>("cut"),
                            kind<MendEvent>("mend")};
static_assert(kKinds.size() == std::variant_size_v<EventAction>);

class Names final : public EventColumns {
 public:
  explicit Names(std::string_view kind) : text(fmt::format("tick,{}", kind)) {}
  void particle(std::string_view name, int& /*index*/) override { add(name); }
  void count(std::string_view name, int& /*number*/) override { add(name); }
  void flag(std::string_view name, bool& /*value*/) override { add(name); }
  void number(std::string_view name, double& /*number*/, Allowed /*allowed*/) override { add(name); }
  void word(std::string_view name, std::string& /*word*/, std::span<const std::string_view> /*allowed*/) override {
    add(name);
  }
  std::string text;

 private:
  void add(std::string_view name) { text.append(",").append(name); }
};

class Values final : public EventColumns {
 public:
  void particle(std::string_view /*name*/, int& index) override { add(index); }
  void count(std::string_view /*name*/, int& number) override { add(number); }
  void flag(std::string_view /*name*/, bool& value) override { add(int(value)); }
  void number(std::string_view /*name*/, double& number, Allowed /*allowed*/) override { add(number); }
  void word(std::string_view /*name*/, std::string& word, std::span<const std::string_view> /*allowed*/) override {
    add(word);
  }
  std::string text;

 private:
  template <class Value>
  void add(const Value& value) {
    text += fmt::format(",{}", value);
  }
};

/// Refuses particles that a sheet does not have.
class ParticleCheck final : public EventColumns {
 public:
  ParticleCheck(std::string_view kind, int particles) : kind_(kind), particles_(particles) {}
  void particle(std::string_view /*name*/, int& index) override {
    if (index >= 0 && index < particles_) return;
    throw InputError(fmt::format("replay: found a {} on particle {}, allowed: 0 to {}", kind_, index, particles_ - 1));
  }
  void count(std::string_view /*name*/, int& /*number*/) override {}
  void flag(std::string_view /*name*/, bool& /*value*/) override {}
  void number(std::string_view /*name*/, double& /*number*/, Allowed /*allowed*/) override {}
  void word(std::string_view /*name*/, std::string& /*word*/, std::span<const std::string_view> /*allowed*/) override {}

 private:
  std::string_view kind_;
  int particles_;
};

}  // namespace

std::span<const EventKind> eventKinds() { return kKinds; }

const EventKind& kindOf(const EventAction& action) { return kKinds.at(action.index()); }

std::string columnNames(const EventAction& action) {
  Names names(kindOf(action).name);
  EventAction copy = action;
  kindOf(copy).visit(copy, names);
  return names.text;
}

std::string columnValues(const EventAction& action) {
  Values values;
  EventAction copy = action;
  kindOf(copy).visit(copy, values);
  return values.text;
}

EventLog beginLog(const Scene& scene, std::string_view integrator) {
  Scene begun = scene;
  begun.integrator = integrator;
  return {.scene = scene.name,
          .columns = scene.columns,
          .rows = scene.rows,
          .integrator = begun.integrator,
          .dt = scene.dt,
          .precision = scene.precision,
          .sceneText = sceneToToml(begun)};
}

void refuseUnfitLog(const EventLog& log, const EventLog& own) {
  const auto size = [](const EventLog& of) { return fmt::format("{}x{}", of.columns, of.rows); };
  if (size(log) != size(own)) {
    throw InputError(
        fmt::format("replay: found a log of a {} sheet, allowed: one of this {} sheet", size(log), size(own)));
  }
  if (log.precision != own.precision || log.integrator != own.integrator || log.dt != own.dt) {
    throw InputError("replay: found a log with another integrator, step or precision; allowed: the same as here");
  }
  for (Event event : log.events) {
    ParticleCheck check(kindOf(event.action).name, own.columns * own.rows);
    kindOf(event.action).visit(event.action, check);
  }
}

}  // namespace tyg
