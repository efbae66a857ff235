// The table of methods: of each a declaration and an entry.
#include <array>
#include <string>
#include <vector>

#include "core/simulation/integrator.h"
#include "tyg/methods.h"
#include "util/suggestion.h"
#include "util/text.h"

namespace tyg {

// Each is defined at the end of its method's file.
Method explicitEulerMethod();
Method symplecticEulerMethod();
Method reportRk4Method();
Method leapfrogMethod();
Method rk4Method();
Method bs32Method();
Method dopri54Method();
Method rkc2Method();
Method imexMethod();
Method backwardEulerMethod();
Method xpbdMethod();

std::span<const Method> methods() {
  static const std::array kMethods = {
      explicitEulerMethod(), symplecticEulerMethod(), reportRk4Method(), leapfrogMethod(), rk4Method(),
      bs32Method(),          dopri54Method(),         rkc2Method(),      imexMethod(),     backwardEulerMethod(),
      xpbdMethod(),
  };
  return kMethods;
}

std::span<const std::string_view> methodNames() {
  static const std::vector<std::string_view> kNames = [] {
    std::vector<std::string_view> names;
    for (const Method& method : methods()) names.push_back(method.name);
    return names;
  }();
  return kNames;
}

const Method& findMethod(std::string_view name, std::string_view key) {
  for (const Method& method : methods()) {
    if (method.name == name) return method;
  }
  throw InputError(std::string(key) + ": found \"" + std::string(name) + "\", allowed: " + joined(methodNames()) +
                   didYouMean(name, methodNames()));
}

void refuseUnfit(const Method& method, const Scene& scene) { (void)method.makeDouble(scene, makeSheet(scene)); }

bool takes(const Method& method, const Scene& scene) {
  try {
    refuseUnfit(method, scene);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

}  // namespace tyg
