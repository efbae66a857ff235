// Sets up the row kernels for a scene and shares the rows out over threads.
#include "core/forces/forces.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <thread>

#include "core/forces/row_kernel.h"
#include "util/workers.h"

namespace tyg {
namespace {

template <class T>
SpringLaw<T> lawOf(const SpringFamily& family, double rest) {
  return {T(family.ks), T(family.ks * rest), T(family.kd)};
}

int familiesOf(const Scene& scene) {
  return (scene.structural.present() ? kStructural : 0) | (scene.shear.present() ? kShear : 0) |
         (scene.bend.present() ? kBend : 0);
}

DampingTerm dampingOf(const Scene& scene) {
  if (scene.structural.kd <= 0 && scene.shear.kd <= 0 && scene.bend.kd <= 0) return DampingTerm::None;
  return scene.damping == Damping::Relative ? DampingTerm::Relative : DampingTerm::Axial;
}

/// 1 for every column that has a neighbour `distance` to the right.
template <class T>
AlignedVector<T> columnMask(const Layout& layout, int distance) {
  AlignedVector<T> mask(static_cast<std::size_t>(layout.stride));
  for (int column = 0; column + distance < layout.columns; ++column) mask[static_cast<std::size_t>(column)] = T(1);
  return mask;
}

/// 1 for every particle of the sheet that is not pinned.
template <class T>
AlignedVector<T> maskOfFree(const Layout& layout, const Sheet& sheet) {
  AlignedVector<T> mask(static_cast<std::size_t>(layout.plane));
  for (int particle = 0; particle < sheet.count(); ++particle)
    mask[static_cast<std::size_t>(layout.at(particle))] = T(1);
  for (const int pin : sheet.pins) mask[static_cast<std::size_t>(layout.at(pin))] = T(0);
  return mask;
}

/// How far a group of steps has come, alone on its cache line.
struct alignas(64) Progress {
  std::atomic<int> rows{0};

  /// Another thread works on it right now: spinning is short, and gives way where threads share cores.
  void await(int wanted) const {
    for (int spin = 0; rows.load(std::memory_order_acquire) < wanted; ++spin) {
      if (spin > 1000) std::this_thread::yield();
    }
  }
};

constexpr int kGroup = 4;

}  // namespace

template <class T>
struct Forces<T>::Kernel {
  const RowKernels<T>& kernels = rowKernels<T>();
  RowTask<T> task;  // all that does not change from call to call; its loops store the forces
  EnergyRow<T> energyRow;
  AlignedVector<T> hasRight, hasRight2, isFree;
  std::vector<AlignedVector<T>> scratch;  // per thread and step of a group
  std::vector<RowEnergy> rowEnergies;     // per row
  double particleMass = 0;
  std::array<Progress, kMostSteps / kGroup> finished;  // rows, by each group of steps

