// Values and attributes in the text format of USD, as they stand inside a prim of a prim.
// Must not know: what they are of.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include <glm/glm.hpp>

#include <fmt/format.h>

namespace tyg {

/// A text between quotes.
inline std::string usdString(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

inline void addTuple(const glm::vec2& v, std::string& text) {
  fmt::format_to(std::back_inserter(text), "({}, {})", v.x, v.y);
}
inline void addTuple(const glm::vec3& v, std::string& text) {
  fmt::format_to(std::back_inserter(text), "({}, {}, {})", v.x, v.y, v.z);
}

/// `[(x, y, z), ...]` with the fewest digits that read back as the numbers themselves.
template <class Tuples>
std::string usdTuples(const Tuples& tuples) {
  std::string text = "[";
  for (const auto& tuple : tuples) {
    if (text.size() > 1) text += ", ";
    addTuple(tuple, text);
  }
  return text + "]";
}

/// The same of directions, which nobody needs that exactly.
inline std::string usdNormals(std::span<const glm::vec3> normals) {
  std::string text = "[";
  for (const glm::vec3& n : normals) {
    fmt::format_to(std::back_inserter(text), "{}({:.5f}, {:.5f}, {:.5f})", text.size() > 1 ? ", " : "", n.x, n.y, n.z);
  }
  return text + "]";
}

/// The attributes that say which points the faces of a mesh have.
template <class Faces>
std::string usdFaces(const Faces& faces) {
  std::string counts, points;
  for (const auto& face : faces) {
    fmt::format_to(std::back_inserter(counts), "{}{}", counts.empty() ? "" : ", ", face.size());
    for (const auto point : face) {
      fmt::format_to(std::back_inserter(points), "{}{}", points.empty() ? "" : ", ", point);
    }
  }
  return "        int[] faceVertexCounts = [" + counts + "]\n        int[] faceVertexIndices = [" + points + "]\n";
}

/// The colour of a whole prim, of a colour as it looks on a screen; the format wants it linear (IEC 61966-2-1).
std::string usdColour(const glm::vec3& onScreen);

}  // namespace tyg
