// A new scheme is three functions and an entry of the table.
#include "gpu/scheme.h"

#include <array>

namespace tyg {
namespace {

// v' = v + h a(x, v); x' = x + h v'

std::vector<double> timesOfEuler(const StepTimes& steps, int count, bool /*hasForce*/) {
  std::vector<double> times(static_cast<std::size_t>(count));
  for (int k = 0; k < count; ++k) times[std::size_t(k)] = steps.at(k);
  return times;
}

void runEuler(CardSheet& sheet, double h, double inverseMass, int count, bool /*hasForce*/) {
  for (int k = 0; k < count; ++k) {
    sheet.pass(CardUpdate::KickAndDrift,
               {{PassRole::Position, Field::X},
                {PassRole::Velocity, Field::V},
                {PassRole::NextPosition, Field::X2},
                {PassRole::NextVelocity, Field::V2}},
               float(h), float(h * inverseMass));
    sheet.swap(Field::X, Field::X2), sheet.swap(Field::V, Field::V2);
  }
}

void accountEuler(Forces<float>& forces, std::span<const Power> powers, double h, bool /*hasForce*/) {
  for (const Power& power : powers) forces.countEvaluation(power), forces.addPower(h);
}

// w = v + h/2 a; x' = x + h w; a' = a(x', w + h/2 a); v' = w + h/2 a'. V2 is the velocity that damping sees.

std::vector<double> timesOfLeapfrog(const StepTimes& steps, int count, bool hasForce) {
  std::vector<double> times;
  if (!hasForce) times.push_back(steps.at(0));
  for (int k = 0; k < count; ++k) times.push_back(steps.at(k) + steps.h);
  return times;
}

void runLeapfrog(CardSheet& sheet, double h, double inverseMass, int count, bool hasForce) {
  const auto step = float(h), kick = float(h / 2 * inverseMass);
  if (!hasForce) {
    sheet.pass(CardUpdate::Force,
               {{PassRole::Position, Field::X}, {PassRole::Velocity, Field::V}, {PassRole::Force, Field::Force}}, step,
               kick);
  }
  sheet.beginLeapfrog({{PassRole::NextVelocity, Field::V2},
                       {PassRole::OwnPosition, Field::X},
                       {PassRole::OwnVelocity, Field::V},
                       {PassRole::Force, Field::Force}},
                      step, kick);
  for (int k = 1; k < count; ++k) {
    sheet.pass(CardUpdate::Leapfrog,
               {{PassRole::Position, Field::X},
                {PassRole::Velocity, Field::V2},
                {PassRole::NextPosition, Field::X2},
                {PassRole::NextVelocity, Field::V3},
                {PassRole::OwnVelocity, Field::V}},
               step, kick);
    sheet.swap(Field::X, Field::X2), sheet.swap(Field::V2, Field::V3);
  }
  sheet.pass(CardUpdate::LastKick,
             {{PassRole::Position, Field::X},
              {PassRole::Velocity, Field::V2},
              {PassRole::OwnVelocity, Field::V},
              {PassRole::Force, Field::Force}},
             step, kick);
}

void accountLeapfrog(Forces<float>& forces, std::span<const Power> powers, double h, bool hasForce) {
  for (std::size_t k = 0; k < powers.size(); ++k) {
    if (k == 0 && !hasForce) {
      forces.countEvaluation(powers[k]);
      continue;
    }
    forces.addPower(h / 2);  // of the force that the step begins with
    forces.countEvaluation(powers[k]);
    forces.addPower(h / 2);
  }
}

// The classical Runge-Kutta method. X2 and V2, then X3 and V3, then X2 and V2 again are the stages.

std::vector<double> timesOfRungeKutta(const StepTimes& steps, int count, bool /*hasForce*/) {
  std::vector<double> times;
  for (int k = 0; k < count; ++k) {
    const double t = steps.at(k), h = steps.h;
    for (const double time : {t, t + h / 2, t + h / 2, t + h}) times.push_back(time);
  }
  return times;
}

void innerStage(CardSheet& sheet, double c, double inverseMass) {
  sheet.pass(CardUpdate::InnerStage,
             {{PassRole::Position, Field::X2},
              {PassRole::Velocity, Field::V2},
              {PassRole::NextPosition, Field::X3},
              {PassRole::NextVelocity, Field::V3},
              {PassRole::OwnPosition, Field::X},
              {PassRole::OwnVelocity, Field::V},
              {PassRole::Force, Field::Force},
              {PassRole::SumV, Field::SumV}},
             float(c), float(c * inverseMass));
  sheet.swap(Field::X2, Field::X3), sheet.swap(Field::V2, Field::V3);
}

void runRungeKutta(CardSheet& sheet, double h, double inverseMass, int count, bool /*hasForce*/) {
  for (int k = 0; k < count; ++k) {
    sheet.pass(CardUpdate::FirstStage,
               {{PassRole::Position, Field::X},
                {PassRole::Velocity, Field::V},
                {PassRole::NextPosition, Field::X2},
                {PassRole::NextVelocity, Field::V2},
                {PassRole::Force, Field::Force},
                {PassRole::SumV, Field::SumV}},
               float(h / 2), float(h / 2 * inverseMass));
    innerStage(sheet, h / 2, inverseMass);
    innerStage(sheet, h, inverseMass);
    sheet.pass(CardUpdate::LastStage,
               {{PassRole::Position, Field::X2},
                {PassRole::Velocity, Field::V2},
                {PassRole::OwnPosition, Field::X},
                {PassRole::OwnVelocity, Field::V},
                {PassRole::Force, Field::Force},
                {PassRole::SumV, Field::SumV}},
               float(h / 6), float(h / 6 * inverseMass));
  }
}

void accountRungeKutta(Forces<float>& forces, std::span<const Power> powers, double h, bool /*hasForce*/) {
  const std::array weights{h / 6, h / 3, h / 3, h / 6};
  for (std::size_t k = 0; k < powers.size(); ++k) {
    forces.countEvaluation(powers[k]);
    forces.addPower(weights.at(k % weights.size()));
  }
}

}  // namespace

std::span<const Scheme> schemes() {
  static constexpr std::array kSchemes{
      Scheme{"symplectic-euler", false, timesOfEuler, runEuler, accountEuler},
      Scheme{"leapfrog", true, timesOfLeapfrog, runLeapfrog, accountLeapfrog},
      Scheme{"rk4", false, timesOfRungeKutta, runRungeKutta, accountRungeKutta},
  };
  return kSchemes;
}

}  // namespace tyg
