// A sheet on the graphics card: its fields, what acts on it, and one pass over all of its particles at a time.
// Must not know: methods, which are sequences of passes.
#pragma once

#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/forces/forces.h"
#include "core/forces/row_kernel.h"
#include "core/simulation/device_state.h"
#include "gpu/card.h"
#include "gpu/card_buffer.h"
#include "gpu/card_moments.h"

namespace tyg {

/// What is kept of every particle. Methods use the numbered ones in turns.
enum class Field { X, V, X2, V2, X3, V3, Force, SumV };
constexpr std::size_t kFields = 8;

/// What a pass makes of the forces; the numbers are those of UPDATE in kernels/step.glsl.
enum class CardUpdate { Force, KickAndDrift, Leapfrog, LastKick, FirstStage, InnerStage, LastStage };

/// Which of the bindings of kernels/step.glsl a field has in a pass.
enum class PassRole : unsigned {
  Position = 0,
  Velocity = 1,
  NextPosition = 3,
  NextVelocity,
  OwnPosition,
  OwnVelocity,
  Force,
  SumV
};
struct InPass {
  PassRole role;
  Field field;
};

/// What of a scene decides which kernels there are.
struct KernelTerms {
  bool structural = false, shear = false, bend = false;
  int damping = 0;  ///< 0: none, 1: relative, 2: axial
  bool air = false, contact = false, cut = false;
};

/// What acts on the sheet during some steps, as the processor's forces have it.
struct CardActing {
  std::span<const PushedParticle<float>> pushes;
  std::span<const int> movingPins;
  CardMoments<float> moments{};  ///< of each evaluation of these steps
  /// Called after the pass of each evaluation, where there is something to call, while programs still see the positions
  /// and velocities that the forces were evaluated at.
  std::function<void(std::size_t evaluation)> afterPass{};
};

/// Made, used and destroyed in the card's thread.
class CardSheet {
 public:
  CardSheet(Card& card, const Layout& layout);

  /// The sheet's pins and what of it is gone; the scene's terms.
  void useSheet(const Sheet& sheet, const KernelTerms& terms);
  /// To be called before the passes of some steps.
  void act(CardActing acting);

  void write(Field field, const VectorField<float>& from);
  void read(Field field, VectorField<float>& to) const;
  [[nodiscard]] ParticleState particle(int index);
  void place(int index, const ParticleState& particle);
  /// Lets programs see the positions and velocities of the state, and which particles are pinned.
  void showState() const;
  /// Runs a program in use in as many work groups along the columns and the rows; without them, with a thread for each
  /// particle.
  void dispatch(Kernel& kernel) const;
  void dispatch(Kernel& kernel, int groupsAcross, int groupsDown) const;
  /// The positions, Field::X, as x, y, z of each particle, and into six numbers the least and the largest of each.
  void gather(const CardBuffer& xyz, const CardBuffer& extremes);
  void swap(Field a, Field b) { std::swap(fields_.at(std::size_t(a)), fields_.at(std::size_t(b))); }

  /// The next evaluation of act() and its update, with a step (s) and a kick (s/kg).
  void pass(CardUpdate update, std::initializer_list<InPass> roles, float step, float kick);
  /// The begin of leapfrog's step, which evaluates nothing.
  void beginLeapfrog(std::initializer_list<InPass> roles, float step, float kick);
  /// What each moving pin felt in each evaluation since act(), x, y, z, in order, N.
  [[nodiscard]] std::vector<float> forcesOnPins() const;

  [[nodiscard]] const Sheet& sheet() const { return sheet_; }
  [[nodiscard]] const KernelTerms& terms() const { return terms_; }

 private:
  CardBuffer& field(Field field);
  [[nodiscard]] std::size_t byteOf(int particle, int axis) const;
  void writeKinds();
  void writePushes();
  [[nodiscard]] std::string definesOf(CardUpdate update) const;
  void setScene(Kernel& kernel) const;
  void run(Kernel& kernel, std::initializer_list<InPass> roles, float step, float kick);

  Card& card_;
  Layout layout_;
  std::array<std::unique_ptr<CardBuffer>, kFields> fields_;
  CardBuffer kinds_, pushes_, pinForces_;
  CardBuffer one_;  // particle, on its way back
  MomentsOnCard<float> moments_;
  Sheet sheet_;
  KernelTerms terms_;
  CardActing acting_;
  std::vector<int> movingPins_;  // that kinds_ has
  std::size_t evaluation_ = 0;   // of the moments: the next one
};

}  // namespace tyg
