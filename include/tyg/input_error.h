// The error for all wrong input: scenes, logs, options, files that cannot be read or written. Read these headers in
// this order: input_error, scene, sheet, method, methods, event_log, simulation. Must not know: who reads the error.
#pragma once

#include <stdexcept>
#include <string>

namespace tyg {

/// What a person wrote is wrong. `what()` says where, what was found and what is allowed. Programs exit with 2.
class InputError : public std::runtime_error {
 public:
  /// NUL characters of the message, which would end it, become `\0`.
  explicit InputError(const std::string& message);
};

}  // namespace tyg
