// A sequence is simulated twice: the first time tells how far the cloth moves (and whether it stays stable at all), so
// that the camera can stay where it is without losing the cloth.
#include "app/output/render.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <optional>

#include <fmt/core.h>

#include "app/output/drawn_files.h"
#include "app/output/exit_code.h"
#include "app/output/moving_scene.h"
#include "app/output/progress.h"
#include "core/forces/terms/air.h"
#include "gfx/movie.h"
#include "gfx/picture_texture.h"
#include "study/motion/telling_moment.h"
#include "tyg/simulation.h"
#include "util/file_names.h"
#include "util/interrupt.h"
#include "util/whole_file.h"
#include "view/body_shapes.h"
#include "view/wind_arrow.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

constexpr const char* kCommand = "tyg render";
constexpr double kFramingPoints = 2000;  // particles that the view is fitted to, about, at each time
constexpr int kLargestSmooth = 4096;     // pixels wide and high

bool isFolder(const fs::path& path) {
  std::error_code none;
  return fs::is_directory(path, none);
}

enum class Form { Picture, Movie, Folder };
Form formOf(const fs::path& out) {
  const std::string ending = endingOf(out);
  if (!ending.empty() && ending != ".png" && ending != ".mp4" && ending != ".gif" && !isFolder(out)) {
    throw InputError("--out: found '" + out.string() + "', allowed are FILE.png, FILE.mp4, FILE.gif and a folder");
  }
  return ending == ".png" ? Form::Picture : ending == ".mp4" || ending == ".gif" ? Form::Movie : Form::Folder;
}

/// Gathers what a still view has to hold.
class Framing {
 public:
  void include(MovingScene& motion) {
    const Box here = motion.box();
    addBodyPoints(motion.bodies(), here, points_);
    all_ = all_ ? all_->with(here) : here;
    const std::span<const float> xyz = motion.xyz();
    const auto columns = static_cast<std::size_t>(motion.simulation().sheet().columns);
    const std::size_t count = xyz.size() / 3, rows = count / columns;
    const auto stride = static_cast<std::size_t>(std::ceil(std::sqrt(double(count) / kFramingPoints)));
    for (const std::size_t row : spread(rows, stride)) {
      for (const std::size_t column : spread(columns, stride)) {
        const float* p = &xyz[3 * (row * columns + column)];
        points_.emplace_back(p[0], p[1], p[2]);
      }
    }
  }
  [[nodiscard]] Camera camera(glm::ivec2 size) const {
    Camera camera;
    camera.watch(all_.value_or(Box{}));
    camera.frame(points_, static_cast<float>(size.x) / static_cast<float>(size.y));
    return camera;
  }

 private:
  /// Every stride-th number below `count`, and the last: the corners of a sheet count most.
  static std::vector<std::size_t> spread(std::size_t count, std::size_t stride) {
    std::vector<std::size_t> numbers;
    for (std::size_t k = 0; k + 1 < count; k += stride) numbers.push_back(k);
    numbers.push_back(count - 1);
    return numbers;
  }

  std::optional<Box> all_;
  std::vector<glm::vec3> points_;
};

/// Machines that cannot draw are told so as for every output that cannot be made.
template <class Open>
auto opened(const Open& open) {
  try {
    return open();
  } catch (const std::runtime_error& error) {
    throw InputError(error.what());
  }
}

/// What draws the pictures, on a graphics card where one may move the cloth, and what moves it.
struct Equipment {
  explicit Equipment(const RenderRequest& request)
      : offscreen(opened([&] {
          const glm::ivec2 size = request.size;
          return request.chooseDevice ? makeOffscreenOnCard(size.x, size.y) : makeOffscreen(size.x, size.y);
        })),
        settings{.threads = request.threads,
                 .device = request.chooseDevice ? request.chooseDevice(offscreen->find()) : nullptr} {}

  std::unique_ptr<Offscreen> offscreen;  // before the device, which may live in this context
  Settings settings;
};

/// Draws one sheet off-screen.
class Studio {
 public:
  Studio(const Sheet& sheet, bool hasSolids, const RenderRequest& request, const Offscreen& offscreen)
      : request_(request), offscreen_(offscreen), renderer_(sheet) {
    if (hasSolids && request.size.x <= kLargestSmooth && request.size.y <= kLargestSmooth) {
      smooth_ = std::make_unique<PictureTexture>(request.size.x, request.size.y);
    }
  }

  const Picture& draw(MovingScene& motion, Camera& camera) {
    camera.watch(motion.box());
    DrawOptions options = request_.draw;
    options.wind = windNow(motion.simulation(), camera.watched());
    options.bodies = motion.bodies();
    followLook(motion.simulation().scene(), options);
    options.show = request_.show.value_or(motion.simulation().scene().look.show);
    const auto draw = [&] {
      renderer_.follow(motion.simulation().sheet());
      renderer_.draw(motion.drawn(), camera, request_.size, options, pushNow(motion.simulation()));
    };
    const auto read = [&] { offscreen_.readPixels(picture_); };
    smooth_ ? smooth_->draw(draw) : draw();
    smooth_ ? smooth_->read(read) : read();
    return picture_;
  }

 private:
  /// The scene's push that acts now; its end counts, or a picture of the default time would not show it.
  static std::optional<ShownPush> pushNow(const Simulation& simulation) {
    for (const Push& push : simulation.scene().pushes) {
      if (simulation.time() >= push.at && simulation.time() <= push.at + push.duration) {
        return ShownPush{particleAt(simulation.sheet(), push.particle), push.force};
      }
    }
    return std::nullopt;
  }

