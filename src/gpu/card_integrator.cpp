// What the card keeps from step to step is its own until somebody wants a copy of the integrator: only then is the kept
// force copied back.
#include "gpu/card_integrator.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "gpu/card_positions.h"
#include "tyg/input_error.h"
#include "util/text.h"

namespace tyg {
namespace {

KernelTerms termsOf(const Scene& scene, const Sheet& sheet) {
  const bool damped = scene.structural.kd > 0 || scene.shear.kd > 0 || scene.bend.kd > 0;
  return {.structural = scene.structural.present(),
          .shear = scene.shear.present(),
          .bend = scene.bend.present(),
          .damping = !damped                              ? 0
                     : scene.damping == Damping::Relative ? 1
                                                          : 2,
          .air = hasTerm(scene, AirTerm::kTerm),
          .contact = hasTerm(scene, ContactTerm::kTerm) && !scene.bodies.empty(),
          .cut = !sheet.missing.none()};
}

/// The state of the sheet on the card, destroyed in the card's thread.
class OwnedSheet {
 public:
  OwnedSheet(std::shared_ptr<Card> card, const Layout& layout) : card_(std::move(card)) {
    card_->run([&] { sheet_ = std::make_unique<CardSheet>(*card_, layout); });
  }
  ~OwnedSheet() {
    card_->run([&] { sheet_.reset(); });
  }
  OwnedSheet(const OwnedSheet&) = delete;
  OwnedSheet& operator=(const OwnedSheet&) = delete;

  [[nodiscard]] CardSheet& operator*() const { return *sheet_; }

 private:
  std::shared_ptr<Card> card_;
  std::unique_ptr<CardSheet> sheet_;
};

class CardIntegrator final : public Integrator<float> {
 public:
  CardIntegrator(std::shared_ptr<Card> card, const Scheme& scheme, const Scene& scene, const Sheet& sheet)
      : card_(std::move(card)), scheme_(&scheme), sheet_(sheet), terms_(termsOf(scene, sheet)), layout_(sheet) {}

  void step(Forces<float>& forces, State<float>& state, double t, double h) override {
    steps(forces, state, {t, 0, h}, 1);
  }
  void steps(Forces<float>& forces, State<float>& state, const StepTimes& times, int count) override;
  void fetch(State<float>& state) override;
  std::shared_ptr<const DevicePositions> positionsOnDevice(const State<float>& state) override;
  /// Whoever has changed the state has fetched it first.
  void reset() override {
    hasForce_ = false;
    if (stateIsHere_) stateIsOnCard_ = false;
  }
  void useParameters(const Scene& scene, const Sheet& sheet) override {
    refuseOnCard(*card_, scene, sheet);
    sheet_ = sheet, terms_ = termsOf(scene, sheet);
    sheetIsOnCard_ = false;
    reset();
  }
  [[nodiscard]] std::unique_ptr<Integrator<float>> clone() const override;
  [[nodiscard]] std::size_t bytes() const override {
    return hasForce_ ? 3 * sizeof(float) * std::size_t(layout_.plane) : 0;
  }

 private:
  [[nodiscard]] static CardActing actingOn(const Forces<float>& forces, const std::vector<double>& times);
  void bringToCard(const State<float>& state);
  static void addPowerOfPins(const Forces<float>& forces, const State<float>& state, const std::vector<float>& felt,
                             std::vector<Power>& powers);

