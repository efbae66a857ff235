// The backend on the processor, once for each precision: state, forces and integrator. What changes while the cloth
// moves is handed to each of them in place.
#include "core/simulation/backend.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/simulation/device.h"
#include "core/simulation/integrator.h"
#include "core/spectrum/live_spectrum.h"
#include "tyg/input_error.h"
#include "util/workers.h"

namespace tyg {
namespace {

template <class T>
State<T> displacedStart(const Scene& scene, const Sheet& sheet) {
  State<T> state = startState<T>(sheet);
  for (const Displacement& displacement : scene.displacements) {
    const int particle = particleAt(sheet, displacement.particle);
    const Vec3 from = state.position.get(particle), by = displacement.by;
    state.position.set(particle, {from.x + by.x, from.y + by.y, from.z + by.z});
  }
  return state;
}

/// `device` may be null, which is the processor.
template <class T>
std::unique_ptr<Integrator<T>> makeIntegrator(Device* device, const Method& method, const Scene& scene,
                                              const Sheet& sheet) {
  if constexpr (std::is_same_v<T, float>) {
    if (device != nullptr) return device->make(method, scene, sheet);
  }
  return method.make<T>(scene, sheet);
}

template <class T>
class BackendOf final : public Backend {
 public:
  BackendOf(const Scene& scene, const Sheet& sheet, const Method& method, Workers& workers, const Settings& settings)
      : scene_(scene),
        sheet_(sheet),
        state_(displacedStart<T>(scene, sheet)),
        workers_(workers),
        forces_(scene, sheet, workers),
        device_(settings.device.get()),
        integrator_(makeIntegrator<T>(device_, method, scene, sheet)) {
    forces_.trackDissipation(settings.ledger);
  }

  void useMethod(const Method& method) override {
    integrator_->fetch(state_);
    integrator_ = makeIntegrator<T>(device_, method, scene_, sheet_);
  }
  void useSheet(const Method& method) override {
    forces_.useSheet(sheet_);
    useMethod(method);
    spectrum_.reset();
  }
  void useLiveParameters() override {
    integrator_->useParameters(scene_, sheet_);  // first: it may refuse
    forces_.useParameters(scene_);
    forces_.act(acting_);
    if (spectrum_) spectrum_->useParameters(scene_);
  }
  void steps(const StepTimes& times, int count) override { integrator_->steps(forces_, state_, times, count); }
  double stepWithin(double time, double most, double tolerance) override {
    return integrator_->stepWithin(forces_, state_, time, most, tolerance);
  }
  void act(const Acting& acting) override {
    acting_ = acting;
    forces_.act(acting_);
  }
  void placePin(int particle, const ParticleState& there) override {
    if (DeviceState<T>* device = integrator_->onDevice(state_)) device->place(particle, there);
    state_.position.set(particle, there.position);
    state_.velocity.set(particle, there.velocity);
  }
  void movePins(std::vector<int> particles) override { forces_.movePins(std::move(particles)); }
  void clearPushes() override { forces_.clearPushes(); }
  void addPush(int particle, const Vec3& force) override { forces_.addPush(particle, force); }
  void reset() override { integrator_->reset(); }
  void trackDissipation(bool on, double time) override {
    forces_.trackDissipation(on);
    const State<T>& now = state();
    forces_.measurePower(time, now.position, now.velocity);  // methods that keep a force begin with its power
  }

