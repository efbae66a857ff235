// A running simulation allocates nothing: ten times as many steps take not one allocation more.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <cstdlib>
#include <new>

#include "tyg/methods.h"
#include "tyg/simulation.h"

namespace {
std::atomic<long> allocations{0};
}

#pragma GCC diagnostic ignored "-Wmismatched-new-delete"  // GCC does not see that these two belong together
// Every form of new in the standard library ends in one of these two.
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  const auto to = static_cast<std::size_t>(alignment);
  if (void* memory = std::aligned_alloc(to, (size + to - 1) / to * to)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

namespace tyg {
namespace {

TEST(Allocation, DoesNotGrowWithTheNumberOfSteps) {
  Scene scene = loadScene("curtain");
  scene.dt = 0.0005;
  for (const Method& method : methods()) {
    Simulation simulation(scene, method, {.keepGoing = true});
    simulation.advanceTo(64 * scene.dt);  // the first steps may set up what a step length needs
    const auto allocatedBy = [&](double time) {
      const long before = allocations;
      simulation.advanceTo(time);
      return allocations - before;
    };
    const long few = allocatedBy(128 * scene.dt), many = allocatedBy(768 * scene.dt);
    EXPECT_LE(many, few) << method.name;
    EXPECT_GE(simulation.steps(), 100) << method.name;
  }
}

TEST(Allocation, HappensInTheFirstCallForTheLiveLimitOnly) {
  for (const Method& method : methods()) {
    Simulation simulation(loadScene("curtain"), method);
    const double first = simulation.liveStableStep();
    const long before = allocations;
    for (int call = 0; call < 5; ++call) {
      EXPECT_EQ(std::isnan(simulation.liveStableStep()), std::isnan(first)) << method.name;
    }
    EXPECT_EQ(allocations, before) << method.name;
  }
}

}  // namespace
}  // namespace tyg
