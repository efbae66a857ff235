// What of a scene acts on the sheet from one moment on until something begins or ends. Must not know: when that is.
#pragma once

#include <vector>

#include "tyg/scene.h"

namespace tyg {

/// How far a body is from where its scene has it: offset + time * velocity.
struct BodyMotion {
  Vec3 offset{};    ///< m
  Vec3 velocity{};  ///< m/s
  bool operator==(const BodyMotion&) const = default;
};

struct Acting {
  std::vector<Wind> winds{};         ///< those that blow
  std::vector<BodyMotion> bodies{};  ///< of the first bodies of the scene; those that are not listed stand still
};

}  // namespace tyg
