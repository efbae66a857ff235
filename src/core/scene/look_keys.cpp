// Whether a picture can be opened is not asked here: a run or a log does without it.
#include "core/scene/look_keys.h"

#include <array>
#include <filesystem>

#include "util/file_names.h"

namespace tyg {

std::string_view nameOf(Show show) {
  constexpr std::array<std::string_view, 3> kNames{"lines", "surface", "both"};
  return kNames.at(std::size_t(show));
}

std::string_view nameOf(Weave weave) {
  constexpr std::array<std::string_view, 3> kNames{"none", "plain", "checker"};
  return kNames.at(std::size_t(weave));
}

Look readLook(SceneTable table, const std::string& sceneFile) {
  Look look;
  table.choice("show", look.show, {"lines", "surface", "both"});
  Vec3 colour;
  table.colour("colour", colour);
  if (table.has("colour")) look.colour = colour;
  table.choice("weave", look.weave, {"none", "plain", "checker"});
  std::string image;
  table.text("image", image);
  table.finish();
  if (!table.has("image")) return look;
  if (table.has("weave")) table.refuse("image", "an image and a weave", "one of them");
  const std::string ending = endingOf(image);
  if (ending != ".png" && ending != ".jpg" && ending != ".jpeg") {
    table.refuse("image", '"' + image + '"', "the name of a PNG or JPEG file beside the scene file");
  }
  // Absolute, so that a scene that is written somewhere else still finds it.
  const std::filesystem::path folder = std::filesystem::path(sceneFile).parent_path();
  look.image = (std::filesystem::current_path() / folder / image).lexically_normal().string();
  return look;
}

Lamp readLamp(SceneTable table) {
  Lamp lamp;
  Vec3 at;
  table.vector("direction", lamp.direction);
  table.vector("at", at);
  table.colour("colour", lamp.colour);
  table.finish();
  if (table.has("direction") == table.has("at")) {
    table.refuse(table.has("at") ? "at" : "direction",
                 table.has("at") ? "both direction and at" : "neither direction nor at", "exactly one of them");
  }
  if (table.has("at")) lamp.at = at;
  if (lamp.direction == Vec3{}) table.refuse("direction", "[0, 0, 0]", "the direction in which the light goes");
  return lamp;
}

}  // namespace tyg
