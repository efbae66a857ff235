// The table of force terms, made of the list of their types, and what follows from their parameters alone.
#include "core/forces/term.h"

#include <algorithm>
#include <array>

#include "core/forces/terms/all_terms.h"

namespace tyg {
namespace {

template <class... Term>
constexpr std::array<const ForceTerm*, sizeof...(Term)> tableOf(TermList<Term...> /*terms*/) {
  return {&Term::kTerm...};
}
constexpr std::array kTerms = tableOf(AllTerms{});

void clear(Scene& scene, const ForceTerm& term, auto&& chosen) {
  for (const Parameter& parameter : term.parameters) {
    if (chosen(parameter)) parameter.set(scene, {});
  }
}

bool damps(const Parameter& parameter) { return parameter.role == Role::Damping; }

}  // namespace

std::span<const ForceTerm* const> forceTerms() { return kTerms; }

std::span<const EnergyStore> energyStores() { return std::span(kStores.list).first(kStores.count); }

bool storesIn(const Scene& scene, std::size_t k) {
  bool stores = kStores.list[k].isInEvery;
  AllTerms::forEach([&]<class Term>() {
    if constexpr (requires { Term::kStore; }) {
      stores = stores || (kStores.indexOf(Term::kStore) == k && hasTerm(scene, Term::kTerm));
    }
  });
  return stores;
}

bool hasTerm(const Scene& scene, const ForceTerm& term) {
  return std::ranges::any_of(term.parameters, [&](const Parameter& parameter) {
    return parameter.decidesPresence && parameter.get(scene) != Vec3{};
  });
}

void leaveOut(Scene& scene, const ForceTerm& term) {
  clear(scene, term, [](const Parameter& parameter) { return parameter.decidesPresence; });
}

double particleDamping(const Scene& scene) {
  double sum = 0;
  for (const ForceTerm* term : forceTerms()) {
    if (term->particleDamping != nullptr) sum += term->particleDamping(scene);
  }
  return sum;
}

double cellDamping(const Scene& scene) {
  double sum = 0;
  for (const ForceTerm* term : forceTerms()) {
    if (term->cellDamping != nullptr) sum += term->cellDamping(scene);
  }
  return sum;
}

const ForceTerm* cellDampingTerm(const Scene& scene) {
  const auto found = std::ranges::find_if(
      kTerms, [&](const ForceTerm* term) { return term->cellDamping != nullptr && hasTerm(scene, *term); });
  return found == kTerms.end() ? nullptr : *found;
}

HoldingTerm holdingTerm(const Scene& scene) {
  for (const ForceTerm* term : forceTerms()) {
    if (term->hold != nullptr && hasTerm(scene, *term)) return {term, term->hold(scene)};
  }
  return {};
}

bool canSupply(const Scene& scene, std::size_t k) {
  std::size_t supply = 0;
  bool can = false;
  AllTerms::forEach([&]<class Term>() {
    if constexpr (requires { Term::kSupply; }) can = can || (supply++ == k && Term::kTerm.canSupply(scene));
  });
  return can;
}

Vec3 steadyForce(const Scene& scene) {
  Vec3 sum;
  for (const ForceTerm* term : forceTerms()) {
    if (term->steadyForce == nullptr) continue;
    const Vec3 force = term->steadyForce(scene);
    sum = {sum.x + force.x, sum.y + force.y, sum.z + force.z};
  }
  return sum;
}

bool isDamped(const Scene& scene) {
  return std::ranges::any_of(valuesOf(scene, Role::Damping), [](const Vec3& value) { return value != Vec3{}; });
}

Scene withoutDamping(Scene scene) { return withoutSpringDamping(withoutParticleDamping(std::move(scene))); }

Scene withoutSpringDamping(Scene scene) {
  for (const ForceTerm* term : forceTerms()) {
    if (term->family) clear(scene, *term, damps);
  }
  return scene;
}

Scene withoutParticleDamping(Scene scene) {
  for (const ForceTerm* term : forceTerms()) {
    if (!term->family) clear(scene, *term, damps);
  }
  return scene;
}

Scene withoutSteadyForce(Scene scene) {
  for (const ForceTerm* term : forceTerms()) {
    if (term->steadyForce != nullptr) leaveOut(scene, *term);
  }
  return scene;
}

}  // namespace tyg
