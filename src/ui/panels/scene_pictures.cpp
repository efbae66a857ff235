// Simulates one scene after the other, a few milliseconds a frame, and draws it into a texture when it is there.
#include "ui/panels/scene_pictures.h"

#include <algorithm>
#include <exception>

#include "gfx/passes/sheet_renderer.h"
#include "study/motion/telling_moment.h"
#include "tyg/methods.h"
#include "view/body_shapes.h"
#include "view/box.h"
#include "view/camera.h"

namespace tyg {

ScenePictures::ScenePictures(int width, int height) : width_(width), height_(height) {
  for (const BuiltinScene& scene : builtinScenes()) {
    entries_.emplace_back().scene = loadScene(std::string(scene.name), methodNames());
  }
}

bool ScenePictures::finished() const { return finished_; }

bool ScenePictures::due(const Entry& entry, Background background) const {
  if (!entry.trouble.empty()) return false;
  return !entry.simulated || (PictureTexture::possible() && (!entry.picture || entry.drawnOn != background));
}

void ScenePictures::work(double seconds, const Clock& clock, Background background) {
  const double deadline = clock() + seconds;
  for (Entry& entry : entries_) {
    finished_ = false;
    if (!due(entry, background)) continue;
    try {
      if (!entry.simulated) simulate(entry, deadline, clock);
      if (entry.simulated && PictureTexture::possible()) draw(entry, background);
    } catch (const std::exception& error) {
      entry.simulation.reset();
      entry.trouble = error.what();
    }
    if (clock() >= deadline) break;
  }
  finished_ = std::ranges::none_of(entries_, [&](const Entry& entry) { return due(entry, background); });
}

/// Up to the telling moment, or as far as the cloth is worth showing: some scenes fail on purpose.
void ScenePictures::simulate(Entry& entry, double deadline, const Clock& clock) {
  if (!entry.simulation) {
    entry.simulation.emplace(entry.scene, findMethod(entry.scene.integrator), Settings{.threads = 1});
    entry.xyz.resize(static_cast<std::size_t>(3 * entry.simulation->sheet().count()));
    entry.simulation->copyPositions(entry.xyz);
    entry.sheet = entry.simulation->sheet();
  }
  Simulation& simulation = *entry.simulation;
  const double moment = tellingMoment(entry.scene);
  const auto keep = [&] {
    if (simulation.status() != Status::Ok) return;
    simulation.copyPositions(entry.xyz);
    entry.sheet = simulation.sheet();
    entry.time = simulation.time();
  };
  simulation.observe([&] {
    keep();
    return clock() < deadline;
  });
  simulation.advanceTo(moment);
  simulation.observe({});
  keep();
  entry.simulated = simulation.status() != Status::Ok || simulation.time() >= moment * (1 - 1e-9);
  if (entry.simulated) entry.simulation.reset();
}

void ScenePictures::draw(Entry& entry, Background background) {
  if (!entry.picture) entry.picture = std::make_unique<PictureTexture>(width_, height_);
  Camera camera;
  const Box box = boxAround(entry.xyz);
  camera.watch(box);
  std::vector<Body> bodies;
  placeBodies(entry.scene, entry.time, bodies);
  const auto corners = box.corners();
  std::vector<glm::vec3> points(corners.begin(), corners.end());
  addBodyPoints(bodies, box, points);
  camera.frame(points, static_cast<float>(width_) / static_cast<float>(height_));
  if (!programs_) programs_ = std::make_shared<Programs>();
  SheetRenderer renderer(entry.sheet, programs_);
  DrawOptions options;
  options.background = background;
  options.bodies = bodies;
  options.show = entry.scene.look.show;
  followLook(entry.scene, options);
  entry.picture->draw([&] { renderer.draw(entry.xyz, camera, {width_, height_}, options); });
  entry.drawnOn = background;
}

}  // namespace tyg
