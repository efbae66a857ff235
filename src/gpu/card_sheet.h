// A sheet on the graphics card: its fields, what acts on it, and one pass over all of its particles at a time.
// Must not know: methods, which are sequences of passes.
#pragma once

#include <array>
#include <functional>
#include <initializer_list>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/forces/forces.h"
#include "core/forces/row_kernel.h"
#include "gpu/card.h"
#include "gpu/card_buffer.h"

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
  AllTerms::Numbers<float> numbers{};    ///< what does not change with time
  std::vector<float> gusts{}, solids{};  ///< of all moments, as kernels/air.glsl and kernels/contact.glsl have them
  struct Moment {
    std::array<float, 3> steadyWind{};  ///< m/s
    int firstGust = 0, endGust = 0, firstSolid = 0, endSolid = 0;
  };
  /// Is shown the positions and the velocities of each evaluation, where somebody wants to see them. That takes longer
  /// than everything else.
  std::function<void(const VectorField<float>& position, const VectorField<float>& velocity)> watch{};
  std::vector<Moment> moments{};  ///< of each evaluation of these steps, in order
};

/// Made, used and destroyed in the card's thread.
class CardSheet {
 public:
  CardSheet(Card& card, const Layout& layout);

  /// The sheet's pins and what of it is gone; the scene's terms.
  void useSheet(const Sheet& sheet, const KernelTerms& terms);
  /// To be called before the passes of some steps.
  void act(const CardActing& acting);

  void write(Field field, const VectorField<float>& from);
  void read(Field field, VectorField<float>& to) const;
  /// The positions, Field::X, as x, y, z of each particle, and into six numbers the least and the largest of each.
  void gather(const CardBuffer& xyz, const CardBuffer& extremes);
  void swap(Field a, Field b) { std::swap(fields_.at(std::size_t(a)), fields_.at(std::size_t(b))); }

  /// The next evaluation of act() and its update, with a step (s) and a kick (s/kg).
  void pass(CardUpdate update, std::initializer_list<InPass> roles, float step, float kick);
  /// The begin of leapfrog's step, which evaluates nothing.
  void beginLeapfrog(std::initializer_list<InPass> roles, float step, float kick);
  /// What each moving pin felt in each evaluation since act(), x, y, z, in order, N.
  [[nodiscard]] std::vector<float> forcesOnPins() const;

 private:
  CardBuffer& field(Field field);
  void writeKinds();
  void writePushes();
  [[nodiscard]] std::string definesOf(CardUpdate update) const;
  void setScene(Kernel& kernel) const;
  void setMoment(Kernel& kernel) const;
  void showTo(std::initializer_list<InPass> roles);
  void run(Kernel& kernel, std::initializer_list<InPass> roles, float step, float kick);

  Card& card_;
  Layout layout_;
  std::array<std::unique_ptr<CardBuffer>, kFields> fields_;
  CardBuffer kinds_, pushes_, pinForces_, gusts_, solids_;
  Sheet sheet_;
  KernelTerms terms_;
  CardActing acting_;
  VectorField<float> watchedPosition_, watchedVelocity_;
  std::vector<int> movingPins_;  // that kinds_ has
  std::size_t evaluation_ = 0;   // of acting_.moments: the next one
};

}  // namespace tyg
