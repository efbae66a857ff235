// Writes the keys in the order of the built-in files, each with its unit as a comment.
#include "core/scene/scene_writer.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/forces/terms/contact.h"
#include "core/scene/bodies.h"
#include "core/scene/look_keys.h"
#include "core/scene/scene_range.h"
#include "core/scene/term_keys.h"
#include "util/text.h"
#include "util/utf8.h"
#include "util/visible_text.h"

namespace tyg {
namespace {

constexpr std::size_t kUnitColumn = 25;  // where the comments begin

std::string numberText(double number) {
  std::string text = shortNumber(number);
  // Whole numbers without a point are TOML integers, of 64 bits and without a negative zero.
  constexpr double kWholeUpTo = 1e15;
  const bool isInteger = text.find_first_of(".en") == std::string::npos;
  if (isInteger && (std::abs(number) > kWholeUpTo || (number == 0 && std::signbit(number)))) text += ".0";
  return text;
}

std::string vectorText(const Vec3& vector) {
  return fmt::format("[{}, {}, {}]", numberText(vector.x), numberText(vector.y), numberText(vector.z));
}

/// A TOML basic string with its quotes. What is active in a text is written as an escape, and reads back.
std::string quoted(std::string_view text) {
  std::string literal = "\"";
  while (!text.empty()) {
    const Utf8Character character = firstCharacter(text);
    const std::uint32_t code = character.code;
    if (code == '"' || code == '\\') {
      literal += {'\\', text.front()};
    } else if (isActive(code)) {
      literal += code <= 0xFFFF ? fmt::format("\\u{:04X}", code) : fmt::format("\\U{:08X}", code);
    } else {
      literal += code == U'\uFFFD' ? kReplacement : text.substr(0, character.length);
    }
    text.remove_prefix(character.length);
  }
  return literal + '"';
}

std::string placeText(const Place& place) {
  if (!place.name.empty()) return quoted(place.name);
  return fmt::format("[{}, {}]", place.column, place.row);
}

class Writer {
 public:
  /// Nothing that is active gets into a comment, which TOML would not read.
  void comment(std::string_view words) {
    const std::string shown = withoutActive(words);
    std::string_view text = shown;
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      text_.append("# ").append(text.substr(0, end)).append("\n");
      text.remove_prefix(std::min(end + 1, text.size()));
    }
  }
  void table(std::string_view header) { text_.append("\n").append(header).append("\n"); }
  void line(std::string_view key, const std::string& value, std::string_view unit = "") {
    std::string line = std::string(key) + " = " + value;
    if (!unit.empty()) {
      line.resize(std::max(line.size() + 1, kUnitColumn), ' ');
      line.append("# ").append(unit);
    }
    text_ += line + "\n";
  }
  void append(std::string_view lines) { text_ += lines; }
  [[nodiscard]] std::string text() { return std::move(text_); }

