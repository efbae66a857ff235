// `tyg export`: USD and OBJ files read back and compared with the samples of `tyg run`, and refusals.
#include <csignal>
#include <filesystem>
#include <sstream>

#include "app/program.h"
#include "app/usd_reader.h"

namespace tyg {
namespace {

namespace fs = std::filesystem;

/// Positions by sample, particle after particle, of a file of `tyg run --out`.
std::vector<std::vector<float>> samplesOf(const fs::path& csv) {
  std::istringstream lines(contentsOf(csv));
  std::vector<std::vector<float>> samples;
  std::string line, lastTime;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream fields(line);
    std::string time, field;
    std::getline(fields, time, ','), std::getline(fields, field, ',');
    if (time != lastTime) samples.emplace_back();
    lastTime = time;
    for (int axis = 0; axis < 3; ++axis) {
      std::getline(fields, field, ',');
      samples.back().push_back(static_cast<float>(std::stod(field)));
    }
  }
  return samples;
}

/// The first `count` of some numbers.
template <class Number>
std::vector<float> firstOf(const std::vector<Number>& numbers, std::size_t count) {
  std::vector<float> first;
  for (std::size_t i = 0; i < count && i < numbers.size(); ++i) first.push_back(static_cast<float>(numbers[i]));
  return first;
}

/// What the lines of an OBJ file hold that begin with this word, in order, as `read` reads the text behind it.
std::vector<double> numbersAfter(const std::string& text, const std::string& word) {
  std::istringstream lines(text);
  std::vector<double> numbers;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(word + " ")) continue;
    std::istringstream fields(line.substr(word.size()));
    for (double number = 0; fields >> number;) numbers.push_back(number);
  }
  return numbers;
}

/// The point numbers of the faces, counted from 1.
std::vector<std::vector<int>> facesIn(const std::string& text) {
  std::istringstream lines(text);
  std::vector<std::vector<int>> faces;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("f ")) continue;
    std::istringstream corners(line.substr(2));
    faces.emplace_back();
    for (std::string corner; corners >> corner;) faces.back().push_back(std::stoi(corner));
  }
  return faces;
}

class Export : public testing::Test {
 protected:
  UsdPrim usd(const std::string& options) {
    const Outcome outcome = tyg("export " + options + " --out " + (folder_ / "a.usda").string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return readUsd(contentsOf(folder_ / "a.usda"));
  }
  std::vector<std::vector<float>> samples(const std::string& options, int count) {
    const Outcome outcome =
        tyg("run " + options + " --samples " + std::to_string(count) + " --out " + (folder_ / "a.csv").string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return samplesOf(folder_ / "a.csv");
  }
  const Folder folder_;
};

TEST_F(Export, UsdHoldsThePositionsOfARunAtTheTimesOfItsFrames) {
  const std::string run = "flag --duration 0.5";
  const UsdPrim layer = usd(run + " --fps 8");
  EXPECT_EQ(layer.values.at("timeCodesPerSecond"), "8");
  EXPECT_EQ(layer.values.at("startTimeCode") + layer.values.at("endTimeCode"), "04");
  EXPECT_EQ(layer.values.at("upAxis") + layer.values.at("metersPerUnit"), "Y1");
  const auto& points = layer.prim("World").prim("Cloth").samples.at("points");
  const auto samples = this->samples(run, 4);
  ASSERT_EQ(points.size(), 5U) << "both ends";
  ASSERT_EQ(samples.size(), 4U);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    EXPECT_EQ(firstOf(points.at(double(k + 1)), points.at(double(k + 1)).size()), samples[k]) << k;
  }
}

TEST_F(Export, FramesAreCountedFromTheFirstTimeThatIsAskedFor) {
  const UsdPrim layer = usd("curtain --from 0.25 --to 0.5 --fps 8");
  const auto& points = layer.prim("World").prim("Cloth").samples.at("points");
  ASSERT_EQ(points.size(), 3U);
  // The same stops as the export has, so that the steps are the same.
  const auto samples = this->samples("curtain --duration 0.25", 1);
  EXPECT_EQ(firstOf(points.at(0), points.at(0).size()), samples.back());
}

TEST_F(Export, TheClothOfUsdIsQuadsWhosePointsAndNormalsExist) {
  const UsdPrim cloth = usd("curtain --duration 0.1").prim("World").prim("Cloth");
  EXPECT_EQ(cloth.type, "Mesh");
  const std::size_t points = cloth.samples.at("points").at(0).size() / 3;
  EXPECT_EQ(points, 400U);
  EXPECT_EQ(cloth.samples.at("normals").at(0).size() / 3, points);
  EXPECT_EQ(cloth.numbers("primvars:st").size() / 2, points);
  EXPECT_EQ(cloth.numbers("faceVertexCounts"), std::vector<double>(19 * 19, 4));
  for (const double corner : cloth.numbers("faceVertexIndices")) EXPECT_LT(corner, double(points));
  EXPECT_EQ(cloth.samples.at("extent").at(0).size(), 6U);
}

TEST_F(Export, ObjFilesHoldTheSamePositionsAsTheRun) {
  const std::string run = "ball --sheet 12x12 --dt 0.004 --duration 0.5";
  const Outcome outcome = tyg("export " + run + " --fps 8 --out " + (folder_ / "frames").string());
  ASSERT_EQ(outcome.code, 0) << outcome.err;
  const auto samples = this->samples(run, 4);
  ASSERT_EQ(samples.size(), 4U);
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const std::string text = contentsOf(folder_ / "frames" / ("frame_0000" + std::to_string(k + 1) + ".obj"));
    const auto points = numbersAfter(text, "v");
    EXPECT_EQ(firstOf(points, samples[k].size()), samples[k]) << k;
    const std::vector<std::vector<int>> faces = facesIn(text);
    ASSERT_GT(faces.size(), 11U * 11U) << "cloth and bodies";
    for (std::size_t i = 0; i < faces.size(); ++i) {
      EXPECT_TRUE(i >= 121 || faces[i].size() == 4);
      for (const int corner : faces[i]) EXPECT_TRUE(corner >= 1 && corner <= int(points.size() / 3));
    }
    EXPECT_TRUE(holds(text, "o cloth\n") && holds(text, "o ball_1\n") && holds(text, "o plane_2\n"));
  }
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "frames"), fs::directory_iterator()), 5);
}

