// Following particles: which, at what times, and what the rows say.
#include "study/motion/trajectories.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include <fmt/core.h>

#include "scaled_scene.h"
#include "study/charts/gnuplot.h"
#include "study/charts/trajectory_chart.h"
#include "tyg/methods.h"

namespace tyg {
namespace {

const auto kNeverStop = [](std::size_t, double) { return true; };

/// Two weights and two held particles, one weight drawn out to the side.
Scene square() {
  Scene scene;
  scene.title = "Square";
  scene.columns = scene.rows = 2;
  scene.pins = {{.name = "top-left"}, {.name = "top-right"}};
  scene.structural.ks = scene.shear.ks = 40;
  scene.displacements = {{.particle = {.name = "bottom-left"}, .by = {-0.3, 0, 0}}};
  scene.integrator = "rk4";
  scene.duration = 1;
  scene.dt = 0.01;
  return scene;
}

std::vector<std::string> labels(const std::vector<ChartedParticle>& particles) {
  std::vector<std::string> names;
  names.reserve(particles.size());
  for (const ChartedParticle& particle : particles) names.push_back(particle.label);
  return names;
}

TrajectoryStudy follow(const Scene& scene, const std::vector<const char*>& names) {
  std::vector<const Method*> methods;
  methods.reserve(names.size());
  for (const char* name : names) methods.push_back(&findMethod(name));
  return followParticles(scene, usualParticles(scene), methods, 1, kNeverStop);
}

TEST(TrajectoryPlot, FollowsTheParticlesThatWereDrawnOut) {
  EXPECT_EQ(labels(usualParticles(square())), std::vector<std::string>{"bottom-left"});
}

TEST(TrajectoryPlot, FollowsThePushedParticlesOtherwise) {
  Scene scene = square();
  scene.displacements.clear();
  scene.pushes = {{.particle = {.name = "", .column = 1, .row = 1}, .force = {1, 0, 0}, .at = 0, .duration = 0.1}};
  EXPECT_EQ(labels(usualParticles(scene)), std::vector<std::string>{"1:1"});
}

TEST(TrajectoryPlot, FollowsFreeNamedParticlesWhereNothingIsDoneToTheCloth) {
  Scene scene = square();
  scene.displacements.clear();
  scene.columns = scene.rows = 5;
  EXPECT_EQ(labels(usualParticles(scene)), (std::vector<std::string>{"bottom-left", "middle"}));
}

TEST(TrajectoryPlot, ParticlesAreNamedOrGivenByColumnAndRow) {
  EXPECT_EQ(chartedParticle(square(), "bottom-right").index, 3);
  EXPECT_EQ(chartedParticle(square(), "1:0").index, 1);
  for (const char* wrong : {"bottom", "top", "2:0", "1:", ":1", "one:two"}) {
    EXPECT_THROW(chartedParticle(square(), wrong), InputError) << wrong;
  }
}

TEST(TrajectoryPlot, SamplesEveryStepOfAShortRun) {
  const TrajectoryStudy study = follow(square(), {"rk4"});
  const std::vector<double>& times = study.runs[0].times;
  ASSERT_EQ(times.size(), 101U);
  EXPECT_EQ(times.front(), 0);
  EXPECT_EQ(times[50], 50 * 0.01);
  EXPECT_EQ(times.back(), 1);
}

TEST(TrajectoryPlot, ALongRunIsThinnedWithoutChangingItsSteps) {
  Scene scene = square();
  scene.dt = 0.0003;
  const TrajectoryStudy study = follow(scene, {"rk4"});
  EXPECT_LE(study.runs[0].times.size(), static_cast<std::size_t>(kTrajectorySamples) + 2);
  Simulation alone(scene, findMethod("rk4"));
  alone.advanceTo(study.runs[0].times[300]);
  EXPECT_NEAR(study.runs[0].paths[0][300].x, alone.position(2).x, 1e-12);  // m; steps may differ in their last bits
}

TEST(TrajectoryPlot, ComparesWithTheHighestOrder) {
  EXPECT_EQ(follow(square(), {"symplectic-euler", "rk4", "leapfrog"}).finest, 1U);
  EXPECT_EQ(follow(square(), {"dopri54", "leapfrog"}).finest, 1U)
      << "an adaptive method is as exact as it is told to be";
}

TEST(TrajectoryPlot, AFailedRunStaysWithItsStatusAndIsNotComparedWith) {
  Scene scene = square();
  scene.duration = 20;
  scene.dt = 0.3;
  const TrajectoryStudy study = follow(scene, {"rk4", "backward-euler"});
  EXPECT_NE(study.runs[0].status, Status::Ok);
  EXPECT_TRUE(std::isfinite(study.runs[0].failedAt));
  EXPECT_EQ(study.finest, 1U);
  EXPECT_NE(trajectoryScript(study).find("at " +
                                         [&] {
                                           std::ostringstream time;
                                           time << study.runs[0].failedAt;
                                           return time.str();
                                         }()),
            std::string::npos);
}

TEST(TrajectoryPlot, RowsHoldEveryRunParticleAndTimeWithTheDistanceFromTheFinest) {
  const TrajectoryStudy study = follow(square(), {"symplectic-euler", "rk4"});
  std::istringstream rows(trajectoryCsv(study));
  std::string row;
  std::getline(rows, row);
  EXPECT_EQ(row, "integrator,particle,t,x,y,z,distance,status");
  int count = 0;
  while (std::getline(rows, row)) {
    ++count;
    EXPECT_EQ(std::count(row.begin(), row.end(), ','), 7) << row;
    EXPECT_TRUE(row.rfind("rk4", 0) != 0 || row.find(",0,ok") != std::string::npos) << row;
  }
  EXPECT_EQ(count, 2 * 101);
}

TEST(TrajectoryPlot, ACoordinateThatNeverChangesGetsNoPanel) {
  const std::string script = trajectoryScript(follow(square(), {"rk4"}));
  EXPECT_NE(script.find("'x (m)'"), std::string::npos);
  EXPECT_EQ(script.find("'z (m)'"), std::string::npos);
  EXPECT_NE(script.find("z does not change"), std::string::npos);
}

TEST(TrajectoryPlot, TheObserverStopsEverything) {
  const auto stopAtHalf = [](std::size_t, double time) { return time < 0.5; };
  const TrajectoryStudy study =
      followParticles(square(), usualParticles(square()), {&findMethod("rk4"), &findMethod("leapfrog")}, 1, stopAtHalf);
  EXPECT_EQ(study.runs.size(), 1U);
  EXPECT_LT(study.runs[0].times.back(), 0.5);
}

std::size_t countOf(const std::string& text, const std::string& part) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

/// How many panels a figure has.
std::size_t panels(const std::string& script) { return countOf(script, "\n  plot "); }

/// gnuplot took minutes where every panel read the rows of all.
TEST(TrajectoryPlot, ReadsTheRowsOfEachCurveOnce) {
  Scene scene = square();
  scene.displacements.push_back({{"bottom-right"}, {0.1, 0, 0}});
  const TrajectoryStudy study = follow(scene, {"symplectic-euler", "leapfrog", "rk4"});
  const std::string script = trajectoryScript(study);
  EXPECT_EQ(countOf(script, "'plot.csv'"), 3 * 2U);
  const std::size_t rows = study.runs[0].times.size();
  EXPECT_NE(script.find(fmt::format("'plot.csv' skip {} every ::0::{} ", 1 + 5 * rows, rows - 1)), std::string::npos);
}

TEST(TrajectoryPlot, IsNoWiderThanAScreenShowsWhereParticlesAreMany) {
  Scene scene = square();
  const auto widthOf = [&](std::size_t count) {
    const std::vector<ChartedParticle> particles(count, chartedParticle(scene, "bottom-left"));
    const std::string script = trajectoryScript(followParticles(scene, particles, {&findMethod("rk4")}, 1, kNeverStop));
    const std::string before = "pngcairo size ";
    return std::stod(script.substr(script.find(before) + before.size()));
  };
  EXPECT_EQ(widthOf(2), widthOf(3));
  EXPECT_LT(widthOf(6), 2 * widthOf(2));
}

TEST(TrajectoryPlot, CutsALongTitleButNotWhatIsCharted) {
  Scene scene = square();
  scene.title = std::string(300, 'm');
  const std::string script = trajectoryScript(follow(scene, {"rk4"}));
  EXPECT_NE(script.find("mm\u2026: the way of the bottom-left particle\""), std::string::npos) << script;
  EXPECT_EQ(script.find(std::string(120, 'm')), std::string::npos);
}

TEST(TrajectoryPlot, OfRoundingNoiseIsNoPanelInAnyUnits) {
  Scene scene = square();
  scene.displacements.clear();
  scene.gravity = {0, -9.81, 0};
  scene.pins.clear();  // falls; what x does is rounding
  for (const test::Units& units : test::kUnits) {
    const std::string script = trajectoryScript(follow(test::scaled(scene, units), {"leapfrog", "rk4"}));
    EXPECT_NE(script.find("x and z do not change"), std::string::npos) << script;
    EXPECT_EQ(panels(script), 4U);  // two particles, y and the distance
  }
}

TEST(TrajectoryPlot, OfAClothAtRestShowsThatItRests) {
  Scene scene = square();
  scene.displacements.clear();
  scene.gravity = {};
  const std::string script = trajectoryScript(follow(scene, {"rk4"}));
  EXPECT_EQ(panels(script), 6U);
  EXPECT_EQ(script.find("do not change"), std::string::npos);
  EXPECT_NE(script.find("set yrange [-0.55:-0.45]"), std::string::npos) << script;
}

}  // namespace
}  // namespace tyg
