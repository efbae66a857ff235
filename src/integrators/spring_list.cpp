// Lists springs family by family, so that a family is one run of the list and can be given other numbers there.
#include "integrators/spring_list.h"

#include <algorithm>

#include "core/forces/terms/springs.h"

namespace tyg {

std::vector<ListedSpring> listSprings(const Scene& scene, const Sheet& sheet) {
  const Layout layout(sheet);
  std::vector<ListedSpring> springs;
  for (const Family family : kFamilies) {
    const SpringFamily& law = familyOf(scene, family);
    if (!law.present()) continue;
    const double rest = restLength(sheet, family);
    for (const SpringEnds& ends : springsOf(sheet, family)) {
      springs.push_back({layout.at(ends.first), layout.at(ends.second), law.ks, law.kd, rest});
    }
  }
  return springs;
}

void relistSprings(std::vector<ListedSpring>& springs, const Scene& before, const Scene& now, const Sheet& sheet) {
  const auto stays = [&](Family family) {
    return familyOf(before, family).present() == familyOf(now, family).present();
  };
  if (!std::ranges::all_of(kFamilies, stays)) {
    springs = listSprings(now, sheet);
    return;
  }
  auto spring = springs.begin();
  for (const Family family : kFamilies) {
    const SpringFamily& law = familyOf(now, family);
    if (!law.present()) continue;
    for (long long k = springCount(sheet, family); k > 0; --k, ++spring) spring->ks = law.ks, spring->kd = law.kd;
  }
}

}  // namespace tyg
