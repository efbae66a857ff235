// The graphics card as the window has it: offered by somebody, chosen and left by a person. The card of these tests is
// the processor, so that they need none.
#include <gtest/gtest.h>

#include "core/simulation/device.h"
#include "tyg/input_error.h"
#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

class ProcessorAsCard final : public Device {
 public:
  [[nodiscard]] std::unique_ptr<Integrator<float>> make(const Method& method, const Scene& scene,
                                                        const Sheet& sheet) override {
    if (method.name == "imex") throw InputError("integrator: this card does not know imex");
    return method.make<float>(scene, sheet);
  }
};

class ViewerWithCard : public ViewerTest {
 protected:
  ViewerWithCard() {
    viewer_.scenes().offerCard([](const Scene&) {
      return OfferedCard{std::make_shared<ProcessorAsCard>(), "a card of paper"};
    });
  }
};

TEST_F(ViewerWithCard, TheClothBeginsAnewInFloatOnTheCard) {
  tap(' ');
  frames(10);
  viewer_.scenes().moveOnCard(true);
  EXPECT_TRUE(viewer_.scenes().onCard());
  EXPECT_TRUE(viewer_.run().simulation().onDevice());
  EXPECT_EQ(viewer_.run().simulation().scene().precision, Precision::Float);
  EXPECT_EQ(ticks(), 0);
  EXPECT_EQ(viewer_.notes().text(), "a card of paper");
}

TEST_F(ViewerWithCard, RestartsAndOtherScenesStayOnTheCard) {
  viewer_.scenes().moveOnCard(true);
  tap('R');
  EXPECT_TRUE(viewer_.run().simulation().onDevice());
  viewer_.scenes().use(loadScene("poke", methodNames()));
  EXPECT_TRUE(viewer_.run().simulation().onDevice());
  EXPECT_EQ(viewer_.run().simulation().scene().precision, Precision::Float);
  viewer_.scenes().moveOnCard(false);
  EXPECT_FALSE(viewer_.run().simulation().onDevice());
}

TEST_F(ViewerWithCard, AMethodThatTheCardDoesNotKnowIsRefusedWithTheReason) {
  viewer_.scenes().moveOnCard(true);
  Scene wanted = viewer_.scenes().scene();
  wanted.integrator = "imex";
  EXPECT_EQ(viewer_.scenes().use(wanted), SceneChange::None);
  EXPECT_EQ(viewer_.notes().text(), "integrator: this card does not know imex");
  EXPECT_EQ(viewer_.scenes().method().name, "rk4");
  tap(' ');
  frames(10);
  EXPECT_EQ(viewer_.run().state(), RunState::Running);
}

TEST_F(ViewerTest, WhereNoCardServesTheProcessorGoesOn) {
  viewer_.scenes().offerCard([](const Scene&) -> OfferedCard { throw std::runtime_error("no card is plugged in"); });
  tap(' ');
  frames(10);
  const std::int64_t before = ticks();
  viewer_.scenes().moveOnCard(true);
  EXPECT_FALSE(viewer_.scenes().onCard());
  EXPECT_EQ(viewer_.notes().text(), "no card is plugged in");
  EXPECT_EQ(ticks(), before);
}

}  // namespace
}  // namespace tyg
