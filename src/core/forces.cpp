// Sets up the row kernels for a scene and shares the rows out over threads.
#include "tyg/forces.h"

#include <algorithm>

#include "core/row_kernel.h"
#include "tyg/workers.h"

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
  for (int particle = 0; particle < sheet.count(); ++particle) mask[static_cast<std::size_t>(layout.at(particle))] = T(1);
  for (const int pin : sheet.pins) mask[static_cast<std::size_t>(layout.at(pin))] = T(0);
  return mask;
}

}  // namespace

template <class T>
struct Forces<T>::Kernel {
  const RowKernels<T>& kernels = rowKernels<T>();
  void (*forcesOfBand)(const RowBand<T>&) = nullptr;
  RowBand<T> band;       // all that does not change from call to call
  EnergyRow<T> energyRow;
  AlignedVector<T> hasRight, hasRight2, isFree;
  std::vector<AlignedVector<T>> scratch;  // per thread
  std::vector<RowEnergy> rowEnergies;     // per row
  double particleMass = 0;
};

template <class T>
Forces<T>::Forces(const Scene& scene, const Sheet& sheet, Workers& workers)
    : layout_(sheet),
      workers_(workers),
      inverseMass_(1.0 / sheet.particleMass),
      kernel_(std::make_unique<Kernel>()) {
  Kernel& k = *kernel_;
  k.forcesOfBand = k.kernels.forces[familiesOf(scene)][int(dampingOf(scene))];
  k.hasRight = columnMask<T>(layout_, 1);
  k.hasRight2 = columnMask<T>(layout_, 2);
  k.isFree = maskOfFree<T>(layout_, sheet);
  k.scratch.assign(static_cast<std::size_t>(workers.threads()), AlignedVector<T>(rowScratchSize(layout_.stride)));
  k.rowEnergies.resize(static_cast<std::size_t>(layout_.rows));
  k.particleMass = sheet.particleMass;

  RowBand<T>& band = k.band;
  constexpr int kVector = 64 / sizeof(T);  // numbers in the widest vector register
  band.width = (layout_.columns + kVector - 1) / kVector * kVector;
  band.rows = layout_.rows;
  band.stride = layout_.stride, band.plane = layout_.plane;
  band.hasRight = k.hasRight.data(), band.hasRight2 = k.hasRight2.data(), band.isFree = k.isFree.data();
  const double rest[] = {restLength(sheet, Family::Structural), restLength(sheet, Family::Shear),
                         restLength(sheet, Family::Bend)};
  band.structural = lawOf<T>(scene.structural, rest[0]);
  band.shear = lawOf<T>(scene.shear, rest[1]);
  band.bend = lawOf<T>(scene.bend, rest[2]);
  band.drag = T(scene.drag);

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
    band.weight[axis] = T(row.weight[axis]);
  }
}

template <class T>
Forces<T>::~Forces() = default;

template <class T>
void Forces<T>::evaluate(const VectorField<T>& position, const VectorField<T>& velocity, VectorField<T>& force) {
  runKernel(kernel_->forcesOfBand, position, velocity, force);
  ++account_.evaluations;
  measurePower(position, velocity);
}

template <class T>
void Forces<T>::evaluateWithoutSprings(const VectorField<T>& position, const VectorField<T>& velocity,
                                       VectorField<T>& force) {
  runKernel(kernel_->kernels.forces[0][int(DampingTerm::None)], position, velocity, force);
}

template <class T>
template <class BandKernel>
void Forces<T>::runKernel(BandKernel forcesOfBand, const VectorField<T>& position, const VectorField<T>& velocity,
                          VectorField<T>& force) {
  Kernel& k = *kernel_;
  workers_.forBands(layout_.rows, [&](int first, int last, int thread) {
    RowBand<T> band = k.band;
    band.first = first, band.last = last;
    band.position = position.x(), band.velocity = velocity.x(), band.force = force.x();
    band.scratch = k.scratch[static_cast<std::size_t>(thread)].data();
    forcesOfBand(band);
  });
  for (const PushedParticle& push : pushes_) {
    force.x()[push.at] += T(push.force.x);
    force.y()[push.at] += T(push.force.y);
    force.z()[push.at] += T(push.force.z);
  }
}

template <class T>
void Forces<T>::measurePower(const VectorField<T>& position, const VectorField<T>& velocity) {
  if (trackDissipation_) account_.power = dampingPower(position, velocity);
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
double Forces<T>::dampingPower(const VectorField<T>& position, const VectorField<T>& velocity) const {
  Kernel& k = *kernel_;
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