  double liveStableStep(const Method& method, double time) override {
    if (!spectrum_) spectrum_.emplace(scene_, sheet_, workers_);
    spectrum_->act(acting_);
    return spectrum_->stableStep(method, state(), time);
  }
  [[nodiscard]] StoredEnergy energy(double time) const override {
    if (DeviceState<T>* there = integrator_->onDevice(state_)) return there->energy(forces_, time);
    return forces_.energy(time, state_);
  }
  [[nodiscard]] StoredEnergy startEnergy() const override {
    return forces_.energy(0, displacedStart<T>(scene_, sheet_));
  }
  [[nodiscard]] std::vector<SpringEnds> longerThan(double length) const override {
    std::vector<SpringEnds> longer;
    const T most = T(length * length);
    if (DeviceState<T>* there = integrator_->onDevice(state_); there && !(there->largest().squaredLength > most))
      return {};
    const Layout& layout = forces_.layout();
    const T* x = state().position.x();
    const auto squared = [&](std::ptrdiff_t a, std::ptrdiff_t b) {
      T sum = 0;
      for (std::ptrdiff_t axis = 0; axis < 3 * layout.plane; axis += layout.plane) {
        const T d = x[axis + b] - x[axis + a];
        sum += d * d;
      }
      return sum;
    };
    for (int particle = 0; particle < sheet_.count(); ++particle) {
      const std::ptrdiff_t a = layout.at(particle);
      const auto look = [&](bool isThere, Missing::Bit bit, std::ptrdiff_t b, int other) {
        if (isThere && squared(a, b) > most && !sheet_.missing.has(particle, bit)) longer.push_back({particle, other});
      };
      look((particle + 1) % sheet_.columns != 0, Missing::Right, a + 1, particle + 1);
      look(particle + sheet_.columns < sheet_.count(), Missing::Down, a + layout.stride, particle + sheet_.columns);
    }
    return longer;
  }
  [[nodiscard]] double largestSpeed() const override {
    if (DeviceState<T>* there = integrator_->onDevice(state_)) return std::sqrt(double(there->largest().squaredSpeed));
    const VectorField<T>& velocity = state_.velocity;
    const T *x = velocity.x(), *y = velocity.y(), *z = velocity.z();
    std::array<T, Layout::kLanes> most{};  // of every sixteenth particle: no comparison waits for the one before
    for (std::ptrdiff_t i = 0; i < velocity.layout().plane; i += Layout::kLanes) {
      for (int k = 0; k < Layout::kLanes; ++k) {
        const T squared = x[i + k] * x[i + k] + y[i + k] * y[i + k] + z[i + k] * z[i + k];
        most[std::size_t(k)] = std::max(most[std::size_t(k)], squared);
      }
    }
    return std::sqrt(double(std::ranges::max(most)));
  }
  [[nodiscard]] Power power(double time) const override {
    if (DeviceState<T>* there = integrator_->onDevice(state_)) return there->power(forces_, time);
    return forces_.powerOf(time, state_.position, state_.velocity);
  }
  [[nodiscard]] Power energyOfPower() const override { return forces_.energyOfPower(); }
  [[nodiscard]] std::int64_t evaluations() const override { return forces_.evaluations(); }
  [[nodiscard]] ParticleState particle(int index) const override {
    if (DeviceState<T>* there = integrator_->onDevice(state_)) return there->particle(index);
    return {state_.position.get(index), state_.velocity.get(index)};
  }
  [[nodiscard]] Vec3 position(int particle) const override { return state().position.get(particle); }
  [[nodiscard]] Vec3 velocity(int particle) const override { return state().velocity.get(particle); }
  [[nodiscard]] std::uint64_t hash() const override { return hashOf(state()); }

  void copyPositions(std::span<float> xyz) const override {
    const Layout& layout = forces_.layout();
    const VectorField<T>& position = state().position;
    const T *x = position.x(), *y = position.y(), *z = position.z();
    float* out = xyz.data();
    for (int row = 0; row < layout.rows; ++row) {
      for (std::ptrdiff_t i = row * layout.stride; i < row * layout.stride + layout.columns; ++i) {
        *out++ = float(x[i]), *out++ = float(y[i]), *out++ = float(z[i]);
      }
    }
  }

  [[nodiscard]] std::shared_ptr<const DevicePositions> positionsOnDevice() const override {
    DeviceState<T>* there = integrator_->onDevice(state_);
    return there == nullptr ? nullptr : there->positions();
  }

  [[nodiscard]] std::unique_ptr<Checkpoint> save() const override {
    auto checkpoint = std::make_unique<CheckpointOf>();
    checkpoint->state = state();
    checkpoint->integrator = integrator_->clone();
    checkpoint->account = forces_.account();
    return checkpoint;
  }
  void restore(const Checkpoint& saved) override {
    const auto& checkpoint = dynamic_cast<const CheckpointOf&>(saved);
    state_ = checkpoint.state;
    integrator_ = checkpoint.integrator->clone();
    forces_.setAccount(checkpoint.account);
  }

 private:
  [[nodiscard]] State<T>& state() const {
    integrator_->fetch(state_);
    return state_;
  }

  struct CheckpointOf final : Checkpoint {
    State<T> state;
    std::unique_ptr<Integrator<T>> integrator;
    typename Forces<T>::Account account;
    [[nodiscard]] std::size_t bytes() const override { return state.bytes() + integrator->bytes(); }
  };

  const Scene& scene_;
  const Sheet& sheet_;
  Acting acting_;
  mutable State<T> state_;  // a device may have it, see Integrator::fetch
  Workers& workers_;
  Forces<T> forces_;
  Device* device_;  // null: the processor
  std::unique_ptr<Integrator<T>> integrator_;
  std::optional<LiveSpectrum<T>> spectrum_;  // with forces of its own: neither counts nor bits of the motion change
};

}  // namespace

std::unique_ptr<Backend> makeBackend(const Scene& scene, const Sheet& sheet, const Method& method, Workers& workers,
                                     const Settings& settings) {
  if (scene.precision == Precision::Float) {
    return std::make_unique<BackendOf<float>>(scene, sheet, method, workers, settings);
  }
  if (settings.device) throw InputError("precision: found double, allowed on the graphics card is float");
  return std::make_unique<BackendOf<double>>(scene, sheet, method, workers, settings);
}

}  // namespace tyg
