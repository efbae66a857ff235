// What a step costs on the graphics card and on the processor as the sheet grows, which share of the card's memory
// bandwidth it takes, from which size on the card pays, and whether both end in the same bits. Runs on whatever offers
// OpenGL 4.3, and says what that is.
//   gpu_sizes [MOST [STEPS]]    up to MOST x MOST particles [1024], STEPS at a time [64]; 4096 needs some gigabytes
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <string>
#include <vector>

#include <fmt/core.h>

#include "gfx/contexts/compute_context.h"
#include "gpu/card.h"
#include "gpu/card_buffer.h"
#include "gpu/gpu_device.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"
#include "util/machine.h"

namespace tyg {
namespace {

constexpr double kStep = 1e-5;                          // s, far from every limit of these sheets
constexpr int kTurns = 3;                               // the least time of which counts
constexpr int kLargest = 4096;                          // as scenes allow
constexpr std::size_t kCopied = std::size_t{64} << 20;  // bytes, to measure the bandwidth

/// Numbers of four bytes that a step reads and writes per particle where every neighbour is found in a cache.
struct Traffic {
  const char* method;
  int bytes;
};
constexpr Traffic kTraffic[] = {
    {"symplectic-euler", 4 * (4 * 3 + 1)},    // x, v; x, v; and the kind
    {"leapfrog", 4 * (6 * 3 + 1)},            // x, v, the predicted v; the same
    {"rk4", 4 * ((6 + 2 * 10 + 8) * 3 + 4)},  // first, two inner and last stage
};

OpenedContext openContext() {
  std::shared_ptr<ComputeContext> context = makeComputeContext();
  return {context, context->find()};
}

double secondsOf(const auto& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Bytes per second that the card reads and writes when it copies its own memory.
double bandwidth() {
  Card card(openContext);
  double best = 0;
  card.run([&] {
    CardBuffer from(card), to(card);
    const std::vector<char> zeros(kCopied);
    from.write(zeros.data(), kCopied), to.write(zeros.data(), kCopied);
    for (int turn = 0; turn < 2 * kTurns; ++turn) {
      constexpr int kCopies = 8;
      const double seconds = secondsOf([&] {
        for (int copy = 0; copy < kCopies; ++copy) to.copyFrom(from);
        card.gl().Finish();
      });
      best = std::max(best, 2.0 * kCopies * double(kCopied) / seconds);
    }
  });
  return best;
}

Scene curtain(int count, const char* method) {
  Scene scene = loadScene("curtain");
  scene.columns = scene.rows = count;
  scene.integrator = method;
  scene.precision = Precision::Float;
  scene.dt = kStep;
  return scene;
}

/// What a sheet of one size costs in one place.
struct Cost {
  double nanoseconds = 0;  ///< per particle and step, the least of all turns
  std::uint64_t hash = 0;  ///< after them
};

Cost costOf(const Scene& scene, const Settings& settings, int steps) {
  Simulation simulation(scene, findMethod(scene.integrator), settings);
  simulation.tick(steps);  // kernels are compiled, and memory is taken
  double least = INFINITY;
  for (int turn = 0; turn < kTurns; ++turn) {
    least = std::min(least, secondsOf([&] { simulation.tick(steps); }));
  }
  return {1e9 * least / steps / simulation.sheet().count(), simulation.hash()};
}

/// From which size on something is cheaper, up to the largest that was measured.
class BreakEven {
 public:
  void see(int count, bool cheaper) { from_ = !cheaper ? 0 : from_ == 0 ? count : from_; }
  [[nodiscard]] std::string text() const {
    return from_ > 0 ? fmt::format("from {0} x {0} particles on", from_) : "at no size";
  }

 private:
  int from_ = 0;  // 0: none
};

struct Plan {
  int most = 1024;  ///< particles in a row and in a column
  int steps = 64;   ///< of one turn: as many as between two energy checks, which are included
};

void measure(const std::shared_ptr<GpuDevice>& device, const Traffic& traffic, const Plan& plan,
             double bytesPerSecond) {
  fmt::print("\n{}: ns per particle and step\n", traffic.method);
  fmt::print("{:>13}{:>12}{:>12}{:>12}{:>12}{:>14}  {}\n", "particles", "1 thread", "2 threads", "card", "bandwidth",
             "with ledger", "bits");
  BreakEven beforeOne, beforeTwo;
  for (int count = 32; count <= plan.most; count *= 2) {
    const Scene scene = curtain(count, traffic.method);
    Cost card, withLedger;
    try {
      card = costOf(scene, {.threads = 2, .device = device}, plan.steps);
      withLedger = costOf(scene, {.threads = 2, .ledger = true, .device = device}, plan.steps);
    } catch (const std::runtime_error& refusal) {
      fmt::print("{:>13}  {}\n", fmt::format("{0} x {0}", count), refusal.what());
      break;
    }
    const Cost one = costOf(scene, {.threads = 1}, plan.steps), two = costOf(scene, {.threads = 2}, plan.steps);
    fmt::print("{:>13}{:12.2f}{:12.2f}{:12.2f}{:11.1f}%{:14.2f}  {}\n", fmt::format("{0} x {0}", count),
               one.nanoseconds, two.nanoseconds, card.nanoseconds,
               100 * traffic.bytes / (card.nanoseconds * 1e-9) / bytesPerSecond, withLedger.nanoseconds,
               card.hash == one.hash ? "the same" : "DIFFERENT");
    std::fflush(stdout);
    beforeOne.see(count, card.nanoseconds < one.nanoseconds);
    beforeTwo.see(count, card.nanoseconds < two.nanoseconds);
  }
  fmt::print("The card is faster than one thread: {}; than two threads: {}.\n", beforeOne.text(), beforeTwo.text());
}

int run(const Plan& plan) {
  const auto device = std::make_shared<GpuDevice>(openContext);
  const double bytesPerSecond = bandwidth();
  fmt::print("Graphics card: {}, which copies its memory at {:.3g} GB/s{}\n", device->name(), bytesPerSecond * 1e-9,
             device->isProcessor() ? " (no card: the processor stands in for one)" : "");
  fmt::print("Processor: {}\n", machineName());
  fmt::print(
      "bandwidth: the share of the card's that a step uses; with ledger: the card works out the power of every step as "
      "well; bits: are the card's the processor's, after all steps?\n");
  for (const Traffic& traffic : kTraffic) measure(device, traffic, plan, bytesPerSecond);
  return 0;
}

/// False where it is no whole number of this range.
bool read(const char* text, int least, int most, int& number) {
  const char* end = text + std::strlen(text);
  const auto [rest, error] = std::from_chars(text, end, number);
  return error == std::errc() && rest == end && number >= least && number <= most;
}

}  // namespace
}  // namespace tyg

int main(int argc, char** argv) {
  tyg::Plan plan;
  const bool isRight = argc <= 3 && (argc < 2 || tyg::read(argv[1], 32, tyg::kLargest, plan.most)) &&
                       (argc < 3 || tyg::read(argv[2], 1, 64, plan.steps));
  if (!isRight) {
    fmt::print(stderr, "gpu_sizes: allowed are gpu_sizes [MOST [STEPS]], MOST from 32 to {}, STEPS from 1 to 64\n",
               tyg::kLargest);
    return 2;
  }
  try {
    return tyg::run(plan);
  } catch (const std::runtime_error& error) {
    fmt::print(stderr, "gpu_sizes: {}\n", error.what());
    return 1;
  }
}
