// The stored hashes of states, and how a run gives one: shared by the tests that compare with them.
#pragma once

#include <fstream>
#include <map>
#include <sstream>
#include <string>

#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg {

constexpr double kGoldenTime = 0.3;  // s: long enough for every spring family, pin and push edge to matter

inline std::string hexadecimal(std::uint64_t number) {
  std::ostringstream text;
  text << std::hex << number;
  return text.str();
}

inline std::string hashAfter(Scene scene, const Method& method, Precision precision, const Settings& settings,
                             double time = kGoldenTime) {
  scene.precision = precision;
  for (Push& push : scene.pushes) push.at = 0.1 * (time / kGoldenTime);
  for (Move& move : scene.moves) move.at *= time / kGoldenTime;
  for (Cut& cut : scene.cuts) cut.at = 0.1 * (time / kGoldenTime);
  Simulation simulation(scene, method, settings);
  simulation.advanceTo(time);
  // What a NaN looks like is up to the machine.
  return simulation.status() == Status::NotFinite ? "not-finite" : hexadecimal(simulation.hash());
}

/// Lines "scene method precision hash"; made anew by printing what a run gives: see the failure text.
inline std::map<std::string, std::string> goldenHashes() {
  std::map<std::string, std::string> hashes;
  std::ifstream file(TYG_SOURCE_DIR "/tests/integrators/golden_hashes.txt");
  std::string scene, method, precision, hash;
  while (file >> scene >> method >> precision >> hash) hashes[scene + " " + method + " " + precision] = hash;
  return hashes;
}

}  // namespace tyg
