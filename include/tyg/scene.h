// A scene: everything that a simulation starts from, as plain data that a program fills in or reads from a TOML text.
// Second of the headers to read. Must not know: the present state of particles, how methods work, results, windows.
#pragma once

#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tyg/input_error.h"

namespace tyg {

/// A vector of the outside world (metres, newtons or m/s2, as its owner says); y is up.
struct Vec3 {
  double x = 0, y = 0, z = 0;
  bool operator==(const Vec3&) const = default;
};

enum class Start { Hanging, Flat };      ///< in the x-y plane, or in the x-z plane
enum class Damping { Relative, Axial };  ///< against the ends' relative velocity, or its part along the spring
enum class Precision { Float, Double };
/// `float` or `double`.
const char* nameOf(Precision precision);

/// One family of springs. A family with neither stiffness nor damping is not part of the model.
struct SpringFamily {
  double ks = 0;  ///< stiffness, N/m, >= 0
  double kd = 0;  ///< damping, N s/m, >= 0
  [[nodiscard]] bool present() const { return ks > 0 || kd > 0; }
  bool operator==(const SpringFamily&) const = default;
};

/// A particle, or for pins a set of particles, as a scene names it.
struct Place {
  std::string name;         ///< "top-left", ..., a set such as "top"; empty: the particle [column, row]
  int column = 0, row = 0;  ///< used where name is empty
  bool operator==(const Place&) const = default;
};

/// One particle is moved once, before t = 0.
struct Displacement {
  Place particle;
  Vec3 by;  ///< m
  bool operator==(const Displacement&) const = default;
};

/// A constant force on one particle during [at, at + duration).
struct Push {
  Place particle;
  Vec3 force;           ///< N
  double at = 0;        ///< s, >= 0
  double duration = 0;  ///< s, >= 0; the key `for` of the file
  bool operator==(const Push&) const = default;
};

/// Air around the cloth; without density there is none.
struct Air {
  double density = 0;        ///< kg/m3, >= 0
  double coefficient = 1.2;  ///< of drag, >= 0
  bool operator==(const Air&) const = default;
};

/// A wind during [at, at + duration), and a gust that travels with it.
struct Wind {
  Vec3 velocity{};                                            ///< m/s
  Vec3 gust{};                                                ///< its amplitude, m/s
  double wavelength = 0;                                      ///< m, > 0 where there is a gust
  double at = 0;                                              ///< s, >= 0
  double duration = std::numeric_limits<double>::infinity();  ///< s, >= 0; the key `for` of the file
  bool operator==(const Wind&) const = default;
};

/// Pinned particles or a body move with this velocity during [at, at + duration); several motions of one add up.
struct Move {
  std::vector<Place> what{};
  Vec3 velocity{};      ///< m/s
  double at = 0;        ///< s, >= 0
  double duration = 0;  ///< s, >= 0; the key `for` of the file
  std::string body{};   ///< the name of a body; `what` is then empty
  bool operator==(const Move&) const = default;
};

/// A straight cut through the sheet in grid coordinates, which may lie between particles and outside the sheet.
struct CutLine {
  double fromColumn = 0, fromRow = 0, toColumn = 0, toRow = 0;
  bool operator==(const CutLine&) const = default;
};

/// The cloth is cut at a time.
struct Cut {
  CutLine line;
  double at = 0;  ///< s, >= 0
  bool operator==(const Cut&) const = default;
};

/// How hard the cloth is to tear; without toughness it never tears.
struct Tear {
  double toughness = 0;  ///< J per m of tear, >= 0
  bool operator==(const Tear&) const = default;
};

struct Scene;
/// The strain beyond which a structural spring breaks, as a fraction; infinite where nothing tears.
double strainThatTears(const Scene& scene);
/// Whether cuts or tears of the scene itself may take springs.
bool losesSprings(const Scene& scene);

enum class Shape { Plane, Ball, Capsule, Box };

/// Something solid that the particles touch.
struct Body {
  Shape shape = Shape::Plane;
  Vec3 at{};             ///< m: a point of a plane, the middle of a ball or a box, one end of a capsule's axis
  Vec3 normal{0, 1, 0};  ///< of a plane, of length 1; it points out of the body
  Vec3 axis{};           ///< m, of a capsule: from `at` to the other end
  Vec3 half{};           ///< m, of a box: half of its extents along x, y and z
  double radius = 0;     ///< m, of a ball or a capsule; of a box that of its edges, the key `rounding` of the file
  std::string name{};    ///< for motions; may be empty
  bool operator==(const Body&) const = default;
};

/// How particles and bodies touch; without stiffness they do not.
struct Contact {
  double stiffness = 0;         ///< N/m, of a particle on a body, >= 0
  double layer = 0;             ///< m, the depth over which the stiffness sets in, > 0
  double damping = 0.3;         ///< as a fraction of the critical one of a particle, >= 0
  double friction = 0;          ///< coefficient, >= 0
  double grip = 0;              ///< N s/m, > 0: friction resists a slow slip like a damper of this size, and never more
  std::optional<double> gap{};  ///< m, >= 0, by which every body is larger; nothing: what a flat cell sinks into each
  bool operator==(const Contact&) const = default;
};

/// How the cloth is drawn: its springs as lines, a lit surface, or both.
enum class Show { Lines, Surface, Both };
enum class Weave { None, Plain, Checker };

/// What the cloth looks like. It changes nothing that is computed, and no hash.
struct Look {
  Show show = Show::Lines;
  std::optional<Vec3> colour{};  ///< red, green and blue, 0..1 each; nothing: one that suits the background
  Weave weave = Weave::None;
  std::string image{};  ///< path of a PNG or JPEG picture that is drawn on the cloth; empty: none
  bool operator==(const Look&) const = default;
};

/// Light on what is drawn; like the look it changes nothing that is computed.
struct Lamp {
  std::optional<Vec3> at{};  ///< m; nothing: it is far away
  Vec3 direction{0, -1, 0};  ///< of the light, where the lamp is far away; of any length but 0
  Vec3 colour{1, 1, 1};      ///< red, green and blue, 0..1 each
  bool operator==(const Lamp&) const = default;
};
/// The most lamps of a scene.
inline constexpr int kMostLamps = 4;

/// The most columns and the most rows of a sheet.
inline constexpr int kLargestCount = 4096;

/// Steps of dt that a run may have at most: more would not end, and could not be counted.
inline constexpr double kMostSteps = 1e15;

/// The contents of a scene file. Defaults are those of an empty world; the reader refuses what it does not know.
struct Scene {
  std::string name;   ///< of the built-in scene, or the path of the file
  std::string title;  ///< a few words
  std::string shows;  ///< one sentence: what a person will see

