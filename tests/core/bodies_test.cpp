// Bodies in scene files: what is filled in, what is refused and with which words, and that all of it reads back.
#include "core/scene/bodies.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/forces/terms/contact.h"
#include "core/scene/scene_writer.h"
#include "core/spectrum/lattice.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace tyg::test {
namespace {

const std::string kSheet =                   // lines
    "title = 't'\n"                          // 1
    "[sheet]\n"                              // 2
    "columns = 4\n"                          // 3
    "rows = 3\n"                             // 4
    "spacing = 0.1\n"                        // 5
    "particle_mass = 0.02\n"                 // 6
    "pins = ['top-left']\n"                  // 7
    "[run]\n"                                // 8
    "duration = 1\n"                         // 9
    "integrator = 'dopri54'\n"               // 10
    "dt = 0.01\n"                            // 11
    "[springs]\n"                            // 12
    "structural = { ks = 100 }\n";           // 13
const std::string kContact = "[contact]\n";  // 14
const std::string kBall =                    //
    "[[body]]\n"                             // 15
    "name = 'ball'\n"                        // 16
    "shape = 'ball'\n"                       // 17
    "at = [0, -1, 0]\n"                      // 18
    "radius = 0.5\n";                        // 19
const std::string kMove = "velocity = [1, 0, 0]\nat = 0\nfor = 1\n";

Scene read(const std::string& text) { return parseScene(text, "bodies.toml", methodNames()); }
std::string refusalOf(const std::string& text) {
  return messageOf([&] { (void)read(text); });
}
std::string bodyOf(const std::string& keys) { return kSheet + kContact + "[[body]]\n" + keys; }

TEST(Bodies, AFileThatNamesTheLeastGetsTheRest) {
  const Scene scene = read(kSheet + kContact + kBall + "[[move]]\nwhat = 'ball'\n" + kMove);
  EXPECT_EQ(scene.contact.stiffness, 100);  // a quarter of 4 ks
  EXPECT_EQ(scene.contact.layer, 0.1 / 20);
  EXPECT_EQ(scene.contact.damping, 0.3);
  EXPECT_EQ(scene.contact.friction, 0);
  EXPECT_EQ(scene.contact.grip, std::sqrt(100 * 0.02) / 2);
  EXPECT_FALSE(scene.contact.gap.has_value());
  EXPECT_EQ(scene.tolerance, 0.1 / 20 / 1000);
  EXPECT_EQ(scene.moves.at(0).body, "ball");
  EXPECT_TRUE(scene.moves.at(0).what.empty());
  EXPECT_DOUBLE_EQ(gapOf(scene, scene.bodies[0]), 0.1 * 0.1 / (4 * 0.5));
  EXPECT_EQ(gapOf(scene, {.shape = Shape::Plane}), 0);
  const Scene wider = read(kSheet + "[contact]\ngap = 0.02\n" + kBall);
  EXPECT_EQ(gapOf(wider, wider.bodies[0]), 0.02);
  EXPECT_EQ(gapOf(wider, {.shape = Shape::Plane}), 0.02);
}

TEST(Bodies, APlaneFacesUpwardsAndItsNormalGetsTheLengthOfOne) {
  EXPECT_EQ(read(bodyOf("shape = 'plane'\nat = [0, 0, 0]\n")).bodies.at(0).normal, (Vec3{0, 1, 0}));
  const Vec3 normal = read(bodyOf("shape = 'plane'\nat = [0, 0, 0]\nnormal = [3, 0, 4]\n")).bodies.at(0).normal;
  EXPECT_NEAR(normal.x, 0.6, 1e-15);
  EXPECT_NEAR(normal.z, 0.8, 1e-15);
}

TEST(Bodies, WhatDoesNotFitIsRefusedWithItsLineAndItsKey) {
  const auto said = [](const std::string& text, const std::string& message) {
    EXPECT_EQ(refusalOf(text).substr(0, message.size()), message) << text;
  };
  said(kSheet + kContact, "bodies.toml:14: key contact: found [contact] without a [[body]], allowed both, or neither");
  said(kSheet + kBall, "bodies.toml:14: key body: found [[body]] without [contact], allowed both, or neither");
  said(bodyOf("at = [0, 0, 0]\n"), "bodies.toml:15: key body.shape: found nothing, and it is required");
  said(bodyOf("shape = 'cone'\n"), "bodies.toml:16: key body.shape: found \"cone\", allowed \"plane\"");
  said(bodyOf("shape = 'plane'\n"), "bodies.toml:15: key body.at: found nothing, and it is required");
  said(bodyOf("shape = 'plane'\nat = [0, 0, 0]\nnormal = [0, 0, 0]\n"),
       "bodies.toml:18: key body.normal: found [0, 0, 0], allowed a direction");
  said(bodyOf("shape = 'ball'\nat = [0, 0, 0]\n"), "bodies.toml:15: key body.radius: found nothing, and it is");
  said(bodyOf("shape = 'ball'\nat = [0, 0, 0]\nradius = 0.09\n"),
       "bodies.toml:18: key body.radius: found 0.09 m, allowed the spacing of the sheet, 0.1 m, or more");
  said(bodyOf("shape = 'ball'\nat = [0, 0, 0]\nradius = 1\nhalf = [1, 1, 1]\n"),
       "bodies.toml:19: key body.half: found an unknown key");
  said(bodyOf("shape = 'capsule'\nfrom = [1, 2, 3]\nto = [1, 2, 3]\nradius = 1\n"),
       "bodies.toml:18: key body.to: found the same place as from");
  said(bodyOf("shape = 'capsule'\nfrom = [1, 2, 3]\nto = [1, 2, 4]\nradius = 0.01\n"),
       "bodies.toml:19: key body.radius: found 0.01 m, allowed the spacing");
  said(bodyOf("shape = 'box'\nat = [1, 2, 3]\nhalf = [1, 0.4, 1]\nrounding = 0.5\n"),
       "bodies.toml:18: key body.half: found [1, 0.4, 1], allowed the rounding of the edges, 0.5 m, or more");
  said(bodyOf("shape = 'box'\nat = [1, 2, 3]\nhalf = [1, 1, 1]\nrounding = 0.05\n"),
       "bodies.toml:19: key body.rounding: found 0.05 m, allowed the spacing");
  said(bodyOf("shape = 'box'\nat = [1, 2, 3]\nhalf = [1, 1, 1]\n"), "bodies.toml:15: key body.rounding: found nothing");
}

TEST(Bodies, NamesAreTheirOwn) {
  const auto said = [](const std::string& text, const std::string& message) {
    EXPECT_EQ(refusalOf(text).substr(0, message.size()), message) << text;
  };
  const std::string scene = kSheet + kContact + kBall;
  said(scene + kBall, "bodies.toml:21: key body.name: found the name of another body, ball, allowed a name of its own");
  said(bodyOf("name = ''\nshape = 'plane'\nat = [0, 0, 0]\n"),
       "bodies.toml:16: key body.name: found \"\", allowed a name of at least one character");
  for (const char* name : {"top", "middle", "corners"}) {
    said(bodyOf("name = '" + std::string(name) + "'\nshape = 'plane'\nat = [0, 0, 0]\n"),
         "bodies.toml:16: key body.name: found \"" + std::string(name) + "\", allowed a name that no particle");
  }
  said(scene + "[[move]]\nwhat = 'bal'\n" + kMove,
       "bodies.toml:21: key move.what: found \"bal\", the name of nothing in this scene, allowed \"top-left\"");
  const std::string message = refusalOf(scene + "[[move]]\nwhat = 'bal'\n" + kMove);
  EXPECT_NE(message.find("\"ball\", [column, row]; did you mean 'ball'?"), std::string::npos) << message;
  said(scene + "[[move]]\nwhat = ['ball']\n" + kMove,
       "bodies.toml:21: key move.what: found \"ball\" in a list, allowed \"ball\" by itself: a body stands alone");
  said(scene + "[[move]]\nwhat = []\n" + kMove, "bodies.toml:21: key move.what: found [], allowed one particle or set");
  said(scene + "[[move]]\nwhat = 'middle'\n" + kMove, "bodies.toml:21: key move.what: found particle [2, 1], which is");
}

TEST(Bodies, ASceneMayNameAnyToleranceAndHasASmallOneIfItNamesNone) {
  std::string text = kSheet + kContact + kBall;
  EXPECT_EQ(read(text).tolerance, largestTolerance(read(text)));
  text.insert(text.find("[springs]"), "tolerance = 1e-5\n");
  EXPECT_EQ(read(text).tolerance, 1e-5);
  EXPECT_GT(read(text).tolerance, largestTolerance(read(text)));
  EXPECT_EQ(read(sceneToToml(read(text), "")).tolerance, 1e-5);
}

TEST(Bodies, ContactIsOneTable) {
  EXPECT_EQ(refusalOf(kSheet + "[[contact]]\nfriction = 1\n" + kBall),
            "bodies.toml:14: key contact: found a list of tables, [[contact]], allowed one table, [contact]");
}

TEST(Bodies, NumbersOfContactAreRefusedWhereTheyMakeNoSense) {
  const auto said = [](const std::string& keys, const std::string& message) {
    EXPECT_EQ(refusalOf(kSheet + kContact + keys + kBall).substr(0, message.size()), message) << keys;
  };
  said("stiffness = 0\n", "bodies.toml:15: key contact.stiffness: found 0, allowed a finite number above 0");
  said("layer = 0\n", "bodies.toml:15: key contact.layer: found 0, allowed a finite number above 0");
  said("damping = -1\n", "bodies.toml:15: key contact.damping: found -1, allowed a finite number of at least 0");
  said("friction = -1\n", "bodies.toml:15: key contact.friction: found -1, allowed a finite number of at least 0");
  said("grip = 0\n", "bodies.toml:15: key contact.grip: found 0, allowed a finite number above 0");
  said("gap = -1\n", "bodies.toml:15: key contact.gap: found -1, allowed a finite number of at least 0");
  said("mu = 1\n", "bodies.toml:15: key contact.mu: found an unknown key, allowed \"stiffness\", \"layer\"");
  std::string limp = kSheet + kContact + kBall;
  limp.replace(limp.find("ks = 100"), 8, "kd = 1");
  EXPECT_EQ(
      refusalOf(limp),
      "bodies.toml:14: key contact: found neither stiffness nor springs to take it from, allowed a stiffness above "
      "0");
}

TEST(Bodies, ASimulationRefusesWhatAFileWould) {
  Scene scene = read(kSheet + kContact + kBall);
  scene.bodies[0].radius = 0.01;
  EXPECT_NE(messageOf([&] { Simulation(scene, findMethod("rk4")); }).find("body 1, key radius: found 0.01 m"),
            std::string::npos);
  scene.bodies[0].radius = 0.5, scene.contact.layer = 0;
  EXPECT_NE(messageOf([&] { Simulation(scene, findMethod("rk4")); }).find("a layer of 0 m"), std::string::npos);
}

/// The largest m w^2 of all waves on a fine grid of them, N/m.
double largestOfWaves(const Scene& scene) {
  const Lattice lattice(scene);
  double largest = 0;
  lattice.forWaves(1200, [&](double qx, double qy) {
    for (const Mode& mode : lattice.modes(qx, qy)) largest = std::max(largest, scene.particleMass * mode.w2);
  });
  return largest;
}

TEST(Bodies, TheDefaultStiffnessIsAQuarterOfTheLargestOfAllWaves) {
  constexpr double kGrid = 1e-5;  // relative: of the nearest wave of the grid
  Numbers numbers(5);
  for (int k = 0; k < 12; ++k) {
    for (const auto& [columns, rows] : {std::pair{9, 7}, {2, 2}, {1, 2}, {1, 9}, {9, 1}}) {
      if (k > 2 && columns > 1 && rows > 1 && k % 3 > 0) continue;  // a fine search of both phases takes its time
      Scene scene = emptyWorld(columns, rows);
      scene.structural.ks = numbers.between(0.1, 100), scene.shear.ks = numbers.between(0, 100);
      scene.bend.ks = numbers.between(0, 60);
      fillContact(scene);
      const double largest = largestOfWaves(scene);
      EXPECT_NEAR(4 * scene.contact.stiffness, largest, kGrid * largest)
          << columns << "x" << rows << " " << scene.structural.ks << " " << scene.shear.ks << " " << scene.bend.ks;
    }
  }
}

TEST(Bodies, OnAnotherGridAParticleHasItsShareOfStiffnessAndGrip) {
  const Scene coarse = read(kSheet + "[contact]\nstiffness = 60\ngrip = 2\nlayer = 0.01\ngap = 0.003\n" + kBall);
  const Scene fine = withSheet(coarse, 7, 5);
  EXPECT_DOUBLE_EQ(fine.contact.stiffness * 35, 60 * 12);
  EXPECT_DOUBLE_EQ(fine.contact.grip * 35, 2 * 12);
  EXPECT_EQ(fine.contact.layer, 0.01);
  EXPECT_EQ(fine.contact.gap, 0.003);
  EXPECT_EQ(fine.bodies, coarse.bodies);
}

/// Of a shape, with everything drawn at random.
Body randomBody(Shape shape, const Scene& scene, Numbers& numbers) {
  Body body{.shape = shape, .at = numbers.inCube(3)};
  if (shape == Shape::Plane) {
    body.normal = numbers.inCube(1);
    body.normal = (1 / length(body.normal)) * body.normal;
    return body;
  }
  body.radius = scene.spacing * numbers.between(1, 4);
  if (shape == Shape::Capsule) body.axis = numbers.inCube(2);
  if (shape == Shape::Box) {
    body.half = Vec3{body.radius, body.radius, body.radius} + numbers.between(0, 1) * Vec3{1, 0.5, 0.1};
  }
  return body;
}

TEST(Bodies, AllShapesReadBackToTheLastBitAsTheyAreWritten) {
  Numbers numbers(3);
  for (int k = 0; k < 60; ++k) {
    Scene scene = randomScene(2 + k % 5, 3 + k % 7, numbers);
    scene.structural.ks += 1;
    scene.contact = {.stiffness = k % 2 == 0 ? 0 : numbers.between(1, 100), .friction = numbers.between(0, 1)};
    if (k % 3 == 0) scene.contact.gap = numbers.between(0, 0.1);
    if (k % 5 == 0) scene.contact.damping = 0;
    if (k % 4 == 0) scene.contact.damping = numbers.between(0, 2), scene.contact.layer = numbers.between(0.01, 1);
    fillContact(scene);
    for (const Shape shape : {Shape::Plane, Shape::Ball, Shape::Capsule, Shape::Box}) {
      scene.bodies.push_back(randomBody(shape, scene, numbers));
    }
    scene.bodies[1].name = "ball \"1\"", scene.bodies[3].name = "box";
    scene.moves.push_back({.velocity = numbers.inCube(1), .at = 0.5, .duration = 0.25, .body = "box"});
    scene.tolerance = std::min(1e-4, scene.contact.layer / 1000);
    const Scene back = parseScene(sceneToToml(scene), scene.name, methodNames());
    // An axis that is not the difference of two numbers has lost its last bit.
    EXPECT_LE(length(back.bodies[2].axis - scene.bodies[2].axis), 1e-15);
    scene.bodies[2].axis = back.bodies[2].axis;
    EXPECT_EQ(back, scene) << sceneToToml(scene);
    EXPECT_EQ(parseScene(sceneToToml(back), scene.name, methodNames()), back);
  }
}

}  // namespace
}  // namespace tyg::test
