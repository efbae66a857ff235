// Where the parameters of force terms lie in a scene file: the parts of their keys, and the tables that hold them.
// Must not know: any term, how files are read or written.
#pragma once

#include <string_view>
#include <vector>

#include "core/forces/term.h"

namespace tyg {

/// `springs.shear.ks` is `ks` in the table `shear` in the table `springs`; `world.gravity` has no inner table.
struct KeyParts {
  std::string_view table, inner, last;
};
KeyParts partsOf(std::string_view key);

/// The table that holds the springs' law of damping besides its terms.
inline constexpr std::string_view kSpringsTable = "springs";
/// The table that has to be there where a scene has [[wind]].
inline constexpr std::string_view kAirTable = "air";
/// The table that has to be there where a scene has [[body]].
inline constexpr std::string_view kContactTable = "contact";
/// The names of all tables that hold terms, each once, in the order of the terms.
std::vector<std::string_view> tablesOfTerms();

}  // namespace tyg
