// The view of the cloth without a window: the camera's keys, framing, insets, and what is drawn.
#include "viewer/view_control.h"

#include <gtest/gtest.h>

#include "viewer/viewer_fixture.h"

namespace tyg {
namespace {

/// Where the middle of the cloth's box is seen, from -1 at the left edge to 1.
float middleOf(const Viewer& viewer) {
  const Camera& camera = viewer.view().camera();
  const glm::vec4 clip =
      camera.projection(1280.0F / 720) * camera.view() * glm::vec4(viewer.run().shown().box().centre(), 1);
  return clip.x / clip.w;
}
constexpr Insets kPanelOnTheRight{.left = 200, .right = 600};
constexpr float kMiddleOfTheRest = -400.0F / 1280;  // 200 pixels to the left
constexpr float kSeenMiddle = 0.1F;                 // the middle of the box is not that of its picture

TEST_F(ViewerTest, EveryMovingKeyMovesTheEyeItsWay) {
  const struct {
    KeyCode key;
    glm::vec3 way;
  } kWays[] = {{'W', viewer_.view().camera().forward()},
               {'S', -viewer_.view().camera().forward()},
               {'D', viewer_.view().camera().right()},
               {'A', -viewer_.view().camera().right()},
               {'E', {0, 1, 0}},
               {'Q', {0, -1, 0}}};
  for (const auto& [key, way] : kWays) {
    const glm::vec3 before = viewer_.view().camera().eye();
    press(key);
    frames(6);
    release(key);
    EXPECT_GT(glm::dot(viewer_.view().camera().eye() - before, way), 0) << key;
  }
}

TEST_F(ViewerTest, TheMouseLooksAroundOnlyWithTheRightButtonHeld) {
  const float yaw = viewer_.view().camera().yaw();
  viewer_.handle({.kind = Kind::Move, .x = 700, .y = 300});
  EXPECT_EQ(viewer_.view().camera().yaw(), yaw);
  press(kRightButton, 700, 300);
  viewer_.handle({.kind = Kind::Move, .x = 760, .y = 300});
  EXPECT_GT(viewer_.view().camera().yaw(), yaw);
}

TEST_F(ViewerTest, TheWheelGoesNearer) {
  const float before = viewer_.view().camera().distance();
  viewer_.handle({.kind = Kind::Scroll, .key = kWheel, .notches = 1});
  EXPECT_LT(viewer_.view().camera().distance(), before);
}

TEST_F(ViewerTest, OneKeyGoesThroughLinesSurfaceAndBoth) {
  const auto shown = [this] { return viewer_.view().drawOptions().show; };
  EXPECT_EQ(shown(), Show::Lines) << "where the scene wishes nothing";
  for (const Show next : {Show::Surface, Show::Both, Show::Lines}) {
    tap(functionKey(6));
    EXPECT_EQ(shown(), next);
  }
}

TEST_F(ViewerTest, AskingForLinesOnASurfaceShowsBoth) {
  tap(functionKey(6));
  tap('X');
  EXPECT_EQ(viewer_.view().drawOptions().show, Show::Both);
  EXPECT_TRUE(viewer_.view().drawOptions().shear);
  tap('X');
  EXPECT_FALSE(viewer_.view().drawOptions().shear);
  EXPECT_EQ(viewer_.view().drawOptions().show, Show::Both);
}

TEST_F(ViewerTest, ASceneIsShownAsItWishesUntilThePersonChooses) {
  const auto shown = [this] { return viewer_.view().drawOptions().show; };
  const auto open = [this](Show wish) {
    Scene scene = curtain();
    scene.look.show = wish;
    viewer_.scenes().use(scene);
  };
  for (const Show wish : {Show::Both, Show::Surface, Show::Lines}) {
    open(wish);
    EXPECT_EQ(shown(), wish);
  }
  tap(functionKey(6));
  EXPECT_EQ(shown(), Show::Surface);
  open(Show::Both);
  EXPECT_EQ(shown(), Show::Surface) << "remembered";
  tap('R');
  EXPECT_EQ(shown(), Show::Surface);
}

TEST_F(ViewerTest, FBringsALostClothBack) {
  press(kRightButton, 0, 300);
  const auto lost = [this] {
    return edgeArrow(viewer_.view().camera(), viewer_.run().shown().box(), {1280, 720}, 20).has_value();
  };
  for (int x = 50; x < 2000 && !lost(); x += 50) viewer_.handle({.kind = Kind::Move, .x = double(x), .y = 300});
  ASSERT_TRUE(lost());
  tap('F');
  EXPECT_FALSE(lost());
}

TEST_F(ViewerTest, APanelMovesTheClothIntoWhatIsFree) {
  const float distance = viewer_.view().camera().distance();
  viewer_.resize({.width = 1280, .height = 720}, kPanelOnTheRight);
  EXPECT_NEAR(middleOf(viewer_), kMiddleOfTheRest, kSeenMiddle);
  EXPECT_GT(viewer_.view().camera().distance(), 1.1F * distance) << "half the room, and no farther away";
  viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200});
  EXPECT_NEAR(middleOf(viewer_), 0, kSeenMiddle);
  EXPECT_NEAR(viewer_.view().camera().distance(), distance, 1e-4F * distance);
}

