// What Tyg costs as the work grows: ns and bytes per particle from 10x10 to 2048x2048 particles on one thread and two,
// what each term of the model adds, and what a simulated second costs on finer and finer grids of the same cloth.
//   build/release/tests/scaling [--quick] [--out DIR]     CSV files and charts; three minutes on a quiet machine
#include "scaling.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <iostream>
#include <sstream>

#include "study/charts/gnuplot.h"
#include "util/whole_file.h"

namespace tyg::scaling {

double seconds(int threads) {
  if (threads > 1) return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

void takeTurns(std::vector<Contestant>& contestants, int rounds) {
  for (int round = 0; round < rounds; ++round) {
    for (Contestant& one : contestants) {
      const double start = seconds(one.threads);
      one.work();
      const double took = seconds(one.threads) - start;
      one.least = round == 0 ? took : std::min(one.least, took);
    }
  }
}

void say(const std::string& what) { std::cerr << what << std::endl; }

void writeAndDraw(const Options& options, const std::string& name, const std::string& csv, const std::string& script) {
  writeWholeFile(options.out / (name + ".csv"), csv);
  std::ostringstream whole;
  whole << "set datafile separator ','\n"
           "do for [kind in 'svg pngcairo'] {\n"
           "  set terminal kind size 1300, 560 font ',13' background rgb 'white'\n"
        << "  set output '" << name << "'.(kind eq 'svg' ? '.svg' : '.png')\n"
        << script << "  unset output\n}\n";
  writeWholeFile(options.out / (name + ".gp"), whole.str());
  const GnuplotOutcome outcome = runGnuplot(options.out, name + ".gp", {"data=" + gnuplotQuoted(name + ".csv")});
  if (outcome.kind != GnuplotOutcome::Kind::Drawn) say("no chart of " + name + ": " + outcome.message);
}

namespace {

struct Part {
  const char* name;
  void (*measure)(const Options& options);
};
constexpr Part kParts[] = {
    {"memory", measureMemory}, {"sizes", measureSizes}, {"terms", measureTerms}, {"refinement", measureRefinement}};

int run(int count, char** words) {
  Options options;
  std::string only;
  for (int k = 1; k < count; ++k) {
    if (std::strcmp(words[k], "--quick") == 0) {
      options.quick = true;
    } else if (std::strcmp(words[k], "--out") == 0 && k + 1 < count) {
      options.out = words[++k];
    } else if (std::strcmp(words[k], "--only") == 0 && k + 1 < count) {
      only = words[++k];
    } else {
      std::cerr << "scaling: found " << words[k]
                << ", allowed: --quick, --out DIR, --only memory|sizes|terms|refinement\n";
      return 2;
    }
  }
  std::filesystem::create_directories(options.out);
  checkWritable(options.out / "sizes.csv");
  for (const Part& part : kParts) {
    if (only.empty() || only == part.name) part.measure(options);
  }
  std::cout << "\nwritten to " << options.out.string() << std::endl;
  return 0;
}

}  // namespace
}  // namespace tyg::scaling

int main(int count, char** words) {
  try {
    return tyg::scaling::run(count, words);
  } catch (const std::exception& error) {
    std::cerr << "scaling: " << error.what() << std::endl;
    return 2;
  }
}
