// How often the energy alarm is wrong: random cloths, every method, steps on both sides of the limit, and beside each
// run an accurate one that says whether it was spoiled. Prints tables. Not a test: minutes long.
//   build/release/tests/alarm_statistics [CLOTHS=200 [wind | contact]]
// With `wind` the cloths are blown at, and their pins move; with `contact` they fall onto bodies.
#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cstdio>
#include <functional>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include "core/simulation/alarm.h"
#include "random_cloth.h"
#include "study/limits/stability.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

constexpr int kSteps = 2000;            // of a run, at its method's limit
constexpr double kMostStretch = 1;      // of the accurate run: beyond twice its length nothing is cloth
constexpr double kSpoiledTimes = 10;    // the kinetic energy at the grid's scale is so many times what it should be ...
constexpr double kSpoiledShare = 1e-3;  // ... and so large a fraction of the alarm's scale
constexpr std::array kBelow = {0.5, 0.8, 0.95};        // of the limit that holds in any deformation
constexpr std::array kAbove = {1.02, 1.05, 1.1, 1.3};  // of the limit at rest
constexpr std::array kThresholds = {0.05, 0.1, 0.15, 0.2, 0.25, 0.3, 0.5, 1.0};

/// The limit that holds in any deformation, or the one at rest where none can be certified.
double soundLimit(const Scene& scene, const Method& method) {
  const double rest = restLatticeLimit(scene, method), certified = certifiedLimit(scene, method);
  return certified > 0 ? std::min(rest, certified) : rest;
}

/// J of the velocities' differences from the mean of their neighbours: where a jitter lives.
double gridEnergy(const Simulation& simulation) {
  const Sheet& sheet = simulation.sheet();
  std::vector<Vec3> v;
  v.reserve(std::size_t(sheet.count()));
  for (int i = 0; i < sheet.count(); ++i) v.push_back(simulation.velocity(i));
  const auto at = [&](int column, int row) { return v[std::size_t(row * sheet.columns + column)]; };
  double sum = 0;
  for (int r = 0; r < sheet.rows; ++r) {
    for (int c = 0; c < sheet.columns; ++c) {
      Vec3 around;
      int count = 0;
      if (c > 0) around = around + at(c - 1, r), ++count;
      if (r > 0) around = around + at(c, r - 1), ++count;
      if (c + 1 < sheet.columns) around = around + at(c + 1, r), ++count;
      if (r + 1 < sheet.rows) around = around + at(c, r + 1), ++count;
      const Vec3 apart = at(c, r) - (1.0 / count) * around;
      sum += sheet.particleMass * dot(apart, apart) / 2;
    }
  }
  return sum;
}

/// One run: the energy at the grid's scale in each tenth of it, and the alarm's two rises.
struct Trace {
  static constexpr int kParts = 10;
  std::array<double, kParts> mean{}, most{};
  double stored = 0, balance = 0, scale = 0, stretch = 0;
  bool finite = true, alarmed = false;
};

Trace follow(const Scene& scene, const Method& method) {
  constexpr int kTicks = 8;  // between two samples
  Simulation simulation(scene, method, {.threads = 1, .keepGoing = true});
  Trace trace;
  std::array<int, Trace::kParts> samples{};
  while (simulation.time() < scene.duration && trace.finite) {
    simulation.tick(kTicks);
    trace.finite = simulation.status() != Status::NotFinite;
    const auto part = std::min(std::size_t(simulation.time() / scene.duration * Trace::kParts), trace.mean.size() - 1);
    const double energy = gridEnergy(simulation);
    trace.most[part] = std::max(trace.most[part], energy);
    trace.mean[part] += (energy - trace.mean[part]) / ++samples[part];
  }
  const Ledger ledger = simulation.ledger();
  trace.alarmed = simulation.status() != Status::Ok;
  trace.stored = ledger.storedRise, trace.balance = ledger.balanceRise;
  trace.scale = ledger.scale, trace.stretch = ledger.maxStretch;
  if (!trace.finite) trace.stored = trace.balance = std::numeric_limits<double>::infinity();
  return trace;
}

struct Row {
  const Method* method = nullptr;
  double share = 0;  ///< of the sound limit below 1, of the limit at rest above; 0: the method has none
  bool spoiled = false, alarmed = false;
  double excess = 0;  ///< energy at the grid's scale beyond twice what it should be, fraction of the alarm's scale
  double stored = 0, balance = 0;
};

