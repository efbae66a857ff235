// Event logs: there and back to the same bits, a form that people and spreadsheets read, and every mistake refused.
#include "tyg/event_log.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "core/event_log_refusals.h"
#include "core/simulation/event_kinds.h"

namespace tyg::test {
namespace {

/// One event of every kind. Its text has 14 lines before the events.
EventLog fullLog() {
  return {.scene = "scenes/my curtain.toml",
          .columns = 20,
          .rows = 30,
          .integrator = "rk4",
          .dt = 0.002,
          .precision = Precision::Float,
          .ticks = 1000000000000,
          .hash = "00ff12ab34cd56ef",
          .events = {{0, PushEvent{599, {0.1, -1.0 / 3, std::numeric_limits<double>::denorm_min()}, 50}},
                     {7, MethodEvent{"leapfrog"}},
                     {7, StepEvent{1.0 / 3000}},
                     {8, WorldEvent{"world.gravity", {0, -1.62, 0.5}}}}};
}

TEST(EventLog, ComesBackToTheSameBits) {
  const EventLog log = fullLog();
  EXPECT_EQ(parseEventLog(formatEventLog(log), "log"), log);
  EventLog quiet = fullLog();
  quiet.events.clear();
  quiet.hash.clear();
  quiet.precision = Precision::Double;
  EXPECT_EQ(parseEventLog(formatEventLog(quiet), "log"), quiet);
}

TEST(EventLog, KeepsEveryKindOfEvent) {
  EventLog log = fullLog();
  log.events.clear();
  for (const EventKind& kind : eventKinds()) {
    Event& event = log.events.emplace_back(Event{5, kind.make()});
    if (auto* method = std::get_if<MethodEvent>(&event.action)) method->method = "rk4";
    if (auto* step = std::get_if<StepEvent>(&event.action)) step->dt = 0.25;
    if (auto* world = std::get_if<WorldEvent>(&event.action)) world->parameter = "world.drag";
    EXPECT_EQ(kindOf(event.action).name, kind.name);
  }
  EXPECT_EQ(parseEventLog(formatEventLog(log), "log"), log);
}

TEST(EventLog, KeepsEveryLiveParameter) {
  EventLog log = fullLog();
  log.events.clear();
  for (const Parameter& parameter : liveParameters()) {
    const Vec3 value = parameter.count == 1 ? Vec3{1.0 / 7, 0, 0} : Vec3{-1.0 / 7, 2, -0.0};
    log.events.push_back(
        {9, WorldEvent{std::string(parameter.key), parameter.allowed == Allowed::Any ? value : Vec3{0.5}}});
  }
  EXPECT_EQ(parseEventLog(formatEventLog(log), "log"), log);
}

TEST(EventLog, CarriesItsScene) {
  EventLog log = fullLog();
  log.sceneText = "title = \"Mine\"\n\n[sheet]\ncolumns = 20\n";
  const std::string text = formatEventLog(log);
  EXPECT_NE(text.find("\n## title = \"Mine\"\n##\n## [sheet]\n## columns = 20\n# push"), std::string::npos) << text;
  EXPECT_EQ(parseEventLog(text, "log"), log);
}

TEST(EventLog, AFilesNameIsOneLineAndCannotBeAKeyOfItsOwn) {
  EventLog log = fullLog();
  log.scene = "a\n# ticks = 7\x1B\xFF.toml";
  const EventLog read = parseEventLog(formatEventLog(log), "log");
  EXPECT_EQ(read.scene, "a # ticks = 7\uFFFD\uFFFD.toml");
  EXPECT_EQ(read.ticks, log.ticks);
}

TEST(EventLog, LooksAsPeopleExpect) {
  EventLog log = fullLog();
  std::get<PushEvent>(log.events[0].action).force = {0, -2, 0.1};
  log.events.push_back({8, WorldEvent{"springs.shear.ks", {1200, 0, 0}}});
  EXPECT_EQ(formatEventLog(log),
            "# version = 2\n# scene = scenes/my curtain.toml\n# columns = 20\n# rows = 30\n# integrator = rk4\n"
            "# dt = 0.002\n# precision = float\n# ticks = 1000000000000\n# hash = 00ff12ab34cd56ef\n"
            "# push: tick,push,particle,fx_N,fy_N,fz_N,ticks\n# method: tick,method,method\n# step: tick,step,dt_s\n"
            "# world: tick,world,parameter,value,value_y,value_z\n"
            "# world: a parameter that is a single number has value alone; the unit is that of the parameter\n"
            "tick,event,...\n"
            "0,push,599,0,-2,0.1,50\n7,method,leapfrog\n7,step,0.0003333333333333333\n"
            "8,world,world.gravity,0,-1.62,0.5\n8,world,springs.shear.ks,1200\n");
}

TEST(EventLog, FromAnotherSystemReadsTheSame) {
  std::string text;
  for (const char c : formatEventLog(fullLog())) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(parseEventLog(text, "log"), fullLog());
}

TEST(EventLog, MistakesInTheHeadAreRefusedWithTheirLine) {
  expectRefusals(
      formatEventLog(fullLog()),
      {
          {1, "# version = 3", "my.log:1: version: found '3', allowed 2, or no such line in a log of version 1"},
          {2, "# scene = ", "my.log:2: scene: found '', allowed a name"},
          {2, "scene = a", "my.log:2: line: found 'scene = a', allowed '# key = value'"},
          {3, "# colums = 20", "my.log:3: key: found 'colums', allowed version, scene, columns, rows"},
          {3, "# columns = 0", "my.log:3: columns: found '0', allowed a whole number from 1 to 4096"},
          {4, "# rows = 4097", "my.log:4: rows: found '4097', allowed a whole number from 1 to 4096"},
          {4, "# columns = 20", "my.log:4: columns: found 'a second time', allowed each key once"},
          {6, "# dt = 0", "my.log:6: dt: found '0', allowed a finite number above 0"},
          {6, "# dt = inf", "my.log:6: dt: found 'inf', allowed a finite number above 0"},
          {6, "# dt = 0,002", "my.log:6: dt: found '0,002', allowed a finite number above 0"},
          {7, "# precision = half", "my.log:7: precision: found 'half', allowed float or double"},
          {8, "# ticks = -1", "my.log:8: ticks: found '-1', allowed a whole number from 0"},
          {9, "# hash = 0x12", "my.log:9: hash: found '0x12', allowed nothing or up to 16 hexadecimal"},
          {9, "# hash = 123456789abcdef01", "my.log:9: hash: found '123456789abcdef01', allowed nothing or up to 16"},
          {10, "# pull: tick,pull", "my.log:10: line: found '# pull: tick,pull', allowed '# key = value'"},
          {15, "tick,event",
           "my.log:15: line: found 'tick,event', allowed '# key = value', or the line tick,event,..."},
          {5, "# hash = 1", "my.log:9: hash: found 'a second time', allowed each key once"},
      });
}

TEST(EventLog, MistakesInTheEventsAreRefusedWithTheirLine) {
  expectRefusals(
      formatEventLog(fullLog()),
      {
          {16, "", "my.log:16: tick: found '', allowed a whole number from 0"},
          {16, "0", "my.log:16: event: found '', allowed push, method, step, world"},
          {16, "0,poke,1,0,0,1,50", "my.log:16: event: found 'poke', allowed push, method, step, world"},
          {16, "-1,push,1,0,0,1,50", "my.log:16: tick: found '-1', allowed a whole number from 0"},
          {16, "0.5,push,1,0,0,1,50", "my.log:16: tick: found '0.5', allowed a whole number"},
          {16, "0,push,600,0,0,1,50", "my.log:16: particle: found '600', allowed a whole number from 0 to 599"},
          {16, "0,push,1,0,nan,1,50", "my.log:16: fy_N: found 'nan', allowed a finite number"},
          {16, "0,push,1,0,0,,50", "my.log:16: fz_N: found '', allowed a finite number"},
          {16, "0,push,1,0,0,1,0", "my.log:16: ticks: found '0', allowed a whole number from 1"},
          {16, "0,push,1,0,0,1", "my.log:16: ticks: found '', allowed a whole number from 1"},
          {16, "0,push,1,0,0,1,50,", "my.log:16: line: found '0,push,1,0,0,1,50,', allowed the columns tick,push,part"},
          {16, "0,push,1,0,0,1,50,rk4",
           "my.log:16: line: found '0,push,1,0,0,1,50,rk4', allowed the columns tick,push"},
          {17, "7,method,", "my.log:17: method: found '', allowed a name"},
          {18, "7,step,-0.1", "my.log:18: dt_s: found '-0.1', allowed a finite number above 0"},
          {19, "8,world,gravity,1,2,3", "my.log:19: parameter: found 'gravity', allowed springs.structural.ks, "},
          {19, "8,world,world.drag,-1", "my.log:19: value: found '-1', allowed a finite number from 0"},
          {19, "8,world,world.drag,1,2",
           "my.log:19: line: found '8,world,world.drag,1,2', allowed the columns tick,wor"},
          {19, "8,world,run.tolerance,0", "my.log:19: value: found '0', allowed a finite number above 0"},
          {19, "8,world,world.gravity,1,2", "my.log:19: value_z: found '', allowed a finite number"},
          {20, "7,step,0.1", "my.log:20: tick: found '7', allowed a whole number from 8"},
      });
}

TEST(EventLog, WithoutARequiredKeyOrAnyTextIsRefused) {
  const std::string right = formatEventLog(fullLog());
  for (const char* key : {"scene", "columns", "rows", "integrator", "dt", "precision", "ticks"}) {
    std::string text = right;
    const std::size_t from = text.find("# " + std::string(key) + " = ");
    text.erase(from, text.find('\n', from) - from + 1);
    const std::string refusal = refusalOf(text);
    EXPECT_EQ(refusal.find("my.log:14: " + std::string(key) + ": found ''"), 0U) << refusal;
  }
  EXPECT_NE(refusalOf(""), kNothingRefused);
  EXPECT_NE(refusalOf("# version = 2\n# scene = a\n"), kNothingRefused);
}

/// Any finite double, the smallest and the largest included.
std::vector<double> manyDoubles() {
  using Limits = std::numeric_limits<double>;
  std::vector<double> numbers = {0.0, -0.0, 1.0 / 3, Limits::denorm_min(), Limits::min(), Limits::max()};
  std::mt19937_64 engine(5);
  while (numbers.size() < 3000) {
    const auto number = std::bit_cast<double>(engine());
    if (std::isfinite(number)) numbers.push_back(number);
  }
  return numbers;
}

TEST(EventLog, KeepsEveryBitOfEveryDouble) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  const std::vector<double> numbers = manyDoubles();
  EventLog log = fullLog();
  log.events.clear();
  for (const double number : numbers) {
    log.events.push_back({7, PushEvent{599, {number, -number, 1}, 50}});
    log.events.push_back({7, StepEvent{number == 0 ? 1 : std::abs(number)}});
  }
  const EventLog back = parseEventLog(formatEventLog(log), "log");
  ASSERT_EQ(back.events.size(), log.events.size());
  for (std::size_t i = 0; i < log.events.size(); i += 2) {
    const Vec3 force = std::get<PushEvent>(back.events[i].action).force;
    const Vec3 wanted = std::get<PushEvent>(log.events[i].action).force;
    EXPECT_EQ(bits(force.x), bits(wanted.x)) << wanted.x;
    EXPECT_EQ(bits(force.y), bits(wanted.y)) << wanted.y;
    EXPECT_EQ(bits(std::get<StepEvent>(back.events[i + 1].action).dt),
              bits(std::get<StepEvent>(log.events[i + 1].action).dt));
  }
}

TEST(EventLog, KeepsTheLargestCounts) {
  EventLog log = fullLog();
  log.columns = log.rows = kLargestCount;
  log.ticks = std::numeric_limits<std::int64_t>::max();
  constexpr int kLast = kLargestCount * kLargestCount - 1;
  log.events = {{log.ticks, PushEvent{kLast, {}, std::numeric_limits<int>::max()}}};
  EXPECT_EQ(parseEventLog(formatEventLog(log), "log"), log);
}

}  // namespace
}  // namespace tyg::test
