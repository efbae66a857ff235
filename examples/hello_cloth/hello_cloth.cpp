// Embeds the cloth simulator: a small sheet that hangs by two corners swings, is pushed once, and tells its energies.
#include <cstdio>

#include "tyg/methods.h"
#include "tyg/simulation.h"

/// A scene is a plain struct. tyg::loadScene("curtain") reads a built-in one, tyg::loadScene("my.toml") a file.
static tyg::Scene smallCloth() {
  tyg::Scene scene;
  scene.columns = 20, scene.rows = 20;
  scene.spacing = 0.1;        // m
  scene.particleMass = 0.02;  // kg
  scene.start = tyg::Start::Flat;
  scene.pins = {{"top-left"}, {"top-right"}};
  scene.structural = {1200, 0.1};  // N/m, N s/m
  scene.shear = {900, 0.1};
  scene.bend = {200, 0.1};
  scene.dt = 0.001;  // s
  return scene;
}

int main() try {
  tyg::Simulation cloth(smallCloth(), tyg::findMethod("leapfrog"), {.ledger = true});
  std::printf("time_s,kinetic_J,elastic_J,gravitational_J,drift\n");
  for (int tenth = 1; tenth <= 10 && cloth.status() == tyg::Status::Ok; ++tenth) {
    if (tenth == 5) cloth.push(210, {0, 0, 3}, 50);  // 3 N along z on one particle for 50 steps
    cloth.tick(100);
    const tyg::Ledger energy = cloth.ledger();
    std::printf("%.1f,%.4f,%.4f,%.4f,%.0e\n", cloth.time(), energy.kinetic, energy.stored["elastic"],
                energy.stored["gravitational"], energy.drift);
  }
  std::printf("status %s, hash %s\n", tyg::nameOf(cloth.status()).data(), tyg::hashText(cloth).c_str());
  return cloth.status() == tyg::Status::Ok ? 0 : 1;
} catch (const tyg::InputError& error) {
  std::fprintf(stderr, "hello_cloth: %s\n", error.what());
  return 2;
}
