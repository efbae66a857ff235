// The card gives the processor's bits: the stored hashes, and the same run whatever is done to the cloth.
#include <gtest/gtest.h>

#include "card_here.h"
#include "golden_hashes.h"
#include "gpu/same_bits.h"
#include "tyg/input_error.h"

namespace tyg {
namespace {

bool cardTakes(const Settings& settings, const Scene& scene, const Method& method) {
  try {
    const Simulation simulation(inFloat(scene), method, settings);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

class GoldenHashesOnCard : public OnCard, public testing::WithParamInterface<std::string_view> {};

TEST_P(GoldenHashesOnCard, HoldForEverySceneThatItTakes) {
  const std::map<std::string, std::string> golden = goldenHashes();
  const Method& method = findMethod(GetParam());
  int compared = 0;
  for (const BuiltinScene& builtin : builtinScenes()) {
    const Scene scene = loadScene(std::string(builtin.name));
    const std::string key = scene.name + " " + std::string(method.name) + " float";
    if (!golden.contains(key) || !cardTakes(onCard(), scene, method)) continue;
    EXPECT_EQ(hashAfter(scene, method, Precision::Float, onCard()), golden.at(key)) << key;
    ++compared;
  }
  constexpr int kFewest = 15;
  EXPECT_GT(compared, kFewest);
}

INSTANTIATE_TEST_SUITE_P(Methods, GoldenHashesOnCard, testing::Values("symplectic-euler", "leapfrog", "rk4"),
                         [](const auto& method) {
                           std::string name(method.param);
                           std::erase(name, '-');
                           return name;
                         });

/// All that acts on a cloth without making it another sheet.
Scene busyScene(int columns, int rows) {
  Scene scene = inFloat(withSheet(loadScene("poke"), columns, rows));
  scene.drag = 0.01;
  scene.pushes.front().at = 0.01, scene.pushes.front().duration = 0.02;
  scene.duration = 0.1;
  return scene;
}

class SameBits : public OnCard {
 protected:
  void expectSame(const Scene& scene, const Method& method, double time = 0.05) {
    Simulation there(scene, method, onCard()), here(scene, method, onProcessor());
    there.advanceTo(time), here.advanceTo(time);
    EXPECT_EQ(hashText(there), hashText(here)) << scene.name << " " << method.name;
    EXPECT_EQ(there.forceEvaluations(), here.forceEvaluations()) << method.name;
    EXPECT_GT(here.steps(), 0);
  }
};

// As many columns and rows as a scene may have, and as many work groups as a card is asked for.
TEST_F(SameBits, ComeOutForTheLongestRowsAndColumns) {
  for (const auto& [columns, rows] : {std::pair{4096, 3}, {3, 4096}}) {
    for (const std::string_view method : gpuMethods()) expectSame(busyScene(columns, rows), findMethod(method), 0.004);
  }
}

TEST_F(SameBits, ComeOutForSheetsOfEveryShape) {
  for (const auto& [columns, rows] : {std::pair{37, 23}, {1, 20}, {33, 1}, {2, 2}, {3, 5}}) {
    for (const std::string_view method : gpuMethods()) expectSame(busyScene(columns, rows), findMethod(method));
  }
}

// One method is enough: the forces are the same for all.
TEST_F(SameBits, ComeOutWithEveryFamilyLeftOutAndEveryDamping) {
  const Method& method = findMethod("symplectic-euler");
  Scene scene = busyScene(9, 7);
  for (SpringFamily Scene::*family : {&Scene::structural, &Scene::shear, &Scene::bend}) {
    for (const Damping damping : {Damping::Relative, Damping::Axial}) {
      Scene without = scene;
      without.*family = {};
      without.damping = damping;
      expectSame(without, method);
    }
  }
  scene.structural.kd = scene.shear.kd = scene.bend.kd = 0;
  expectSame(scene, method);
}

TEST_F(SameBits, ComeOutWhereManyPushesActOnOneParticle) {
  Scene scene = busyScene(9, 7);
  for (int k = 0; k < 5; ++k) {
    Push push = scene.pushes.front();
    push.force = {0.1 * k, 1.0 / (k + 1), 0.3};
    scene.pushes.push_back(push);
    push.particle = Place{"bottom-left"};
    scene.pushes.push_back(push);
  }
  for (const std::string_view method : gpuMethods()) expectSame(scene, findMethod(method));
}

/// Everything that a person can do to a running cloth, at the same ticks.
void handle(Simulation& simulation) {
  simulation.tick(7);
  simulation.push(simulation.sheet().count() / 2, {0.2, 0.5, 1}, 5);
  simulation.tick(3);
  simulation.pin(11, true);
  simulation.tick(9);
  simulation.grab(20, {0.1, 0.2, -0.3});
  simulation.tick(4);
  simulation.cut({2.5, 0.5, 2.5, 5.5});
  simulation.tick(5);
  simulation.release(20);
  simulation.pin(11, false);
  simulation.tick(6);
  simulation.mend();
  Scene other = simulation.scene();
  other.gravity = {1, -5, 0.5}, other.drag = 0.02, other.shear.ks *= 0.5;
  simulation.useLiveParameters(other);
  simulation.tick(8);
  simulation.useStep(simulation.dt() / 2);
  simulation.tick(70);
}

void expectSameEnergies(Simulation& there, Simulation& here) {
  const Ledger a = there.ledger(), b = here.ledger();
  EXPECT_EQ(a.kinetic, b.kinetic);
  EXPECT_EQ(a.stored.sum(), b.stored.sum());
  EXPECT_EQ(a.work.sum(), b.work.sum());
  EXPECT_EQ(a.storedRise, b.storedRise);
  EXPECT_EQ(a.balanceRise, b.balanceRise);
  EXPECT_EQ(a.maxStretch, b.maxStretch);
}

TEST_F(SameBits, ComeOutWhateverHandsDoToTheCloth) {
  for (const std::string_view method : gpuMethods()) {
    const Scene scene = busyScene(12, 9);
    Simulation there(scene, findMethod(method), onCard()), here(scene, findMethod(method), onProcessor());
    handle(there), handle(here);
    EXPECT_EQ(hashText(there), hashText(here)) << method;
    expectSameEnergies(there, here);
    EXPECT_NE(here.ledger().work.sum(), 0);
  }
}

TEST_F(SameBits, ReachEveryEntryOfTheLedger) {
  // Washing on a line that is lowered, gusts, a floor, and a ball that comes and goes.
  Scene scene = inFloat(withSheet(loadScene("storm"), 15, 12));
  for (Move& move : scene.moves) move.at = 0, move.duration = 0.05;
  for (const std::string_view method : gpuMethods()) {
    Settings there = onCard(), here = onProcessor();
    there.ledger = here.ledger = true;
    Simulation onIt(scene, findMethod(method), there), beside(scene, findMethod(method), here);
    onIt.advanceTo(0.1), beside.advanceTo(0.1);
    EXPECT_EQ(hashText(onIt), hashText(beside)) << method;
    expectSameEnergies(onIt, beside);
    const Ledger ledger = beside.ledger();
    EXPECT_EQ(onIt.ledger().dissipated, ledger.dissipated) << method;
    EXPECT_EQ(onIt.ledger().drift, ledger.drift) << method;
    for (const std::string_view work : {"wind", "pins"}) {
      EXPECT_EQ(onIt.ledger().work[work], ledger.work[work]) << method << " " << work;
      EXPECT_NE(ledger.work[work], 0) << work;
    }
    EXPECT_GT(ledger.dissipated, 0);
  }
}

TEST_F(SameBits, ComeOutWhereARunGoesBackToACheckpoint) {
  for (const std::string_view method : gpuMethods()) {
    Simulation there(busyScene(12, 9), findMethod(method), onCard());
    Simulation here(busyScene(12, 9), findMethod(method), onProcessor());
    there.tick(5), here.tick(5);
    const Snapshot kept = there.save();
    there.tick(9), here.tick(9);
    there.restore(kept);
    const Snapshot again = there.save();  // of a copy that has not stepped yet
    there.tick(2);
    there.restore(again);
    there.tick(9);
    EXPECT_EQ(hashText(there), hashText(here)) << method;
  }
}

TEST_F(SameBits, ComeOutWhereTheMethodChangesOnTheWay) {
  Simulation there(busyScene(12, 9), findMethod("rk4"), onCard());
  Simulation here(busyScene(12, 9), findMethod("rk4"), onProcessor());
  for (const std::string_view method : {"leapfrog", "symplectic-euler", "leapfrog", "rk4"}) {
    for (Simulation* simulation : {&there, &here}) simulation->tick(3), simulation->useMethod(findMethod(method));
  }
  there.tick(3), here.tick(3);
  EXPECT_EQ(hashText(there), hashText(here));
}

TEST_F(SameBits, LetTheAlarmGoAtTheSameStep) {
  for (const std::string_view name : {"fail-stretched", "fail-wet", "fail-refined", "fail-contact"}) {
    const Scene scene = inFloat(loadScene(std::string(name)));
    const Method& method = findMethod(scene.integrator);
    Simulation there(scene, method, onCard()), here(scene, method, onProcessor());
    there.advanceTo(scene.duration), here.advanceTo(scene.duration);
    EXPECT_NE(here.status(), Status::Ok) << name;
    EXPECT_EQ(there.status(), here.status()) << name;
    EXPECT_EQ(there.steps(), here.steps()) << name;
    EXPECT_EQ(there.alarmTime(), here.alarmTime()) << name;
  }
}

TEST_F(SameBits, ComeOutForTwoClothsAtOnce) {
  const Method& method = findMethod("leapfrog");
  Simulation one(busyScene(12, 9), method, onCard()), other(busyScene(7, 11), method, onCard());
  Simulation first(busyScene(12, 9), method, onProcessor()), second(busyScene(7, 11), method, onProcessor());
  for (int k = 0; k < 4; ++k) {
    for (Simulation* simulation : {&one, &other, &first, &second}) simulation->tick(3);
  }
  EXPECT_EQ(hashText(one), hashText(first));
  EXPECT_EQ(hashText(other), hashText(second));
}

TEST_F(SameBits, AreFoundByTheComparison) {
  const BitsCompared bits = compareBits(busyScene(12, 9), findMethod("rk4"), device_, 1);
  EXPECT_TRUE(bits.same);
  EXPECT_EQ(bits.strays, 0);
}

TEST_F(SameBits, AreComparedWhileARunThatBlowsUpHasNumbers) {
  Scene scene = loadScene("fail-jitter", methodNames());
  scene.precision = Precision::Float, scene.dt = 0.0035;
  const BitsCompared bits = compareBits(scene, findMethod("leapfrog"), device_, 1);
  EXPECT_TRUE(bits.same);
  EXPECT_EQ(bits.strays, 0);
}

/// A device that is a little wrong.
class WrongIntegrator final : public Integrator<float> {
 public:
  explicit WrongIntegrator(std::unique_ptr<Integrator<float>> right) : right_(std::move(right)) {}
  void step(Forces<float>& forces, State<float>& state, double t, double h) override {
    right_->step(forces, state, t, h);
    state.position.x()[0] += kError;
  }
  [[nodiscard]] std::unique_ptr<Integrator<float>> clone() const override {
    return std::make_unique<WrongIntegrator>(right_->clone());
  }
  [[nodiscard]] std::size_t bytes() const override { return right_->bytes(); }
  static constexpr float kError = 0x1p-20F;  // m: adds up without rounding

 private:
  std::unique_ptr<Integrator<float>> right_;
};

/// Moves the cloth rightly, and is a little wrong about its kinetic energy.
class WrongMeasure final : public Integrator<float>, public DeviceState<float> {
 public:
  explicit WrongMeasure(std::unique_ptr<Integrator<float>> right) : right_(std::move(right)) {}
  void step(Forces<float>& forces, State<float>& state, double t, double h) override {
    right_->step(forces, state, t, h);
  }
  void reset() override { right_->reset(); }
  DeviceState<float>* onDevice(const State<float>& state) override {
    state_ = &state;
    return this;
  }
  [[nodiscard]] std::unique_ptr<Integrator<float>> clone() const override {
    return std::make_unique<WrongMeasure>(right_->clone());
  }
  [[nodiscard]] std::size_t bytes() const override { return right_->bytes(); }

  [[nodiscard]] ParticleState particle(int index) override {
    return {state_->position.get(index), state_->velocity.get(index)};
  }
  void place(int /*index*/, const ParticleState& /*particle*/) override {}
  [[nodiscard]] StoredEnergy energy(const Forces<float>& forces, double time) override {
    StoredEnergy energy = forces.energy(time, *state_);
    energy.kinetic *= 1 + 1e-15;
    return energy;
  }
  [[nodiscard]] Power power(const Forces<float>& forces, double time) override {
    return forces.powerOf(time, state_->position, state_->velocity);
  }
  [[nodiscard]] Largest largest() override { return {}; }
  [[nodiscard]] std::shared_ptr<const DevicePositions> positions() override { return nullptr; }

 private:
  std::unique_ptr<Integrator<float>> right_;
  const State<float>* state_ = nullptr;
};

template <class Wrong>
class WrongDevice final : public Device {
 public:
  [[nodiscard]] std::unique_ptr<Integrator<float>> make(const Method& method, const Scene& scene,
                                                        const Sheet& sheet) override {
    return std::make_unique<Wrong>(method.make<float>(scene, sheet));
  }
};

TEST(Comparison, FindsADeviceThatIsWrongAboutEnergiesAlone) {
  const auto device = std::make_shared<WrongDevice<WrongMeasure>>();
  const BitsCompared bits = compareBits(busyScene(12, 9), findMethod("leapfrog"), device, 1);
  EXPECT_FALSE(bits.same);
  EXPECT_EQ(bits.strays, 0);
}

TEST(Comparison, SaysHowFarADeviceStraysThatIsWrong) {
  const Scene scene = busyScene(12, 9);
  const auto device = std::make_shared<WrongDevice<WrongIntegrator>>();
  const BitsCompared bits = compareBits(scene, findMethod("leapfrog"), device, 1);
  EXPECT_FALSE(bits.same);
  const double expected = kStepsCompared * double(WrongIntegrator::kError);
  EXPECT_GE(bits.strays, expected);      // of the wrong particle, a pin that nothing else moves
  EXPECT_LT(bits.strays, 2 * expected);  // of those that it pulls along
}

}  // namespace
}  // namespace tyg
