// Follows modes by restarted Lanczos iterations; products with the matrices are differences of the force.
#include "core/spectrum/live_spectrum.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/forces/field_ops.h"
#include "core/forces/term.h"
#include "core/forces/terms/contact.h"
#include "util/noise.h"

namespace tyg {
namespace {

/// Random directions that every call adds, as a share of the mode's length: a mode that the present one does not
/// touch, as those out of a flat sheet's plane, is found soon; the eigenvalue feels the square.
constexpr double kMixed = 0.01;
constexpr double kNothingNew = 1e-4;  // of a product outside the earlier ones: what is left is rounding

/// The springs, what resists particles and what holds them: steady forces do not depend on the state, and air and
/// friction are counted apart.
Scene withoutAir(Scene scene) {
  scene = withoutSteadyForce(std::move(scene));
  scene.contact.friction = 0;
  for (const ForceTerm* term : forceTerms()) {
    if (term->cellDamping != nullptr) leaveOut(scene, *term);
  }
  return scene;
}

/// Where it is at a time, at rest: the damping of a motion counts from there.
BodyMotion stoppedAt(const BodyMotion& motion, double time) {
  return {{motion.offset.x + time * motion.velocity.x, motion.offset.y + time * motion.velocity.y,
           motion.offset.z + time * motion.velocity.z},
          {}};
}

/// Of all waves of the sheet at rest, 1/s.
double mostDampedOf(const Lattice& lattice) {
  return extremeWave(lattice, [](const Mode& mode) { return mode.d; }).mode.d;
}

}  // namespace

template <class T>
LiveSpectrum<T>::LiveSpectrum(const Scene& scene, const Sheet& sheet, Workers& workers)
    : layout_(sheet),
      mass_(sheet.particleMass),
      // A difference errs by its reach, through the curvature of the force, and by rounding over its reach.
      reach_((sizeof(T) == sizeof(float) ? 1e-3 : 1e-6) * sheet.spacing),
      law_(scene.damping),
      lattice_(scene),
      forces_(withoutAir(scene), sheet, workers),
      ofRow_(std::size_t(layout_.rows)) {
  for (Follower& follower : followers_) follower.direction = VectorField<T>(layout_);
  for (VectorField<T>* field : {&force_, &position_, &velocity_}) *field = VectorField<T>(layout_);
  for (VectorField<T>& field : basis_) field = VectorField<T>(layout_);
  for (VectorField<T>& field : image_) field = VectorField<T>(layout_);
  countApart(scene);
  const bool flat = scene.start == Start::Flat;
  along_[kStiff] = flat ? Vec3{1, 0, 0.7} : Vec3{1, 0.7, 0};
  along_[kDamped] = law_ == Damping::Axial ? along_[kStiff] : flat ? Vec3{0.1, 1, 0.1} : Vec3{0.1, 0.1, 1};
}

template <class T>
void LiveSpectrum<T>::useParameters(const Scene& scene) {
  forces_.useParameters(withoutAir(scene));
  lattice_ = Lattice(scene);
  countApart(scene);
  isStarted_ = false;
  turn_ = kStiff;
  seed_ = kFirstSeed;
}

template <class T>
void LiveSpectrum<T>::countApart(const Scene& scene) {
  const ParticleHold hold = holdingTerm(scene).hold;
  mostDamped_ = mostDampedOf(lattice_) + hold.damping / mass_;
  ofAir_ = cellDamping(scene) / mass_;
  ofFriction_ = hold.across / mass_;
  held_ = {hold.stiffness / mass_, hold.damping / mass_};
}

/// s: of a single particle that touches something, where the method treats that damping in another way than what the
/// followed modes have; else infinite.
template <class T>
double LiveSpectrum<T>::limitOfTouching(const Method& method) const {
  if (method.stableStepWhereHeld == nullptr) return std::numeric_limits<double>::infinity();
  return std::min(method.stableStepWhereHeld(held_.w2, held_.d), method.stableStepWhereHeld(0, ofFriction_));
}

/// From the wave that sets the limit of the sheet at rest, fading towards the edges as the modes of a free sheet do.
template <class T>
void LiveSpectrum<T>::start(const Method& method, bool both) {
  isStarted_ = true;
  const auto stiffness = [](const Mode& mode) { return mode.w2; };
  const auto damping = [](const Mode& mode) { return mode.d; };
  const auto limit = [&](const Mode& mode) {
    return mode.w2 > 0 || mode.d > 0 ? -method.stableStep(mode.w2, mode.d) : -std::numeric_limits<double>::infinity();
  };
  startFrom(kStiff, both ? extremeWave(lattice_, stiffness) : extremeWave(lattice_, limit));
  startFrom(kDamped, extremeWave(lattice_, damping));
  if (law_ == Damping::Relative) followers_[kDamped].mode.w2 = 0;  // out of plane
}

template <class T>
void LiveSpectrum<T>::startFrom(Which which, const LatticeWave& wave) {
  const auto fading = [](int k, int count) { return std::sin(std::numbers::pi * (k + 0.5) / count); };
  Follower& follower = followers_[which];
  follower.mode = wave.mode;
  for (int row = 0; row < layout_.rows; ++row) {
    for (int column = 0; column < layout_.columns; ++column) {
      constexpr double kPhase = 0.4;  // a wave of two or four particles stands still on none of them
      const double height = std::cos(wave.qx * column + wave.qy * row + kPhase) * fading(column, layout_.columns) *
                            fading(row, layout_.rows);
      const Vec3& along = along_[which];
      follower.direction.set(row * layout_.columns + column, {height * along.x, height * along.y, height * along.z});
    }
  }
}

template <class T>
double LiveSpectrum<T>::stableStep(const Method& method, const State<T>& state, double time) {
  time_ = time;
  for (BodyMotion& motion : acting_.bodies) motion = stoppedAt(motion, time);
  forces_.act(acting_);
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (method.stableStep == nullptr) return kNone;
  const bool both = !hasStraightLevelLines(method, mostDamped_);
  if (!isStarted_) start(method, both);
  if (!follow(method, both ? turn_ : kStiff, state)) return kNone;
  turn_ = turn_ == kStiff ? kDamped : kStiff;
  const bool isHeld = held_.w2 > 0 && touches(state);
  const double apart = ofAir_ + (isHeld ? ofFriction_ : 0);
  const auto limit = [&](Which which) {
    const Mode& mode = followers_[which].mode;
    if (!(mode.w2 > 0 || mode.d > 0)) return std::numeric_limits<double>::infinity();
    const double still = method.stableStep(mode.w2, mode.d);
    return apart > 0 ? std::min(still, method.stableStep(mode.w2, mode.d + apart)) : still;
  };
  const double followed = both ? std::min(limit(kStiff), limit(kDamped)) : limit(kStiff);
  return isHeld ? std::min(followed, limitOfTouching(method)) : followed;
}

/// Whether any particle touches a body.
template <class T>
bool LiveSpectrum<T>::touches(const State<T>& state) const {
  return forces_.energy(time_, state).template of<ContactTerm>() > 0;
}

template <class T>
bool LiveSpectrum<T>::follow(const Method& method, Which which, const State<T>& state) {
  Follower& follower = followers_[which];
  const LineNormal weights =
      which == kStiff ? normalOfStiff(method, follower.mode) : normalOfDamped(method, follower.mode);
  forces_.evaluate(time_, state.position, state.velocity, force_);
  basis_[0] = follower.direction;
  mix(basis_[0]);
  // Lanczos, orthogonalised against all vectors: there are three.
  int size = 0;
  Eigen::Matrix<double, kProducts, kProducts> small = decltype(small)::Zero();
  for (; size < kProducts; ++size) {
    VectorField<T>& u = basis_[std::size_t(size)];
    const double before = std::sqrt(dot(u, u));
    for (int k = 0; k < size; ++k) add(u, 1, -dot(u, basis_[std::size_t(k)]), basis_[std::size_t(k)]);
    const double length = std::sqrt(dot(u, u));
    if (!(length > kNothingNew * before)) break;
    add(u, 1 / length, 0, u);
    VectorField<T>& image = image_[std::size_t(size)];
    product(weights, state, u, image);
    for (int k = 0; k <= size; ++k) small(size, k) = dot(basis_[std::size_t(k)], image);
    if (size + 1 < kProducts) basis_[std::size_t(size + 1)] = image;
  }
  if (!small.allFinite()) return false;
  // Of the symmetric part: only axial damping of a moving sheet has another.
  const Eigen::SelfAdjointEigenSolver<decltype(small)> eigen(small, Eigen::ComputeEigenvectors);
  const int last = kProducts - 1;
  const bool upper = which == kDamped || eigen.eigenvalues()[last] >= -eigen.eigenvalues()[0];
  const int chosen = upper ? last : 0;
  add(follower.direction, 0, eigen.eigenvectors()(0, chosen), basis_[0]);
  for (int k = 1; k < size; ++k) add(follower.direction, 1, eigen.eigenvectors()(k, chosen), basis_[std::size_t(k)]);
  const double value = eigen.eigenvalues()[chosen], d = dampingOf(state, follower.direction);
  follower.mode.d = d;
  follower.mode.w2 = weights.ofK == 0 ? 0 : std::max(0.0, (std::abs(value) - weights.ofC * d) / weights.ofK);
  return true;
}

/// result = (a K + b C) u = -(a(x + e a u, v + e b u) - a(x, v)) / e
template <class T>
void LiveSpectrum<T>::product(const LineNormal& weights, const State<T>& state, const VectorField<T>& u,
                              VectorField<T>& result) {
  const double scale = weights.ofK != 0 ? std::abs(weights.ofK) : std::abs(weights.ofC);
  const double e = reach_ / (scale * largest(u));
  const T moved = T(e * weights.ofK), sped = T(e * weights.ofC), divided = T(-1 / (e * mass_));
  const T *x = state.position.x(), *v = state.velocity.x(), *from = u.x();
  T *toX = position_.x(), *toV = velocity_.x();
  forNumbers(forces_.workers(), layout_, [=](std::ptrdiff_t i) {
    toX[i] = x[i] + moved * from[i];
    toV[i] = v[i] + sped * from[i];
  });
  forces_.evaluate(time_, position_, velocity_, result);
  T* to = result.x();
  const T* f = force_.x();
  forNumbers(forces_.workers(), layout_, [=](std::ptrdiff_t i) { to[i] = divided * (to[i] - f[i]); });
}

/// Scales to unit length, adds noise, and holds the pinned particles.
template <class T>
void LiveSpectrum<T>::mix(VectorField<T>& direction) {
  const double length = std::sqrt(dot(direction, direction));
  if (length > 0) add(direction, 1 / length, 0, direction);
  const double height = kMixed / std::sqrt(double(layout_.columns) * layout_.rows);
  const T* isFree = forces_.freeMask();
  for (int axis = 0; axis < 3; ++axis) {
    T* u = direction.x() + axis * layout_.plane;
    for (int row = 0; row < layout_.rows; ++row) {
      for (std::ptrdiff_t i = row * layout_.stride; i < row * layout_.stride + layout_.columns; ++i) {
        u[i] = isFree[i] * (u[i] + T(height * noise(seed_)));
      }
    }
  }
}

/// u.Cu of a unit direction: the power that damping takes at the velocity u, over the mass.
template <class T>
double LiveSpectrum<T>::dampingOf(const State<T>& state, const VectorField<T>& u) {
  if (mostDamped_ == 0) return 0;
  forces_.trackDissipation(true);
  forces_.measurePower(time_, state.position, u);
  forces_.trackDissipation(false);
  return forces_.power().lost / mass_;
}

template <class T>
double LiveSpectrum<T>::dot(const VectorField<T>& a, const VectorField<T>& b) {
  forces_.workers().forBands(layout_.rows, [&](int first, int last, int) {
    for (int row = first; row < last; ++row) {
      double sum = 0;
      for (int axis = 0; axis < 3; ++axis) {
        const T *p = a.x() + axis * layout_.plane + row * layout_.stride,
                *q = b.x() + axis * layout_.plane + row * layout_.stride;
        for (int column = 0; column < layout_.columns; ++column) sum += double(p[column]) * double(q[column]);
      }
      ofRow_[std::size_t(row)] = sum;
    }
  });
  double sum = 0;
  for (const double row : ofRow_) sum += row;
  return sum;
}

template <class T>
double LiveSpectrum<T>::largest(const VectorField<T>& a) {
  const T* u = a.x();
  T most = 0;
  for (std::ptrdiff_t i = 0; i < 3 * layout_.plane; ++i) most = std::max(most, std::abs(u[i]));
  return double(most);
}

template <class T>
void LiveSpectrum<T>::add(VectorField<T>& to, double keep, double factor, const VectorField<T>& from) {
  const T kept = T(keep), added = T(factor);
  T* sum = to.x();
  const T* more = from.x();
  forNumbers(forces_.workers(), layout_, [=](std::ptrdiff_t i) { sum[i] = kept * sum[i] + added * more[i]; });
}

template class LiveSpectrum<float>;
template class LiveSpectrum<double>;

}  // namespace tyg
