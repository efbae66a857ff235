// Family by family, the ends of the sheet's springs become indices into the planes of a state.
#include "integrators/spring_list.h"

namespace tyg {

std::vector<ListedSpring> listSprings(const Scene& scene, const Sheet& sheet) {
  const Layout layout(sheet);
  std::vector<ListedSpring> springs;
  const auto add = [&](const SpringFamily& law, Family family) {
    if (!law.present()) return;
    const double rest = restLength(sheet, family);
    for (const SpringEnds& ends : springsOf(sheet, family)) {
      springs.push_back({layout.at(ends.first), layout.at(ends.second), law.ks, law.kd, rest});
    }
  };
  add(scene.structural, Family::Structural);
  add(scene.shear, Family::Shear);
  add(scene.bend, Family::Bend);
  return springs;
}

}  // namespace tyg
