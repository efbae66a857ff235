// Chooses the row kernels for what a scene has, hands them its numbers, and shares the rows out over threads.
#include "core/forces/forces.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "core/forces/forces_kernel.h"
#include "core/forces/term.h"
#include "util/workers.h"

namespace tyg {
namespace {

int familiesOf(const Scene& scene) {
  return (scene.structural.present() ? kStructural : 0) | (scene.shear.present() ? kShear : 0) |
         (scene.bend.present() ? kBend : 0);
}

DampingTerm dampingOf(const Scene& scene) {
  if (scene.structural.kd <= 0 && scene.shear.kd <= 0 && scene.bend.kd <= 0) return DampingTerm::None;
  return scene.damping == Damping::Relative ? DampingTerm::Relative : DampingTerm::Axial;
}

/// The terms of a place that the scene has, a bit each.
unsigned termsOf(const Scene& scene, TermPlace place) {
  unsigned terms = 0, bit = 1;
  AllTerms::forEach([&]<class Term>() {
    if (Term::kPlace != place) return;
    if (hasTerm(scene, Term::kTerm)) terms |= bit;
    bit *= 2;
  });
  return terms;
}

/// Fills in the numbers of every term.
template <class T>
void fill(AllTerms::Numbers<T>& numbers, const Scene& scene, const Sheet& sheet) {
  AllTerms::forEach([&]<class Term>() {
    static_cast<typename Term::template Numbers<T>&>(numbers) = Term::template numbersOf<T>(scene, sheet);
  });
}

}  // namespace

template <class T>
Forces<T>::Forces(const Scene& scene, const Sheet& sheet, Workers& workers)
    : layout_(sheet),
      workers_(workers),
      inverseMass_(1.0 / sheet.particleMass),
      kernel_(std::make_unique<Kernel>(sheet)) {
  Kernel& k = *kernel_;
  k.hasRight = columnMask<T>(layout_, 1);
  k.hasRight2 = columnMask<T>(layout_, 2);
  k.scratch.assign(static_cast<std::size_t>(workers.threads() * kGroup),
                   AlignedVector<T>(rowScratchSize(layout_.stride)));
  k.moments.resize(k.scratch.size());
  k.rowEnergies.resize(static_cast<std::size_t>(layout_.rows));
  k.rowPowers.resize(static_cast<std::size_t>(layout_.rows));

  k.isFree.resize(static_cast<std::size_t>(layout_.plane));
  RowTask<T>& task = k.task;
  constexpr int kVector = 64 / sizeof(T);  // numbers in the widest vector register
  task.width = (layout_.columns + kVector - 1) / kVector * kVector;
  task.columns = layout_.columns, task.rows = layout_.rows;
  task.stride = layout_.stride, task.plane = layout_.plane;
  task.hasRight = k.hasRight.data(), task.hasRight2 = k.hasRight2.data(), task.isFree = k.isFree.data();
  task.isUnpinned = k.isFree.data();

  EnergyRow<T>& row = k.energyRow;
  row.columns = layout_.columns, row.rows = layout_.rows;
  row.stride = layout_.stride, row.plane = layout_.plane;
  row.isUnpinned = k.isFree.data();
  useSheet(sheet);
  useParameters(scene);
}

template <class T>
void Forces<T>::useSheet(const Sheet& sheet) {
  Kernel& k = *kernel_;
  k.sheet = sheet;
  std::ranges::copy(maskOfFree<T>(layout_, sheet), k.isFree.begin());
  k.masks = RowMasks<T>(layout_, sheet.missing);
}

template <class T>
void Forces<T>::useParameters(const Scene& scene) {
  Kernel& k = *kernel_;
  k.scene = scene;
  k.acting = {.winds = scene.winds};
  k.particleTerms = termsOf(scene, TermPlace::Particles), k.cellTerms = termsOf(scene, TermPlace::Cells);
  k.blockTerms = termsOf(scene, TermPlace::Blocks);
  k.task.addToBlock = k.kernels.addToBlock[k.blockTerms];
  k.task.accumulate = k.kernels.accumulate[k.cellTerms][familiesOf(scene)][int(dampingOf(scene))];
  k.task.masked = k.kernels.masked[k.cellTerms][familiesOf(scene)][int(dampingOf(scene))];
  fill<T>(k.task, scene, k.sheet);
  fill<double>(k.energyRow, scene, k.sheet);
  k.energyRow.axial = scene.damping == Damping::Axial;
  k.hasPower = isDamped(scene) || k.cellTerms != 0 || k.blockTerms != 0;
}

template <class T>
void Forces<T>::act(const Acting& acting) {
  kernel_->acting = acting;
}

template <class T>
Forces<T>::~Forces() = default;

template <class T>
void Forces<T>::evaluate(double time, const VectorField<T>& position, const VectorField<T>& velocity,
                         VectorField<T>& force) {
  runBands([](RowTask<T>&) {}, time, position, velocity, force);
  finishEvaluation(time, position, velocity, force);
}

template <class T>
void Forces<T>::evaluate(double time, const VectorField<T>& position, const VectorField<T>& velocity,
                         VectorField<T>& force, const VectorField<T>& blockVelocity) {
  runBands([&](RowTask<T>& task) { task.blockVelocity = blockVelocity.x(); }, time, position, velocity, force);
  finishEvaluation(time, position, velocity, force);
}

template <class T>
void Forces<T>::finishEvaluation(double time, const VectorField<T>& position, const VectorField<T>& velocity,
                                 VectorField<T>& force) {
  ++account_.evaluations;
  takePower(time, position, velocity);
  if (!movingPins_.empty()) account_.power.pins = takeFromPins(velocity, force);
}

template <class T>
void Forces<T>::evaluateWithoutStiffness(double time, const VectorField<T>& position, const VectorField<T>& velocity,
                                         VectorField<T>& force) {
  const auto without = [&](RowTask<T>& task) {
    task.accumulate = kernel_->kernels.accumulate[kernel_->cellTerms][0][int(DampingTerm::None)];
    task.masked = kernel_->kernels.masked[kernel_->cellTerms][0][int(DampingTerm::None)];
    task.addToBlock = nullptr;
  };
  runBands(without, time, position, velocity, force);
  if (!movingPins_.empty()) takeFromPins(velocity, force);
}

/// Each thread finishes a band of rows; the two rows above it are accumulated again rather than waited for.
template <class T>
template <class Change>
void Forces<T>::runBands(const Change& change, double time, const VectorField<T>& position,
                         const VectorField<T>& velocity, VectorField<T>& force) {
  Kernel& k = *kernel_;
  RowTask<T> now = k.task;
  setMoment<T>(now, k.moments.front(), k.scene, k.acting, time);
  if (!movingPins_.empty()) now.isFree = k.isFreeOrMoves.data();
  change(now);
  workers_.forBands(layout_.rows, [&](int first, int last, int thread) {
    RowTask<T> task = now;
    task.finish = k.finish(Update::Store);
    task.position = position.x(), task.velocity = velocity.x(), task.force = force.x();
    task.scratch = k.cleanScratch(thread);
    for (int row = std::max(0, first - 2); row < last; ++row) k.run(task, Update::Store, row, row >= first);
  });
}

template <class T>
void Forces<T>::measurePower(double time, const VectorField<T>& position, const VectorField<T>& velocity) {
  takePower(time, position, velocity);
  if (movingPins_.empty()) return;
  VectorField<T>& force = kernel_->forceOnPins;
  runBands([](RowTask<T>&) {}, time, position, velocity, force);
  account_.power.pins = takeFromPins(velocity, force);
}

template <class T>
void Forces<T>::takePower(double time, const VectorField<T>& position, const VectorField<T>& velocity) {
  if (trackDissipation_) account_.power = powerOf(time, position, velocity);
}

template <class T>
void Forces<T>::movePins(std::vector<int> particles) {
  Kernel& k = *kernel_;
  movingPins_ = std::move(particles);
  if (movingPins_.empty()) {
    account_.power.pins = 0;
    return;
  }
  k.isFreeOrMoves = k.isFree;
  for (const int pin : movingPins_) k.isFreeOrMoves[static_cast<std::size_t>(layout_.at(pin))] = T(1);
  if (k.forceOnPins.bytes() == 0) k.forceOnPins = VectorField<T>(layout_);
}

/// Sets the forces on moving pins to 0, and returns the power that the pins bring by holding against them, W.
template <class T>
double Forces<T>::takeFromPins(const VectorField<T>& velocity, VectorField<T>& force) const {
  double power = 0;
  for (const int pin : movingPins_) {
    const Vec3 f = force.get(pin), v = velocity.get(pin);
    power -= f.x * v.x + f.y * v.y + f.z * v.z;
    force.set(pin, {});
  }
  return power;
}

template <class T>
AllTerms::Numbers<T> Forces<T>::numbersAt(double time) const {
  AllTerms::Numbers<T> numbers = kernel_->task;
  setMoment<T>(numbers, kernel_->moments.front(), kernel_->scene, kernel_->acting, time);
  return numbers;
}

template <class T>
const T* Forces<T>::freeMask() const {
  return kernel_->isFree.data();
}

template <class T>
void Forces<T>::addPush(int particle, const Vec3& force) {
  if (kernel_->isFree[static_cast<std::size_t>(layout_.at(particle))] == T(0)) return;
  const PushedParticle<T> push{
      particle / layout_.columns, particle % layout_.columns, {T(force.x), T(force.y), T(force.z)}};
  std::vector<PushedParticle<T>>& pushes = kernel_->pushes;
  const auto place = [](const PushedParticle<T>& at) { return std::pair(at.row, at.column); };
  if (pushes.empty() || place(pushes.back()) <= place(push)) return pushes.push_back(push);
  pushes.insert(std::ranges::upper_bound(pushes, place(push), {}, place), push);
}

template <class T>
std::span<const PushedParticle<T>> Forces<T>::pushes() const {
  return kernel_->pushes;
}

template <class T>
void Forces<T>::clearPushes() {
  kernel_->pushes.clear();
  kernel_->task.firstPush = kernel_->task.endPush = nullptr;
}

template <class T>
AllTerms::Numbers<double> Forces<T>::energyNumbersAt(double time) const {
  AllTerms::Numbers<double> numbers = kernel_->energyRow;
  setMoment<double>(numbers, kernel_->energyMoment, kernel_->scene, kernel_->acting, time);
  return numbers;
}

template <class T>
bool Forces<T>::hasPower() const {
  return kernel_->hasPower;
}

template <class T>
StoredEnergy Forces<T>::energy(double time, const State<T>& state) const {
  Kernel& k = *kernel_;
  EnergyRow<T> now = k.energyRow;
  static_cast<AllTerms::Numbers<double>&>(now) = energyNumbersAt(time);
  workers_.forBands(layout_.rows, [&](int first, int last, int) {
    EnergyRow<T> row = now;
    row.position = state.position.x(), row.velocity = state.velocity.x();
    for (row.row = first; row.row < last; ++row.row) {
      row.there = k.masks.of(row.row);
      k.rowEnergies[static_cast<std::size_t>(row.row)] = k.kernels.energy(row);
    }
  });
  StoredEnergy sum;
  for (StoredEnergy& row : k.rowEnergies) {
    row.kinetic *= k.sheet.particleMass;
    sum.add(row);
  }
  return sum;
}

template <class T>
Power Forces<T>::powerOf(double time, const VectorField<T>& position, const VectorField<T>& velocity) const {
  Kernel& k = *kernel_;
  Power power;
  if (!k.hasPower) return power;
  EnergyRow<T> now = k.energyRow;
  static_cast<AllTerms::Numbers<double>&>(now) = energyNumbersAt(time);
  workers_.forBands(layout_.rows, [&](int first, int last, int) {
    EnergyRow<T> row = now;
    row.position = position.x(), row.velocity = velocity.x();
    for (row.row = first; row.row < last; ++row.row) {
      row.there = k.masks.of(row.row);
      k.rowPowers[static_cast<std::size_t>(row.row)] = k.kernels.power(row);
    }
  });
  for (const Power& row : k.rowPowers) power.add(row);
  return power;
}

template class Forces<float>;
template class Forces<double>;

}  // namespace tyg