  [[nodiscard]] FinishForces<T> finish(Update update) const {
    return kernels.finish[int(update)][task.drag > T(0) ? 1 : 0];
  }
  T* cleanScratch(int slot) {
    AlignedVector<T>& memory = scratch[static_cast<std::size_t>(slot)];
    std::fill(memory.begin(), memory.end(), T(0));
    return memory.data();
  }
};

template <class T>
Forces<T>::Forces(const Scene& scene, const Sheet& sheet, Workers& workers)
    : layout_(sheet), workers_(workers), inverseMass_(1.0 / sheet.particleMass), kernel_(std::make_unique<Kernel>()) {
  Kernel& k = *kernel_;
  k.hasRight = columnMask<T>(layout_, 1);
  k.hasRight2 = columnMask<T>(layout_, 2);
  k.isFree = maskOfFree<T>(layout_, sheet);
  k.scratch.assign(static_cast<std::size_t>(workers.threads() * kGroup),
                   AlignedVector<T>(rowScratchSize(layout_.stride)));
  k.rowEnergies.resize(static_cast<std::size_t>(layout_.rows));
  k.particleMass = sheet.particleMass;

  RowTask<T>& task = k.task;
  task.stage = k.kernels.stage[familiesOf(scene)][int(dampingOf(scene))];
  constexpr int kVector = 64 / sizeof(T);  // numbers in the widest vector register
  task.width = (layout_.columns + kVector - 1) / kVector * kVector;
  task.rows = layout_.rows;
  task.stride = layout_.stride, task.plane = layout_.plane;
  task.hasRight = k.hasRight.data(), task.hasRight2 = k.hasRight2.data(), task.isFree = k.isFree.data();
  const double rest[] = {restLength(sheet, Family::Structural), restLength(sheet, Family::Shear),
                         restLength(sheet, Family::Bend)};
  task.structural = lawOf<T>(scene.structural, rest[0]);
  task.shear = lawOf<T>(scene.shear, rest[1]);
  task.bend = lawOf<T>(scene.bend, rest[2]);
  task.drag = T(scene.drag);

  EnergyRow<T>& row = k.energyRow;
  row.columns = layout_.columns, row.rows = layout_.rows;
  row.stride = layout_.stride, row.plane = layout_.plane;
  row.families[0] = {scene.structural.ks, scene.structural.kd, rest[0]};
  row.families[1] = {scene.shear.ks, scene.shear.kd, rest[1]};
  row.families[2] = {scene.bend.ks, scene.bend.kd, rest[2]};
  row.axial = scene.damping == Damping::Axial;
  row.drag = scene.drag;
  const double gravity[] = {scene.gravity.x, scene.gravity.y, scene.gravity.z};
  for (int axis = 0; axis < 3; ++axis) {
    row.weight[axis] = sheet.particleMass * gravity[axis];
    task.weight[axis] = T(row.weight[axis]);
  }
}

template <class T>
Forces<T>::~Forces() = default;

template <class T>
void Forces<T>::evaluate(const VectorField<T>& position, const VectorField<T>& velocity, VectorField<T>& force) {
  runBands(kernel_->task.stage, position, velocity, force);
  ++account_.evaluations;
  measurePower(position, velocity);
}

template <class T>
void Forces<T>::evaluateWithoutSprings(const VectorField<T>& position, const VectorField<T>& velocity,
                                       VectorField<T>& force) {
  runBands(kernel_->kernels.stage[0][int(DampingTerm::None)], position, velocity, force);
}

/// Each thread finishes a band of rows; the two rows above it are staged again rather than waited for.
template <class T>
template <class Loop>
void Forces<T>::runBands(Loop stage, const VectorField<T>& position, const VectorField<T>& velocity,
                         VectorField<T>& force) {
  Kernel& k = *kernel_;
  workers_.forBands(layout_.rows, [&](int first, int last, int thread) {
    RowTask<T> task = k.task;
    task.stage = stage;
    task.finish = k.finish(Update::Store);
    task.position = position.x(), task.velocity = velocity.x(), task.force = force.x();
    task.scratch = k.cleanScratch(thread);
    for (int row = std::max(0, first - 2); row < last; ++row) task.stage(task, row, row >= first);
  });
  for (const PushedParticle& push : pushes_) {
    force.x()[push.at] += T(push.force.x);
    force.y()[push.at] += T(push.force.y);
    force.z()[push.at] += T(push.force.z);
  }
}

template <class T>
bool Forces<T>::canAdvance() const {
  return pushes_.empty() && !trackDissipation_;
}

template <class T>
void Forces<T>::kickAndDrift(State<T>& state, double h, int count) {
  RowTask<T> task = kernel_->task;
  task.finish = kernel_->finish(Update::KickAndDrift);
  task.velocity = state.velocity.x();
  task.kick = T(h * inverseMass_);
  advance(task, state, h, count);
}

template <class T>
void Forces<T>::leapfrog(State<T>& state, VectorField<T>& predicted, double h, int count) {
  RowTask<T> task = kernel_->task;
  task.finish = kernel_->finish(Update::Leapfrog);
  task.velocity = task.seen = predicted.x();
  task.kick = T(h / 2 * inverseMass_);
  advance(task, state, h, count);
}

/// Steps follow each other down the sheet: a step may finish a row once the step before has finished the two below it.
/// Steps in groups of kGroup stay within one thread's cache; groups are dealt out to the threads in turn.
template <class T>
template <class Task>
void Forces<T>::advance(Task task, State<T>& state, double h, int count) {
  Kernel& k = *kernel_;
  task.position = task.moving = state.position.x();
  task.kicked = state.velocity.x();
  task.step = T(h);
  account_.evaluations += count;
  const int rows = layout_.rows, groups = (count + kGroup - 1) / kGroup;
  for (int group = 0; group < groups; ++group) k.finished[std::size_t(group)].rows.store(0, std::memory_order_relaxed);
  workers_.forBands(workers_.threads(), [&](int first, int, int thread) {
    for (int group = first; group < groups; group += workers_.threads()) {
      const int steps = std::min(kGroup, count - group * kGroup), lag = 2 * (steps - 1);
      std::array<RowTask<T>, kGroup> tasks;
      for (int step = 0; step < steps; ++step) {
        tasks[std::size_t(step)] = task;
        tasks[std::size_t(step)].scratch = k.cleanScratch(thread * kGroup + step);
      }
      for (int front = 0; front < rows + lag; ++front) {
        if (group > 0) k.finished[std::size_t(group - 1)].await(std::min(front + 3, rows));
        for (int step = 0; step < steps; ++step) {
          const int row = front - 2 * step;
          if (row >= 0 && row < rows) tasks[std::size_t(step)].stage(tasks[std::size_t(step)], row, true);
        }
        k.finished[std::size_t(group)].rows.store(front - lag + 1, std::memory_order_release);
      }
    }
  });
}

template <class T>
void Forces<T>::measurePower(const VectorField<T>& position, const VectorField<T>& velocity) {
  if (trackDissipation_) account_.power = lossPower(position, velocity);
}

template <class T>
const T* Forces<T>::freeMask() const {
  return kernel_->isFree.data();
}

template <class T>
void Forces<T>::addPush(int particle, const Vec3& force) {
  const std::ptrdiff_t at = layout_.at(particle);
  if (kernel_->isFree[static_cast<std::size_t>(at)] != T(0)) pushes_.push_back({at, force});
}

template <class T>
StoredEnergy Forces<T>::energy(const State<T>& state) const {
  Kernel& k = *kernel_;
  workers_.forBands(layout_.rows, [&](int first, int last, int) {
    EnergyRow<T> row = k.energyRow;
    row.position = state.position.x(), row.velocity = state.velocity.x();
    for (row.row = first; row.row < last; ++row.row) {
      k.rowEnergies[static_cast<std::size_t>(row.row)] = k.kernels.energy(row);
    }
  });
  StoredEnergy sum;
  for (const RowEnergy& row : k.rowEnergies) {
    sum.kinetic += k.particleMass * row.kinetic;
    sum.elastic += row.elastic;
    sum.gravitational -= row.fallen;
    sum.maxStretch = std::max(sum.maxStretch, row.maxStretch);
  }
  return sum;
}

template <class T>
double Forces<T>::lossPower(const VectorField<T>& position, const VectorField<T>& velocity) const {
  Kernel& k = *kernel_;
  const auto damps = [](const auto& family) { return family.kd > 0; };
  if (k.energyRow.drag <= 0 && std::ranges::none_of(k.energyRow.families, damps)) return 0;
  workers_.forBands(layout_.rows, [&](int first, int last, int) {
    EnergyRow<T> row = k.energyRow;
    row.position = position.x(), row.velocity = velocity.x();
    for (row.row = first; row.row < last; ++row.row) {
      k.rowEnergies[static_cast<std::size_t>(row.row)] = k.kernels.power(row);
    }
  });
  double power = 0;
  for (const RowEnergy& row : k.rowEnergies) power += row.power;
  return power;
}

template class Forces<float>;
template class Forces<double>;

}  // namespace tyg
