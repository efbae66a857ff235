// What a step costs on the graphics card and on the processor as the sheet grows, which share of the card's memory
// bandwidth it takes, and from which size on the card pays. Runs on whatever offers OpenGL 4.3, and says what that is.
//   gpu_sizes [MOST]    up to MOST x MOST particles [1024]; 4096 needs some gigabytes
#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

#include "gfx/contexts/compute_context.h"
#include "gpu/card.h"
#include "gpu/card_buffer.h"
#include "gpu/gpu_device.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {
namespace {

constexpr int kSteps = 64;      // of one turn: as many as between two energy checks, which are included
constexpr double kStep = 1e-5;  // s, far from every limit of these sheets
constexpr int kTurns = 3;       // the least time of which counts
constexpr int kLargest = 4096;  // as scenes allow
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

/// ns per particle and step.
double costOf(const Scene& scene, const Settings& settings) {
  Simulation simulation(scene, findMethod(scene.integrator), settings);
  simulation.tick(kSteps);  // kernels are compiled, and memory is taken
  double least = INFINITY;
  for (int turn = 0; turn < kTurns; ++turn) least = std::min(least, secondsOf([&] { simulation.tick(kSteps); }));
  return 1e9 * least / kSteps / simulation.sheet().count();
}

void measure(const std::shared_ptr<GpuDevice>& device, const Traffic& traffic, int most, double bytesPerSecond) {
  std::optional<int> pays;
  for (int count = 32; count <= most; count *= 2) {
    const Scene scene = curtain(count, traffic.method);
    const double processor = costOf(scene, {}), card = costOf(scene, {.device = device});
    std::printf("%s,%d,%.3f,%.3f,%.3f\n", traffic.method, count, processor, card,
                traffic.bytes / (card * 1e-9) / bytesPerSecond);
    std::fflush(stdout);
    if (!pays && card < processor) pays = count;
    if (card >= processor) pays.reset();
  }
  if (pays) {
    std::fprintf(stderr, "%s: the card pays from %d x %d particles on\n", traffic.method, *pays, *pays);
  } else {
    std::fprintf(stderr, "%s: the processor is faster at every size up to %d x %d\n", traffic.method, most, most);
  }
}

int run(int most) {
  const auto device = std::make_shared<GpuDevice>(openContext);
  const double bytesPerSecond = bandwidth();
  std::fprintf(stderr, "%s, which copies its memory at %.3g GB/s; the processor takes as many threads as pay\n",
               device->name().c_str(), bytesPerSecond * 1e-9);
  std::puts("method,columns,processor_ns_per_particle_and_step,card_ns_per_particle_and_step,share_of_bandwidth");
  for (const Traffic& traffic : kTraffic) measure(device, traffic, most, bytesPerSecond);
  return 0;
}

}  // namespace
}  // namespace tyg

int main(int argc, char** argv) {
  int most = 1024;
  if (argc > 1) {
    const char* end = argv[1] + std::strlen(argv[1]);
    const auto [rest, error] = std::from_chars(argv[1], end, most);
    if (error != std::errc() || rest != end || most < 32 || most > tyg::kLargest || argc > 2) {
      std::fprintf(stderr, "gpu_sizes: found '%s', allowed is one whole number from 32 to %d\n", argv[1],
                   tyg::kLargest);
      return 2;
    }
  }
  try {
    return tyg::run(most);
  } catch (const std::runtime_error& error) {
    std::fprintf(stderr, "gpu_sizes: %s\n", error.what());
    return 1;
  }
}
