// The error for all wrong input: scenes, logs, options, files that cannot be read or written. Read these headers in
// this order: input_error, scene, sheet, method, methods, event_log, simulation. Must not know: who reads the error.
#pragma once

#include <stdexcept>

namespace tyg {

/// What a person wrote is wrong. `what()` says where, what was found and what is allowed. Programs exit with 2.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

}  // namespace tyg
