// `tyg run` and the studies' commands on a cloth that touches bodies: what they say, and what they refuse.
#include <cmath>
#include <fstream>

#include "app/program.h"

namespace tyg {
namespace {

/// A sheet that falls onto a ball that moves.
std::string fallsOnABall(const Folder& folder) {
  const std::filesystem::path path = folder.path() / "ball.toml";
  std::ofstream(path) << R"(title = "Falls on a ball"
[sheet]
columns = 8
rows = 8
spacing = 0.05
particle_mass = 0.002
start = "flat"
[springs]
structural = { ks = 50, kd = 0.02 }
shear = { ks = 30, kd = 0.01 }
[world]
gravity = [0, -9.81, 0]
[contact]
friction = 0.4
stiffness = 200
[[body]]
name = "globe"
shape = "ball"
at = [0.175, -0.25, 0.175]
radius = 0.2
[[move]]
what = "globe"
velocity = [0, 0.1, 0]
at = 0.1
for = 0.2
[run]
duration = 0.4
integrator = "leapfrog"
dt = 0.001
)";
  return path.string();
}

TEST(RunOnBodies, OfBodiesTellsTheirEnergyTheirWorkAndStepsThatAreTooLong) {
  const Folder folder;
  const std::string scene = fallsOnABall(folder);
  const std::string text = tyg("run " + scene + " --json").out;
  EXPECT_TRUE(isFlatJson(text)) << text;
  for (const char* key : {"work_of_bodies_J", "largest_speed_m_per_s", "layers_per_step"}) {
    EXPECT_GT(std::abs(std::stod(jsonValue(text, key))), 0) << key;
  }
  EXPECT_GE(std::stod(jsonValue(text, "contact_J")), 0);
  EXPECT_EQ(jsonValue(tyg("run " + scene + " --json --integrator bs32").out, "layers_per_step"), "null");
  EXPECT_FALSE(holds(text, "work_of_wind_J"));
  EXPECT_TRUE(holds(tyg("run flag --duration 0.1 --json").out, "\"work_of_wind_J\""));
  EXPECT_TRUE(holds(tyg("run " + scene).out, "work of bodies"));
  EXPECT_TRUE(holds(tyg("run " + scene).out, "the layer of contact, so that"));
  EXPECT_FALSE(holds(tyg("run " + scene + " --dt 0.0001").out, "the layer of contact, so that"));
  EXPECT_FALSE(holds(tyg("run curtain --duration 0.2").out, "layer"));
}

TEST(RunOnBodies, VerboseSaysBodiesAndTheirMotionsInWords) {
  const Folder folder;
  const std::string plan = tyg("run " + fallsOnABall(folder) + " --verbose").err;
  EXPECT_TRUE(holds(plan, "body 1: ball globe at (0.175, -0.25, 0.175) m, radius 0.2 m, gap 0.003125 m")) << plan;
  EXPECT_TRUE(holds(plan, "move 1: globe with (0, 0.1, 0) m/s from 0.1 s to 0.3 s")) << plan;
  EXPECT_TRUE(holds(plan, "friction 0.4")) << plan;
  const std::string curtain = tyg("run curtain --verbose --duration 0.1").err;
  EXPECT_TRUE(holds(curtain, "gravity (0, -9.81, 0) m/s2")) << curtain;
  EXPECT_FALSE(holds(curtain, "contact") || holds(curtain, "air density")) << curtain;
}

TEST(RunOnBodies, VerboseNamesPinsThatMoveAndNeitherAShapeTwiceNorAWindInStillAir) {
  const std::string table = tyg("run tablecloth --verbose --duration 0.01").err;
  EXPECT_TRUE(holds(table, "move 1: [35, 9], [35, 18] with (-0.2, -0.35, 0) m/s")) << table;
  EXPECT_TRUE(holds(table, "air density 1.2")) << table;
  EXPECT_FALSE(holds(table, "wind (0")) << table;
  EXPECT_FALSE(holds(table, "gust")) << table;
  EXPECT_FALSE(holds(table, "box box")) << table;
}

TEST(RunOnBodies, RefusesWhatBodiesDoNotAllow) {
  const Folder folder;
  const std::string scene = fallsOnABall(folder);
  const Outcome tolerance = tyg("run " + scene + " --integrator dopri54 --tolerance 1mm");
  EXPECT_EQ(tolerance.code, 2);
  EXPECT_TRUE(holds(tolerance.err, "--tolerance: found 0.001 m, the tolerance for dopri54, allowed is up to a"));
  EXPECT_EQ(tyg("run " + scene + " --integrator rk4 --tolerance 1mm --duration 0.1").code, 0) << "it is not used";
  for (const char* command : {"run ", "diet ", "stability ", "chart "}) {
    const Outcome coarse = tyg(command + scene + " --sheet 2x2");
    EXPECT_EQ(coarse.code, 2) << command;
    EXPECT_TRUE(holds(coarse.err, "allowed the spacing of the sheet")) << command << coarse.err;
  }
}

TEST(RunOnBodies, AFailureByContactSaysThatItIsNotTheSprings) {
  const Folder folder;
  const Outcome outcome = tyg("run " + fallsOnABall(folder) + " --dt 0.006");
  EXPECT_EQ(outcome.code, 1);
  EXPECT_TRUE(holds(outcome.err, "contact with the globe, not the springs")) << outcome.err;
}

}  // namespace
}  // namespace tyg
