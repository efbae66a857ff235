// What the card keeps from step to step is its own until somebody wants a copy of the integrator: only then is the kept
// force copied back.
#include "gpu/card_integrator.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <type_traits>
#include <utility>

#include "gpu/card_measure.h"
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

/// A sheet on the card and what measures it, destroyed in the card's thread.
class OwnedSheet {
 public:
  OwnedSheet(std::shared_ptr<Card> card, const Layout& layout) : card_(std::move(card)) {
    card_->run([&] {
      sheet_ = std::make_unique<CardSheet>(*card_, layout);
      measure_ = std::make_unique<CardMeasure>(*card_, *sheet_);
    });
  }
  ~OwnedSheet() {
    card_->run([&] { measure_.reset(), sheet_.reset(); });
  }
  OwnedSheet(const OwnedSheet&) = delete;
  OwnedSheet& operator=(const OwnedSheet&) = delete;

  [[nodiscard]] CardSheet& sheet() const { return *sheet_; }
  [[nodiscard]] CardMeasure& measure() const { return *measure_; }

 private:
  std::shared_ptr<Card> card_;
  std::unique_ptr<CardSheet> sheet_;
  std::unique_ptr<CardMeasure> measure_;
};

class CardIntegrator final : public Integrator<float>, public DeviceState<float> {
 public:
  CardIntegrator(std::shared_ptr<Card> card, const Scheme& scheme, const Scene& scene, const Sheet& sheet)
      : card_(std::move(card)), scheme_(&scheme), sheet_(sheet), terms_(termsOf(scene, sheet)), layout_(sheet) {}

  void step(Forces<float>& forces, State<float>& state, double t, double h) override {
    steps(forces, state, {t, 0, h}, 1);
  }
  void steps(Forces<float>& forces, State<float>& state, const StepTimes& times, int count) override;
  void fetch(State<float>& state) override;
  DeviceState<float>* onDevice(const State<float>& state) override {
    bringToCard(state);
    return this;
  }
  void reset() override { hasForce_ = false; }
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

  [[nodiscard]] ParticleState particle(int index) override;
  void place(int index, const ParticleState& particle) override;
  [[nodiscard]] StoredEnergy energy(const Forces<float>& forces, double time) override;
  [[nodiscard]] Power power(const Forces<float>& forces, double time) override;
  [[nodiscard]] Largest largest() override;
  [[nodiscard]] std::shared_ptr<const DevicePositions> positions() override;

 private:
  void bringToCard(const State<float>& state);
  /// What is found in the state on the card, in its thread.
  template <class Ask>
  auto asked(const Ask& ask);
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

/// At these times, as the terms themselves work it out: in float for forces, in double for energies and powers.
template <class T>
CardMoments<T> momentsOf(const Forces<float>& forces, const std::vector<double>& times) {
  CardMoments<T> moments;
  for (const double time : times) {
    if constexpr (std::is_same_v<T, float>) {
      moments.add(forces.numbersAt(time));
    } else {
      moments.add(forces.energyNumbersAt(time));
    }
  }
  return moments;
}

void CardIntegrator::bringToCard(const State<float>& state) {
  if (!onCard_) onCard_ = std::make_unique<OwnedSheet>(card_, layout_);
  if (sheetIsOnCard_ && stateIsOnCard_) return;
  card_->run([&] {
    CardSheet& sheet = onCard_->sheet();
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
  card_->run([&] { onCard_->sheet().read(Field::X, state.position), onCard_->sheet().read(Field::V, state.velocity); });
}

template <class Ask>
auto CardIntegrator::asked(const Ask& ask) {
  decltype(ask(onCard_->sheet(), onCard_->measure())) found;
  card_->run([&] {
    onCard_->sheet().showState();
    found = ask(onCard_->sheet(), onCard_->measure());
    card_->refuseErrors();
  });
  return found;
}

ParticleState CardIntegrator::particle(int index) {
  return asked([&](CardSheet& sheet, CardMeasure& /*measure*/) { return sheet.particle(index); });
}

void CardIntegrator::place(int index, const ParticleState& particle) {
  card_->run([&] {
    onCard_->sheet().place(index, particle);
    card_->refuseErrors();
  });
}

StoredEnergy CardIntegrator::energy(const Forces<float>& forces, double time) {
  return asked([&](CardSheet& /*sheet*/, CardMeasure& measure) {
    measure.use(momentsOf<double>(forces, {time}));
    return measure.energy();
  });
}

Power CardIntegrator::power(const Forces<float>& forces, double time) {
  if (!forces.hasPower()) return {};
  return asked([&](CardSheet& /*sheet*/, CardMeasure& measure) {
    measure.use(momentsOf<double>(forces, {time}));
    measure.beginPower(0);
    return measure.powers().front();
  });
}

CardIntegrator::Largest CardIntegrator::largest() {
  return asked([](CardSheet& /*sheet*/, CardMeasure& measure) { return measure.largest(); });
}

std::shared_ptr<const DevicePositions> CardIntegrator::positions() {
  if (!card_->draws()) return nullptr;
  return std::make_shared<const CardPositions>(card_, onCard_->sheet(), layout_.columns * layout_.rows);
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
  CardActing acting{
      .pushes = forces.pushes(), .movingPins = forces.movingPins(), .moments = momentsOf<float>(forces, evaluated)};
  const bool addsUpPower = forces.tracksDissipation() && forces.hasPower();
  if (addsUpPower) acting.afterPass = [&](std::size_t evaluation) { onCard_->measure().beginPower(evaluation); };
  std::vector<Power> powers(evaluated.size(), forces.tracksDissipation() ? Power{} : forces.power());
  std::vector<float> felt;
  card_->run([&] {
    CardSheet& sheet = onCard_->sheet();
    if (addsUpPower) onCard_->measure().use(momentsOf<double>(forces, evaluated));
    sheet.act(std::move(acting));
    scheme_->run(sheet, times.h, forces.inverseMass(), count, hadForce);
    if (addsUpPower) powers = onCard_->measure().powers();
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
    card_->run([&] { onCard_->sheet().read(Field::Force, copy->kept_); });
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
