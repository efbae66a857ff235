// Scene files: which keys they have, what each may hold, where built-in scenes come from.
// Must not know: what a simulation does with a scene.
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "core/scene/bodies.h"
#include "core/scene/key_depth.h"
#include "core/scene/look_keys.h"
#include "core/scene/scene_table.h"
#include "core/scene/term_keys.h"
#include "tyg/scene.h"
#include "tyg/sheet.h"
#include "util/suggestion.h"
#include "util/text.h"
#include "util/visible_text.h"
#include "util/whole_file.h"

namespace tyg {
namespace {

/// The mass comes as particle_mass or, spread over the sheet's area, as area_density.
void readMass(SceneTable& table, Scene& scene) {
  double density = 0;
  table.number("particle_mass", scene.particleMass, Allowed::Positive);
  table.number("area_density", density, Allowed::Positive);
  if (!table.has("area_density")) return;
  if (table.has("particle_mass")) {
    table.refuse("area_density", "both particle_mass and area_density", "exactly one of them");
  }
  const double across = (scene.columns - 1) * scene.spacing, down = (scene.rows - 1) * scene.spacing;
  scene.particleMass = density * across * down / (double(scene.columns) * scene.rows);
  if (!(scene.particleMass > 0) || !std::isfinite(scene.particleMass)) {
    table.refuse("area_density", "a density that gives no finite particle mass above 0",
                 "particle_mass where the sheet has no area");
  }
}

void readSheet(SceneTable table, Scene& scene) {
  // Until they are read: finish() is to refuse a missing size, not a pin outside a size that nobody wrote.
  scene.columns = scene.rows = kLargestCount;
  table.integer("columns", scene.columns, 1, kLargestCount);
  table.integer("rows", scene.rows, 1, kLargestCount);
  table.number("spacing", scene.spacing, Allowed::Positive);
  table.choice("start", scene.start, {"hanging", "flat"});
  readMass(table, scene);
  table.particleSets("pins", makeSheet(scene), scene.pins);
  table.finish({"columns", "rows", "spacing"});
  if (!table.has("particle_mass") && !table.has("area_density")) {
    table.refuse("particle_mass", "neither particle_mass nor area_density", "exactly one of them");
  }
}

/// The parameters of one term; where they have a table of their own, `table` is the one around it.
void readTerm(SceneTable& table, const ForceTerm& term, Scene& scene) {
  const auto readFrom = [&](SceneTable& own) {
    for (const Parameter& parameter : term.parameters) {
      if (parameter.ofList) continue;
      const std::string_view key = partsOf(parameter.key).last;
      Vec3 value = parameter.get(scene);
      parameter.count == 1 ? own.number(key, value.x, parameter.allowed) : own.vector(key, value);
      parameter.set(scene, value);
    }
  };
  const std::string_view inner = partsOf(term.parameters.front().key).inner;
  if (inner.empty()) return readFrom(table);
  std::optional<SceneTable> own = table.table(inner);
  if (!own) return;
  readFrom(*own);
  own->finish();
}

/// The keys that a shape has.
void readShape(SceneTable& table, Body& body) {
  Vec3 to;
  switch (body.shape) {
    case Shape::Plane:
      table.vector("at", body.at), table.vector("normal", body.normal);
      return table.finish({"shape", "at"});
    case Shape::Ball:
      table.vector("at", body.at), table.number("radius", body.radius, Allowed::Positive);
      return table.finish({"shape", "at", "radius"});
    case Shape::Capsule:
      table.vector("from", body.at), table.vector("to", to), table.number("radius", body.radius, Allowed::Positive);
      body.axis = {to.x - body.at.x, to.y - body.at.y, to.z - body.at.z};
      return table.finish({"shape", "from", "to", "radius"});
    case Shape::Box:
      table.vector("at", body.at), table.vector("half", body.half);
      table.number("rounding", body.radius, Allowed::Positive);
      return table.finish({"shape", "at", "half", "rounding"});
  }
}

/// A body without a shape: of its keys only what no shape has is unknown.
void refuseShapeless(SceneTable& table) {
  Vec3 vector;
  double number = 0;
  for (const std::string_view key : {"at", "normal", "from", "to", "half"}) table.vector(key, vector);
  for (const std::string_view key : {"radius", "rounding"}) table.number(key, number, Allowed::Positive);
  table.finish({"shape"});
}

/// A vector of the length 1 stays as it is: what has been written reads back to the same bits.
Vec3 ofLengthOne(const Vec3& v) {
  constexpr double kRounding = 1e-15;
  const double length = std::hypot(v.x, v.y, v.z);
  if (std::abs(length - 1) <= kRounding) return v;
  return {v.x / length, v.y / length, v.z / length};
}

Body readBody(SceneTable table, const Scene& scene) {
  Body body;
  table.text("name", body.name);
  table.choice("shape", body.shape, {"plane", "ball", "capsule", "box"});
  if (!table.has("shape")) refuseShapeless(table);
  readShape(table, body);
  if (table.has("name")) {
    if (std::ranges::find(scene.bodies, body.name, &Body::name) != scene.bodies.end()) {
      table.refuse("name", "the name of another body, " + body.name, "a name of its own");
    }
    if (body.name.empty()) table.refuse("name", "\"\"", "a name of at least one character");
    if (isPlaceName(body.name)) {
      table.refuse("name", '"' + body.name + '"', "a name that no particle and no set of particles has");
    }
  }
  Scene alone = scene;
  alone.bodies = {body};
  if (const auto unfit = unfitBody(alone)) table.refuse(unfit->key, unfit->found, unfit->allowed);
  body.normal = ofLengthOne(body.normal);
  return body;
}

/// Needs the springs, from which contact has its stiffness where none is named.
void completeContact(const SceneTable& root, Scene& scene) {
  if (scene.bodies.empty()) {
    if (root.has("contact")) root.refuse("contact", "[contact] without a [[body]]", "both, or neither");
    return;
  }
  if (!root.has("contact")) root.refuse("body", "[[body]] without [contact]", "both, or neither");
  fillContact(scene);
  if (scene.contact.stiffness > 0) return;
  root.refuse("contact", "neither stiffness nor springs to take it from", "a stiffness above 0");
}

/// What a scene file says of contact besides its parameters.
void readGap(SceneTable& table, Contact& contact) {
  double gap = 0;
  table.number("gap", gap, Allowed::NotNegative);
  if (table.has("gap")) contact.gap = gap;
}

void readTerms(SceneTable table, std::string_view name, Scene& scene) {
  if (name == kSpringsTable) table.choice("damping", scene.damping, {"relative", "axial"});
  for (const ForceTerm* term : forceTerms()) {
    if (partsOf(term->parameters.front().key).table == name) readTerm(table, *term, scene);
  }
  if (name == kContactTable) readGap(table, scene.contact);
  table.finish();
  for (const Parameter& parameter : liveParameters()) {
    const auto [outer, inner, key] = partsOf(parameter.key);
    if (outer == name && parameter.required && !table.has(key)) {
      table.refuse(key, "nothing, and it is required", "a number");
    }
  }
}

Displacement readDisplacement(SceneTable table, const Sheet& sheet) {
  Displacement displacement;
  table.particle("particle", sheet, displacement.particle);
  table.vector("by", displacement.by);
  table.finish({"particle", "by"});
  return displacement;
}

Wind readWind(SceneTable table) {
  Wind wind;
  table.vector("velocity", wind.velocity);
  table.vector("gust", wind.gust);
  table.number("wavelength", wind.wavelength, Allowed::Positive);
  table.number("at", wind.at, Allowed::NotNegative);
  table.number("for", wind.duration, Allowed::NotNegative);
  table.finish({"velocity"});
  if (wind.gust == Vec3{}) return wind;
  if (wind.velocity == Vec3{}) table.refuse("gust", "a gust without a velocity that it travels with", "both");
  if (!table.has("wavelength")) table.refuse("gust", "a gust without a wavelength", "both");
  return wind;
}

Move readMove(SceneTable table, const Sheet& sheet, const std::vector<Body>& bodies) {
  Move move;
  table.particleSetsOrName("what", sheet, bodies, &Body::name, move.what, move.body);
  table.vector("velocity", move.velocity);
  table.number("at", move.at, Allowed::NotNegative);
  table.number("for", move.duration, Allowed::NotNegative);
  table.finish({"what", "velocity", "at", "for"});
  for (const Place& place : move.what) {
    for (const int particle : particlesAt(sheet, place)) {
      if (std::ranges::binary_search(sheet.pins, particle)) continue;
      table.refuse(
          "what",
          fmt::format("particle [{}, {}], which is not pinned", particle % sheet.columns, particle / sheet.columns),
          "pinned particles");
    }
  }
  return move;
}

Cut readCut(SceneTable table) {
  Cut cut;
  table.gridPoint("from", cut.line.fromColumn, cut.line.fromRow);
  table.gridPoint("to", cut.line.toColumn, cut.line.toRow);
  table.number("at", cut.at, Allowed::NotNegative);
  table.finish({"from", "to", "at"});
  if (cut.line.fromColumn == cut.line.toColumn && cut.line.fromRow == cut.line.toRow) {
    table.refuse("to", "the same place as from", "another place");
  }
  return cut;
}

void readTear(SceneTable table, Scene& scene) {
  table.number("toughness", scene.tear.toughness, Allowed::Positive);
  table.finish({"toughness"});
  if (!(scene.structural.ks > 0)) {
    table.refuse("toughness", "a toughness without structural springs", "both: these are what tears");
  }
}

Push readPush(SceneTable table, const Sheet& sheet) {
  Push push;
  table.particle("particle", sheet, push.particle);
  table.vector("force", push.force);
  table.number("at", push.at, Allowed::NotNegative);
  table.number("for", push.duration, Allowed::NotNegative);
  table.finish({"particle", "force", "at", "for"});
  return push;
}

void readRun(SceneTable table, Scene& scene, std::span<const std::string_view> methods) {
  table.number("duration", scene.duration, Allowed::Positive);
  if (methods.empty()) {
    table.text("integrator", scene.integrator);
  } else if (const auto method = table.oneOf("integrator", methods)) {
    scene.integrator = methods[*method];
  }
  table.number("dt", scene.dt, Allowed::Positive, 0);
  scene.tolerance = std::min(scene.tolerance, largestTolerance(scene));
  table.number("tolerance", scene.tolerance, Allowed::Positive, 0);
  table.choice("precision", scene.precision, {"float", "double"});
  table.finish({"duration", "integrator", "dt"});
  if (scene.duration / scene.dt > kMostSteps) {
    table.refuse("dt", fmt::format("{:g} s, which makes {:.3g} steps", scene.dt, scene.duration / scene.dt),
                 fmt::format("up to {:g} steps", kMostSteps));
  }
}

/// The root is finished before its tables are read: a misspelt table is named, not what it seems to lack.
void readRoot(SceneTable root, const std::string& file, Scene& scene, std::span<const std::string_view> methods) {
  root.text("title", scene.title);
  root.text("shows", scene.shows);
  const auto sheetTable = root.table("sheet");
  std::vector<std::pair<std::string_view, std::optional<SceneTable>>> ofTerms;
  for (const std::string_view name : tablesOfTerms()) ofTerms.emplace_back(name, root.table(name));
  const auto winds = root.tables("wind"), displacements = root.tables("displace"), pushes = root.tables("push");
  const auto moves = root.tables("move"), bodies = root.tables("body"), cuts = root.tables("cut");
  const auto tear = root.table("tear"), look = root.table("look");
  const auto lamps = root.tables("lamp");
  const auto run = root.table("run");
  root.finish({"title", "sheet", "run"});

  readSheet(*sheetTable, scene);
  for (const SceneTable& table : bodies) scene.bodies.push_back(readBody(table, scene));
  for (const auto& [name, table] : ofTerms) {
    if (table) readTerms(*table, name, scene);
  }
  completeContact(root, scene);
  const Sheet sheet = makeSheet(scene);
  for (const SceneTable& table : displacements) scene.displacements.push_back(readDisplacement(table, sheet));
  for (const SceneTable& table : pushes) scene.pushes.push_back(readPush(table, sheet));
  for (const SceneTable& table : moves) scene.moves.push_back(readMove(table, sheet, scene.bodies));
  if (tear) readTear(*tear, scene);
  for (const SceneTable& table : cuts) scene.cuts.push_back(readCut(table));
  for (const SceneTable& table : winds) scene.winds.push_back(readWind(table));
  if (!winds.empty() && !root.has("air")) root.refuse("wind", "[[wind]] without [air]", "both, or neither");
  if (look) scene.look = readLook(*look, file);
  for (const SceneTable& table : lamps) scene.lamps.push_back(readLamp(table));
  if (lamps.size() > kMostLamps) {
    root.refuse("lamp", fmt::format("{} lamps", lamps.size()), fmt::format("{} at most", kMostLamps));
  }
  readRun(*run, scene, methods);
}

/// Refuses what would take the parser too much memory or too deep.
void refuseEndless(std::string_view text, const std::string& fileName) {
  constexpr std::size_t kMostBytes = 16 << 20;
  constexpr int kMostParts = 8;
  if (text.size() > kMostBytes) {
    throw InputError(
        fmt::format("{}: found a scene of {} bytes, allowed are {} at most", fileName, text.size(), kMostBytes));
  }
  if (const int line = lineOfDeepKey(text, kMostParts); line > 0) {
    throw InputError(fmt::format("{}:{}: found a key of more than {} parts, allowed are keys such as springs.shear.ks",
                                 fileName, line, kMostParts));
  }
}

std::string builtinNames() { return joined(builtinScenes(), &BuiltinScene::name); }

}  // namespace

const char* nameOf(Precision precision) { return precision == Precision::Float ? "float" : "double"; }

Scene parseScene(std::string_view text, const std::string& fileName, std::span<const std::string_view> methods) {
  refuseEndless(text, fileName);
  try {
    const toml::table root = toml::parse(text, std::string_view(fileName));
    Scene scene;
    scene.name = oneLine(fileName);  // it goes into files and onto screens
    readRoot(SceneTable(root, "", fileName), fileName, scene, methods);
    return scene;
  } catch (const toml::parse_error& mistake) {
    throw InputError(fmt::format("{}:{}: found what is not TOML ({}), allowed TOML 1.0 in UTF-8", fileName,
                                 mistake.source().begin.line, mistake.description()));
  }
}

Scene loadScene(const std::string& nameOrPath, std::span<const std::string_view> methods) {
  for (const BuiltinScene& scene : builtinScenes()) {
    if (scene.name == nameOrPath) return parseScene(scene.text, nameOrPath, methods);
  }
  const std::string allowed = "the path of a .toml file, or one of the built-in scenes " + builtinNames();
  const std::string hint = didYouMean(nameOrPath, builtinScenes(), &BuiltinScene::name);
  return parseScene(readWholeFile(nameOrPath, "cannot read the scene", allowed + hint), nameOrPath, methods);
}

}  // namespace tyg
