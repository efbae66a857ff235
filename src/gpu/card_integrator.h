// A method's steps on the graphics card, for simulations. Must not know: who chose it, windows.
#pragma once

#include <memory>
#include <span>

#include "core/forces/term.h"
#include "core/simulation/integrator.h"
#include "gpu/card.h"
#include "gpu/scheme.h"

namespace tyg {

/// Throws InputError with the reason where the card does not take the sheet, or has no kernel for a term of the scene.
void refuseOnCard(const Card& card, const Scene& scene, const Sheet& sheet);
/// The latter, of these terms.
void refuseTermsWithoutKernel(const Scene& scene, std::span<const ForceTerm* const> terms);

/// Copies the state to the card where something else has changed it, and back where it is fetched.
std::unique_ptr<Integrator<float>> makeCardIntegrator(std::shared_ptr<Card> card, const Scheme& scheme,
                                                      const Scene& scene, const Sheet& sheet);

}  // namespace tyg