TEST_F(Export, TheBallOfObjHasItsRadius) {
  ASSERT_EQ(tyg("export ball --to 0.01 --fps 100 --out " + (folder_ / "frames").string()).code, 0);
  const std::string text = contentsOf(folder_ / "frames" / "frame_00000.obj");
  const std::size_t from = text.find("o ball_1"), to = text.find("o plane_2");
  const auto points = numbersAfter(text.substr(from, to - from), "v");
  ASSERT_GT(points.size(), 300U);
  for (std::size_t i = 0; i < points.size(); i += 3) {
    EXPECT_NEAR(std::hypot(points[i] - 0.17, points[i + 1] + 0.65, points[i + 2] - 0.8), 0.45, 1e-6);
  }
}

constexpr const char* kBodies = R"(title = "Bodies"
[sheet]
columns = 4
rows = 4
spacing = 0.1
particle_mass = 0.01
[springs]
structural = { ks = 20, kd = 0.01 }
[contact]
layer = 0.01
[[body]]
shape = "ball"
name = "the \"ball"
at = [0, 0.5, 0]
radius = 0.2
[[body]]
shape = "capsule"
from = [1, 0, 0]
to = [1, 0, 2]
radius = 0.25
[[body]]
shape = "box"
at = [3, 0, 0]
half = [0.5, 0.4, 0.3]
rounding = 0.15
[[body]]
shape = "plane"
at = [0, -5, 0]
[[move]]
what = "the \"ball"
velocity = [1, 0, 0]
at = 0.25
for = 1
[run]
duration = 0.5
integrator = "rk4"
dt = 0.001
)";

TEST_F(Export, BodiesOfUsdAreShapesAndOnlyThoseThatMoveHaveSamples) {
  const UsdPrim world = usd(folder_.write("bodies.toml", kBodies).string() + " --fps 4").prim("World");
  const UsdPrim& ball = world.prim("the__ball_1");
  EXPECT_EQ(ball.type, "Sphere");
  EXPECT_EQ(ball.values.at("radius"), "0.2");
  const auto& places = ball.samples.at("xformOp:translate");
  EXPECT_EQ(places.at(1), (std::vector<double>{0, 0.5, 0}));
  EXPECT_NEAR(places.at(2).front(), 0.25, 1e-12);
  const UsdPrim& capsule = world.prim("capsule_2");
  EXPECT_EQ(capsule.type + capsule.values.at("axis") + capsule.values.at("height"), "CapsuleY2");
  EXPECT_EQ(capsule.numbers("xformOp:translate"), (std::vector<double>{1, 0, 1})) << "its middle";
  const std::vector<double> rows = capsule.numbers("xformOp:transform");
  EXPECT_EQ(std::vector(rows.begin() + 4, rows.begin() + 7), (std::vector<double>{0, 0, 1})) << "its y goes along z";
  const UsdPrim& box = world.prim("box_3");
  EXPECT_EQ(box.type, "Mesh") << "its edges are rounded";
  const std::vector<double> extent = box.numbers("extent");
  for (const auto& [index, half] : {std::pair(3, 0.5), {4, 0.4}, {5, 0.3}}) EXPECT_NEAR(extent.at(index), half, 1e-6);
  const UsdPrim& plane = world.prim("plane_4");
  EXPECT_EQ(plane.numbers("faceVertexIndices").size(), 4U);
  for (std::size_t i = 1; i < 12; i += 3) EXPECT_EQ(plane.numbers("points")[i], 0) << "in the height of its own point";
}

