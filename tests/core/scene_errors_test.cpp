// Every mistake in a scene file is refused with the file, the line, the key, what was found and what is allowed.
#include <gtest/gtest.h>

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "files.h"
#include "test_systems.h"
#include "tyg/methods.h"
#include "tyg/scene.h"

namespace tyg::test {
namespace {

constexpr std::array kGood = {
    "title = 'Wrong'",                     // 1
    "shows = 'Nothing.'",                  // 2
    "[sheet]",                             // 3
    "columns = 4",                         // 4
    "rows = 3",                            // 5
    "spacing = 0.1",                       // 6
    "start = 'flat'",                      // 7
    "particle_mass = 0.02",                // 8
    "pins = ['top-left', [3, 0]]",         // 9
    "[springs]",                           // 10
    "damping = 'axial'",                   // 11
    "structural = { ks = 10, kd = 0.1 }",  // 12
    "shear = { ks = 5 }",                  // 13
    "bend = { kd = 2 }",                   // 14
    "[world]",                             // 15
    "gravity = [0, -9.81, 0]",             // 16
    "drag = 0.1",                          // 17
    "[[displace]]",                        // 18
    "particle = 'bottom-left'",            // 19
    "by = [0.1, 0, 0]",                    // 20
    "[[push]]",                            // 21
    "particle = 'middle'",                 // 22
    "force = [0, 0, 2]",                   // 23
    "at = 0.5",                            // 24
    "for = 0.1",                           // 25
    "[run]",                               // 26
    "duration = 2",                        // 27
    "integrator = 'rk4'",                  // 28
    "dt = 0.002",                          // 29
    "tolerance = 1e-4",                    // 30
    "precision = 'float'",                 // 31
};

std::string sceneWith(int line, const std::string& text) {
  std::string scene;
  for (int at = 1; at <= int(kGood.size()); ++at) scene += (at == line ? text : kGood[std::size_t(at - 1)]) + '\n';
  return scene;
}

/// One line of the good scene is written differently; the message then names `reported`, the line that is wrong.
struct Mistake {
  int line;
  std::string text;
  int reported;
  std::string key, found, allowed;
};

constexpr const char* kPositive = "a finite number above 0";
constexpr const char* kNotNegative = "a finite number of at least 0";
constexpr const char* kVector = "three finite numbers [x, y, z]";
constexpr const char* kCount = "a whole number from 1 to 4096";
constexpr const char* kPlace = "a particle by name or as [column, row]";
constexpr const char* kParticles = R"("top-left", "top-right", "bottom-left", "bottom-right", "middle", )";
constexpr const char* kRequired = "nothing, and it is required";

/// The message for a text, or nothing where the text is taken.
std::string refusalOf(const std::string& text) {
  try {
    parseScene(text, "wrong.toml", methodNames());
  } catch (const InputError& mistake) {
    return mistake.what();
  }
  return "";
}

void expectRefusals(const std::vector<Mistake>& mistakes) {
  for (const Mistake& mistake : mistakes) {
    const std::string expected = "wrong.toml:" + std::to_string(mistake.reported) + ": key " + mistake.key +
                                 ": found " + mistake.found + ", allowed " + mistake.allowed;
    const std::string said = refusalOf(sceneWith(mistake.line, mistake.text));
    EXPECT_EQ(said.substr(0, expected.size()), expected) << "for: " << mistake.text << "\nsaid: " << said;
  }
}

TEST(SceneErrors, AreNotFoundInTheSceneThatTheyAreMadeFrom) { EXPECT_EQ(refusalOf(sceneWith(1, kGood[0])), ""); }

TEST(SceneErrors, NameWhatWindsAndMotionsLack) {
  const std::string head =
      "title = \"t\"\n[sheet]\ncolumns = 3\nrows = 3\nspacing = 1\nparticle_mass = 1\npins = [\"top\"]\n"
      "[run]\nduration = 1\nintegrator = \"rk4\"\ndt = 0.01\n";
  const std::string wind = "[air]\ndensity = 1.2\n[[wind]]\n";
  for (const auto& [text, said] : {
           std::pair{std::string("[[wind]]\nvelocity = [1, 0, 0]\n"), "[[wind]] without [air]"},
           {"[air]\ncoefficient = 1\n", "air.density"},
           {wind + "at = 1\n", "wind.velocity"},
           {wind + "velocity = [1, 0, 0]\ngust = [1, 0, 0]\n", "without a wavelength"},
           {wind + "velocity = [0, 0, 0]\ngust = [1, 0, 0]\nwavelength = 1\n", "without a velocity"},
           {wind + "velocity = [1, 0, 0]\nwavelength = 0\n", "wind.wavelength"},
           {"[[move]]\nwhat = \"middle\"\nvelocity = [1, 0, 0]\nat = 0\nfor = 1\n", "which is not pinned"},
           {"[[move]]\nwhat = \"ball\"\nvelocity = [1, 0, 0]\nat = 0\nfor = 1\n",
            "\"ball\", the name of nothing in this scene, allowed \"top-left\""},
           {"[[move]]\nwhat = \"topleft\"\nvelocity = [1, 0, 0]\nat = 0\nfor = 1\n", "did you mean 'top-left'"},
           {"[[move]]\nwhat = \"top\"\nvelocity = [1, 0, 0]\nat = 0\n", "move.for"},
       }) {
    const std::string message = test::messageOf([&, &scene = text] { (void)parseScene(head + scene, "wrong.toml"); });
    EXPECT_NE(message.find(said), std::string::npos) << text << message;
    EXPECT_EQ(message.rfind("wrong.toml:", 0), 0U) << message;
  }
  EXPECT_EQ(parseScene(head + "[[move]]\nwhat = [1, 0]\nvelocity = [1, 0, 0]\nat = 0\nfor = 1\n", "right.toml")
                .moves.at(0)
                .what,
            (std::vector<Place>{{"", 1, 0}}));
}

TEST(SceneErrors, NameWhatIsWrongWithTheLookAndItsLamps) {
  constexpr const char* kColour = "three numbers from 0 to 1, [red, green, blue]";
  const auto look = [](const std::string& line) { return "[look]\n" + line + "\n[run]"; };
  const auto lamp = [](const std::string& line) { return "[[lamp]]\n" + line + "\n[run]"; };
  expectRefusals({
      {26, look("show = 'line'"), 27, "look.show", "\"line\"", R"("lines", "surface", "both"; did you mean 'lines')"},
      {26, look("colour = [1, 2, 0]"), 27, "look.colour", "[1, 2, 0]", kColour},
      {26, look("colour = [1, 0.5]"), 27, "look.colour", "[1, 0.5]", kColour},
      {26, look("weave = 'plane'"), 27, "look.weave", "\"plane\"", R"("none", "plain", "checker")"},
      {26, look("image = 'a.gif'"), 27, "look.image", "\"a.gif\"", "the name of a PNG or JPEG file"},
      {26, look("image = 'a.png'\nweave = 'none'"), 27, "look.image", "an image and a weave", "one of them"},
      {26, look("color = [1, 0, 0]"), 27, "look.color", "an unknown key", R"("show", "colour", "weave", "image")"},
      {26, lamp("colour = [1, 1, 1]"), 26, "lamp.direction", "neither direction nor at", "exactly one of them"},
      {26, lamp("at = [0, 1, 0]\ndirection = [0, -1, 0]"), 27, "lamp.at", "both direction and at", "exactly one"},
      {26, lamp("direction = [0, 0, 0]"), 27, "lamp.direction", "[0, 0, 0]", "the direction in which the light goes"},
      {26, lamp("at = [0, 1, 0]\ncolour = [-1, 0, 0]"), 28, "lamp.colour", "[-1, 0, 0]", kColour},
  });
  std::string five;
  for (int k = 0; k < 5; ++k) five += "[[lamp]]\nat = [0, 1, 0]\n";
  EXPECT_NE(refusalOf(sceneWith(26, five + "[run]")).find("found 5 lamps, allowed 4 at most"), std::string::npos);
}

TEST(SceneErrors, NameUnknownKeysAndTables) {
  const std::string root =
      R"("title", "shows", "sheet", "springs", "world", "air", "contact", "wind", "displace", "push", "move", "body", "cut", "tear", "look", "lamp", "run")";
  expectRefusals({
      {2, "show = 'x'", 2, "show", "an unknown key", root},
      {10, "[spring]", 10, "spring", "an unknown table", root},
      {21, "[[poke]]", 21, "poke", "an unknown key", root},
      {9, "colums = 4", 9, "sheet.colums", "an unknown key", R"("columns", "rows", "spacing", "start")"},
      {11, "friction = 1", 11, "springs.friction", "an unknown key", R"("damping", "structural", "shear", "bend")"},
      {12, "structural = { ks = 1, k = 2 }", 12, "springs.structural.k", "an unknown key", R"("ks", "kd")"},
      {17, "wind = 1", 17, "world.wind", "an unknown key", R"("gravity", "drag")"},
      {20, "by = [0, 0, 0]\nat = 1", 21, "displace.at", "an unknown key", R"("particle", "by")"},
      {24, "at = 0.5\nto = 1", 25, "push.to", "an unknown key", R"("particle", "force", "at", "for")"},
      {31, "[run.step]", 31, "run.step", "an unknown table", R"("duration", "integrator", "dt")"},
  });
}

TEST(SceneErrors, NameMissingKeysAndTheLineOfTheirTable) {
  expectRefusals({
      {1, "", 1, "title", kRequired, "a text in quotes"},
      {4, "", 3, "sheet.columns", kRequired, kCount},
      {5, "", 3, "sheet.rows", kRequired, kCount},
      {6, "", 3, "sheet.spacing", kRequired, kPositive},
      {8, "", 3, "sheet.particle_mass", "neither particle_mass nor area_density", "exactly one of them"},
      {8, "particle_mass = 1\narea_density = 1", 9, "sheet.area_density", "both particle_mass and area_density",
       "exactly one of them"},
      {19, "", 18, "displace.particle", kRequired, kPlace},
      {20, "", 18, "displace.by", kRequired, kVector},
      {22, "", 21, "push.particle", kRequired, kPlace},
      {23, "", 21, "push.force", kRequired, kVector},
      {24, "", 21, "push.at", kRequired, kNotNegative},
      {25, "", 21, "push.for", kRequired, kNotNegative},
      {27, "", 26, "run.duration", kRequired, kPositive},
      {28, "", 26, "run.integrator", kRequired, R"("explicit-euler", )"},
      {29, "", 26, "run.dt", kRequired, kPositive},
  });
  EXPECT_EQ(refusalOf(""), "wrong.toml:1: key title: found nothing, and it is required, allowed a text in quotes");
  EXPECT_EQ(refusalOf("\ntitle = ''\n[sheet]"),
            "wrong.toml:1: key run: found nothing, and it is required, allowed a table");
}

TEST(SceneErrors, NameValuesOfAWrongType) {
  expectRefusals({
      {1, "title = 7", 1, "title", "7", "a text in quotes"},
      {4, "columns = 4.0", 4, "sheet.columns", "4.0", kCount},
      {5, "rows = '3'", 5, "sheet.rows", R"("3")", kCount},
      {6, "spacing = '10 cm'", 6, "sheet.spacing", R"("10 cm")", kPositive},
      {7, "start = true", 7, "sheet.start", "true", R"("hanging", "flat")"},
      {9, "pins = 'top'", 9, "sheet.pins", R"("top")", "an array of particles or sets"},
      {9, "pins = ['top',\n 3]", 10, "sheet.pins", "3", "an array of particles or sets"},
      {9, "pins = [[1.0, 0]]", 9, "sheet.pins", "[1.0, 0]", "an array of particles or sets"},
      {12, "structural = 1200", 12, "springs.structural", "1200", "a table"},
      {13, "shear = { ks = [5] }", 13, "springs.shear.ks", "[5]", kNotNegative},
      {16, "gravity = -9.81", 16, "world.gravity", "-9.81", kVector},
      {16, "gravity = [0, -9.81]", 16, "world.gravity", "[0, -9.81]", kVector},
      {18, "[displace]", 18, "displace", "a table", "tables, each under [[displace]]"},
      {19, "particle = ''", 19, "displace.particle", R"("")", kPlace},
      {20, "by = [0, 0, '1']", 20, "displace.by", R"([0, 0, "1"])", kVector},
      {22, "particle = [1, 2, 3]", 22, "push.particle", "[1, 2, 3]", kPlace},
      {24, "at = 07:32:00", 24, "push.at", "07:32:00", kNotNegative},
      {26, "[[run]]", 26, "run", "a list of tables, [[run]]", "one table, [run]"},
      {29, "dt = { s = 1 }", 29, "run.dt", "a table", kPositive},
  });
}

TEST(SceneErrors, NameNumbersOutOfRange) {
  expectRefusals({
      {4, "columns = 0", 4, "sheet.columns", "0", kCount},
      {4, "columns = 4097", 4, "sheet.columns", "4097", kCount},
      {5, "rows = -3", 5, "sheet.rows", "-3", kCount},
      {5, "rows = 9_000_000_000", 5, "sheet.rows", "9000000000", kCount},
      {6, "spacing = 0", 6, "sheet.spacing", "0", kPositive},
      {8, "particle_mass = -0.02", 8, "sheet.particle_mass", "-0.02", kPositive},
      {8, "area_density = 0.0", 8, "sheet.area_density", "0.0", kPositive},
      {12, "structural = { ks = -1 }", 12, "springs.structural.ks", "-1", kNotNegative},
      {14, "bend = { kd = -0.5 }", 14, "springs.bend.kd", "-0.5", kNotNegative},
      {17, "drag = -1", 17, "world.drag", "-1", kNotNegative},
      {24, "at = -0.5", 24, "push.at", "-0.5", kNotNegative},
      {25, "for = -1", 25, "push.for", "-1", kNotNegative},
      {27, "duration = 0", 27, "run.duration", "0", kPositive},
      {29, "dt = -0.0", 29, "run.dt", "-0.0", kPositive},
      {30, "tolerance = 0", 30, "run.tolerance", "0", kPositive},
  });
}

TEST(SceneErrors, NameNumbersThatAreNotFinite) {
  expectRefusals({
      {6, "spacing = inf", 6, "sheet.spacing", "inf", kPositive},
      {8, "particle_mass = nan", 8, "sheet.particle_mass", "nan", kPositive},
      {12, "structural = { ks = inf }", 12, "springs.structural.ks", "inf", kNotNegative},
      {16, "gravity = [0, -inf, 0]", 16, "world.gravity", "[0, -inf, 0]", kVector},
      {17, "drag = nan", 17, "world.drag", "nan", kNotNegative},
      {20, "by = [nan, 0, 0]", 20, "displace.by", "[nan, 0, 0]", kVector},
      {23, "force = [0, 0, inf]", 23, "push.force", "[0, 0, inf]", kVector},
      {27, "duration = inf", 27, "run.duration", "inf", kPositive},
  });
}

TEST(SceneErrors, NameParticlesThatAreNotThere) {
  const std::string sets = R"("top", "left", "corners", [column, row])";
  expectRefusals({
      {9, "pins = ['bottom']", 9, "sheet.pins", R"(particle "bottom")", kParticles + sets},
      {9, "pins = ['top',\n [4, 0]]", 10, "sheet.pins", "particle [4, 0]", "columns 0 to 3 and rows 0 to 2"},
      {9, "pins = [[-1, 0]]", 9, "sheet.pins", "particle [-1, 0]", "columns 0 to 3 and rows 0 to 2"},
      {19, "particle = [0, 3]", 19, "displace.particle", "particle [0, 3]", "columns 0 to 3 and rows 0 to 2"},
      {22, "particle = 'centre'", 22, "push.particle", R"(particle "centre")", kParticles + std::string("[column")},
      {22, "particle = 'top'", 22, "push.particle", R"(particle "top")", kParticles + std::string("[column, row]")},
      {22, "particle = [9999999999, 0]", 22, "push.particle", "[9999999999, 0]", kPlace},
  });
}

TEST(SceneErrors, NameUnknownWordsAndTheKnownOnes) {
  std::string names;
  for (const std::string_view name : methodNames()) names += (names.empty() ? "\"" : ", \"") + std::string(name) + '"';
  expectRefusals({
      {7, "start = 'upright'", 7, "sheet.start", R"("upright")", R"("hanging", "flat")"},
      {11, "damping = 'none'", 11, "springs.damping", R"("none")", R"("relative", "axial")"},
      {28, "integrator = 'RK4'", 28, "run.integrator", R"("RK4")", names},
      {31, "precision = 'half'", 31, "run.precision", R"("half")", R"("float", "double")"},
  });
}

TEST(SceneErrors, SayThatADensityNeedsAnArea) {
  const std::string said =
      refusalOf("title = 'Chain'\n[sheet]\ncolumns = 1\nrows = 9\nspacing = 1\narea_density = 1\n[run]");
  EXPECT_EQ(said,
            "wrong.toml:6: key sheet.area_density: found a density that gives no finite particle mass above 0, allowed "
            "particle_mass where the sheet has no area");
}

TEST(SceneErrors, NameTheLineThatIsNotToml) {
  struct Broken {
    int line;
    std::string text;
    int reported;
  };
  const std::vector<Broken> all = {
      {2, "shows = '\xff'", 2},
      {3, "[sheet]\n[sheet]", 4},
      {4, "columns = ", 4},
      {5, "columns = 4", 5},
      {6, "spacing = 0,1", 6},
      {9, "pins = ['top'", 10},
      {16, "gravity = [0 -9.8 0]", 16},
      {26, "[run", 26},
      {29, "dt = 2 ms", 29},
      {30, "tolerance = 1e999", 30},
      {5, "rows = 99999999999999999999", 5},
  };
  for (const Broken& broken : all) {
    const std::string said = refusalOf(sceneWith(broken.line, broken.text));
    const std::string expected = "wrong.toml:" + std::to_string(broken.reported) + ": found what is not TOML (";
    EXPECT_EQ(said.substr(0, expected.size()), expected) << "for: " << broken.text << "\nsaid: " << said;
    EXPECT_NE(said.find("), allowed TOML 1.0 in UTF-8"), std::string::npos) << said;
  }
}

TEST(SceneErrors, ShortenLongValuesBetweenCharacters) {
  std::string title;
  for (int n = 0; n < 40; ++n) title += "\u00e9";  // two bytes each: the 60th byte lies inside of one
  const std::string said = refusalOf(sceneWith(7, "start = '" + title + "'"));
  EXPECT_EQ(said,
            "wrong.toml:7: key sheet.start: found \"" + title.substr(0, 58) + "..., allowed \"hanging\", \"flat\"");
}

/// The message for a file that cannot be loaded.
std::string loadingError(const std::string& path) {
  try {
    loadScene(path, methodNames());
  } catch (const InputError& mistake) {
    return mistake.what();
  }
  return "";
}

TEST(SceneErrors, SayWhyAFileCannotBeRead) {
  const Folder folder;
  const std::string allowed = "; allowed: the path of a .toml file, or one of the built-in scenes curtain, ";
  const auto begins = [&](const std::string& path, const std::string& found) {
    const std::string expected = "cannot read the scene '" + path + "': " + found + allowed;
    EXPECT_EQ(loadingError(path).substr(0, expected.size()), expected);
  };
  begins((folder / "nowhere.toml").string(), "No such file or directory");
  begins(folder.path().string(), "it is a folder");
  begins("", "No such file or directory");
  begins("/proc/self/mem", "reading failed");
}

TEST(SceneErrors, NameTheFileThatWasLoaded) {
  const Folder folder;
  const std::filesystem::path path = folder.write("mine.toml", sceneWith(17, "drag = -1"));
  EXPECT_EQ(loadingError(path.string()),
            path.string() + ":17: key world.drag: found -1, allowed a finite number of at least 0");
}

TEST(SceneErrors, ListTheBuiltinScenesWhereANameIsUnknown) {
  const std::string said = loadingError("nonsense");
  EXPECT_NE(said.find("'nonsense'"), std::string::npos) << said;
  for (const BuiltinScene& scene : builtinScenes()) {
    EXPECT_NE(said.find(std::string(scene.name)), std::string::npos) << scene.name << " in: " << said;
  }
}

TEST(SceneErrors, CountTheLinesOfOtherSystemsAlike) {
  std::string text = "\xef\xbb\xbf";
  for (const char c : sceneWith(17, "drag = -1")) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(refusalOf(text), "wrong.toml:17: key world.drag: found -1, allowed a finite number of at least 0");
}

TEST(SceneErrors, NameTheGridThatASheetCannotHave) {
  const Scene scene = loadScene("curtain");
  for (const auto& [columns, rows] : {std::pair{0, 5}, {9, 0}, {4097, 5}, {9, 4097}, {-1, 5}}) {
    try {
      withSheet(scene, columns, rows);
      ADD_FAILURE() << columns << "x" << rows << " was taken";
    } catch (const InputError& mistake) {
      EXPECT_EQ(std::string(mistake.what()),
                "sheet: found " + std::to_string(columns) + "x" + std::to_string(rows) + ", allowed 1x1 to 4096x4096");
    }
  }
  EXPECT_EQ(withSheet(scene, 4096, 1).columns, 4096);
}

}  // namespace
}  // namespace tyg::test
