// Surfaces lie a little behind where they are, so that lines and discs on them are seen whole.
#include "gfx/passes/surface_pass.h"

#include <algorithm>
#include <array>

#include "gfx/passes/kept_picture.h"
#include "gfx/picture.h"
#include "tyg/input_error.h"

namespace tyg {
namespace {

constexpr float kThreads = 128, kChecks = 12;     // along the larger side of the sheet
constexpr float kBehind = 1.5F, kBehindFlat = 2;  // as glPolygonOffset takes them
constexpr int kMostSmooth = 128 * 128;  // particles of a sheet whose outline is softened: of others it takes too long
constexpr glm::vec2 kCopiesAside{0.7F, 1};  // half pixels; few edges have that direction, which stay sharp
constexpr float kSoft = 0.4F;               // opacity of each of the copies that soften it
/// For each pattern.
constexpr std::array kDefines{"", "#define PLAIN\n", "#define CHECKER\n", "#define IMAGE\n", "#define NUMBERS\n"};
enum TextureUnit { ValuesUnit = 0, ImageUnit };  // in which the shaders find their textures

glm::vec3 vec(const Vec3& v) { return {float(v.x), float(v.y), float(v.z)}; }

void bindTexture(TextureUnit unit, GLenum kind, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(kind, texture);
}

}  // namespace

void SurfacePass::draw(const Frame& frame) {
  const DrawOptions& options = frame.options;
  if (!canvas_.showsSurface(options)) return;
  static const Look kUsual;
  const Look& look = options.look != nullptr ? *options.look : kUsual;
  if (!objects_) objects_.emplace();
  const Pattern pattern = uploadValues(frame) ? Pattern::Numbers : patternOf(look);
  const GlProgram& program = canvas_.programs.get("surface", kDefines.at(static_cast<std::size_t>(pattern)));
  program.use();
  program.set("view", frame.view);
  program.set("projection", frame.projection);
  program.set("eye", frame.camera.eye());
  setLights(program, frame.lights);
  program.set("values", int{ValuesUnit});
  program.set("image", int{ImageUnit});
  program.set("colour", look.colour ? vec(*look.colour) : frame.palette.cloth);
  program.set("perCell", perCell(pattern));
  program.set("range", glm::vec2(options.colouring.low, options.colouring.high));
  program.set("ramp", std::span<const glm::vec3>(coloursOf(options.colouring.ramp, options.background)));
  if (pattern == Pattern::Image) bindTexture(ImageUnit, GL_TEXTURE_2D, objects_->image.name());
  glEnable(GL_POLYGON_OFFSET_FILL);
  glPolygonOffset(kBehind, kBehindFlat);
  program.set("opacity", 1.0F);
  program.set("aside", glm::vec2(0));
  canvas_.cloth.draw(program);
  if (canvas_.sheet.count() <= kMostSmooth && KeptPicture::possible()) drawSoftEdges(frame, program);
  glDisable(GL_POLYGON_OFFSET_FILL);
}

/// Two copies behind the surface, half a pixel beside it: only what is past its outline is seen of them.
void SurfacePass::drawSoftEdges(const Frame& frame, const GlProgram& program) const {
  program.set("opacity", kSoft);
  glPolygonOffset(kBehind + 1, kBehindFlat + 4);
  glDepthMask(GL_FALSE);
  for (const float sign : {1.0F, -1.0F}) {
    program.set("aside", sign * kCopiesAside / frame.pixels);
    canvas_.cloth.draw(program);
  }
  glDepthMask(GL_TRUE);
}

/// False where the colours are not by a number, or where there is not one for every particle.
bool SurfacePass::uploadValues(const Frame& frame) {
  const Colouring& colouring = frame.options.colouring;
  if (colouring.by == Colouring::By::Family) return false;
  if (colouring.by == Colouring::By::Strain) particleStrains(canvas_.sheet, frame.positions.xyz(), strains_);
  const std::span<const float> values = colouring.by == Colouring::By::Strain ? strains_ : colouring.values;
  if (values.size() != static_cast<std::size_t>(canvas_.sheet.count())) return false;
  glBindBuffer(GL_TEXTURE_BUFFER, objects_->values.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(values.size_bytes()), values.data(), GL_STREAM_DRAW);
  bindTexture(ValuesUnit, GL_TEXTURE_BUFFER, objects_->valueTexture.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, objects_->values.name());
  return true;
}

SurfacePass::Pattern SurfacePass::patternOf(const Look& look) {
  if (!look.image.empty() && loadImage(look.image)) return Pattern::Image;
  return look.weave == Weave::Checker ? Pattern::Checker : look.weave == Weave::Plain ? Pattern::Plain : Pattern::None;
}

/// How often a pattern repeats on a cell of the sheet.
glm::vec2 SurfacePass::perCell(Pattern pattern) const {
  const glm::vec2 cells(canvas_.sheet.columns - 1, canvas_.sheet.rows - 1);
  if (pattern == Pattern::Image) return 1.0F / cells;
  return glm::vec2((pattern == Pattern::Checker ? kChecks : kThreads) / std::max(cells.x, cells.y));
}

/// Once for each path. False where there is no picture: commands and windows have said so before.
bool SurfacePass::loadImage(const std::string& path) {
  if (path == imagePath_) return hasImage_;
  imagePath_ = path;
  hasImage_ = false;
  try {
    const Picture picture = readPicture(path);
    bindTexture(ImageUnit, GL_TEXTURE_2D, objects_->image.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, picture.width, picture.height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 picture.rgba.data());
    glGenerateMipmap(GL_TEXTURE_2D);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    hasImage_ = true;
  } catch (const InputError&) {
  }
  return hasImage_;
}

}  // namespace tyg