TEST_F(ViewerTest, APanelSlidesAClothThatThePersonHasLookedAtCloser) {
  viewer_.handle({.kind = Kind::Scroll, .notches = 2});
  const glm::vec3 eye = viewer_.view().camera().eye();
  const float before = middleOf(viewer_);
  viewer_.resize({.width = 1280, .height = 720}, kPanelOnTheRight);
  EXPECT_NEAR(middleOf(viewer_), before + kMiddleOfTheRest, kSeenMiddle);
  viewer_.resize({}, kPanelOnTheRight);
  viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200});
  EXPECT_LT(glm::distance(viewer_.view().camera().eye(), eye), 0.05F * viewer_.view().camera().distance());
}

TEST_F(ViewerTest, TheViewTakesInASecondClothBesideTheFirst) {
  constexpr float kAway = 2;  // m
  viewer_.resize({.width = 1280, .height = 720}, {.left = 200, .right = 200, .beside = kAway});
  const Camera& camera = viewer_.view().camera();
  for (const glm::vec3 corner : viewer_.run().shown().box().corners()) {
    for (const glm::vec3 point : {corner, corner - kAway * camera.right()}) {
      const glm::vec4 clip = camera.projection(1280.0F / 720) * camera.view() * glm::vec4(point, 1);
      const float x = 640 * (1 + clip.x / clip.w);
      EXPECT_GT(x, 200);
      EXPECT_LT(x, 1080);
    }
  }
}

TEST_F(ViewerTest, TogglesSwitchWhatIsDrawn) {
  tap('X'), tap('N'), tap('P'), tap('I'), tap('L'), tap('U'), tap('B'), tap('H');
  const DrawOptions& draw = viewer_.view().drawOptions();
  EXPECT_TRUE(draw.shear && draw.bend && draw.particles);
  EXPECT_FALSE(draw.pins || draw.structural || draw.ground || viewer_.view().showsHelp());
  EXPECT_EQ(draw.background, Background::Light);
}

constexpr Extent kWindow{.width = 1280, .height = 720};
const Box kSquare{.low = {-1, -1, 0}, .high = {1, 1, 0}};

/// A view of a square of 2 m, not yet framed.
ViewControl viewOfASquare() {
  ViewControl view;
  const auto corners = kSquare.corners();
  view.begin({corners.begin(), corners.end()});
  view.follow(kSquare, {}, false, false);
  return view;
}

TEST(ViewControl, FramesTheClothWhenTheWindowFirstHasASize) {
  ViewControl view = viewOfASquare();
  const glm::vec3 before = view.camera().eye();
  view.resize({}, {});
  EXPECT_FALSE(view.visible());
  EXPECT_EQ(view.camera().eye(), before);
  view.resize(kWindow, {});
  EXPECT_NE(view.camera().eye(), before);
}

