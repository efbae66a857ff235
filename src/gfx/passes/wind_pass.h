// A wind: a small solid arrow along it, in a corner of the picture.
// Must not know: what the wind does to the cloth, where it comes from.
#pragma once

#include "gfx/gl_objects.h"
#include "gfx/passes/pass.h"

namespace tyg {

class WindPass final : public Pass {
 public:
  explicit WindPass(const Canvas& canvas);
  void draw(const Frame& frame) override;

 private:
  GlProgram program_{"solid"};
  GlVertexArray vertices_;
  GlBuffer buffer_;
  GLsizei count_ = 0;
};

}  // namespace tyg