Row judged(const Trace& run, const Trace& accurate) {
  Row row;
  row.spoiled = !run.finite;
  for (int part = 0; part < Trace::kParts && run.finite; ++part) {
    double right = 0;
    for (int k = std::max(0, part - 1); k <= std::min(Trace::kParts - 1, part + 1); ++k) {
      right = std::max(right, accurate.most[std::size_t(k)]);
    }
    const double found = run.mean[std::size_t(part)], excess = (found - 2 * right) / run.scale;
    row.excess = std::max(row.excess, excess);
    row.spoiled = row.spoiled || (found > kSpoiledTimes * right && excess > kSpoiledShare);
  }
  row.stored = run.stored, row.balance = run.balance, row.alarmed = run.alarmed;
  return row;
}

using Cloth = Scene(unsigned seed, double seconds);

/// The runs of one method on one cloth. None where the accurate run stretches too far.
void addRows(unsigned seed, const Method& method, Cloth* cloth, std::vector<Row>& rows) {
  const Scene look = cloth(seed, 1);
  if (!takes(method, look)) return;
  const Method& accurate = findMethod("rk4");
  const double rest = restLatticeLimit(look, method), own = soundLimit(look, accurate);
  const bool limited = !std::isnan(rest);
  if (limited && rest <= 0) return;
  const double unit = limited ? rest : own;
  const int steps = limited ? kSteps : kSteps / 5;  // the others solve equations
  Scene scene = cloth(seed, steps * unit);
  scene.tolerance = 0;  // adaptive methods take steps of dt
  scene.dt = 0.5 * std::min(own, unit);
  const Trace reference = follow(scene, accurate);
  if (reference.stretch > kMostStretch) return;
  const auto add = [&](double share, double dt) {
    scene.dt = dt;
    Row row = judged(follow(scene, method), reference);
    row.method = &method, row.share = share;
    rows.push_back(row);
  };
  if (!limited) {
    for (const double step : {0.5, 1.0, 4.0}) add(0, step * unit);
    return;
  }
  const double sound = soundLimit(look, method);
  for (const double share : kBelow) add(share, share * sound);
  for (const double share : kAbove) add(share, share * rest);
  if (!method.adaptive) return;
  for (const double share : {1e-2, 1e-3, 1e-4}) {
    scene.tolerance = share * makeSheet(scene).size();
    add(0, sound);
  }
}

/// Wilson's interval at 95 % (Wilson 1927), in per cent.
std::string rate(int wrong, int all) {
  if (all == 0) return "none";
  const double z = 1.96, n = all, p = wrong / n, base = 1 + z * z / n;
  const double middle = (p + z * z / (2 * n)) / base,
               half = z / base * std::sqrt(p * (1 - p) / n + z * z / (4 * n * n));
  std::array<char, 80> text{};
  std::snprintf(text.data(), text.size(), "%d of %d, %.1f %% (%.1f to %.1f)", wrong, all, 100 * p,
                100 * std::max(0.0, middle - half), 100 * (middle + half));
  return text.data();
}

template <class Chosen, class Wrong>
std::string rateOf(const std::vector<Row>& rows, const Chosen& chosen, const Wrong& wrong) {
  int all = 0, found = 0;
  for (const Row& row : rows) {
    if (!chosen(row)) continue;
    ++all;
    if (wrong(row)) ++found;
  }
  return rate(found, all);
}

double level(const Row& row) { return std::max(row.stored, row.balance); }
bool soundBelow(const Row& row) { return row.share < 1 && !row.spoiled; }
bool spoiledAbove(const Row& row) { return row.share > 1 && row.spoiled; }

void printThresholds(const std::vector<Row>& rows) {
  std::printf("\nthreshold | false, K+E+G-W alone | missed | false, balance too | missed\n");
  for (const double at : kThresholds) {
    const auto stored = [=](const Row& row) { return row.stored > at; };
    const auto either = [=](const Row& row) { return level(row) > at; };
    std::printf("%9.2f | %s | %s | %s | %s\n", at, rateOf(rows, soundBelow, stored).c_str(),
                rateOf(rows, spoiledAbove, std::not_fn(stored)).c_str(), rateOf(rows, soundBelow, either).c_str(),
                rateOf(rows, spoiledAbove, std::not_fn(either)).c_str());
  }
}