TEST_F(Export, ACutClothKeepsItsFacesAndOpensBesideTheCut) {
  const UsdPrim cloth = usd("cut --duration 1 --fps 4").prim("World").prim("Cloth");
  const auto& points = cloth.samples.at("points");
  const std::vector<double> corners = cloth.numbers("faceVertexIndices");
  ASSERT_EQ(points.size(), 5U);
  // The longest side of any face; the cut is at 0.6 s.
  const auto longest = [&](double frame) {
    double most = 0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t a = 3 * std::size_t(corners[i]), b = 3 * std::size_t(corners[i % 4 == 3 ? i - 3 : i + 1]);
      const auto& p = points.at(frame);
      most = std::max(most, std::hypot(p[a] - p[b], p[a + 1] - p[b + 1], p[a + 2] - p[b + 2]));
    }
    return most;
  };
  EXPECT_GT(points.at(0).size(), std::size_t{3 * 24 * 20}) << "points of their own for both sides of the cut";
  EXPECT_EQ(points.at(0).size(), points.at(4).size());
  EXPECT_LT(longest(4), 0.08 * 1.5) << "nothing joins both sides";
  EXPECT_EQ(cloth.numbers("faceVertexCounts"), std::vector<double>(corners.size() / 4, 4));
}

TEST_F(Export, AChainIsACurveInUsdAndLinesInObj) {
  const UsdPrim chain = usd("chain --duration 0.1").prim("World").prim("Cloth");
  EXPECT_EQ(chain.type, "BasisCurves");
  const std::vector<double> counts = chain.numbers("curveVertexCounts");
  ASSERT_EQ(counts.size(), 1U);
  EXPECT_EQ(chain.samples.at("points").at(0).size(), 3 * std::size_t(counts[0]));
  ASSERT_EQ(tyg("export chain --to 0.1 --out " + (folder_ / "frames").string()).code, 0);
  const auto ends = numbersAfter(contentsOf(folder_ / "frames" / "frame_00002.obj"), "l");
  EXPECT_EQ(ends.size(), 2 * std::size_t(counts[0] - 1));
}

TEST_F(Export, AFailedSimulationLeavesNothingAndExitsWithOne) {
  for (const char* out : {"lost.usda", "lost"}) {
    const Outcome outcome = tyg("export curtain --integrator rk4 --dt 0.05 --out " + (folder_ / out).string());
    EXPECT_EQ(outcome.code, 1);
    EXPECT_TRUE(holds(outcome.err, "rk4")) << outcome.err;
    EXPECT_EQ(folder_.fileCount(), 0U) << out;
  }
}

TEST_F(Export, ReplacesAnEarlierExportAndNothingElse) {
  const std::string to = " --out " + (folder_ / "frames").string();
  ASSERT_EQ(tyg("export spring --to 0.5 --fps 8" + to).code, 0);
  ASSERT_EQ(tyg("export spring --to 0.25 --fps 8" + to).code, 0);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_ / "frames"), fs::directory_iterator()), 3);
  folder_.write("frames/notes.txt", "mine");
  const Outcome refused = tyg("export spring --to 0.5 --fps 8" + to);
  EXPECT_EQ(refused.code, 2);
  EXPECT_TRUE(holds(refused.err, "notes.txt")) << refused.err;
  EXPECT_EQ(contentsOf(folder_ / "frames" / "notes.txt"), "mine");
}

TEST_F(Export, RefusesOutputsAndTimesThatDoNotFit) {
  const std::string there = (folder_ / "a").string();
  EXPECT_EQ(tyg("export curtain --out " + there + ".fbx").code, 2);
  EXPECT_EQ(tyg("export curtain --out /nowhere/a.usda").code, 2);
  EXPECT_EQ(tyg("export curtain --out /nowhere/a").code, 2);
  EXPECT_EQ(tyg("export curtain --from 1 --to 0.5 --out " + there).code, 2);
  EXPECT_EQ(tyg("export curtain --fps 0 --out " + there).code, 2);
  EXPECT_EQ(folder_.fileCount(), 0U);
}

}  // namespace
}  // namespace tyg