  /// At the middle of the cloth; none where the scene has no wind.
  static std::optional<ShownWind> windNow(const Simulation& simulation, const Box& cloth) {
    const glm::vec3 middle = cloth.centre();
    const Vec3 wind = windAt(simulation.scene(), simulation.time(), {middle.x, middle.y, middle.z});
    if (wind == Vec3{}) return std::nullopt;
    return ShownWind{wind, windArrowPlace()};
  }

  const RenderRequest& request_;
  const Offscreen& offscreen_;
  std::unique_ptr<PictureTexture> smooth_;  // lines are smooth by themselves, outlines of bodies and surfaces are not
  SheetRenderer renderer_;
  Picture picture_;
};

Studio openStudio(const Simulation& simulation, const RenderRequest& request, const Equipment& equipment) {
  const Scene& scene = simulation.scene();
  const bool hasSurface = request.show.value_or(scene.look.show) != Show::Lines;
  return opened(
      [&] { return Studio(simulation.sheet(), hasSurface || !scene.bodies.empty(), request, *equipment.offscreen); });
}

std::string frameName(std::size_t frame) { return fmt::format("frame_{:05}.png", frame); }

/// Nothing is computed for an output that cannot be written.
void checkOutput(const RenderRequest& request) {
  const Form form = formOf(request.out);
  const std::string found = "--out: found '" + request.out.string() + "'";
  if (request.times.size() == 1 && form != Form::Picture) {
    throw InputError(found + ", allowed for one picture is FILE.png");
  }
  if (request.times.size() > 1 && form == Form::Picture) {
    throw InputError(found + ", allowed for several pictures are a folder, FILE.mp4 or FILE.gif");
  }
  if (form == Form::Movie && !haveFfmpeg()) {
    throw InputError(found +
                     ", but there is no ffmpeg to make a movie; allowed without it is a folder for PNG pictures");
  }
  if (form != Form::Folder) return checkWritable(request.out);
  checkFolder(request.out, std::array{frameName(0)});
}

/// What an earlier sequence that was longer left in the folder would be taken for more of this one.
void removeFramesFrom(const RenderRequest& request, std::size_t frame) {
  std::error_code none;
  while (fs::remove(request.out / frameName(frame), none)) ++frame;
}

int renderPicture(const Scene& scene, const RenderRequest& request, const Equipment& equipment) {
  const double time = request.times.front();
  Progress progress("tyg render " + scene.name);
  MovingScene motion(scene, equipment.settings,
                     [&](double now) { return progress.show(now / std::max(time, scene.dt)); });
  Studio studio = openStudio(motion.simulation(), request, equipment);
  if (!motion.reach(time)) return sayStopped(kCommand, motion.simulation(), progress);
  Framing framing;
  framing.include(motion);
  Camera camera = framing.camera(request.size);
  writePng(studio.draw(motion, camera), request.out);
  return kDone;
}

int renderSequence(const Scene& scene, const RenderRequest& request, const Equipment& equipment) {
  const double end = request.times.back();
  Progress progress("tyg render " + scene.name);
  constexpr double kFirstShare = 0.2;  // of the time that both passes take: drawing is the slower part
  MovingScene scout(scene, equipment.settings, [&](double now) { return progress.show(kFirstShare * now / end); });
  Studio studio = openStudio(scout.simulation(), request, equipment);
  Framing framing;
  for (const double time : request.times) {
    if (!scout.reach(time)) return sayStopped(kCommand, scout.simulation(), progress);
    framing.include(scout);
  }
  Camera camera = framing.camera(request.size);

  const bool isMovie = formOf(request.out) == Form::Movie;
  std::optional<Movie> movie;
  if (isMovie) movie.emplace(request.out, MovieForm{request.size.x, request.size.y, request.fps}, interrupted);
  if (!isMovie) preparedFolder(request.out, std::array{frameName(0)});
  MovingScene motion(scene, equipment.settings, [](double) { return !interrupted(); });
  for (std::size_t frame = 0; frame < request.times.size(); ++frame) {
    if (!motion.reach(request.times[frame])) return sayStopped(kCommand, motion.simulation(), progress);
    const Picture& picture = studio.draw(motion, camera);
    isMovie ? movie->add(picture) : writePng(picture, request.out / frameName(frame));
    progress.show(kFirstShare + (1 - kFirstShare) * double(frame + 1) / double(request.times.size()));
  }
  if (movie && !movie->finish()) return sayStopped(kCommand, motion.simulation(), progress);
  if (!movie) removeFramesFrom(request, request.times.size());
  return kDone;
}

}  // namespace

int render(const Scene& scene, const RenderRequest& request) {
  RenderRequest asked = request;
  if (formOf(asked.out) == Form::Movie) asked.size += asked.size % 2;
  checkOutput(asked);
  const InterruptWatch watch;
  const Equipment equipment(asked);
  const int code =
      asked.times.size() == 1 ? renderPicture(scene, asked, equipment) : renderSequence(scene, asked, equipment);
  if (code == kDone) {
    std::cout << asked.out.string();
    if (formOf(asked.out) == Form::Folder) std::cout << ": " << asked.times.size() << " pictures";
    std::cout << std::endl;
  }
  return code;
}

int renderInstead(const Scene& scene, const RenderRequest& like) {
  RenderRequest picture = like;
  picture.times = {tellingMoment(scene)};
  picture.out = freeName("", fileStem(scene.name), ".png");
  const int code = render(scene, picture);
  constexpr double kLongest = 60;  // s of movie
  RenderRequest movie = like;
  movie.times = frameTimes(0, std::min(scene.duration, kLongest), movie.fps);
  if (code != kDone || movie.times.size() < 2 || !haveFfmpeg()) return code;
  movie.out = freeName("", fileStem(scene.name), ".mp4");
  return render(scene, movie);
}

}  // namespace tyg