void printMethods(const std::vector<Row>& rows) {
  const auto alarmed = [](const Row& row) { return row.alarmed; };
  std::printf("\nat %.2f: method | false alarms | missed | largest excess missed, of S | missed without the balance\n",
              Alarm::kThreshold);
  for (const Method& method : methods()) {
    const auto mine = [&](auto of) {
      return [&method, of](const Row& row) { return row.method == &method && of(row); };
    };
    double largest = 0;
    for (const Row& row : rows) {
      if (mine(spoiledAbove)(row) && !alarmed(row)) largest = std::max(largest, row.excess);
    }
    std::printf(
        "%s | %s | %s | %.3f | %s\n", std::string(method.name).c_str(), rateOf(rows, mine(soundBelow), alarmed).c_str(),
        rateOf(rows, mine(spoiledAbove), std::not_fn(alarmed)).c_str(), largest,
        rateOf(rows, mine(spoiledAbove), [](const Row& row) { return row.stored <= Alarm::kThreshold; }).c_str());
  }
}

void printShares(const std::vector<Row>& rows) {
  const auto alarmed = [](const Row& row) { return row.alarmed; };
  std::printf("\nat share of the limit | runs not spoiled that alarmed | spoiled that did not\n");
  const auto print = [&](double share) {
    const auto sound = [=](const Row& row) { return row.share == share && !row.spoiled; };
    const auto spoiled = [=](const Row& row) { return row.share == share && row.spoiled; };
    std::printf("%.2f | %s | %s\n", share, rateOf(rows, sound, alarmed).c_str(),
                rateOf(rows, spoiled, std::not_fn(alarmed)).c_str());
  };
  print(0);
  for (const double share : kBelow) print(share);
  for (const double share : kAbove) print(share);
}

std::vector<Row> study(unsigned scenes, Cloth* cloth) {
  std::vector<std::vector<Row>> ofScene(scenes);
  std::atomic<unsigned> next{0};
  const auto work = [&] {
    for (unsigned k = next++; k < scenes; k = next++) {
      for (const Method& method : methods()) addRows(k + 1, method, cloth, ofScene[k]);
      std::fprintf(stderr, "\r%u of %u cloths", k + 1, scenes);
    }
  };
  {
    std::vector<std::jthread> threads;
    for (unsigned k = 0; k < std::max(1U, std::thread::hardware_concurrency()); ++k) threads.emplace_back(work);
  }
  std::fprintf(stderr, "\n");
  std::vector<Row> rows;
  for (const std::vector<Row>& some : ofScene) rows.insert(rows.end(), some.begin(), some.end());
  return rows;
}

}  // namespace
}  // namespace tyg::test

int main(int argc, char** argv) {
  unsigned scenes = 200;
  const std::string asked = argc > 1 ? argv[1] : "200";
  const auto [end, error] = std::from_chars(asked.data(), asked.data() + asked.size(), scenes);
  if (error != std::errc() || *end != 0 || scenes < 1 || scenes > 100000) {
    std::fprintf(stderr, "alarm_statistics: found \"%s\" cloths, allowed: 1 to 100000\n", asked.c_str());
    return 2;
  }
  const std::string kind = argc > 2 ? argv[2] : "";
  if (argc > 3 || (argc > 2 && kind != "wind" && kind != "contact")) {
    std::fprintf(stderr, "alarm_statistics: found \"%s\", allowed: wind or contact\n", argv[argc - 1]);
    return 2;
  }
  tyg::test::Cloth* const cloth = kind == "wind"      ? tyg::test::randomWindyCloth
                                  : kind == "contact" ? tyg::test::randomTouchingCloth
                                                      : tyg::test::randomCloth;
  const std::vector<tyg::test::Row> rows = tyg::test::study(scenes, cloth);
  std::printf("%u cloths, %zu runs; a share of 0 stands for methods without limit and for adaptive steps\n", scenes,
              rows.size());
  tyg::test::printThresholds(rows);
  tyg::test::printMethods(rows);
  tyg::test::printShares(rows);
  return 0;
}
