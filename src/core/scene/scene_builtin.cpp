// The order in which people meet the built-in scenes.
// Must not know: what is in them.
#include <algorithm>
#include <tuple>
#include <vector>

#include "core/scene/embedded_scenes.h"

namespace tyg {
namespace {

std::vector<BuiltinScene> inOrder() {
  const std::span<const BuiltinScene> embedded = embeddedScenes();
  std::vector<BuiltinScene> scenes(embedded.begin(), embedded.end());
  const auto place = [](const BuiltinScene& scene) {
    return std::tuple(showsFailure(scene), scene.name != "curtain", scene.name);
  };
  const auto earlier = [&](const BuiltinScene& a, const BuiltinScene& b) { return place(a) < place(b); };
  std::sort(scenes.begin(), scenes.end(), earlier);
  return scenes;
}

}  // namespace

std::span<const BuiltinScene> builtinScenes() {
  static const std::vector<BuiltinScene> kScenes = inOrder();
  return kScenes;
}

}  // namespace tyg
