// Time and memory per particle as the sheet grows, and from which size on a second thread pays.
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <sstream>

#include "scaling.h"
#include "tyg/methods.h"

namespace tyg::scaling {
namespace {

constexpr double kStep = 1e-4;  // s, far from every limit
constexpr int kSteps = 64;      // of one turn: as many as between two energy checks, which are included
constexpr std::array kPrecisions{Precision::Float, Precision::Double};

Scene curtain(int count, Precision precision) {
  Scene scene = loadScene("curtain");
  scene.columns = scene.rows = count;
  scene.integrator = "leapfrog";
  scene.precision = precision;
  scene.dt = kStep;
  return scene;
}

/// Most memory that this process has had resident so far, bytes; NaN where the system does not tell.
double peakMemory() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == "VmHWM:" && status >> kilobytes) return 1024 * kilobytes;
  }
  return std::numeric_limits<double>::quiet_NaN();
}

/// The same of a child that sets up and steps a sheet.
double peakMemoryOf(int count, Precision precision) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) return std::numeric_limits<double>::quiet_NaN();
  const pid_t child = fork();
  if (child == 0) {
    const Scene scene = curtain(count, precision);
    Simulation simulation(scene, findMethod(scene.integrator), {.threads = 1});
    simulation.advanceTo(8 * kStep);
    const double peak = peakMemory();
    _exit(write(ends[1], &peak, sizeof peak) == sizeof peak ? 0 : 1);
  }
  close(ends[1]);
  double peak = std::numeric_limits<double>::quiet_NaN();
  if (read(ends[0], &peak, sizeof peak) != sizeof peak) peak = std::numeric_limits<double>::quiet_NaN();
  close(ends[0]);
  if (child > 0) waitpid(child, nullptr, 0);
  return peak;
}

struct Size {
  int count;
  int rounds;
};
std::vector<Size> sizesOf(const Options& options) {
  if (options.quick) return {{10, 200}, {32, 50}, {128, 10}, {512, 3}};
  return {{10, 500}, {20, 300}, {32, 150}, {48, 80}, {64, 60},  {96, 40}, {128, 25},
          {192, 16}, {256, 12}, {384, 8},  {512, 6}, {1024, 4}, {2048, 3}};
}

/// The smallest size from which on two threads are never slower, or 0.
int breakEven(const std::vector<Size>& sizes, const std::vector<std::array<double, 4>>& times, std::size_t precision) {
  int from = 0;
  for (std::size_t k = sizes.size(); k-- > 0 && times[k][2 * precision + 1] < times[k][2 * precision];) {
    from = sizes[k].count;
  }
  return from;
}

/// ns per particle-step: float on one thread and two, double on one and two.
std::array<double, 4> timesOf(const Size& size) {
  std::vector<Simulation> simulations;
  for (const Precision precision : kPrecisions) {
    for (const int threads : {1, 2}) {
      simulations.emplace_back(curtain(size.count, precision), findMethod("leapfrog"), Settings{.threads = threads});
    }
  }
  std::vector<Contestant> contestants;
  for (Simulation& simulation : simulations) {
    contestants.push_back({[&] { simulation.tick(kSteps); }, simulation.threads()});
  }
  takeTurns(contestants, size.rounds);
  std::array<double, 4> times{};
  for (std::size_t k = 0; k < times.size(); ++k) {
    times[k] = 1e9 * contestants[k].least / (double(kSteps) * size.count * size.count);
  }
  return times;
}

constexpr const char* kChart = R"(
  set multiplot layout 1,2 margins 0.07,0.98,0.13,0.9 spacing 0.09
  set logscale x; set grid lc rgb '#dddddd' lt 1; set key right top; set xtics 10,10,10000000 format '10^{%T}'
  set xlabel 'particles'; set yrange [0:20]; set title 'leapfrog, alarm included: ns per particle and step'
  plot data using 1:2 skip 1 w lp pt 6 lw 2 lc rgb '#0072B2' t 'float, 1 thread', \
       '' using 1:3 skip 1 w lp pt 7 lw 2 lc rgb '#0072B2' dt 2 t 'float, 2 threads', \
       '' using 1:4 skip 1 w lp pt 8 lw 2 lc rgb '#D55E00' t 'double, 1 thread', \
       '' using 1:5 skip 1 w lp pt 9 lw 2 lc rgb '#D55E00' dt 2 t 'double, 2 threads'
  set key right top; set yrange [0:250]; set title 'bytes per particle, of what the process has resident'
  plot data using 1:6 skip 1 w lp pt 6 lw 2 lc rgb '#0072B2' t 'float', \
       '' using 1:7 skip 1 w lp pt 8 lw 2 lc rgb '#D55E00' t 'double', \
       36 w l lw 2 dt 3 lc rgb '#0072B2' t 'position, velocity, predicted velocity', \
       72 w l lw 2 dt 3 lc rgb '#D55E00' notitle
  unset multiplot
)";

/// Peak resident memory by size and precision, bytes per particle.
std::vector<std::array<double, 2>> memories;

std::string memoryText(double bytes) { return std::isnan(bytes) ? "" : std::to_string(std::lround(bytes)); }

}  // namespace

void measureMemory(const Options& options) {
  say("memory ...");
  const std::array base{peakMemoryOf(2, Precision::Float), peakMemoryOf(2, Precision::Double)};
  for (const Size& size : sizesOf(options)) {
    auto& peak = memories.emplace_back();
    for (std::size_t k = 0; k < 2; ++k) {
      constexpr int kTellable = 64;  // less of a sheet is lost among pages that come and go
      peak[k] = size.count < kTellable ? std::nan("")
                                       : (peakMemoryOf(size.count, kPrecisions[k]) - base[k]) / size.count / size.count;
    }
  }
}

void measureSizes(const Options& options) {
  const std::vector<Size> sizes = sizesOf(options);
  std::vector<std::array<double, 4>> times;
  std::ostringstream csv;
  csv << "particles,float_1_ns,float_2_ns,double_1_ns,double_2_ns,float_bytes,double_bytes\n";
  std::printf(
      "leapfrog, alarm included: ns per particle and step; resident bytes per particle, less the program's own\n"
      "%-10s %9s %9s %9s %9s %9s %9s\n",
      "sheet", "float 1", "float 2", "double 1", "double 2", "float", "double");
  for (std::size_t k = 0; k < sizes.size(); ++k) {
    const int count = sizes[k].count;
    const double particles = double(count) * count;
    say("sheet of " + std::to_string(count) + "x" + std::to_string(count) + " ...");
    times.push_back(timesOf(sizes[k]));
    const auto& t = times.back();
    const std::string single = memoryText(memories[k][0]), wide = memoryText(memories[k][1]);
    std::printf("%4dx%-5d %9.2f %9.2f %9.2f %9.2f %9s %9s\n", count, count, t[0], t[1], t[2], t[3], single.c_str(),
                wide.c_str());
    csv << particles << "," << t[0] << "," << t[1] << "," << t[2] << "," << t[3] << "," << single << "," << wide
        << "\n";
  }
  for (std::size_t k = 0; k < 2; ++k) {
    const int from = breakEven(sizes, times, k);
    std::printf("%s: a second thread pays %s\n", nameOf(kPrecisions[k]),
                from == 0 ? "nowhere" : ("from " + std::to_string(from) + "x" + std::to_string(from) + " on").c_str());
  }
  writeAndDraw(options, "sizes", csv.str(), kChart);
}

}  // namespace tyg::scaling
