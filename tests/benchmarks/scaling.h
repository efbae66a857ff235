// What the parts of `scaling` share: turns on the clock, and files with their chart. Must not know: what is measured.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "tyg/simulation.h"

namespace tyg::scaling {

struct Options {
  bool quick = false;
  std::filesystem::path out = "scaling";  ///< folder of the CSV files and charts
};

/// s from any start: for one thread the time that it has computed, so that other programs do not count.
double seconds(int threads);

/// One of several pieces of work that take turns on the clock.
struct Contestant {
  std::function<void()> work;
  int threads = 1;
  double least = 0;  ///< s, of all turns
};
/// Every one in turn, `rounds` times; the least of the times is kept, as work can only be disturbed to take longer.
void takeTurns(std::vector<Contestant>& contestants, int rounds);

/// Shows on standard error how far a part has come.
void say(const std::string& what);

/// Writes `csv` and, where gnuplot is there, draws `script` as NAME.svg and NAME.png in the folder. The script plots
/// the file whose name is in its variable `data`; terminals and outputs are set for it.
void writeAndDraw(const Options& options, const std::string& name, const std::string& csv, const std::string& script);

/// Memory is measured in children of this process, which must not have started a thread: first of all.
void measureMemory(const Options& options);
void measureSizes(const Options& options);
void measureTerms(const Options& options);
void measureRefinement(const Options& options);

}  // namespace tyg::scaling
