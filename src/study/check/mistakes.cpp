// The table. An entry is an edit of the scene where a scene can be as wrong as that, else a habit of the program.
#include "study/check/mistakes.h"

#include <array>

#include "core/scene/scene_range.h"

namespace tyg {
namespace {

using Kind = Mistake::Kind;

Vec3 times(double factor, const Vec3& v) { return {factor * v.x, factor * v.y, factor * v.z}; }
double countOf(const Scene& scene) { return double(scene.columns) * scene.rows; }

template <class Change>
void eachFamily(Scene& scene, const Change& change) {
  for (SpringFamily* family : {&scene.structural, &scene.shear, &scene.bend}) change(*family);
}

/// Where two of them are made at once, the first is made first: kd is what the scene says when it is turned into drag.
constexpr std::array kTable = {
    Mistake{"gravity left out", "without gravity", "Add m g to the force on every particle.", Kind::Gravity,
            [](Scene& s) { s.gravity = {}; }},
    Mistake{"gravity doubled", "with gravity doubled", "Add m g to the force on a particle once, not in two places.",
            Kind::Gravity, [](Scene& s) { s.gravity = times(2, s.gravity); }},
    Mistake{"gravity reversed", "with gravity reversed", "Let gravity point downwards: y is up, so that g is negative.",
            Kind::Gravity, [](Scene& s) { s.gravity = times(-1, s.gravity); }},
    Mistake{"gravity not multiplied by the mass", "with g instead of m g as the force of gravity",
            "Multiply g by the mass before it is added to the forces.", Kind::Gravity,
            [](Scene& s) { s.gravity = times(1 / s.particleMass, s.gravity); }},
    Mistake{"mass per sheet instead of per particle", "with the mass of the whole sheet in every particle",
            "Give every particle its own mass, not that of the sheet.", Kind::Mass,
            [](Scene& s) { s.particleMass *= countOf(s); }},
    Mistake{
        "mass of a particle shared by the sheet", "with the mass of one particle divided among all",
        "Do not divide the mass by the number of particles: the number that you were given is that of one particle.",
        Kind::Mass, [](Scene& s) { s.particleMass /= countOf(s); }},
    Mistake{"mass in grams instead of kilograms", "with a mass that is a thousand times as large",
            "Give the mass in kilograms, not in grams.", Kind::Mass, [](Scene& s) { s.particleMass *= 1000; }},
    Mistake{"damping left out", "without the springs' damping",
            "Subtract kd times the relative velocity of its ends from "
            "the force of every spring.",
            Kind::Damping, [](Scene& s) { eachFamily(s, [](SpringFamily& f) { f.kd = 0; }); }},
    Mistake{"damping reversed", "with damping reversed",
            "Turn the sign of the damping around: it must slow the motion of the ends against each other.",
            Kind::Damping, nullptr, [](Habits& h) { h.dampingSign = -1; }},
    Mistake{"axial for relative damping", "with axial instead of relative damping",
            "Damp the whole relative velocity of the ends, not only its part along the spring.", Kind::Damping,
            [](Scene& s) { s.damping = Damping::Axial; }},
    Mistake{"relative for axial damping", "with relative instead of axial damping",
            "Damp only the part of the relative velocity that lies along the spring.", Kind::Damping,
            [](Scene& s) { s.damping = Damping::Relative; }},
    Mistake{"absolute for relative damping", "with each end damped by its own velocity",
            "Damp the velocity of the two ends against each other, not each end's own velocity.", Kind::Damping,
            nullptr, [](Habits& h) { h.absoluteDamping = true; }},
    Mistake{"damping as drag on every particle", "with kd as drag on the particles instead of damping in the springs",
            "Damp the springs by the velocity of their two ends against each other, not the particles against the air.",
            Kind::Damping,
            [](Scene& s) {
              s.drag += s.structural.kd;
              eachFamily(s, [](SpringFamily& f) { f.kd = 0; });
            }},
    Mistake{"each spring applied twice", "with every spring applied twice", "Apply each spring once to each end.",
            Kind::Count, [](Scene& s) { eachFamily(s, [](SpringFamily& f) { f.ks *= 2, f.kd *= 2; }); }},
    Mistake{"each spring applied to one end only", "with every spring applied to its first end only",
            "Apply each spring to both ends: the second end gets the opposite force.", Kind::Count, nullptr,
            [](Habits& h) { h.ends = Habits::Ends::First; }},
    Mistake{"each spring applied to its second end only", "with every spring applied to its second end only",
            "Apply each spring to both ends: the first end gets the opposite force.", Kind::Count, nullptr,
            [](Habits& h) { h.ends = Habits::Ends::Second; }},
    Mistake{"structural springs left out", "without structural springs",
            "Add the springs to the next particle of the row and of the column.", Kind::Structural,
            [](Scene& s) { s.structural = {}; }},
    Mistake{"shear springs left out", "without shear springs", "Add both diagonals of every cell.", Kind::Shear,
            [](Scene& s) { s.shear = {}; }},
    Mistake{"bend springs left out", "without bend springs",
            "Add the springs to the next particle but one of the row and of the column.", Kind::Bend,
            [](Scene& s) { s.bend = {}; }},
    Mistake{"shear rest length equal to the spacing", "with shear springs that rest at the spacing",
            "Let shear springs rest at the spacing times the root of 2.", Kind::Shear, nullptr,
            [](Habits& h) { h.shearRestsAtSpacing = true; }},
    Mistake{"bend rest length equal to the spacing", "with bend springs that rest at the spacing",
            "Let bend springs rest at twice the spacing.", Kind::Bend, nullptr,
            [](Habits& h) { h.bendRestsAtSpacing = true; }},
    Mistake{"pins left out", "without pins", "Give pinned particles no acceleration and no velocity.", Kind::Pins,
            [](Scene& s) { s.pins.clear(); }},
    Mistake{"pinned after the position was moved", "with pins that are stopped after they have moved",
            "Skip pinned particles before their position is moved, not after.", Kind::Pins, nullptr,
            [](Habits& h) { h.pins = Habits::Pins::StoppedAfterMove; }},
    Mistake{"pins put back with their velocity", "with pins that are put back but keep their velocity",
            "Give pinned particles no velocity: the damping of their neighbours sees it.", Kind::Pins, nullptr,
            [](Habits& h) { h.pins = Habits::Pins::PutBack; }},
    Mistake{"pins held only after the step", "with pins that move during the step's stages",
            "Hold pinned particles in every stage, not only after the step.", Kind::Pins, nullptr,
            [](Habits& h) { h.pins = Habits::Pins::HeldAfterStep; }},
    Mistake{"particles updated in place", "with each particle moved before its neighbours have read it",
            "Work out the forces on all particles first, and move them afterwards.", Kind::Order, nullptr,
            [](Habits& h) { h.inPlace = true; }},
    Mistake{"forces kept stale across stages", "with the force of the step's beginning in all of its stages",
            "Work the forces out again in every stage, from that stage's positions and velocities.", Kind::Order,
            nullptr, [](Habits& h) { h.stale = true; }},
    Mistake{"push left out", "without the push", "Add the push to the force on its particle.", Kind::Push,
            [](Scene& s) { s.pushes.clear(); }},
    Mistake{"push that never ends", "with a push that never ends", "Take the push away at the end of its time.",
            Kind::Push,
            [](Scene& s) {
              for (Push& push : s.pushes) push.duration = s.duration + 1;
            }},
};

bool inRange(const Scene& scene) {
  try {
    refuseExtremes(scene);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

bool makesDifference(const Model& before, const Model& after) {
  const Scene& s = after.scene;
  const bool damped = s.structural.kd > 0 || s.shear.kd > 0 || s.bend.kd > 0;
  const Habits& h = after.habits;
  if (h.shearRestsAtSpacing != before.habits.shearRestsAtSpacing && !s.shear.present()) return false;
  if (h.bendRestsAtSpacing != before.habits.bendRestsAtSpacing && !s.bend.present()) return false;
  if ((h.dampingSign != before.habits.dampingSign || h.absoluteDamping != before.habits.absoluteDamping) && !damped) {
    return false;
  }
  if (s.damping != before.scene.damping && !damped) return false;
  if (h.pins != before.habits.pins && s.pins.empty()) return false;
  return !(after.scene == before.scene) || !(after.habits == before.habits);
}

}  // namespace

std::span<const Mistake> mistakes() { return kTable; }

std::string Model::names() const {
  std::string text;
  for (const Mistake* mistake : made) text += (text.empty() ? "" : " and ") + std::string(mistake->name);
  return text;
}

Model withMistake(Model model, const Mistake& mistake) {
  Model made = model;
  if (mistake.edit != nullptr) mistake.edit(made.scene);
  if (mistake.spoil != nullptr) mistake.spoil(made.habits);
  if (!makesDifference(model, made) || !inRange(made.scene)) return model;
  if (!made.isScene() && !StudentProgram::takes(made.scene)) return model;
  made.made.push_back(&mistake);
  return made;
}

}  // namespace tyg
