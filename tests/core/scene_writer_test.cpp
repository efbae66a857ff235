// Scenes written as files read back as themselves.
#include "core/scene/scene_writer.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>

#include "test_systems.h"
#include "tyg/methods.h"
#include "util/visible_text.h"

namespace tyg::test {
namespace {

Scene readBack(const Scene& scene, std::string_view comment = {}) {
  return parseScene(sceneToToml(scene, comment), scene.name, methodNames());
}

TEST(SceneWriter, EveryBuiltinSceneReadsBackAsItself) {
  for (const BuiltinScene& builtin : builtinScenes()) {
    const Scene scene = loadScene(std::string(builtin.name), methodNames());
    EXPECT_EQ(readBack(scene), scene) << builtin.name;
  }
}

TEST(SceneWriter, RandomScenesReadBackToTheLastBit) {
  Numbers numbers(1);
  for (int k = 0; k < 50; ++k) {
    Scene scene = randomScene(2 + k % 5, 3 + k % 7, numbers);
    scene.displacements.push_back({{"", 1, 2}, numbers.inCube(1)});
    scene.pushes.push_back({{"middle"}, numbers.inCube(3), numbers.between(0, 1), numbers.between(0, 1)});
    scene.pins.push_back({"top"});
    scene.air = {numbers.between(0, 2), numbers.between(0, 2)};
    scene.winds.push_back({.velocity = numbers.inCube(5)});
    scene.winds.push_back({numbers.inCube(5), numbers.inCube(2), numbers.between(0.1, 3), numbers.between(0, 1), 0.5});
    scene.moves.push_back({{{"top-left"}, {"", 1, 0}}, numbers.inCube(1), numbers.between(0, 1), 0.25});
    scene.tolerance = numbers.between(1e-12, 1e-3);
    scene.precision = numbers.coin() ? Precision::Float : Precision::Double;
    EXPECT_EQ(readBack(scene), scene) << sceneToToml(scene);
  }
}

TEST(SceneWriter, LooksAndLampsReadBack) {
  Numbers numbers(2);
  Scene scene = emptyWorld(2, 2);
  scene.name = "scenes/of mine/a.toml";
  for (const Show show : {Show::Lines, Show::Surface, Show::Both}) {
    for (const Weave weave : {Weave::None, Weave::Plain, Weave::Checker}) {
      scene.look = {.show = show, .colour = Vec3{0.1 + 0.2, 0, 1}, .weave = weave};
      scene.lamps = {{.direction = numbers.inCube(1)}, {.at = numbers.inCube(3), .colour = {0.5, 0.25, 1}}};
      EXPECT_EQ(readBack(scene), scene) << sceneToToml(scene);
    }
  }
}

TEST(SceneWriter, ThePictureOfALookIsBesideItsSceneAndIsFoundFromACopyElsewhere) {
  const std::string look = "[look]\nimage = 'my cloth.JPG'\n[run]\nduration = 1\nintegrator = 'rk4'\ndt = 0.01\n";
  const std::string text = "title = 't'\n[sheet]\ncolumns = 2\nrows = 2\nspacing = 1\nparticle_mass = 1\n" + look;
  const Scene scene = parseScene(text, "far/away/a.toml");
  EXPECT_EQ(scene.look.image, (std::filesystem::current_path() / "far" / "away" / "my cloth.JPG").string());
  EXPECT_EQ(parseScene(sceneToToml(scene), "copy.toml").look.image, scene.look.image);
}

TEST(SceneWriter, NumbersThatTomlHoldsAsIntegersOrFloatsComeBack) {
  Scene scene = emptyWorld(2, 2);
  scene.structural = {123456789012345678901.0, 1e-30};
  scene.shear = {1e15, 9007199254740993.0};
  scene.gravity = {-1e30, 1e-300, 0.1 + 0.2};
  scene.tolerance = std::numeric_limits<double>::denorm_min();
  EXPECT_EQ(readBack(scene), scene) << sceneToToml(scene);
}

TEST(SceneWriter, TextsKeepQuotesBackslashesControlsAndLetters) {
  Scene scene = emptyWorld(2, 2);
  scene.title = "a \"b\" \\ c\td\x7f";
  scene.shows = "två tyg\nrad";
  EXPECT_EQ(readBack(scene), scene);
}

TEST(SceneWriter, NothingInATextIsActiveInTheFileAndAllOfItReadsBack) {
  Scene scene = emptyWorld(2, 2);
  scene.title = "a\x1B[31m\xC2\x9B \xE2\x80\xAE \xEF\xBF\xBF \xF0\x9F\xBF\xBF";
  EXPECT_EQ(readBack(scene), scene);
  const std::string text = sceneToToml(scene, "of \x1B[31m\xFF.toml\nkey = 1");
  EXPECT_EQ(text, withoutActive(text));
  EXPECT_EQ(parseScene(text, scene.name), scene) << text;
}

TEST(SceneWriter, WhatAnEmptyWorldHasByItselfIsNotWritten) {
  Scene scene = emptyWorld(2, 2);
  scene.gravity = Scene{}.gravity;
  const std::string text = sceneToToml(scene);
  for (const char* word : {"springs", "world", "gravity", "drag", "push", "pins", "tolerance", "precision"}) {
    EXPECT_EQ(text.find(word), std::string::npos) << word << " in\n" << text;
  }
}

TEST(SceneWriter, ACommentStandsInFrontLineByLine) {
  const Scene scene = emptyWorld(2, 2);
  EXPECT_EQ(sceneToToml(scene, "one\ntwo").rfind("# one\n# two\ntitle", 0), 0U);
  EXPECT_EQ(readBack(scene, "one\ntwo\n"), scene);
}

}  // namespace
}  // namespace tyg::test
