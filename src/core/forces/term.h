// The force terms as everything but the row kernels sees them: names, parameters, and what they do to limits.
// Must not know: how forces are computed.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "core/forces/parameter.h"
#include "core/forces/terms/term_list.h"
#include "tyg/sheet.h"

namespace tyg {

/// What a term does to a single particle at most, whatever the springs do.
struct ParticleHold {
  double stiffness = 0;  ///< N/m, in one direction
  double damping = 0;    ///< N s/m, in that direction
  double across = 0;     ///< N s/m, in the other ones
  int times = 0;         ///< how often at once, as by several bodies
};

/// One term of the force. A scene has it where one of the parameters that decide so is not 0.
struct ForceTerm {
  std::string_view name;  ///< as people read it
  std::span<const Parameter> parameters;
  std::optional<Family> family{};  ///< of springs; else nothing
  bool mayBeLeftOut = true;        ///< is a leaner model of the same cloth thinkable without it?
  /// N s/m by which it resists every motion of a particle alike; null: not at all.
  double (*particleDamping)(const Scene& scene) = nullptr;
  /// N s/m by which it resists the motion of a cell along its normal, at most; null: not at all.
  double (*cellDamping)(const Scene& scene) = nullptr;
  /// Whether it can bring energy to the cloth by itself; null: never.
  bool (*canSupply)(const Scene& scene) = nullptr;
  /// N by which it pulls every particle alike, wherever that is; null: not at all.
  Vec3 (*steadyForce)(const Scene& scene) = nullptr;
  /// How it holds single particles where they are; null: not at all.
  ParticleHold (*hold)(const Scene& scene) = nullptr;
};

/// All terms, in the order of a scene file.
std::span<const ForceTerm* const> forceTerms();

/// What the terms store energy in.
std::span<const EnergyStore> energyStores();

/// Whether the k-th of energyStores() is spoken of in a scene.
bool storesIn(const Scene& scene, std::size_t k);

bool hasTerm(const Scene& scene, const ForceTerm& term);
void leaveOut(Scene& scene, const ForceTerm& term);

/// N s/m by which all terms together resist every motion of a particle alike.
double particleDamping(const Scene& scene);
/// N s/m by which all terms together resist the motion of a cell along its normal, at most.
double cellDamping(const Scene& scene);
/// The first term of the scene that resists the motion of cells; null where there is none.
const ForceTerm* cellDampingTerm(const Scene& scene);
/// The term of the scene that holds single particles, if any, and how.
struct HoldingTerm {
  const ForceTerm* term = nullptr;  ///< null: none, and all is 0
  ParticleHold hold;
};
HoldingTerm holdingTerm(const Scene& scene);
/// Whether the k-th of kSupplies can bring energy to the cloth.
bool canSupply(const Scene& scene, std::size_t k);
/// N by which all terms together pull every particle alike.
Vec3 steadyForce(const Scene& scene);
/// Does the scene have any damping, of springs or of particles?
bool isDamped(const Scene& scene);
Scene withoutDamping(Scene scene);
Scene withoutSpringDamping(Scene scene);
Scene withoutParticleDamping(Scene scene);
Scene withoutSteadyForce(Scene scene);

}  // namespace tyg
