// How often `tyg check` names a mistake rightly, and whether it ever accuses a right program: random scenes, mistakes,
// methods and steps, run by a program that shares no code with Tyg. Prints what went wrong and the rates.
//   build/release/tests/check_statistics [MOTIONS=200 [FIRST=1]]
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "random_check.h"

int main(int argc, char** argv) {
  using namespace tyg::test;
  const int motions = argc > 1 ? std::atoi(argv[1]) : 200, first = argc > 2 ? std::atoi(argv[2]) : 1;
  for (const int mistakes : {0, 1, 2}) {
    int good = 0, accused = 0;
    double slowest = 0, all = 0;
    for (int seed = first; seed < first + motions; ++seed) {
      const auto begin = std::chrono::steady_clock::now();
      const RandomCheck check = randomCheck(unsigned(seed), mistakes);
      const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      slowest = std::max(slowest, seconds), all += seconds;
      good += check.named ? 1 : 0;
      accused += check.accused ? 1 : 0;
      if (!check.named) std::printf("%d: %s\n   said: %s\n", seed, check.what.c_str(), check.said.c_str());
    }
    std::printf("%d mistakes: %d of %d named rightly, %d accused wrongly; %.2f s each, at most %.2f s\n", mistakes,
                good, motions, accused, all / motions, slowest);
    std::fflush(stdout);
  }
}
