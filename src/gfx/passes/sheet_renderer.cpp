// Uploads the positions, sets OpenGL's state as every pass expects it, and runs the table of passes from the back of
// the picture to its front.
#include "gfx/passes/sheet_renderer.h"

#include <fmt/core.h>

#include <stdexcept>

#include "gfx/passes/body_pass.h"
#include "gfx/passes/particle_pass.h"
#include "gfx/passes/plane_pass.h"
#include "gfx/passes/push_pass.h"
#include "gfx/passes/shadow_pass.h"
#include "gfx/passes/spring_pass.h"
#include "gfx/passes/surface_pass.h"
#include "gfx/passes/surroundings_pass.h"
#include "gfx/passes/wind_pass.h"
#include "tyg/input_error.h"

namespace tyg {
namespace {

template <class Kind>
std::unique_ptr<Pass> make(const Canvas& canvas) {
  return std::make_unique<Kind>(canvas);
}

/// In the order in which they draw.
constexpr std::unique_ptr<Pass> (*kPasses[])(const Canvas& canvas){
    make<SurroundingsPass>, make<PlanePass>,    make<ShadowPass>, make<BodyPass>, make<SurfacePass>,
    make<SpringPass>,       make<ParticlePass>, make<PushPass>,   make<WindPass>,
};

/// Of all depths, by which what is drawn over another picture comes nearer: where two cloths agree to rounding, the one
/// drawn over the other would be seen in patches. At three metres it is a centimetre.
constexpr double kOverNearer = 1e-3;

std::unique_ptr<Canvas> makeCanvas(const Sheet& sheet, Programs& programs) {
  if (sheet.count() > Positions::mostPoints()) {
    throw InputError(fmt::format("sheet: found {} particles, allowed: up to {}, as this graphics driver draws no more",
                                 sheet.count(), Positions::mostPoints()));
  }
  return std::make_unique<Canvas>(sheet, programs);
}

void setState(glm::ivec2 pixels) {
  glViewport(0, 0, pixels.x, pixels.y);
  glDisable(GL_CULL_FACE), glDisable(GL_SCISSOR_TEST), glDisable(GL_STENCIL_TEST);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glEnable(GL_DEPTH_TEST), glDepthFunc(GL_LEQUAL), glDepthMask(GL_TRUE);
  glEnable(GL_PROGRAM_POINT_SIZE), glEnable(GL_BLEND);
  // The framebuffer stays opaque whatever is blended into it.
  glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
}

}  // namespace

SheetRenderer::SheetRenderer(const Sheet& sheet, std::shared_ptr<Programs> programs)
    : programs_(std::move(programs)), canvas_(makeCanvas(sheet, *programs_)) {
  for (const auto& makePass : kPasses) passes_.push_back(makePass(*canvas_));
}
SheetRenderer::~SheetRenderer() = default;

void SheetRenderer::follow(const Sheet& sheet) {
  Sheet& known = canvas_->sheet;
  if (sheet.columns != known.columns || sheet.rows != known.rows) {
    throw std::invalid_argument("the renderer follows its own sheet");
  }
  if (sheet.pins == known.pins && sheet.missing == known.missing) return;
  known = sheet;
  canvas_->cloth.changeSheet();
  for (const std::unique_ptr<Pass>& pass : passes_) pass->changeSheet();
}

void SheetRenderer::draw(const DrawnPositions& positions, const Camera& camera, glm::ivec2 pixels,
                         const DrawOptions& options, const std::optional<ShownPush>& push) {
  const int count = canvas_->sheet.count();
  if (positions.buffer() == 0 && positions.xyz().size() != 3 * static_cast<std::size_t>(count)) {
    throw std::invalid_argument("the renderer needs the positions of its own sheet");
  }
  if (pixels.x <= 0 || pixels.y <= 0) return;
  const bool shown = push && push->particle >= 0 && push->particle < count;
  const Frame frame = makeFrame(positions, camera, pixels, options, shown ? &*push : nullptr);
  setState(pixels);
  positions.buffer() != 0 ? canvas_->positions.copy(positions.buffer()) : canvas_->positions.upload(positions.xyz());
  if (canvas_->showsSurface(options)) canvas_->cloth.prepare(canvas_->sheet, positions);
  if (!options.over) canvas_->bodies.follow(options.bodies);
  for (const std::unique_ptr<Pass>& pass : passes_) pass->prepare(frame);
  if (!options.over) {
    const glm::vec3& clear = frame.palette.background;
    glClearColor(clear.r, clear.g, clear.b, 1);
    // With the stencil, which lies in the same words: depths alone take several times as long without a graphics card.
    // The ground covers all of the picture.
    glClear((options.ground ? 0U : GL_COLOR_BUFFER_BIT) | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
  }
  glDepthRange(0, options.over ? 1 - kOverNearer : 1);
  for (const std::unique_ptr<Pass>& pass : passes_) pass->draw(frame);
  glDepthRange(0, 1);
  glBindVertexArray(0);
}

}  // namespace tyg