  int columns = 1, rows = 1;  ///< 1..kLargestCount each
  double spacing = 1;         ///< m between neighbours at rest, > 0
  double particleMass = 1;    ///< kg each, > 0 (worked out from area_density where the file gives that)
  Start start = Start::Hanging;
  std::vector<Place> pins;  ///< held at their start positions

  Damping damping = Damping::Relative;
  SpringFamily structural, shear, bend;

  Vec3 gravity{0, -9.81, 0};  ///< m/s2
  double drag = 0;            ///< N s/m per particle, >= 0
  Air air;
  std::vector<Wind> winds;
  Contact contact;
  std::vector<Body> bodies;  ///< touched where the contact has a stiffness

  std::vector<Displacement> displacements;
  std::vector<Push> pushes;
  std::vector<Move> moves;
  std::vector<Cut> cuts;
  Tear tear;

  Look look;
  std::vector<Lamp> lamps;  ///< up to kMostLamps; none: one far away, above to the left and in front

  double duration = 1;      ///< s, > 0
  std::string integrator;   ///< a registered method's name
  double dt = 1e-3;         ///< s, > 0; fixed-step methods and the viewer's tick
  double tolerance = 1e-4;  ///< m, > 0; adaptive methods
  Precision precision = Precision::Double;
  bool operator==(const Scene&) const = default;
};

/// Gives the contact of a scene what it lacks, as scene files have it: a quarter of the sheet's largest m w^2 as
/// stiffness, a twentieth of the spacing as layer, half the root of stiffness times mass as grip. What is 0 lacks.
void fillContact(Scene& scene);

/// Reads a scene from TOML text. `methods` are the integrator names to allow (none given: any).
/// Throws InputError with file, line, key, what was found and what is allowed.
Scene parseScene(std::string_view text, const std::string& fileName, std::span<const std::string_view> methods = {});

/// Reads a built-in scene by its name, or else the .toml file at that path. Throws InputError; a name that is neither
/// is answered with the built-in names.
Scene loadScene(const std::string& nameOrPath, std::span<const std::string_view> methods = {});

/// A scene that is embedded in the program.
struct BuiltinScene {
  std::string_view name;
  std::string_view text;  ///< TOML
};
/// Whether a scene is there to fail, and to say why: its name begins with `fail-`.
inline bool showsFailure(const BuiltinScene& scene) { return scene.name.starts_with("fail-"); }
/// All built-in scenes, the default (`curtain`) first, the others by name, those that fail last.
std::span<const BuiltinScene> builtinScenes();

/// The same cloth on another grid: spacing = larger side / (larger count - 1), particle mass and drag = the sheet's
/// total over the new count, as are the stiffness and the grip of contact, [column, row] places scale with the sheet
/// and are rounded; ks, kd and pushes stay. Throws InputError where a count is outside 1..kLargestCount or the cloth
/// has no extent to keep.
Scene withSheet(Scene scene, int columns, int rows);

}  // namespace tyg
