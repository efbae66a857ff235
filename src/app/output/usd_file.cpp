// The format holds all samples of one attribute together. Points, which are most of the file, are written as they come;
// normals wait in a file of their own, and what is short waits in memory. Schemas: OpenUSD, UsdGeom.
#include "app/output/usd_file.h"

#include <array>
#include <fstream>
#include <optional>

#include <fmt/core.h>
#include <fmt/format.h>

#include "app/output/usd_bodies.h"
#include "app/output/usd_text.h"
#include "util/visible_text.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

/// What of a sheet is a prim: a mesh of cells, a chain's curves, or a single particle.
enum class Form { Mesh, Curves, Point };
Form formOf(const Sheet& sheet) {
  return sheet.count() == 1 ? Form::Point : sheet.columns == 1 || sheet.rows == 1 ? Form::Curves : Form::Mesh;
}

class UsdFile final : public ExportSink {
 public:
  explicit UsdFile(const std::filesystem::path& path) : file_(path), normals_(path) {}

  void begin(const ExportedScene& scene, const ExportedFrame& first) override {
    form_ = formOf(scene.last);
    losesLinks_ = form_ == Form::Curves && !scene.last.missing.none();
    bodies_.emplace(scene.scene, first);
    std::string text = heading(scene);
    text += fmt::format("def Xform \"World\"\n{{\n    def {} \"Cloth\"\n    {{\n", primType());
    addWhatStays(scene, first.cloth, text);
    text += "        point3f[] points.timeSamples = {\n";
    file_.write(text);
  }

  void add(const ExportedFrame& frame) override {
    const std::vector<glm::vec3>& points = losesLinks_ ? linkEnds(frame) : frame.cloth.points();
    file_.write(sample(frame.number, usdTuples(points)));
    if (form_ == Form::Mesh) normals_.write(sample(frame.number, usdNormals(frame.cloth.normals())));
    const Box box = boxAround({&points.front().x, 3 * points.size()});
    const std::array<glm::vec3, 2> ends{box.low, box.high};
    extents_ += sample(frame.number, usdTuples(ends));
    bodies_->add(frame);
  }

  void keep() override {
    file_.write("        }\n");
    if (form_ == Form::Mesh) {
      file_.write("        normal3f[] normals.timeSamples = {\n");
      appendNormals();
      file_.write("        }\n");
    }
    file_.write("        float3[] extent.timeSamples = {\n" + extents_ + "        }\n    }\n" + bodies_->text() +
                "}\n");
    file_.keep();
  }

 private:
  static std::string heading(const ExportedScene& scene) {
    return fmt::format(
        "#usda 1.0\n(\n    defaultPrim = \"World\"\n    doc = {}\n    endTimeCode = {}\n    framesPerSecond = {}\n"
        "    metersPerUnit = 1\n    startTimeCode = 0\n    timeCodesPerSecond = {}\n    upAxis = \"Y\"\n)\n\n",
        usdString("Tyg, " + oneLine(scene.scene.name) + ": " + oneLine(scene.scene.title)), scene.frames - 1, scene.fps,
        scene.fps);
  }

  static std::string sample(std::size_t frame, const std::string& value) {
    return fmt::format("            {}: {},\n", frame, value);
  }

  [[nodiscard]] const char* primType() const {
    return form_ == Form::Mesh ? "Mesh" : form_ == Form::Curves ? "BasisCurves" : "Points";
  }

  void addWhatStays(const ExportedScene& scene, const LastingMesh& cloth, std::string& text) const {
    constexpr double kWidth = 0.1;  // of the spacing
    const auto out = std::back_inserter(text);
    text += usdColour(clothColour(scene.scene));
    if (form_ == Form::Mesh) return addMesh(scene.last, cloth, text);
    fmt::format_to(out, "        float[] widths = [{}] (\n            interpolation = \"constant\"\n        )\n",
                   float(kWidth * scene.scene.spacing));
    if (form_ == Form::Point) return;
    text += "        uniform token type = \"linear\"\n        int[] curveVertexCounts = [";
    const int curves = losesLinks_ ? scene.last.count() - 1 : 1;
    for (int curve = 0; curve < curves; ++curve) {
      fmt::format_to(out, "{}{}", curve == 0 ? "" : ", ", losesLinks_ ? 2 : scene.last.count());
    }
    text += "]\n";
  }

  static void addMesh(const Sheet& sheet, const LastingMesh& cloth, std::string& text) {
    text += "        uniform bool doubleSided = 1\n        uniform token subdivisionScheme = \"none\"\n";
    text += usdFaces(cloth.quads());
    std::vector<glm::vec2> onPicture;
    for (const glm::vec2& place : cloth.places()) onPicture.push_back(pictureAt(sheet, place));
    text += "        texCoord2f[] primvars:st = " + usdTuples(onPicture) +
            " (\n            interpolation = \"vertex\"\n        )\n";
  }

  /// The ends of every link of a chain that loses some: one that is gone has both ends on its first particle.
  const std::vector<glm::vec3>& linkEnds(const ExportedFrame& frame) {
    linkEnds_.clear();
    const std::vector<glm::vec3>& particles = frame.cloth.points();
    const bool isRow = frame.sheet.rows == 1;
    for (int first = 0; first + 1 < frame.sheet.count(); ++first) {
      const bool isGone = frame.sheet.missing.has(first, isRow ? Missing::Right : Missing::Down);
      linkEnds_.push_back(particles[std::size_t(first)]);
      linkEnds_.push_back(particles[std::size_t(isGone ? first : first + 1)]);
    }
    return linkEnds_;
  }

  void appendNormals() {
    std::ifstream in(normals_.temporary(), std::ios::binary);
    std::string piece(std::size_t{1} << 20U, '\0');
    while (in.read(piece.data(), std::streamsize(piece.size())) || in.gcount() > 0) {
      file_.write(std::string_view(piece).substr(0, std::size_t(in.gcount())));
    }
  }

  WholeFile file_, normals_;  // of the second only what was written is used: it is never kept
  Form form_ = Form::Mesh;
  bool losesLinks_ = false;
  std::optional<UsdBodies> bodies_;
  std::string extents_;
  std::vector<glm::vec3> linkEnds_;
};

}  // namespace

std::unique_ptr<ExportSink> openUsdFile(const std::filesystem::path& file) { return std::make_unique<UsdFile>(file); }

}  // namespace tyg
