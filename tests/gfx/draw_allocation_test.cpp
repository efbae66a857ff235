// Drawing a frame allocates nothing once everything in it has been drawn before.
#include <gtest/gtest.h>

#include <vector>

#include "counted_allocations.h"
#include "gfx/contexts/offscreen.h"
#include "gfx/passes/sheet_renderer.h"

namespace tyg {
namespace {

TEST(SheetRenderer, ASecondFrameAllocatesNothing) {
  const auto context = makeOffscreen(160, 100);
  Sheet sheet;
  sheet.columns = sheet.rows = 12;
  sheet.spacing = 0.1;
  sheet.pins = {0, 11};
  std::vector<float> xyz, values;
  for (int i = 0; i < sheet.count(); ++i) {
    const Vec3 p = sheet.startPosition(i);
    xyz.insert(xyz.end(), {float(p.x), float(p.y), float(p.z)});
    values.push_back(float(i));
  }
  DrawOptions options;
  options.shear = options.bend = options.particles = true;
  options.colouring = {.by = Colouring::By::Particle, .ramp = Ramp::Growing, .low = 0, .high = 100, .values = values};
  const std::vector<Body> bodies{{.shape = Shape::Ball, .radius = 0.2, .name = "a ball with a long name"},
                                 {.shape = Shape::Plane, .at = {0, -1, 0}}};
  options.bodies = bodies;
  const ShownPush push{.particle = 66, .force = {0.5, 0, 2}};
  Camera camera;
  camera.frame(boxAround(xyz), 1.6F);
  SheetRenderer renderer(sheet);
  const auto allocationsOfAFrame = [&] {
    const long before = allocations;
    renderer.draw(xyz, camera, {160, 100}, options, push);
    return allocations - before;
  };
  EXPECT_GT(allocationsOfAFrame(), 0) << "lines of families that are shown for the first time";
  allocationsOfAFrame(),
      allocationsOfAFrame();  // surroundings are kept, then shown; the driver sets things up of its own
  EXPECT_EQ(allocationsOfAFrame(), 0);
  const Look look{.colour = Vec3{0.5, 0.2, 0.1}, .image = "a picture that is not there, with a long name.png"};
  options.show = Show::Both;
  options.look = &look;
  Sheet cut = sheet;
  cut.missing = cut.missing.withCut(12, 12, {5.5, -1, 5.5, 6});
  renderer.follow(cut);
  for (const Colouring::By by : {Colouring::By::Family, Colouring::By::Particle, Colouring::By::Strain}) {
    options.colouring.by = by;
    EXPECT_GT(allocationsOfAFrame(), 0) << "a surface, or a pattern, that is shown for the first time";
    allocationsOfAFrame();
    EXPECT_EQ(allocationsOfAFrame(), 0) << int(by);
  }
}

}  // namespace
}  // namespace tyg
