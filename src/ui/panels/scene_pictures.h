// Small pictures of scenes at a telling moment, made a little at a time so that a window beside them stays smooth.
// Must not know: how they are laid out.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gfx/passes/programs.h"
#include "gfx/picture_texture.h"
#include "tyg/simulation.h"
#include "view/draw_options.h"

namespace tyg {

class ScenePictures {
 public:
  using Clock = std::function<double()>;  ///< s, from any start

  /// Of the built-in scenes; `width` x `height` pixels each.
  ScenePictures(int width, int height);

  /// Goes on making them for about `seconds`, on this ground. Where no OpenGL is loaded scenes are simulated, not
  /// drawn.
  void work(double seconds, const Clock& clock, Background background);
  [[nodiscard]] bool finished() const;

  /// One of the built-in scenes, in their order.
  struct Entry {
    Scene scene;
    std::vector<float> xyz;                   ///< m, the last good moment so far
    Sheet sheet;                              ///< then, with what was cut
    double time = 0;                          ///< of it, s
    std::optional<Simulation> simulation;     ///< under way
    std::unique_ptr<PictureTexture> picture;  ///< null before it is made
    Background drawnOn = Background::Dark;
    bool simulated = false;
    std::string trouble;  ///< why there is no picture
  };
  [[nodiscard]] std::span<const Entry> entries() const { return entries_; }

 private:
  [[nodiscard]] bool due(const Entry& entry, Background background) const;
  static void simulate(Entry& entry, double deadline, const Clock& clock);
  void draw(Entry& entry, Background background);

  int width_, height_;
  std::vector<Entry> entries_;
  std::shared_ptr<Programs> programs_;  ///< of all pictures
  bool finished_ = false;
};

}  // namespace tyg
