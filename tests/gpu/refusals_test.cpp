// What the card does not take is refused with a reason.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "card_here.h"
#include "core/forces/terms/drag.h"
#include "gpu/card_integrator.h"
#include "tyg/input_error.h"

namespace tyg {
namespace {

using Refusals = OnCard;

template <class Do>
std::string refusalOf(const Do& what) {
  try {
    what();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

std::string refusalOf(const Scene& scene, std::string_view method, const Settings& settings) {
  return refusalOf([&] { const Simulation simulation(scene, findMethod(method), settings); });
}

TEST_F(Refusals, NameTheMethodsThatTheCardKnows) {
  EXPECT_EQ(refusalOf(inFloat(loadScene("curtain")), "rkc2", onCard()),
            "integrator: found \"rkc2\", allowed on the graphics card: symplectic-euler, leapfrog, rk4");
}

TEST_F(Refusals, SayThatTheCardComputesInFloat) {
  EXPECT_EQ(refusalOf(loadScene("curtain"), "rk4", onCard()),
            "precision: found double, allowed on the graphics card is float");
}

TEST_F(Refusals, OfAMethodLeaveTheRunAsItWas) {
  Simulation there(inFloat(loadScene("curtain")), findMethod("rk4"), onCard());
  Simulation here(inFloat(loadScene("curtain")), findMethod("rk4"), onProcessor());
  there.tick(3), here.tick(6);
  EXPECT_NE(refusalOf([&] { there.useMethod(findMethod("imex")); }).find("allowed on the graphics card"),
            std::string::npos);
  there.tick(3);
  EXPECT_EQ(there.method().name, "rk4");
  EXPECT_EQ(hashText(there), hashText(here));
}

TEST(TermsWithoutKernel, AreRefusedWhereASceneHasThem) {
  ForceTerm magnet = Drag::kTerm;
  magnet.name = "magnet";
  const std::array<const ForceTerm*, 1> terms{&magnet};
  Scene scene = loadScene("curtain");
  EXPECT_EQ(refusalOf([&] { refuseTermsWithoutKernel(scene, terms); }), "nothing was refused");
  scene.drag = 0.1;
  EXPECT_NE(refusalOf([&] { refuseTermsWithoutKernel(scene, terms); }).find("found a scene with magnet"),
            std::string::npos);
  EXPECT_EQ(refusalOf([&] { refuseTermsWithoutKernel(scene, forceTerms()); }), "nothing was refused");
}

TEST(NoCard, IsSaidWithTheReason) {
  const auto none = []() -> OpenedContext { throw std::runtime_error("the driver is asleep"); };
  try {
    const GpuDevice device(none);
    FAIL() << "a device without a context";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "the driver is asleep");
  }
}

}  // namespace
}  // namespace tyg
