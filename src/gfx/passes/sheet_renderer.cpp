// Drawing a sheet; see sheet_renderer.h. Positions go to the GPU once a frame, in one buffer that the line shader reads
// as a texture and the disc shader as vertices; the points of a push's arrow follow behind the particles.
#include "gfx/passes/sheet_renderer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "gfx/passes/gl_objects.h"
#include "view/round_step.h"
#include "view/sheet_lines.h"

namespace tyg {
namespace {

/// Colours of Okabe and Ito (2008), which colour-blind people tell apart as well; on light ground the darker ones.
struct Palette {
  glm::vec3 background, sky, ground, grid;
  glm::vec3 structural, shear, bend, particle, pin, push;
};

const Palette kDark{.background = rgb(0x14181f),
                    .sky = rgb(0x1b212b),
                    .ground = rgb(0x0e1116),
                    .grid = rgb(0x46505f),
                    .structural = rgb(0x8fd3ff),
                    .shear = rgb(0xe69f00),
                    .bend = rgb(0x009e73),
                    .particle = rgb(0xf2f6fa),
                    .pin = rgb(0xff7a1f),
                    .push = rgb(0xf0e442)};
const Palette kLight{.background = rgb(0xf6f7f8),
                     .sky = rgb(0xfafbfc),
                     .ground = rgb(0xeceef0),
                     .grid = rgb(0xa9b0b8),
                     .structural = rgb(0x005a94),
                     .shear = rgb(0xc07f00),
                     .bend = rgb(0x009e73),
                     .particle = rgb(0x101418),
                     .pin = rgb(0xd55e00),
                     .push = rgb(0xb0306a)};

const Palette& paletteOf(Background background) { return background == Background::Dark ? kDark : kLight; }

constexpr float kFade = 0.62F;            // of the way to the background for the cloth's farthest part
constexpr float kColouredFade = 0.2F;     // the same where colours tell numbers
constexpr float kShallowest = 0.5F;       // cloth sizes: a range of depths below this is not stretched to full contrast
constexpr float kPinDiameter = 12;        // pixels
constexpr float kSmallestPin = 6;         // pixels
constexpr float kBesideStructural = 3;    // pixels from a structural line to the bend line along it
constexpr float kHairlineSpacing = 3.5F;  // pixels between lines below which they are thinner than a pixel
constexpr float kParticleDiameter = 5;    // pixels
constexpr float kPushWidth = 2.6F;        // pixels
constexpr float kGroundExtent = 5;        // sheet sizes
constexpr GLuint kPositionSlot = 0;       // of discs.vert
enum Pass { Middles = 0, Edges = 1, Both = 2 };

/// Indices on the GPU: pairs of a line texture, or the order in which discs are drawn.
struct Lines {
  GlBuffer buffer;
  GlTexture texture;
  GLsizei count = 0;

  explicit Lines(const std::vector<std::uint32_t>& pairs) : count(static_cast<GLsizei>(pairs.size() / 2)) {
    glBindBuffer(GL_TEXTURE_BUFFER, buffer.name());
    glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(pairs.size() * sizeof pairs[0]), pairs.data(),
                 GL_STATIC_DRAW);
    glBindTexture(GL_TEXTURE_BUFFER, texture.name());
    glTexBuffer(GL_TEXTURE_BUFFER, GL_RG32UI, buffer.name());
  }
};

glm::vec2 middleOnGround(const Sheet& sheet) {
  const Vec3 first = sheet.startPosition(0), last = sheet.startPosition(sheet.count() - 1);
  return {static_cast<float>(first.x + last.x) / 2, static_cast<float>(first.z + last.z) / 2};
}

/// Distances along the line of sight of the nearest and the farthest part of a box.
glm::vec2 depthsOf(const Camera& camera) {
  float low = std::numeric_limits<float>::max(), high = -low;
  for (const glm::vec3& corner : camera.watched().corners()) {
    const float depth = glm::dot(corner - camera.eye(), camera.forward());
    low = std::min(low, depth), high = std::max(high, depth);
  }
  const float missing = std::max(kShallowest * camera.watched().size() - (high - low), 0.0F);
  return {low, high + missing};
}

}  // namespace

struct SheetRenderer::Body {
  Sheet sheet;
  GlProgram lineProgram{"lines"}, discProgram{"discs"}, surroundingsProgram{"surroundings"};
  GlBuffer positions, pinOrder, values;
  GlTexture positionTexture, valueTexture;
  GlVertexArray nothing, particles;
  std::array<std::unique_ptr<Lines>, 3> families;  // made when first shown: a large sheet's take much memory
  Lines arrow;