TEST(ViewControl, ShowsAWaitingClothLargeAndGlidesToWhereItWillGetToOnceItMoves) {
  ViewControl view = viewOfASquare();
  view.begin({{-5, -5, 0}, {5, 5, 0}});
  view.resize(kWindow, {});
  const float near = view.camera().distance();
  view.follow(kSquare, {}, true, false);
  ASSERT_TRUE(view.glides());
  view.move({}, 0.1F);
  EXPECT_LT(view.camera().distance(), 1.5F * near) << "not at once";
  for (int frame = 0; frame < 100; ++frame) view.move({}, 0.02F);
  EXPECT_FALSE(view.glides());
  EXPECT_GT(view.camera().distance(), 2 * near);
  view.frameCloth();
  EXPECT_NEAR(view.camera().distance(), near, 1e-3F * near);
}

TEST(ViewControl, GlidesNowhereOnceThePersonHasMovedTheCamera) {
  for (const bool before : {true, false}) {
    ViewControl view = viewOfASquare();
    view.begin({{-5, -5, 0}, {5, 5, 0}});
    view.resize(kWindow, {});
    if (before) view.orbit({30, 0}, {});
    view.follow(kSquare, {}, true, false);
    if (!before) view.orbit({30, 0}, {});
    EXPECT_FALSE(view.glides()) << before;
    const glm::vec3 eye = view.camera().eye();
    view.move({}, 0.5F);
    EXPECT_EQ(view.camera().eye(), eye) << before;
  }
}

/// The corners of a box as particles.
std::vector<float> particlesOf(const Box& box) {
  std::vector<float> xyz;
  for (const glm::vec3& corner : box.corners()) xyz.insert(xyz.end(), {corner.x, corner.y, corner.z});
  return xyz;
}
/// Shows the view a box in a frame of 0.02 s.
void showFrame(ViewControl& view, const Box& cloth, bool isWhole = false) {
  view.follow(cloth, {}, true, isWhole);
  view.move({}, 0.02F);
  view.keepInView([particles = particlesOf(cloth)] { return std::span<const float>(particles); }, 0.02F);
}
Box squareAt(const glm::vec3& way) { return {kSquare.low + way, kSquare.high + way}; }
/// How far the corners are from the picture's middle, in halves of its width or height.
float farthestOut(const ViewControl& view, const Box& cloth) {
  float most = 0;
  for (const glm::vec3& corner : cloth.corners()) {
    const glm::vec4 clip = view.camera().projection(16.0F / 9) * view.camera().view() * glm::vec4(corner, 1);
    most = std::max({most, std::abs(clip.x / clip.w), std::abs(clip.y / clip.w)});
  }
  return most;
}

TEST(ViewControl, GoesAlongWithAClothThatIsDrawnAway) {
  constexpr float kSpeed = 1.5F;  // m/s
  ViewControl view = viewOfASquare();
  view.resize(kWindow, {});
  for (int frame = 0; frame < 50; ++frame) showFrame(view, kSquare);
  const glm::vec3 waiting = view.camera().eye();
  float fastest = 0;
  for (int frame = 0; frame < 200; ++frame) {
    const Box cloth = squareAt({0.02F * kSpeed * float(frame), 0, 0});
    const glm::vec3 eye = view.camera().eye();
    showFrame(view, cloth);
    fastest = std::max(fastest, glm::distance(view.camera().eye(), eye) / 0.02F);
    EXPECT_LT(farthestOut(view, cloth), 1) << frame;
  }
  EXPECT_GT(view.camera().eye().x, waiting.x + 2);
  EXPECT_LT(fastest, 2 * kSpeed) << "gently";
  const Box there = squareAt({6, 0, 0});
  showFrame(view, there);
  EXPECT_TRUE(view.glides());
  for (int frame = 0; frame < 400; ++frame) showFrame(view, there);
  EXPECT_FALSE(view.glides()) << "it has come to rest";
  view.resize(kWindow, {.bottom = 100});
  view.resize(kWindow, {});
  EXPECT_LT(farthestOut(view, there), 1) << "a panel that opens and closes takes nothing away";
}