  std::shared_ptr<Card> card_;
  const Scheme* scheme_;
  Sheet sheet_;
  KernelTerms terms_;
  Layout layout_;
  std::unique_ptr<OwnedSheet> onCard_;  // null: nothing of this integrator is there yet
  bool sheetIsOnCard_ = false, stateIsOnCard_ = false;
  bool stateIsHere_ = true;    // as well
  bool hasForce_ = false;      // the last step has kept one
  VectorField<float> kept_{};  // that force, where this is a copy that has not been used
};

/// How many numbers of a gust and of a body kernels/air.glsl and kernels/contact.glsl expect.
constexpr std::size_t kGustSize = 7, kSolidSize = 12;

template <std::size_t count>
void add(const float (&from)[count], std::vector<float>& to) {
  to.insert(to.end(), std::begin(from), std::end(from));
}

void addGusts(const AirTerm::Numbers<float>& air, CardActing& acting, CardActing::Moment& moment) {
  std::ranges::copy(air.steady, moment.steadyWind.begin());
  moment.firstGust = int(acting.gusts.size() / kGustSize);
  for (const AirTerm::Gusts<float>* gusts = air.firstGusts; gusts != air.endGusts; ++gusts) {
    add(gusts->amplitude, acting.gusts), add(gusts->wave, acting.gusts);
    acting.gusts.push_back(gusts->phase);
  }
  moment.endGust = int(acting.gusts.size() / kGustSize);
}

void addSolids(const ContactTerm::Numbers<float>& contact, CardActing& acting, CardActing::Moment& moment) {
  moment.firstSolid = int(acting.solids.size() / kSolidSize);
  for (const ContactTerm::Solid<float>* solid = contact.firstSolid; solid != contact.endSolid; ++solid) {
    acting.solids.push_back(float(int(solid->shape)));
    add(solid->at, acting.solids), add(solid->axis, acting.solids);
    acting.solids.push_back(solid->perSquare), acting.solids.push_back(solid->radius);
    add(solid->velocity, acting.solids);
  }
  moment.endSolid = int(acting.solids.size() / kSolidSize);
}

/// The moments of all evaluations, worked out by the terms themselves.
CardActing CardIntegrator::actingOn(const Forces<float>& forces, const std::vector<double>& times) {
  CardActing acting{.pushes = forces.pushes(), .movingPins = forces.movingPins()};
  for (const double time : times) {
    acting.numbers = forces.numbersAt(time);
    CardActing::Moment& moment = acting.moments.emplace_back();
    addGusts(acting.numbers, acting, moment);
    addSolids(acting.numbers, acting, moment);
  }
  return acting;
}

void CardIntegrator::bringToCard(const State<float>& state) {
  if (!onCard_) onCard_ = std::make_unique<OwnedSheet>(card_, layout_);
  if (sheetIsOnCard_ && stateIsOnCard_) return;
  card_->run([&] {
    CardSheet& sheet = **onCard_;
    if (!sheetIsOnCard_) sheet.useSheet(sheet_, terms_);
    if (stateIsOnCard_) return;
    sheet.write(Field::X, state.position), sheet.write(Field::V, state.velocity);
    if (hasForce_) sheet.write(Field::Force, kept_);
    kept_ = {};
  });
  sheetIsOnCard_ = stateIsOnCard_ = true;
}

void CardIntegrator::fetch(State<float>& state) {
  if (std::exchange(stateIsHere_, true)) return;
  card_->run([&] { (**onCard_).read(Field::X, state.position), (**onCard_).read(Field::V, state.velocity); });
}

std::shared_ptr<const DevicePositions> CardIntegrator::positionsOnDevice(const State<float>& state) {
  if (!card_->draws()) return nullptr;
  bringToCard(state);
  return std::make_shared<const CardPositions>(card_, **onCard_, layout_.columns * layout_.rows);
}

/// As Forces has it: minus every force on a moving pin times its velocity, which no step changes: it is here.
void CardIntegrator::addPowerOfPins(const Forces<float>& forces, const State<float>& state,
                                    const std::vector<float>& felt, std::vector<Power>& powers) {
  auto f = felt.begin();
  for (Power& power : powers) {
    power.pins = 0;
    for (const int pin : forces.movingPins()) {
      const Vec3 v = state.velocity.get(pin), force{f[0], f[1], f[2]};
      power.pins -= force.x * v.x + force.y * v.y + force.z * v.z;
      f += 3;
    }
  }
}

void CardIntegrator::steps(Forces<float>& forces, State<float>& state, const StepTimes& times, int count) {
  bringToCard(state);
  const bool hadForce = hasForce_;
  const std::vector<double> evaluated = scheme_->times(times, count, hadForce);
  CardActing acting = actingOn(forces, evaluated);
  std::vector<Power> powers(evaluated.size(), forces.power());
  if (forces.tracksDissipation()) {
    acting.watch = [&, k = std::size_t{0}](const auto& position, const auto& velocity) mutable {
      powers.at(k) = forces.powerOf(evaluated.at(k), position, velocity);
      ++k;
    };
  }
  std::vector<float> felt;
  card_->run([&] {
    CardSheet& sheet = **onCard_;
    sheet.act(acting);
    scheme_->run(sheet, times.h, forces.inverseMass(), count, hadForce);
    felt = sheet.forcesOnPins();
    card_->gl().Finish();  // whoever measures steps, to plan a frame or to give advice, measures the card's work
    card_->refuseErrors();
  });
  stateIsHere_ = false;
  hasForce_ = scheme_->keepsForce;
  addPowerOfPins(forces, state, felt, powers);
  scheme_->account(forces, powers, times.h, hadForce);
}

std::unique_ptr<Integrator<float>> CardIntegrator::clone() const {
  auto copy = std::make_unique<CardIntegrator>(card_, *scheme_, Scene{}, sheet_);
  copy->terms_ = terms_;
  copy->hasForce_ = hasForce_;
  copy->kept_ = kept_;
  if (hasForce_ && stateIsOnCard_) {
    copy->kept_ = VectorField<float>(layout_);
    card_->run([&] { (**onCard_).read(Field::Force, copy->kept_); });
  }
  return copy;
}

}  // namespace

void refuseTermsWithoutKernel(const Scene& scene, std::span<const ForceTerm* const> terms) {
  constexpr std::array<std::string_view, 7> kKernels{"structural", "shear", "bend",   "gravity",
                                                     "drag",       "air",   "contact"};
  for (const ForceTerm* term : terms) {
    if (!hasTerm(scene, *term) || std::ranges::find(kKernels, term->name) != kKernels.end()) continue;
    throw InputError(fmt::format("device: found a scene with {}, allowed on the graphics card are {}", term->name,
                                 joined(kKernels)));
  }
}

void refuseOnCard(const Card& card, const Scene& scene, const Sheet& sheet) {
  refuseTermsWithoutKernel(scene, forceTerms());
  const std::size_t bytes = 3 * sizeof(float) * std::size_t(Layout(sheet).plane);
  if (bytes > card.largestBuffer()) {
    throw InputError(fmt::format(
        "sheet: found {} x {} particles, whose positions take {} MB; allowed on this graphics card are {} MB",
        sheet.columns, sheet.rows, bytes >> 20, card.largestBuffer() >> 20));
  }
}

std::unique_ptr<Integrator<float>> makeCardIntegrator(std::shared_ptr<Card> card, const Scheme& scheme,
                                                      const Scene& scene, const Sheet& sheet) {
  refuseOnCard(*card, scene, sheet);
  return std::make_unique<CardIntegrator>(std::move(card), scheme, scene, sheet);
}

}  // namespace tyg
