// Cloths drawn at random from fixed seeds: sizes, springs, damping, pins and what is done to them, within what a cloth
// may suffer. For tests and statistics that must not be tuned to a few scenes.
#pragma once

#include <algorithm>
#include <cmath>

#include "test_systems.h"

namespace tyg::test {

/// Even in the logarithm.
inline double logBetween(Numbers& numbers, double low, double high) {
  return low * std::pow(high / low, numbers.between(0, 1));
}

/// Springs that stretch by between 0.3 and 300 times less than their length under the whole sheet's weight, and damping
/// between nothing and three times what is critical for the fastest wave.
inline void drawSprings(Scene& scene, Numbers& numbers) {
  const double weight = scene.particleMass * 9.81 * std::max(scene.rows, scene.columns);
  const double ks = logBetween(numbers, 0.3, 300) * weight / scene.spacing;
  scene.structural.ks = ks;
  scene.shear.ks = ks * numbers.between(0, 1);
  scene.bend.ks = numbers.coin() ? ks * numbers.between(0, 0.5) : 0;
  const double critical = std::sqrt(8 * ks * scene.particleMass) / 8;
  const double kd = numbers.between(0, 1) < 0.15 ? 0 : critical * logBetween(numbers, 1e-3, 3);
  scene.structural.kd = kd;
  scene.shear.kd = numbers.coin() ? kd : kd * numbers.between(0, 1);
  if (scene.bend.ks > 0) scene.bend.kd = kd * numbers.between(0, 1);
  scene.damping = numbers.coin() ? Damping::Relative : Damping::Axial;
}

inline void drawPins(Scene& scene, Numbers& numbers) {
  const double kind = numbers.between(0, 5);
  if (kind < 2) {
    scene.pins = {{"top-left"}, {"top-right"}};
  } else {
    scene.pins = {{kind < 3 ? "top" : kind < 4 ? "left" : kind < 4.5 ? "corners" : "middle"}};
  }
}

/// A cloth that swings, is poked hard once or thrice, falls fast, buckles under its weight, or is plucked, within
/// `seconds`.
inline Scene randomCloth(unsigned seed, double seconds) {
  Numbers numbers(seed);
  for (int k = 0; k < 20; ++k) numbers.coin();  // the first numbers of neighbouring seeds are alike
  Scene scene = emptyWorld(int(numbers.between(4, 17)), int(numbers.between(4, 17)));
  scene.name = "cloth " + std::to_string(seed);
  scene.spacing = logBetween(numbers, 0.02, 0.2);
  scene.particleMass = logBetween(numbers, 1e-3, 0.1);
  scene.start = numbers.coin() ? Start::Flat : Start::Hanging;
  scene.gravity = {0, -9.81, 0};
  scene.duration = seconds;
  drawSprings(scene, numbers);
  if (numbers.between(0, 1) < 0.3) scene.drag = scene.particleMass * numbers.between(0.01, 3);
  drawPins(scene, numbers);
  const double weight = scene.particleMass * 9.81 * scene.columns * scene.rows;
  const double kind = numbers.between(0, 6);
  if (kind < 1) {
    const double force = weight * logBetween(numbers, 0.1, 5), at = seconds * numbers.between(0, 0.3);
    scene.pushes = {{{"middle"}, force * Vec3{0.2, 0.3, 0.93}, at, seconds * numbers.between(0.02, 0.3)}};
  } else if (kind < 2) {
    for (int k = 0; k < 3; ++k) {
      const Place place{"", int(numbers.between(0, scene.columns)), int(numbers.between(0, scene.rows))};
      const Vec3 force = numbers.inCube(2 * weight);
      const double at = seconds * numbers.between(0, 0.8);
      scene.pushes.push_back({place, force, at, seconds * numbers.between(0.02, 0.2)});
    }
  } else if (kind < 3) {
    scene.pins.clear();
    if (numbers.coin()) scene.pins = {{"bottom-left"}};
    scene.gravity = {0, -9.81 * logBetween(numbers, 1, 10), 0};
    scene.displacements = {{{"middle"}, numbers.inCube(0.3 * scene.spacing)}};
  } else if (kind < 4) {
    scene.start = Start::Hanging;
    scene.pins = {{"bottom-left"}, {"bottom-right"}};
    scene.displacements = {{{"middle"}, {0, 0, 0.01 * scene.spacing}}};
  } else if (kind < 5) {
    scene.displacements = {{{"middle"}, numbers.inCube(2 * scene.spacing)}};
    if (numbers.coin()) scene.gravity = {};
  }
  return scene;
}

/// The same in a wind with gusts, its pins moved about, or both.
inline Scene randomWindyCloth(unsigned seed, double seconds) {
  Scene scene = randomCloth(seed, seconds);
  Numbers numbers(7777 + seed);
  for (int k = 0; k < 20; ++k) numbers.coin();
  const double size = makeSheet(scene).size();
  const double kind = scene.pins.empty() ? 0 : numbers.between(0, 3);
  if (kind < 2) {
    // From a breeze that hardly lifts the cloth to one whose force is ten times its weight, or a hurricane.
    const double force = scene.particleMass * 9.81 * logBetween(numbers, 0.03, 10);
    const double speed = std::min(40.0, std::sqrt(2 * force / (1.2 * 1.2 * scene.spacing * scene.spacing)));
    const Vec3 way = numbers.inCube(1);
    scene.air = {1.2, 1.2};
    scene.winds = {{.velocity = speed / length(way) * way}};
    if (numbers.coin()) {
      scene.winds[0].gust = numbers.inCube(0.6 * speed), scene.winds[0].wavelength = size * logBetween(numbers, 0.3, 5);
    }
    if (numbers.coin()) scene.winds[0].at = seconds * numbers.between(0, 0.5);
    if (numbers.coin()) scene.winds[0].duration = seconds * numbers.between(0.1, 0.4);
  }
  if (kind < 1 || scene.pins.empty()) return scene;
  for (const Place& pin : scene.pins) {
    const double at = seconds * numbers.between(0, 0.6), duration = seconds * numbers.between(0.05, 0.4);
    scene.moves.push_back({{pin}, numbers.inCube(0.3 * size / duration), at, duration});
  }
  return scene;
}

/// A body somewhere below the cloth, which falls onto it or hangs into it.
inline Body randomBody(const Scene& scene, Numbers& numbers, double size) {
  const Sheet sheet = makeSheet(scene);
  const int under = int(numbers.between(0, double(sheet.count())));
  const Vec3 middle = sheet.startPosition(std::min(under, sheet.count() - 1));
  const double radius = std::max(scene.spacing, size * numbers.between(0.1, 0.5));
  const double below = numbers.between(0.02, 0.4) * size;
  Body body{.at = middle - Vec3{0, radius + below, 0}, .radius = radius};
  const double kind = numbers.between(0, 3);
  if (kind < 1) {
    body.shape = Shape::Ball;
  } else if (kind < 2) {
    body.shape = Shape::Capsule;
    body.axis = {size * numbers.between(-1, 1), 0, size * numbers.between(0.2, 1)};
  } else {
    body.shape = Shape::Box;
    body.half = {radius + size * numbers.between(0, 0.5), radius, radius + size * numbers.between(0, 0.5)};
    body.radius = scene.spacing;
  }
  return body;
}

/// A cloth that falls onto a floor, a ball, a capsule, a box, or two of them, with friction or without, some of them
/// moving, some in wind.
inline Scene randomTouchingCloth(unsigned seed, double seconds) {
  Numbers numbers(33333 + seed);
  for (int k = 0; k < 20; ++k) numbers.coin();
  Scene scene = numbers.between(0, 1) < 0.25 ? randomWindyCloth(seed, seconds) : randomCloth(seed, seconds);
  scene.moves.clear();
  if (numbers.between(0, 1) < 0.6) scene.pins.clear(), scene.start = Start::Flat;
  if (length(scene.gravity) == 0) scene.gravity = {0, -9.81, 0};
  if (scene.pins.empty()) scene.pushes.clear();
  const double size = makeSheet(scene).size(), fall = 0.5 * length(scene.gravity) * seconds * seconds;
  const double reach = std::min(size, fall);  // what falls shall arrive within the run
  const double kind = numbers.between(0, 3);
  if (kind < 2) {
    const double slope = numbers.coin() ? 0 : numbers.between(-0.5, 0.5);
    double lowest = 0;
    const Sheet sheet = makeSheet(scene);
    for (int i = 0; i < sheet.count(); ++i) lowest = std::min(lowest, sheet.startPosition(i).y);
    const double below = slope == 0 ? 0 : std::abs(slope) * size;
    const double steep = std::sqrt(1 + slope * slope);
    scene.bodies = {{.at = {0, lowest - below - reach * numbers.between(0.01, 0.3), 0},
                     .normal = {slope / steep, 1 / steep, 0},
                     .name = "floor"}};
  }
  if (kind > 1) scene.bodies.push_back(randomBody(scene, numbers, reach < size ? reach : size));
  for (Body& body : scene.bodies) {
    if (body.shape != Shape::Plane) body.name = "body";
  }
  scene.contact.stiffness = numbers.coin() ? 0 : scene.structural.ks * logBetween(numbers, 0.1, 10);
  scene.contact.layer = scene.spacing * logBetween(numbers, 0.02, 0.2);
  scene.contact.damping = numbers.between(0, 1) < 0.15 ? 0 : logBetween(numbers, 0.03, 2);
  if (numbers.coin()) scene.contact.friction = logBetween(numbers, 0.05, 1.5);
  fillContact(scene);
  scene.contact.grip *= logBetween(numbers, 0.3, 3);
  if (numbers.between(0, 1) < 0.3) {
    const double at = seconds * numbers.between(0, 0.5), duration = seconds * numbers.between(0.1, 0.5);
    scene.moves = {{{}, numbers.inCube(0.3 * size / duration), at, duration, scene.bodies.front().name}};
  }
  return scene;
}

}  // namespace tyg::test
