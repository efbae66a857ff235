// Wavefront's format: lines `v`, `vt`, `vn`, `f` and `l`, with points counted from 1 through the whole file.
#include "app/output/obj_folder.h"

#include <algorithm>

#include <fmt/core.h>
#include <fmt/format.h>

#include "util/visible_text.h"
#include "util/whole_folder.h"
#include "view/body_shapes.h"

namespace tyg {
namespace {

/// Whether an earlier export may have written a file of this name.
bool isFrame(const std::string& name) {
  constexpr std::size_t kDigits = 5;
  const std::string_view front = "frame_", ending = ".obj";
  if (name.size() < front.size() + kDigits + ending.size() || !name.starts_with(front) || !name.ends_with(ending)) {
    return false;
  }
  const std::string_view digits =
      std::string_view(name).substr(front.size(), name.size() - front.size() - ending.size());
  return std::ranges::all_of(digits, [](char c) { return c >= '0' && c <= '9'; });
}

class ObjFolder final : public ExportSink {
 public:
  explicit ObjFolder(const std::filesystem::path& path) : folder_(path, isFrame) {}

  void begin(const ExportedScene& scene, const ExportedFrame& first) override {
    heading_ = "# Tyg, " + oneLine(scene.scene.name);
    for (std::size_t k = 0; k < first.bodies.size(); ++k) {
      names_.push_back(exportedName(scene.scene, k));
      bodies_.push_back(bodyMesh(first.bodies[k], boxAround(first.xyz), first.bodies));
    }
  }

  void add(const ExportedFrame& frame) override {
    std::string text = fmt::format("{}, {:g} s\n", heading_, frame.time);
    addCloth(frame, text);
    Counts before{frame.cloth.points().size(), frame.cloth.quads().empty() ? 0 : frame.cloth.points().size()};
    for (std::size_t k = 0; k < bodies_.size(); ++k) {
      text += fmt::format("o {}\n", names_[k]);
      addBody(bodies_[k], frame.bodies[k], before, text);
      before.points += bodies_[k].points.size(), before.normals += bodies_[k].points.size();
    }
    folder_.write(fmt::format("frame_{:05}.obj", frame.number), text);
  }

  void keep() override { folder_.keep(); }

 private:
  struct Counts {
    std::size_t points, normals;
  };

  static void addCloth(const ExportedFrame& frame, std::string& text) {
    const auto out = std::back_inserter(text);
    const LastingMesh& cloth = frame.cloth;
    text += "o cloth\n";
    for (const glm::vec3& p : cloth.points()) fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
    for (const SpringEnds& link : chainLinks(frame.sheet)) {
      fmt::format_to(out, "l {} {}\n", link.first + 1, link.second + 1);
    }
    if (frame.sheet.count() == 1) text += "p 1\n";
    if (cloth.quads().empty()) return;
    for (const glm::vec2& place : cloth.places()) {
      const glm::vec2 at = pictureAt(frame.sheet, place);
      fmt::format_to(out, "vt {} {}\n", at.x, at.y);
    }
    for (const glm::vec3& n : cloth.normals()) fmt::format_to(out, "vn {:.5f} {:.5f} {:.5f}\n", n.x, n.y, n.z);
    for (const auto& quad : cloth.quads()) {
      text += "f";
      for (const std::uint32_t point : quad) fmt::format_to(out, " {0}/{0}/{0}", point + 1);
      text += "\n";
    }
  }

  static void addBody(const BodyMesh& mesh, const Body& body, const Counts& before, std::string& text) {
    const auto out = std::back_inserter(text);
    const glm::mat4 model = bodyModel(body);
    for (const SolidVertex& point : mesh.points) {
      const glm::vec3 p = model * glm::vec4(point.position, 1);
      fmt::format_to(out, "v {} {} {}\n", p.x, p.y, p.z);
    }
    for (const SolidVertex& point : mesh.points) {
      const glm::vec3 n = model * glm::vec4(point.normal, 0);
      fmt::format_to(out, "vn {:.5f} {:.5f} {:.5f}\n", n.x, n.y, n.z);
    }
    for (const auto& face : mesh.faces) {
      text += "f";
      for (const std::uint32_t point : face) {
        fmt::format_to(out, " {}//{}", before.points + point + 1, before.normals + point + 1);
      }
      text += "\n";
    }
  }

  WholeFolder folder_;
  std::string heading_;
  std::vector<std::string> names_;
  std::vector<BodyMesh> bodies_;
};

}  // namespace

std::unique_ptr<ExportSink> openObjFolder(const std::filesystem::path& folder) {
  return std::make_unique<ObjFolder>(folder);
}

}  // namespace tyg
