// Boost.Odeint's classical Runge-Kutta method, with the list of springs and with Tyg's forces.
#include <boost/numeric/odeint/stepper/runge_kutta4.hpp>

#include "core/forces/forces.h"
#include "peers.h"
#include "study/motion/error.h"
#include "tyg/methods.h"
#include "util/workers.h"

namespace tyg::peers {
namespace {

/// What Odeint does number by number, on Tyg's states.
struct StateAlgebra {
  template <class Op, class First, class... States>
  static void forNumbers(Op op, First& first, States&... states) {
    const std::ptrdiff_t numbers = 3 * first.position.layout().plane;
    for (std::ptrdiff_t i = 0; i < numbers; ++i) op(first.position.x()[i], states.position.x()[i]...);
    for (std::ptrdiff_t i = 0; i < numbers; ++i) op(first.velocity.x()[i], states.velocity.x()[i]...);
  }
  template <class A, class B, class C, class Op>
  static void for_each3(A& a, B& b, C& c, Op op) {
    forNumbers(op, a, b, c);
  }
  template <class A, class B, class C, class D, class Op>
  static void for_each4(A& a, B& b, C& c, D& d, Op op) {
    forNumbers(op, a, b, c, d);
  }
  template <class A, class B, class C, class D, class E, class Op>
  static void for_each5(A& a, B& b, C& c, D& d, E& e, Op op) {
    forNumbers(op, a, b, c, d, e);
  }
  template <class A, class B, class C, class D, class E, class F, class Op>
  static void for_each6(A& a, B& b, C& c, D& d, E& e, F& f, Op op) {
    forNumbers(op, a, b, c, d, e, f);
  }
};

}  // namespace
}  // namespace tyg::peers

namespace boost::numeric::odeint {
template <>
struct is_resizeable<tyg::State<double>> : boost::true_type {};
template <>
struct same_size_impl<tyg::State<double>, tyg::State<double>> {
  static bool same_size(const tyg::State<double>& a, const tyg::State<double>& b) {
    return a.position.layout() == b.position.layout();
  }
};
template <>
struct resize_impl<tyg::State<double>, tyg::State<double>> {
  static void resize(tyg::State<double>& a, const tyg::State<double>& b) {
    a = tyg::State<double>(b.position.layout());
  }
};
}  // namespace boost::numeric::odeint

namespace tyg::peers {
namespace {

namespace odeint = boost::numeric::odeint;

class OdeintWithSpringList {
 public:
  explicit OdeintWithSpringList(const Scene& scene) : springs_(scene), y_(springs_.start()) {}
  void step() {
    stepper_.do_step([this](const Numbers& y, Numbers& dy, double) { springs_(y.data(), dy.data()); }, y_, 0, kStep);
  }
  [[nodiscard]] std::vector<Vec3> positions() const { return SpringList::positionsOf(y_); }

 private:
  using Numbers = std::vector<double>;
  SpringList springs_;
  Numbers y_;
  odeint::runge_kutta4<Numbers> stepper_;
};

class OdeintWithTygsForces {
 public:
  explicit OdeintWithTygsForces(const Scene& scene)
      : sheet_(makeSheet(scene)), forces_(scene, sheet_, workers_), state_(startState<double>(sheet_)) {}
  void step() {
    const auto system = [this](const State<double>& y, State<double>& dy, double) {
      dy.position = y.velocity;
      forces_.evaluate(0, y.position, y.velocity, dy.velocity);
      const double inverseMass = forces_.inverseMass();
      double* const v = dy.velocity.x();
      for (std::ptrdiff_t i = 0; i < 3 * sheetPlane(); ++i) v[i] *= inverseMass;
    };
    stepper_.do_step(system, state_, 0, kStep);
  }
  [[nodiscard]] std::vector<Vec3> positions() const {
    std::vector<Vec3> positions;
    for (int particle = 0; particle < sheet_.count(); ++particle) positions.push_back(state_.position.get(particle));
    return positions;
  }

 private:
  [[nodiscard]] std::ptrdiff_t sheetPlane() const { return forces_.layout().plane; }
  Workers workers_{1};
  Sheet sheet_;
  Forces<double> forces_;
  State<double> state_;
  odeint::runge_kutta4<State<double>, double, State<double>, double, StateAlgebra> stepper_;
};

/// Distance from our own motion over the sheet's size, after some steps.
template <class Peer>
double distanceFromOurs(const Scene& scene) {
  constexpr int kSteps = 200;
  Peer peer(scene);
  for (int k = 0; k < kSteps; ++k) peer.step();
  Simulation ours(scene, findMethod("rk4"), {.threads = 1});
  ours.advanceTo(kSteps * kStep);
  return distanceBetween(peer.positions(), positionsOf(ours)).rms / ours.sheet().size();
}

template <class Peer>
void steps(benchmark::State& state) {
  const Scene scene = curtain(kCount, Precision::Double);
  static const double kApart = distanceFromOurs<Peer>(scene);
  Peer peer(scene);
  for (auto _ : state) {
    for (int k = 0; k < kStepsPerRound; ++k) peer.step();
  }
  reportPerParticle(state);
  state.counters["from_ours"] = kApart;
}

}  // namespace

void addOdeint() {
  benchmark::RegisterBenchmark("odeint/rk4/list_of_springs", steps<OdeintWithSpringList>);
  benchmark::RegisterBenchmark("odeint/rk4/forces_of_tyg", steps<OdeintWithTygsForces>);
  comparisons().push_back({"odeint/rk4/list_of_springs", "tyg/rk4/double", 4.5});
  comparisons().push_back({"odeint/rk4/forces_of_tyg", "tyg/rk4/double", 1});
}

}  // namespace tyg::peers