TEST(ViewControl, LeavesAClothToThePersonWhoHasMovedTheCameraAndPartsThatFallToThemselves) {
  for (const bool byHand : {true, false}) {
    ViewControl view = viewOfASquare();
    view.resize(kWindow, {});
    for (int frame = 0; frame < 50; ++frame) showFrame(view, kSquare);
    if (byHand) view.orbit({3, 0}, {});
    const glm::vec3 eye = view.camera().eye();
    showFrame(view, byHand ? squareAt({5, 0, 0}) : Box{{-1, -50, 0}, {1, 1, 0}});
    EXPECT_EQ(view.camera().eye(), eye) << byHand;
    EXPECT_FALSE(view.glides()) << byHand;
  }
}

TEST(ViewControl, GoesAlongWithAWholeClothHoweverFarItSpreads) {
  ViewControl view = viewOfASquare();
  view.resize(kWindow, {});
  for (int frame = 0; frame < 50; ++frame) showFrame(view, kSquare, true);
  const Box wide{{-4, -1, 0}, {4, 1, 0}};
  for (int frame = 0; frame < 200; ++frame) showFrame(view, wide, true);
  EXPECT_LT(farthestOut(view, wide), 1);
}

TEST(ViewControl, StaysAsNearToAClothThatFallsForLong) {
  ViewControl view = viewOfASquare();
  view.resize(kWindow, {});
  for (int frame = 0; frame < 60; ++frame) showFrame(view, kSquare);
  const float distance = view.camera().distance();
  for (int frame = 0; frame < 100; ++frame) {
    const float time = 0.02F * float(frame);
    showFrame(view, squareAt({0, -4.9F * time * time, 0}));
  }
  EXPECT_LT(view.camera().distance(), 1.3F * distance);
}

TEST(ViewControl, GoesBackAtARestartIfItHasFollowedTheCloth) {
  for (const bool follows : {true, false}) {
    ViewControl view = viewOfASquare();
    view.resize(kWindow, {});
    for (int frame = 0; frame < 60; ++frame) showFrame(view, kSquare);
    if (follows) {
      for (int frame = 0; frame < 60; ++frame) showFrame(view, squareAt({3, 0, 0}));
    }
    view.follow(kSquare, {}, false, false);
    EXPECT_EQ(view.glides(), follows);
  }
}

TEST(ViewControl, GoesBackWhereAClothThatItFollowedComesApart) {
  ViewControl view = viewOfASquare();
  view.resize(kWindow, {});
  for (int frame = 0; frame < 60; ++frame) showFrame(view, kSquare);
  const glm::vec3 eye = view.camera().eye();
  for (int frame = 0; frame < 60; ++frame) showFrame(view, squareAt({3, 0, 0}));
  ASSERT_GT(glm::distance(view.camera().eye(), eye), 1);
  for (int frame = 0; frame < 60; ++frame) showFrame(view, {{-1, -50, 0}, {1, 1, 0}});
  EXPECT_LT(glm::distance(view.camera().eye(), eye), 1e-3F);
}

TEST(ViewControl, KeepsTheClothAboveWhatTakesTheLowerEdge) {
  ViewControl view = viewOfASquare();
  constexpr int kTaken = 360;  // pixels, half of the window
  view.resize(kWindow, {.bottom = kTaken});
  const auto lowest = [&] {
    float y = 1;
    for (const glm::vec3& corner : kSquare.corners()) {
      const glm::vec4 clip = view.camera().projection(16.0F / 9) * view.camera().view() * glm::vec4(corner, 1);
      y = std::min(y, clip.y / clip.w);
    }
    return y;
  };
  EXPECT_GT(lowest(), 0);
  view.resize(kWindow, {});
  EXPECT_LT(lowest(), -0.5F);
  view.approach(0.1F);
  view.resize(kWindow, {.bottom = kTaken});
  EXPECT_GT(lowest(), -0.5F) << "a view of the person's own slides up";
}

