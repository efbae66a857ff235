// How the viewer gets at a graphics card, which somebody else opens. Must not know: what a card is, OpenGL.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "tyg/simulation.h"

namespace tyg {

struct OfferedCard {
  std::shared_ptr<Device> device;
  std::string sentence;  ///< about the card, for people
};

/// Opens the card, and compares it with the processor on this scene. Throws std::runtime_error that says why none
/// serves, and InputError where it does not take the scene.
using CardOffer = std::function<OfferedCard(const Scene& scene)>;

}  // namespace tyg