 private:
  std::string text_;
};

void writeSheet(Writer& out, const Scene& scene) {
  out.table("[sheet]");
  out.line("columns", fmt::format("{}", scene.columns));
  out.line("rows", fmt::format("{}", scene.rows));
  out.line("spacing", numberText(scene.spacing), "m");
  if (scene.start == Start::Flat) out.line("start", "\"flat\"");
  out.line("particle_mass", numberText(scene.particleMass), "kg");
  if (scene.pins.empty()) return;
  std::string pins;
  for (const Place& pin : scene.pins) pins += (pins.empty() ? "[" : ", ") + placeText(pin);
  out.line("pins", pins + "]");
}

std::string valueText(const Parameter& parameter, const Scene& scene) {
  const Vec3 value = parameter.get(scene);
  return parameter.count == 1 ? numberText(value.x) : vectorText(value);
}

/// The parameters of a term, but for those of an empty world; where they have a table of their own, all or none.
void writeTerm(Writer& out, const ForceTerm& term, const Scene& scene) {
  static const Scene kEmptyWorld = [] {
    Scene world;
    world.bodies.emplace_back();  // or else contact would have no numbers to compare with
    return world;
  }();
  const bool isThere = hasTerm(scene, term);
  const auto isOwn = [&](const Parameter& parameter) {
    if (!isThere && !parameter.decidesPresence) return false;
    if (parameter.ofList) return false;
    return parameter.get(scene) != parameter.get(kEmptyWorld) || (isThere && parameter.required);
  };
  const std::string_view inner = partsOf(term.parameters.front().key).inner;
  if (inner.empty()) {
    for (const Parameter& parameter : term.parameters) {
      if (isOwn(parameter)) out.line(partsOf(parameter.key).last, valueText(parameter, scene), parameter.unit);
    }
  } else if (std::ranges::any_of(term.parameters, isOwn)) {
    const auto assignment = [&](const Parameter& parameter) {
      return std::string(partsOf(parameter.key).last) + " = " + valueText(parameter, scene);
    };
    out.line(inner, "{ " + joined(term.parameters, assignment) + " }", joined(term.parameters, &Parameter::unit));
  }
}

void writeTerms(Writer& out, std::string_view name, const Scene& scene) {
  Writer lines;
  if (name == kSpringsTable && scene.damping == Damping::Axial) lines.line("damping", "\"axial\"");
  for (const ForceTerm* term : forceTerms()) {
    if (partsOf(term->parameters.front().key).table == name) writeTerm(lines, *term, scene);
  }
  if (name == kContactTable && hasTerm(scene, ContactTerm::kTerm) && scene.contact.gap) {
    lines.line("gap", numberText(*scene.contact.gap), "m");
  }
  std::string text = lines.text();
  if (text.empty() && name == kAirTable && !scene.winds.empty()) text = "density = 0\n";  // a wind needs the table
  if (text.empty()) return;
  out.table("[" + std::string(name) + "]");
  out.append(text);
}

/// The number that reads back as `along` when `from` is taken from it: a step or two beside the sum, where there is
/// one.
double otherEnd(double from, double along) {
  const double sum = from + along;
  double above = sum, below = sum;
  for (int k = 0; k < 3; ++k) {
    if (above - from == along) return above;
    if (below - from == along) return below;
    above = std::nextafter(above, kLargestNumber), below = std::nextafter(below, -kLargestNumber);
  }
  return sum;
}

/// Only where the cloth touches them, as scene files have both or neither.
void writeBodies(Writer& out, const Scene& scene) {
  if (!hasTerm(scene, ContactTerm::kTerm)) return;
  for (const Body& body : scene.bodies) {
    const Vec3 &at = body.at, &axis = body.axis;
    out.table("[[body]]");
    if (!body.name.empty()) out.line("name", quoted(body.name));
    switch (body.shape) {
      case Shape::Plane:
        out.line("shape", "\"plane\"");
        out.line("at", vectorText(at), "m");
        out.line("normal", vectorText(body.normal));
        break;
      case Shape::Ball:
        out.line("shape", "\"ball\"");
        out.line("at", vectorText(at), "m");
        out.line("radius", numberText(body.radius), "m");
        break;
      case Shape::Capsule:
        out.line("shape", "\"capsule\"");
        out.line("from", vectorText(at), "m");
        out.line("to", vectorText({otherEnd(at.x, axis.x), otherEnd(at.y, axis.y), otherEnd(at.z, axis.z)}), "m");
        out.line("radius", numberText(body.radius), "m");
        break;
      case Shape::Box:
        out.line("shape", "\"box\"");
        out.line("at", vectorText(at), "m");
        out.line("half", vectorText(body.half), "m");
        out.line("rounding", numberText(body.radius), "m");
        break;
    }
  }
}

void writeEvents(Writer& out, const Scene& scene) {
  for (const Displacement& displacement : scene.displacements) {
    out.table("[[displace]]");
    out.line("particle", placeText(displacement.particle));
    out.line("by", vectorText(displacement.by), "m");
  }
  for (const Wind& wind : scene.winds) {
    out.table("[[wind]]");
    out.line("velocity", vectorText(wind.velocity), "m/s");
    if (wind.gust != Vec3{}) out.line("gust", vectorText(wind.gust), "m/s");
    if (wind.wavelength > 0) out.line("wavelength", numberText(wind.wavelength), "m");
    if (wind.at != 0) out.line("at", numberText(wind.at), "s");
    if (std::isfinite(wind.duration)) out.line("for", numberText(wind.duration), "s");
  }
  for (const Move& move : scene.moves) {
    if (!move.body.empty() && !hasTerm(scene, ContactTerm::kTerm)) continue;
    out.table("[[move]]");
    out.line("what", move.body.empty() ? "[" + joined(move.what, placeText) + "]" : quoted(move.body));
    out.line("velocity", vectorText(move.velocity), "m/s");
    out.line("at", numberText(move.at), "s");
    out.line("for", numberText(move.duration), "s");
  }
  if (scene.tear.toughness > 0 && scene.structural.ks > 0) {
    out.table("[tear]");
    out.line("toughness", numberText(scene.tear.toughness), "J/m");
  }
  for (const auto& [line, at] : scene.cuts) {
    out.table("[[cut]]");
    out.line("from", fmt::format("[{}, {}]", numberText(line.fromColumn), numberText(line.fromRow)), "column, row");
    out.line("to", fmt::format("[{}, {}]", numberText(line.toColumn), numberText(line.toRow)), "column, row");
    out.line("at", numberText(at), "s");
  }
  for (const Push& push : scene.pushes) {
    out.table("[[push]]");
    out.line("particle", placeText(push.particle));
    out.line("force", vectorText(push.force), "N");
    out.line("at", numberText(push.at), "s");
    out.line("for", numberText(push.duration), "s");
  }
}

std::string inQuotes(std::string_view word) { return '"' + std::string(word) + '"'; }

/// What a scene does not have to say is left out.
void writeLook(Writer& out, const Scene& scene) {
  const Look& look = scene.look;
  if (look != Look{}) {
    out.table("[look]");
    if (look.show != Look{}.show) out.line("show", inQuotes(nameOf(look.show)));
    if (look.colour) out.line("colour", vectorText(*look.colour), "red, green, blue");
    if (!look.image.empty()) {
      out.line("image", quoted(look.image));
    } else if (look.weave != Look{}.weave) {
      out.line("weave", inQuotes(nameOf(look.weave)));
    }
  }
  for (const Lamp& lamp : scene.lamps) {
    out.table("[[lamp]]");
    lamp.at ? out.line("at", vectorText(*lamp.at), "m") : out.line("direction", vectorText(lamp.direction));
    if (lamp.colour != Lamp{}.colour) out.line("colour", vectorText(lamp.colour), "red, green, blue");
  }
}

void writeRun(Writer& out, const Scene& scene) {
  out.table("[run]");
  out.line("duration", numberText(scene.duration), "s");
  out.line("integrator", quoted(scene.integrator));
  out.line("dt", numberText(scene.dt), "s");
  if (scene.tolerance != std::min(Scene{}.tolerance, largestTolerance(scene)))
    out.line("tolerance", numberText(scene.tolerance), "m");
  if (scene.precision == Precision::Float) out.line("precision", "\"float\"");
}

}  // namespace

std::string sceneToToml(const Scene& scene, std::string_view comment) {
  Writer out;
  out.comment(comment);
  out.line("title", quoted(scene.title));
  if (!scene.shows.empty()) out.line("shows", quoted(scene.shows));
  writeSheet(out, scene);
  for (const std::string_view name : tablesOfTerms()) writeTerms(out, name, scene);
  writeBodies(out, scene);
  writeEvents(out, scene);
  writeLook(out, scene);
  writeRun(out, scene);
  return out.text();
}

}  // namespace tyg
