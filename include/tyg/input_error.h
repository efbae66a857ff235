// The error that all wrong input ends in: scenes, logs, options, files that cannot be read or written.
// Must not know: who reads it.
#pragma once

#include <stdexcept>

namespace tyg {

/// What a person wrote is wrong. `what()` says where, what was found and what is allowed. Programs exit with 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tyg