TEST_F(ViewerTest, AClothThatAHandDrawsOutOfTheWindowIsFollowedWhenItIsLetGo) {
  Scene scene = curtain();
  scene.pins.clear();
  scene.gravity = {};
  viewer_.scenes().use(scene);
  tap(' ');
  frames(60);
  pressOnCloth();
  moveTo({1400, 300});
  const glm::vec3 eye = viewer_.view().camera().eye();
  frames(30);
  EXPECT_EQ(viewer_.view().camera().eye(), eye) << "the plane in which it is drawn keeps its place";
  release(kLeftButton);
  frames(10);
  EXPECT_GT(glm::dot(viewer_.view().camera().eye() - eye, viewer_.view().camera().right()), 0);
}

TEST_F(ViewerTest, TheArrowKeysLookAround) {
  const float yaw = viewer_.view().camera().yaw(), pitch = viewer_.view().camera().pitch();
  press(kRightKey), press(kUpKey);
  frames(10);
  release(kRightKey), release(kUpKey);
  EXPECT_GT(viewer_.view().camera().yaw(), yaw);
  EXPECT_GT(viewer_.view().camera().pitch(), pitch);
}

TEST_F(ViewerTest, ADragBesideTheClothOrbitsAroundItWithEveryToolThatNeedsCloth) {
  for (const auto& [key, orbits] : {std::pair{functionKey(2), true}, {functionKey(3), true}, {functionKey(4), false}}) {
    tap(key);
    const glm::vec3 eye = viewer_.view().camera().eye();
    press(kLeftButton, 250, 620);
    viewer_.handle({.kind = Kind::Move, .x = 300, .y = 640});
    viewer_.handle({.kind = Kind::Move, .x = 400, .y = 660});
    EXPECT_EQ(viewer_.view().camera().eye() != eye, orbits);
    viewer_.handle({.kind = Kind::FocusLost});
    const glm::vec3 after = viewer_.view().camera().eye();
    viewer_.handle({.kind = Kind::Move, .x = 500, .y = 660});
    EXPECT_EQ(viewer_.view().camera().eye(), after);
  }
  EXPECT_EQ(viewer_.tools().record().uses, 0);
  EXPECT_EQ(viewer_.run().state(), RunState::Waiting);
  EXPECT_TRUE(viewer_.run().record().events.empty());
}

TEST(ViewControl, FramesTheBodiesNearToAClothThatHasMoved) {
  ViewControl view = viewOfASquare();
  view.resize(kWindow, {});
  const std::vector<Body> bodies{{.shape = Shape::Ball, .at = {0, -2, 0}, .radius = 0.5}};
  const auto lowestSeen = [&](std::span<const Body> shown) {
    view.follow(kSquare, shown, true, false);
    view.frameCloth();
    const glm::vec4 clip =
        view.camera().projection(16.0F / 9) * view.camera().view() * glm::vec4(0, -2.5F, 0, 1);  // the ball's lowest
    return clip.y / clip.w;
  };
  EXPECT_LT(lowestSeen({}), -1) << "below the picture";
  EXPECT_GT(lowestSeen(bodies), -1);
}

TEST(ViewControl, KeepsThePersonsViewWhenTheWindowChanges) {
  ViewControl view = viewOfASquare();
  view.resize(kWindow, {});
  view.approach(3);
  const float chosen = view.camera().distance();
  view.resize({.width = 640, .height = 720}, {});
  EXPECT_NEAR(view.camera().distance(), chosen, 1e-4F * chosen);
  view.frameCloth();
  EXPECT_GT(view.camera().distance(), 1.1F * chosen);
}

}  // namespace
}  // namespace tyg
