// What each term of the model, and what is followed beside it, adds to a step: leapfrog on 256x256 particles.
#include <cstdio>
#include <memory>
#include <sstream>

#include "core/simulation/integrator.h"
#include "scaling.h"
#include "tyg/methods.h"
#include "util/whole_file.h"
#include "util/workers.h"

namespace tyg::scaling {
namespace {

constexpr double kStep = 1e-4;
constexpr int kSteps = 64, kCount = 256;

Scene curtain() {
  Scene scene = loadScene("curtain");
  scene.columns = scene.rows = kCount;
  scene.integrator = "leapfrog";
  scene.dt = kStep;
  return scene;
}

void withoutDamping(Scene& scene) { scene.structural.kd = scene.shear.kd = scene.bend.kd = 0; }

/// A floor this far below the sheet, which lies flat, m.
void addPlane(Scene& scene, double below) {
  scene.start = Start::Flat;
  scene.bodies.push_back({.shape = Shape::Plane, .at = {0, -below, 0}});
  fillContact(scene);
}
/// A ball whose top touches the sheet and whose box holds all of it.
void addBall(Scene& scene) {
  constexpr double kRadius = 100;  // m
  scene.start = Start::Flat;
  scene.bodies.push_back({.shape = Shape::Ball, .at = {0, 5e-4 - kRadius, 0}, .radius = kRadius});
  fillContact(scene);
}
void addWind(Scene& scene) {
  scene.air.density = 1.2;
  scene.winds = {{.velocity = {4, 0, 1}}};
}

void cutAcross(Scene& scene) { scene.cuts = {{{-1, kCount / 2 + 0.3, kCount, kCount / 2 + 0.3}, 0}}; }
/// From top to bottom: something of every row is gone.
void cutDown(Scene& scene) { scene.cuts = {{{kCount / 2 + 0.3, -1, kCount / 2 + 0.3, kCount}, 0}}; }

/// A change of the curtain, and what is followed beside its motion.
struct Variant {
  const char* name;
  void (*change)(Scene& scene) = [](Scene&) {};
  bool ledger = false;
  bool alarm = true;
};

constexpr Variant kVariants[] = {
    {"all families, relative damping, alarm"},
    {"without the alarm", [](Scene&) {}, false, false},
    {"without bend springs", [](Scene& s) { s.bend = {}; }},
    {"structural springs alone", [](Scene& s) { s.bend = s.shear = {}; }},
    {"structural springs alone, no damping", [](Scene& s) { s.bend = s.shear = {}, s.structural.kd = 0; }},
    {"no damping", withoutDamping},
    {"axial damping", [](Scene& s) { s.damping = Damping::Axial; }},
    {"drag", [](Scene& s) { s.drag = 1e-4; }},
    {"still air", [](Scene& s) { s.air.density = 1.2; }},
    {"a steady wind", addWind},
    {"a wind with gusts",
     [](Scene& s) {
       s.air.density = 1.2;
       s.winds = {{.velocity = {4, 0, 1}, .gust = {1, 0, 2}, .wavelength = 1.5}};
     }},
    {"a plane far away", [](Scene& s) { addPlane(s, 10); }},
    {"lying flat", [](Scene& s) { s.start = Start::Flat; }},
    {"a plane", [](Scene& s) { addPlane(s, -1e-3); }},
    {"a plane with friction", [](Scene& s) { s.contact.friction = 0.5, addPlane(s, -1e-3); }},
    {"the same without the alarm", [](Scene& s) { s.contact.friction = 0.5, addPlane(s, -1e-3); }, false, false},
    {"a ball with friction", [](Scene& s) { s.contact.friction = 0.5, addBall(s); }},
    {"wind, a plane and a ball, friction",
     [](Scene& s) {
       addWind(s), addBall(s);
       s.contact.friction = 0.5, addPlane(s, -1e-3);
     }},
    {"a push acting",
     [](Scene& s) {
       s.pushes = {{{"middle"}, {0, 0, 1e-3}, 0, 1e6}};
     }},
    {"one cut across", cutAcross},
    {"every row masked by a cut", cutDown},
    {"ledger", [](Scene&) {}, true},
};

/// The method without a simulation around it: forces and steps, and no energy checks.
template <class T>
struct Bare {
  explicit Bare(const Scene& scene)
      : sheet(makeSheet(scene)),
        forces(scene, sheet, workers),
        state(startState<T>(sheet)),
        method(findMethod(scene.integrator).make<T>(scene, sheet)) {}
  Workers workers{1};
  Sheet sheet;
  Forces<T> forces;
  State<T> state;
  std::unique_ptr<Integrator<T>> method;
};

template <class T>
std::function<void()> bareSteps(const Scene& scene) {
  return [bare = std::make_shared<Bare<T>>(scene)] {
    bare->method->steps(bare->forces, bare->state, {0, 0, kStep}, kSteps);
  };
}

std::function<void()> stepsOf(const Variant& variant, Precision precision) {
  Scene scene = curtain();
  scene.precision = precision;
  variant.change(scene);
  if (!variant.alarm) return precision == Precision::Float ? bareSteps<float>(scene) : bareSteps<double>(scene);
  auto simulation = std::make_shared<Simulation>(scene, findMethod(scene.integrator),
                                                 Settings{.threads = 1, .ledger = variant.ledger});
  return [simulation] { simulation->tick(kSteps); };
}

}  // namespace

void measureTerms(const Options& options) {
  say("terms ...");
  std::vector<Contestant> contestants;
  for (const Variant& variant : kVariants) {
    for (const Precision precision : {Precision::Float, Precision::Double}) {
      contestants.push_back({stepsOf(variant, precision)});
    }
  }
  takeTurns(contestants, options.quick ? 3 : 25);
  std::ostringstream csv;
  csv << "variant,float_ns,double_ns\n";
  std::printf(
      "\nleapfrog on %dx%d, one thread: ns per particle and step, and against the first line\n%-40s %16s %16s\n",
      kCount, kCount, "", "float", "double");
  const auto ns = [&](std::size_t k) { return 1e9 * contestants[k].least / (double(kSteps) * kCount * kCount); };
  for (std::size_t k = 0; k < std::size(kVariants); ++k) {
    const double single = ns(2 * k), wide = ns(2 * k + 1);
    std::printf("%-40s %7.2f (%+4.0f %%) %7.2f (%+4.0f %%)\n", kVariants[k].name, single, 100 * (single / ns(0) - 1),
                wide, 100 * (wide / ns(1) - 1));
    csv << '"' << kVariants[k].name << "\"," << single << "," << wide << "\n";
  }
  writeWholeFile(options.out / "terms.csv", csv.str());
}

}  // namespace tyg::scaling