  explicit Body(const Sheet& of);
  [[nodiscard]] GLsizei count() const { return sheet.count(); }
  [[nodiscard]] const Lines& linesFor(Family family);

  struct Frame {
    const Camera& camera;
    Background background;
    const Palette& palette;
    glm::vec2 pixels;
    glm::mat4 view, projection;
    glm::vec2 depths;
    float focal;
  };
  void upload(std::span<const float> xyz, const ShownPush* push) const;
  [[nodiscard]] bool uploadValues(const Colouring& colouring) const;
  void drawSurroundings(const Frame& frame) const;
  void setCommon(const GlProgram& program, const Frame& frame, const glm::vec3& colour, float fade,
                 float spacing) const;
  struct LineStyle {
    glm::vec3 colour;
    float width, sideways, spacing, fade;
    float opacity = 1;
    float restLength = 1;                  ///< m
    const Colouring* colouring = nullptr;  ///< null: one colour
  };
  void setColouring(const Frame& frame, const LineStyle& style) const;
  void drawLines(const Frame& frame, const Lines& lines, const LineStyle& style) const;
  void drawSprings(const Frame& frame, const DrawOptions& options);
  void drawDiscs(const Frame& frame, const DrawOptions& options) const;
  void setMarker(const Frame& frame, const glm::vec3& colour, float spacing) const;
  void drawPush(const Frame& frame) const;
};

SheetRenderer::Body::Body(const Sheet& of)
    : sheet(of), arrow([&of] {
        std::vector<std::uint32_t> pairs = arrowLines();
        for (std::uint32_t& index : pairs) {
          index += static_cast<std::uint32_t>(of.count());
        }
        return Lines(pairs);
      }()) {
  const std::int64_t numbers = 3LL * (sheet.count() + kArrowPoints);
  GLint most = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &most);
  if (numbers > most) {
    throw InputError("sheet: found " + std::to_string(sheet.count()) + " particles, allowed: up to " +
                     std::to_string(most / 3 - kArrowPoints) + ", as this graphics driver draws no more");
  }
  glBindBuffer(GL_ARRAY_BUFFER, positions.name());
  glBufferData(GL_ARRAY_BUFFER, numbers * GLsizeiptr{sizeof(float)}, nullptr, GL_STREAM_DRAW);
  glBindTexture(GL_TEXTURE_BUFFER, positionTexture.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, positions.name());

  glBindVertexArray(particles.name());
  glEnableVertexAttribArray(kPositionSlot);
  glVertexAttribPointer(kPositionSlot, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, pinOrder.name());
  glBufferData(GL_ELEMENT_ARRAY_BUFFER, static_cast<GLsizeiptr>(sheet.pins.size() * sizeof(int)), sheet.pins.data(),
               GL_STATIC_DRAW);
  glBindVertexArray(0);
}

const Lines& SheetRenderer::Body::linesFor(Family family) {
  std::unique_ptr<Lines>& lines = families[static_cast<std::size_t>(family)];
  if (!lines) {
    lines = std::make_unique<Lines>(linesOf(sheet, family));
  }
  return *lines;
}

void SheetRenderer::Body::upload(std::span<const float> xyz, const ShownPush* push) const {
  const auto bytes = static_cast<GLsizeiptr>(xyz.size_bytes());
  glBindBuffer(GL_ARRAY_BUFFER, positions.name());
  // A new store for each frame: the driver need not wait for the last frame to be done with the old one.
  glBufferData(GL_ARRAY_BUFFER, bytes + GLsizeiptr{kArrowPoints * sizeof(glm::vec3)}, nullptr, GL_STREAM_DRAW);
  glBufferSubData(GL_ARRAY_BUFFER, 0, bytes, xyz.data());
  if (push != nullptr) {
    const auto at = 3 * static_cast<std::size_t>(push->particle);
    const glm::vec3 foot(xyz[at], xyz[at + 1], xyz[at + 2]);
    const glm::vec3 force(push->force.x, push->force.y, push->force.z);
    const auto points = arrowPoints(foot, force, arrowLength(sheet, glm::length(force)));
    glBufferSubData(GL_ARRAY_BUFFER, bytes, sizeof points, points.data());
  }
}

