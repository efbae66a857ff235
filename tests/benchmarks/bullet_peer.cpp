// Bullet's soft body with the same particles and links, in its default settings. What this comparison leaves out:
// Bullet moves links towards their rest length by a solver's sweeps instead of forces, so its cloth has neither our
// stiffness nor our damping, but bears steps of 1/60 s; and its step looks for contacts and supports rigid bodies, wind
// and volume, which stand empty here. Its motion therefore differs from ours by far more than an integrator's error.
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>

#include "peers.h"
#include "study/motion/error.h"
#include "tyg/methods.h"

namespace tyg::peers {
namespace {

constexpr double kBulletStep = 1.0 / 60;  // s, Bullet's own

btVector3 toBullet(const Vec3& v) { return {btScalar(v.x), btScalar(v.y), btScalar(v.z)}; }

class BulletSheet {
 public:
  explicit BulletSheet(const Scene& scene) : sheet_(makeSheet(scene)) {
    world_.setGravity(toBullet(scene.gravity));
    world_.getWorldInfo().m_gravity = toBullet(scene.gravity);
    std::vector<btVector3> places;
    for (int particle = 0; particle < sheet_.count(); ++particle) {
      places.push_back(toBullet(sheet_.startPosition(particle)));
    }
    const std::vector<btScalar> masses(places.size(), btScalar(sheet_.particleMass));
    body_ = new btSoftBody(&world_.getWorldInfo(), sheet_.count(), places.data(), masses.data());
    for (const int pin : sheet_.pins) body_->setMass(pin, 0);
    for (const Family family : {Family::Structural, Family::Shear, Family::Bend}) {
      for (const SpringEnds& ends : springsOf(sheet_, family)) body_->appendLink(ends.first, ends.second);
    }
    world_.addSoftBody(body_);
  }
  ~BulletSheet() {
    world_.removeSoftBody(body_);
    delete body_;
  }
  BulletSheet(const BulletSheet&) = delete;
  BulletSheet& operator=(const BulletSheet&) = delete;

  void step(double h = kBulletStep) { world_.stepSimulation(btScalar(h), 0); }
  [[nodiscard]] std::vector<Vec3> positions() const {
    std::vector<Vec3> positions;
    for (int particle = 0; particle < sheet_.count(); ++particle) {
      const btVector3& x = body_->m_nodes[particle].m_x;
      positions.push_back({x.x(), x.y(), x.z()});
    }
    return positions;
  }

 private:
  Sheet sheet_;
  btSoftBodyRigidBodyCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver rigidBodies_;
  btSoftRigidDynamicsWorld world_{&dispatcher_, &broadphase_, &rigidBodies_, &configuration_};
  btSoftBody* body_ = nullptr;
};

/// Distance from our own motion over the sheet's size after a second of so many steps.
double distanceFromOurs(int steps) {
  const Scene scene = curtain(20, Precision::Double);
  BulletSheet bullet(scene);
  for (int k = 0; k < steps; ++k) bullet.step(1.0 / steps);
  Simulation ours(scene, findMethod("leapfrog"), {.threads = 1});
  ours.advanceTo(1);
  return distanceBetween(bullet.positions(), positionsOf(ours)).rms / ours.sheet().size();
}

void steps(benchmark::State& state) {
  static const double kApart = distanceFromOurs(60), kApartInSmallSteps = distanceFromOurs(6000);
  BulletSheet bullet(curtain(kCount, Precision::Float));
  for (auto _ : state) {
    for (int k = 0; k < kStepsPerRound; ++k) bullet.step();
  }
  reportPerParticle(state);
  state.counters["from_ours"] = kApart;
  state.counters["in_small_steps"] = kApartInSmallSteps;
}

}  // namespace

void addBullet() {
  benchmark::RegisterBenchmark("bullet/soft_body", steps);
  comparisons().push_back({"bullet/soft_body", "tyg/symplectic-euler/float", 50});
}

}  // namespace tyg::peers
