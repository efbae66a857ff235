// The options that say which times of a run become frames.
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/commands/command_options.h"
#include "app/commands/commands.h"
#include "app/output/moving_scene.h"
#include "util/amounts.h"

namespace tyg {

void addFrameOptions(Command& command, FrameOptions& options, const FrameWords& words) {
  const auto time = [](const char* option) {
    return [=](const std::string& text) { return parseTime(option, text, Zero::Allowed); };
  };
  command
      .amount("--from", options.from, time("--from"),
              fmt::format("The simulated time of the first of several {} [0]", words.frames))
      .typeName("TIME");
  command.amount("--to", options.to, time("--to"), "The simulated time of the last one [the end]").typeName("TIME");
  command
      .amount(
          "--fps", options.fps, [](const std::string& text) { return parseNumber("--fps", text); },
          fmt::format("{} per simulated second [{:g}]", words.framesAtFirst, words.usualFps))
      .typeName("N");
}

std::vector<double> chosenFrames(const FrameOptions& options, const Scene& scene, double usualFps) {
  constexpr std::size_t kMostFrames = 100'000;
  const double from = options.from.value_or(0), to = options.to.value_or(scene.duration);
  const double fps = options.fps.value_or(usualFps);
  if (!(to > from)) throw InputError("--to: found a time that is not after --from, allowed is a later one");
  if ((to - from) * fps > double(kMostFrames)) {
    throw InputError(fmt::format("--from, --to, --fps: found more than {} frames, allowed are fewer", kMostFrames));
  }
  return frameTimes(from, to, fps);
}

void sayLastFrame(const char* command, double last, const FrameOptions& options, const Scene& scene) {
  constexpr double kRounding = 1e-9;
  if (options.to && last < (1 - kRounding) * *options.to) {
    std::cerr << fmt::format("{}: the last frame is at {:g} s, because none is due at {:g} s", command, last,
                             *options.to)
              << std::endl;
  }
  if (last <= scene.duration) return;
  std::cerr << fmt::format("{}: {:g} s is after the end of the run at {:g} s; the cloth moves on until then", command,
                           last, scene.duration)
            << std::endl;
}

}  // namespace tyg