void SheetRenderer::Body::drawSurroundings(const Frame& frame) const {
  const Camera& camera = frame.camera;
  const float slope = std::tan(camera.fieldOfView() / 2);
  surroundingsProgram.use();
  surroundingsProgram.set("forward", camera.forward());
  surroundingsProgram.set("rightward", slope * frame.pixels.x / frame.pixels.y * camera.right());
  surroundingsProgram.set("upward", slope * camera.up());
  surroundingsProgram.set("sky", frame.palette.sky);
  surroundingsProgram.set("ground", frame.palette.ground);
  surroundingsProgram.set("grid", frame.palette.grid);
  surroundingsProgram.set("eye", camera.eye());
  surroundingsProgram.set("height", groundHeight(sheet));
  surroundingsProgram.set("cell", static_cast<float>(roundStep(sheet.size() / 4)));
  surroundingsProgram.set("middle", middleOnGround(sheet));
  surroundingsProgram.set("extent", kGroundExtent * static_cast<float>(sheet.size()));
  glBindVertexArray(nothing.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SheetRenderer::Body::setCommon(const GlProgram& program, const Frame& frame, const glm::vec3& colour, float fade,
                                    float spacing) const {
  program.use();
  program.set("view", frame.view);
  program.set("projection", frame.projection);
  program.set("focal", frame.focal);
  program.set("middle", frame.camera.distance());
  program.set("depths", frame.depths);
  program.set("colour", colour);
  program.set("background", frame.palette.background);
  program.set("fade", fade);
  program.set("spacing", spacing);
}

void SheetRenderer::Body::setColouring(const Frame& frame, const LineStyle& style) const {
  lineProgram.set("opacityOfAll", style.opacity);
  lineProgram.set("colouring", style.colouring == nullptr ? 0 : static_cast<int>(style.colouring->by));
  if (style.colouring == nullptr) return;
  lineProgram.set("values", 2);
  lineProgram.set("restLength", style.restLength);
  lineProgram.set("range", glm::vec2(style.colouring->low, style.colouring->high));
  lineProgram.set("ramp", std::span<const glm::vec3>(coloursOf(style.colouring->ramp, frame.background)));
  if (style.colouring->by != Colouring::By::Particle) return;
  glActiveTexture(GL_TEXTURE2);
  glBindTexture(GL_TEXTURE_BUFFER, valueTexture.name());
}

void SheetRenderer::Body::drawLines(const Frame& frame, const Lines& lines, const LineStyle& style) const {
  const bool coloured = style.colouring != nullptr;
  setCommon(lineProgram, frame, style.colour, coloured ? kColouredFade : style.fade, style.spacing);
  setColouring(frame, style);
  lineProgram.set("positions", 0);
  lineProgram.set("lines", 1);
  lineProgram.set("pixels", frame.pixels);
  lineProgram.set("nearest", frame.camera.nearest());
  lineProgram.set("width", style.width);
  lineProgram.set("sideways", style.sideways);
  glBindVertexArray(nothing.name());
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_BUFFER, lines.texture.name());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_BUFFER, positionTexture.name());
  // Lines thinner than a pixel have no solid middles to draw first.
  const bool hairlines = style.spacing * frame.focal / frame.camera.distance() < kHairlineSpacing && style.spacing > 0;
  if (hairlines) {
    lineProgram.set("pass", int{Both});
    glDrawArrays(GL_TRIANGLES, 0, 6 * lines.count);
    return;
  }
  for (const Pass pass : {Middles, Edges}) {
    lineProgram.set("pass", int{pass});
    glDepthMask(pass == Middles ? GL_TRUE : GL_FALSE);
    glDrawArrays(GL_TRIANGLES, 0, 6 * lines.count);
  }
  glDepthMask(GL_TRUE);
}

void SheetRenderer::Body::drawSprings(const Frame& frame, const DrawOptions& options) {
  const bool coloured = options.colouring.by != Colouring::By::Family && uploadValues(options.colouring);
  const float thin = 0.7F * options.lineWidth;  // the structural mesh stays the loudest
  const auto draw = [&](Family family, const glm::vec3& colour, float width, float sideways) {
    drawLines(frame, linesFor(family),
              {.colour = colour,
               .width = width,
               .sideways = sideways,
               .spacing = static_cast<float>(sheet.spacing),
               .fade = kFade,
               .opacity = options.opacity,
               .restLength = static_cast<float>(restLength(sheet, family)),
               .colouring = coloured ? &options.colouring : nullptr});
  };
  // Bend springs lie along structural ones.
  if (options.bend) draw(Family::Bend, frame.palette.bend, thin, kBesideStructural);
  if (options.shear) draw(Family::Shear, frame.palette.shear, thin, 0);
  if (options.structural) {
    draw(Family::Structural, options.mesh.value_or(frame.palette.structural), options.lineWidth, 0);
  }
}

