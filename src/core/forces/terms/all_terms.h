// Every force term, in the order in which scene files name them and forces add them up. A new one is a header and a
// .cpp beside these, an include, and its name here.
#pragma once

#include "core/forces/terms/air.h"
#include "core/forces/terms/contact.h"
#include "core/forces/terms/drag.h"
#include "core/forces/terms/gravity.h"
#include "core/forces/terms/springs.h"

namespace tyg {

using AllTerms = TermList<StructuralSprings, ShearSprings, BendSprings, Gravity, Drag, AirTerm, ContactTerm>;

/// What these terms store energy in.
inline constexpr auto kStores = AllTerms::stores();
/// What brings energy to the sheet by these terms.
inline constexpr auto kSupplies = AllTerms::supplies();

}  // namespace tyg
