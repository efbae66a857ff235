// What the table of methods needs from each method's file: how to make one, and its largest stable step.
#pragma once

#include <memory>

#include "tyg/integrator.h"

namespace tyg {

template <class T>
std::unique_ptr<Integrator<T>> makeExplicitEuler(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeSymplecticEuler(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeReportRk4(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeLeapfrog(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeRk4(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeBs32(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeDopri54(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeRkc2(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeImex(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeBackwardEuler(const Scene& scene, const Sheet& sheet);
template <class T>
std::unique_ptr<Integrator<T>> makeXpbd(const Scene& scene, const Sheet& sheet);

// Largest stable step in s for the mode x'' + d x' + w2 x = 0: infinite where every step is stable, 0 where none is.
double stableStepExplicitEuler(double w2, double d);
double stableStepSymplecticEuler(double w2, double d);
double stableStepReportRk4(double w2, double d);
double stableStepLeapfrog(double w2, double d);
double stableStepRk4(double w2, double d);
double stableStepBs32(double w2, double d);
double stableStepDopri54(double w2, double d);
double stableStepImex(double w2, double d);
/// The same for all modes of the scene's sheet at rest at once.
double stableStepRkc2(const Scene& scene);

}  // namespace tyg
