// Push logs: there and back to the same bits, and every mistake refused.
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tyg/push_log.h"

namespace tyg::test {
namespace {

PushLog fullLog() {
  PushLog log{"scenes/my curtain.toml", 20, 30, "rk4", 0.002, Precision::Float, 1000000000000,
              "00ff12ab34cd56ef",       {}, {}};
  LogEvent push;
  push.particle = 599;
  push.force = {0.1, -1.0 / 3, std::numeric_limits<double>::denorm_min()};
  push.ticks = 50;
  LogEvent method;
  method.tick = 7, method.kind = LogEvent::Kind::Method, method.method = "leapfrog";
  LogEvent step;
  step.tick = 7, step.kind = LogEvent::Kind::Step, step.dt = 1.0 / 3000;
  log.events = {push, method, step};
  return log;
}

TEST(PushLog, ComesBackToTheSameBits) {
  const PushLog log = fullLog();
  EXPECT_EQ(parsePushLog(formatPushLog(log), "log"), log);
  PushLog quiet = fullLog();
  quiet.events.clear();
  quiet.hash.clear();
  quiet.precision = Precision::Double;
  EXPECT_EQ(parsePushLog(formatPushLog(quiet), "log"), quiet);
}

TEST(PushLog, KeepsChangesOfSpringsAndWorld) {
  using Kind = LogEvent::Kind;
  PushLog log = fullLog();
  log.events = {{.tick = 3, .kind = Kind::Structural, .force = {1200, 0.1, 0}},
                {.tick = 3, .kind = Kind::Gravity, .force = {0, -1.62, 0.5}},
                {.tick = 4, .kind = Kind::Drag, .force = {0.25, 0, 0}},
                {.tick = 5, .kind = Kind::Tolerance, .force = {1e-6, 0, 0}}};
  const std::string text = formatPushLog(log);
  EXPECT_NE(text.find("\n3,structural,,1200,0.10000000000000001,,,,\n3,gravity,,0,-1.6200000000000001,0.5,,,\n"),
            std::string::npos)
      << text;
  EXPECT_EQ(parsePushLog(text, "log"), log);
}

TEST(PushLog, CarriesItsScene) {
  PushLog log = fullLog();
  log.sceneText = "title = \"Mine\"\n\n[sheet]\ncolumns = 20\n";
  const std::string text = formatPushLog(log);
  EXPECT_NE(text.find("\n## title = \"Mine\"\n##\n## [sheet]\n## columns = 20\ntick,event"), std::string::npos) << text;
  EXPECT_EQ(parsePushLog(text, "log"), log);
}

TEST(PushLog, LooksAsPeopleExpect) {
  PushLog log = fullLog();
  log.dt = 0.5;
  log.events[0].force = {0, -2, 0.1};
  log.events.pop_back();
  EXPECT_EQ(formatPushLog(log),
            "# scene = scenes/my curtain.toml\n# columns = 20\n# rows = 30\n# integrator = rk4\n# dt = 0.5\n"
            "# precision = float\n# ticks = 1000000000000\n# hash = 00ff12ab34cd56ef\n"
            "tick,event,particle,fx,fy,fz,ticks,method,dt\n"
            "0,push,599,0,-2,0.10000000000000001,50,,\n7,method,,,,,,leapfrog,\n");
}

TEST(PushLog, FromAnotherSystemReadsTheSame) {
  std::string text;
  for (const char c : formatPushLog(fullLog())) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(parsePushLog(text, "log"), fullLog());
}

/// The right log with one line (from 1) changed; line 13 adds to it.
std::string refusalOf(std::size_t line, const std::string& changed) {
  std::string text;
  std::size_t number = 0;
  const std::string right = formatPushLog(fullLog());
  for (std::size_t from = 0; from < right.size(); from = right.find('\n', from) + 1) {
    const std::string one = right.substr(from, right.find('\n', from) - from);
    text += (++number == line ? changed : one) + '\n';
  }
  if (number < line) text += changed + '\n';
  try {
    (void)parsePushLog(text, "my.log");
  } catch (const InputError& mistake) {
    return mistake.what();
  }
  return "nothing was refused";
}

struct Mistake {
  std::size_t line;
  std::string text, refusal;
};

TEST(PushLog, MistakesInTheHeadAreRefusedWithTheirLine) {
  const std::vector<Mistake> mistakes = {
      {1, "# scene = ", "my.log:1: scene: found '', allowed a name"},
      {1, "scene = a", "my.log:1: line: found 'scene = a', allowed '# key = value'"},
      {2, "# colums = 20", "my.log:2: key: found 'colums', allowed scene, columns, rows"},
      {2, "# columns = 0", "my.log:2: columns: found '0', allowed a whole number from 1 to 4096"},
      {3, "# rows = 4097", "my.log:3: rows: found '4097', allowed a whole number from 1 to 4096"},
      {3, "# columns = 20", "my.log:3: columns: found 'a second time', allowed each key once"},
      {5, "# dt = 0", "my.log:5: dt: found '0', allowed a finite number above 0"},
      {5, "# dt = inf", "my.log:5: dt: found 'inf', allowed a finite number above 0"},
      {5, "# dt = 0,002", "my.log:5: dt: found '0,002', allowed a finite number above 0"},
      {6, "# precision = half", "my.log:6: precision: found 'half', allowed float or double"},
      {7, "# ticks = -1", "my.log:7: ticks: found '-1', allowed a whole number from 0"},
      {8, "# hash = 0x12", "my.log:8: hash: found '0x12', allowed nothing or up to 16 hexadecimal"},
      {8, "# hash = 123456789abcdef01", "my.log:8: hash: found '123456789abcdef01', allowed nothing or up to 16"},
      {9, "tick,event", "my.log:9: line: found 'tick,event', allowed '# key = value', or the line tick,event,particle"},
      {4, "# hash = 1", "my.log:8: hash: found 'a second time', allowed each key once"},
  };
  for (const Mistake& mistake : mistakes) {
    const std::string refusal = refusalOf(mistake.line, mistake.text);
    EXPECT_EQ(refusal.find(mistake.refusal), 0U) << mistake.text << "\n  " << refusal;
  }
}

TEST(PushLog, MistakesInTheEventsAreRefusedWithTheirLine) {
  const std::vector<Mistake> mistakes = {
      {10, "", "my.log:10: line: found '', allowed nine fields"},
      {10, "0,push,1,0,0,1,50,", "my.log:10: line: found '0,push,1,0,0,1,50,', allowed nine fields"},
      {10, "0,poke,1,0,0,1,50,,", "my.log:10: event: found 'poke', allowed push, method, step, structural"},
      {10, "-1,push,1,0,0,1,50,,", "my.log:10: tick: found '-1', allowed a whole number from 0"},
      {10, "0.5,push,1,0,0,1,50,,", "my.log:10: tick: found '0.5', allowed a whole number"},
      {10, "0,push,600,0,0,1,50,,", "my.log:10: particle: found '600', allowed a whole number from 0 to 599"},
      {10, "0,push,1,0,nan,1,50,,", "my.log:10: fy: found 'nan', allowed a finite number"},
      {10, "0,push,1,0,0,,50,,", "my.log:10: fz: found '', allowed a finite number"},
      {10, "0,push,1,0,0,1,0,,", "my.log:10: ticks: found '0', allowed a whole number from 1"},
      {10, "0,push,1,0,0,1,50,rk4,", "my.log:10: field 8: found 'rk4', allowed nothing"},
      {11, "7,method,,,,,,,", "my.log:11: method: found '', allowed a name"},
      {11, "7,method,3,,,,,rk4,", "my.log:11: field 3: found '3', allowed nothing"},
      {11, "7,drag,,-1,,,,,", "my.log:11: fx: found '-1', allowed a finite number from 0"},
      {11, "7,drag,,1,2,,,,", "my.log:11: field 5: found '2', allowed nothing"},
      {11, "7,tolerance,,0,,,,,", "my.log:11: fx: found '0', allowed a finite number above 0"},
      {11, "7,bend,,200,,,,,", "my.log:11: fy: found '', allowed a finite number"},
      {12, "7,step,,,,,,,-0.1", "my.log:12: dt: found '-0.1', allowed a finite number above 0"},
      {13, "6,step,,,,,,,0.1", "my.log:13: tick: found '6', allowed a whole number from 7"},
  };
  for (const Mistake& mistake : mistakes) {
    const std::string refusal = refusalOf(mistake.line, mistake.text);
    EXPECT_EQ(refusal.find(mistake.refusal), 0U) << mistake.text << "\n  " << refusal;
  }
}

TEST(PushLog, WithoutARequiredKeyOrAnyTextIsRefused) {
  const std::string right = formatPushLog(fullLog());
  for (const char* key : {"scene", "columns", "rows", "integrator", "dt", "precision", "ticks"}) {
    std::string text = right;
    const std::size_t from = text.find("# " + std::string(key) + " = ");
    text.erase(from, text.find('\n', from) - from + 1);
    try {
      (void)parsePushLog(text, "my.log");
      ADD_FAILURE() << key << " was not missed";
    } catch (const InputError& mistake) {
      EXPECT_EQ(std::string(mistake.what()).find("my.log:8: " + std::string(key) + ": found ''"), 0U) << mistake.what();
    }
  }
  EXPECT_THROW((void)parsePushLog("", "my.log"), InputError);
  EXPECT_THROW((void)parsePushLog("# scene = a\n", "my.log"), InputError);
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

TEST(PushLog, KeepsEveryBitOfEveryDouble) {
  const auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number); };
  const std::vector<double> numbers = manyDoubles();
  PushLog log = fullLog();
  const LogEvent push = log.events[0], step = log.events[2];
  log.events.clear();
  for (const double number : numbers) {
    log.events.push_back(push);
    log.events.back().tick = 7, log.events.back().force = {number, -number, 1};
    log.events.push_back(step);
    log.events.back().dt = number == 0 ? 1 : std::abs(number);
  }
  const PushLog back = parsePushLog(formatPushLog(log), "log");
  ASSERT_EQ(back.events.size(), log.events.size());
  for (std::size_t i = 0; i < log.events.size(); ++i) {
    EXPECT_EQ(bits(back.events[i].force.x), bits(log.events[i].force.x)) << log.events[i].force.x;
    EXPECT_EQ(bits(back.events[i].force.y), bits(log.events[i].force.y)) << log.events[i].force.y;
    EXPECT_EQ(bits(back.events[i].dt), bits(log.events[i].dt)) << log.events[i].dt;
  }
}

TEST(PushLog, KeepsTheLargestCounts) {
  PushLog log = fullLog();
  log.columns = log.rows = kLargestCount;
  log.ticks = std::numeric_limits<std::int64_t>::max();
  log.events.resize(1);
  log.events[0].tick = log.ticks;
  log.events[0].particle = kLargestCount * kLargestCount - 1;
  log.events[0].ticks = std::numeric_limits<int>::max();
  EXPECT_EQ(parsePushLog(formatPushLog(log), "log"), log);
}

}  // namespace
}  // namespace tyg::test