/// False where there is not a number for every particle.
bool SheetRenderer::Body::uploadValues(const Colouring& colouring) const {
  if (colouring.by != Colouring::By::Particle) return true;
  if (colouring.values.size() != static_cast<std::size_t>(count())) return false;
  glBindBuffer(GL_TEXTURE_BUFFER, values.name());
  glBufferData(GL_TEXTURE_BUFFER, static_cast<GLsizeiptr>(colouring.values.size_bytes()), colouring.values.data(),
               GL_STREAM_DRAW);
  glActiveTexture(GL_TEXTURE2);
  glBindTexture(GL_TEXTURE_BUFFER, valueTexture.name());
  glTexBuffer(GL_TEXTURE_BUFFER, GL_R32F, values.name());
  glActiveTexture(GL_TEXTURE0);
  return true;
}

void SheetRenderer::Body::drawDiscs(const Frame& frame, const DrawOptions& options) const {
  glBindVertexArray(particles.name());
  if (options.particles) {
    setCommon(discProgram, frame, frame.palette.particle, kFade, static_cast<float>(sheet.spacing));
    discProgram.set("diameter", kParticleDiameter);
    discProgram.set("least", 1.5F);
    discProgram.set("outline", 0.0F);
    glDrawArrays(GL_POINTS, 0, count());
  }
  if (options.pins && !sheet.pins.empty()) {
    setMarker(frame, frame.palette.pin, 0);
    glDrawElements(GL_POINTS, static_cast<GLsizei>(sheet.pins.size()), GL_UNSIGNED_INT, nullptr);
  }
}

void SheetRenderer::Body::setMarker(const Frame& frame, const glm::vec3& colour, float spacing) const {
  setCommon(discProgram, frame, colour, 0, spacing);
  discProgram.set("diameter", kPinDiameter);
  discProgram.set("least", kSmallestPin);
  discProgram.set("outline", 1.5F);
}

void SheetRenderer::Body::drawPush(const Frame& frame) const {
  glDisable(GL_DEPTH_TEST);  // the cloth must not hide what is done to it
  drawLines(frame, arrow, {.colour = frame.palette.push, .width = kPushWidth, .sideways = 0, .spacing = 0, .fade = 0});
  glBindVertexArray(particles.name());
  setMarker(frame, frame.palette.push, 0);
  glDrawArrays(GL_POINTS, count(), 1);  // the arrow's foot
  glEnable(GL_DEPTH_TEST);
}

SheetRenderer::SheetRenderer(const Sheet& sheet) : body_(std::make_unique<Body>(sheet)) {}
SheetRenderer::~SheetRenderer() = default;

void SheetRenderer::draw(std::span<const float> xyz, const Camera& camera, glm::ivec2 pixels,
                         const DrawOptions& options, const std::optional<ShownPush>& push) {
  Body& body = *body_;
  if (xyz.size() != 3 * static_cast<std::size_t>(body.sheet.count())) {
    throw std::invalid_argument("the renderer needs the positions of its own sheet");
  }
  if (pixels.x <= 0 || pixels.y <= 0) {
    return;
  }
  const glm::vec2 size(pixels);
  const Body::Frame frame{camera,
                          options.background,
                          paletteOf(options.background),
                          size,
                          camera.view(),
                          camera.projection(size.x / size.y),
                          depthsOf(camera),
                          size.y / (2 * std::tan(camera.fieldOfView() / 2))};
  glViewport(0, 0, pixels.x, pixels.y);
  glDisable(GL_CULL_FACE), glDisable(GL_SCISSOR_TEST), glDisable(GL_STENCIL_TEST), glDisable(GL_DEPTH_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE), glDepthMask(GL_TRUE);
  glEnable(GL_PROGRAM_POINT_SIZE), glEnable(GL_BLEND);
  // The framebuffer stays opaque whatever is blended into it.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
  if (!options.over) {
    const glm::vec3& clear = frame.palette.background;
    glClearColor(clear.r, clear.g, clear.b, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  }

  const bool shown = push && push->particle >= 0 && push->particle < body.sheet.count();
  body.upload(xyz, shown ? &*push : nullptr);
  if (options.ground && !options.over) {
    body.drawSurroundings(frame);
  }
  glEnable(GL_DEPTH_TEST), glDepthFunc(GL_LEQUAL);
  body.drawSprings(frame, options);
  body.drawDiscs(frame, options);
  if (shown) {
    body.drawPush(frame);
  }
  glBindVertexArray(0);
}

}  // namespace tyg
