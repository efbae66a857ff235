// Both passes stop at the times of all frames: steps that end there are part of the motion.
#include "app/output/export.h"

#include <functional>
#include <iostream>
#include <memory>

#include <fmt/core.h>

#include "app/output/exit_code.h"
#include "app/output/moving_scene.h"
#include "app/output/obj_folder.h"
#include "app/output/progress.h"
#include "app/output/usd_file.h"
#include "util/file_names.h"
#include "util/interrupt.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCommand = "tyg export";

bool isUsd(const fs::path& out) { return endingOf(out) == ".usda"; }

std::unique_ptr<ExportSink> openSink(const fs::path& out) {
  std::error_code none;
  const std::string ending = endingOf(out);
  if (isUsd(out)) return openUsdFile(out);
  if (ending.empty() || fs::is_directory(out, none)) return openObjFolder(out);
  throw InputError("--out: found '" + out.string() +
                   "', allowed are FILE.usda and a folder, which gets numbered .obj files");
}

/// One pass through the times of the frames.
class Pass {
 public:
  /// `show`: as Progress::part().
  Pass(const Scene& scene, const ExportRequest& request, const std::function<bool(double)>& show)
      : times_(request.times),
        moving_(scene, {.threads = request.threads}, [this, show](double now) { return show(now / times_.back()); }) {}

  /// False where the scene cannot go on.
  template <class See>
  bool through(const See& see) {
    for (std::size_t k = 0; k < times_.size(); ++k) {
      if (!moving_.reach(times_[k])) return false;
      see(k);
    }
    return true;
  }
  [[nodiscard]] MovingScene& moving() { return moving_; }

 private:
  const std::vector<double>& times_;
  MovingScene moving_;
};

int written(const Scene& scene, const ExportRequest& request, ExportSink& sink) {
  Progress progress("tyg export " + scene.name);
  Sheet last = makeSheet(scene);
  const double firstShare = losesSprings(scene) ? 0.5 : 0;
  if (firstShare > 0) {
    Pass scout(scene, request, progress.part(0, firstShare));
    if (!scout.through([](std::size_t) {})) return sayStopped(kCommand, scout.moving().simulation(), progress);
    last = scout.moving().simulation().sheet();
  }
  LastingMesh cloth(last);
  const ExportedScene exported{scene, last, request.times.size(), request.fps};
  Pass pass(scene, request, progress.part(firstShare));
  const bool isWhole = pass.through([&](std::size_t k) {
    MovingScene& moving = pass.moving();
    const Sheet& sheet = moving.simulation().sheet();
    cloth.follow(sheet, moving.xyz());
    const ExportedFrame frame{k, request.times[k], sheet, moving.xyz(), cloth, moving.bodies()};
    if (k == 0) sink.begin(exported, frame);
    sink.add(frame);
  });
  if (!isWhole) return sayStopped(kCommand, pass.moving().simulation(), progress);
  progress.finish();
  sink.keep();
  return kDone;
}

}  // namespace

int exportScene(const Scene& scene, const ExportRequest& request) {
  const InterruptWatch watch;
  const std::unique_ptr<ExportSink> sink = openSink(request.out);
  const double bytesOfParticle = isUsd(request.out) ? 70 : 130;
  sayLargeOutput(kCommand, request.out.string(), scene, request.times.size(), bytesOfParticle);
  const int code = written(scene, request, *sink);
  if (code == kDone) {
    const std::size_t frames = request.times.size();
    std::cout << fmt::format("{}: {} {}{}", request.out.string(), frames, frames == 1 ? "frame" : "frames",
                             isUsd(request.out) ? "" : " as OBJ files")
              << std::endl;
  }
  return code;
}

}  // namespace tyg
