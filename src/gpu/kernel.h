// A compute program made from the texts in kernels/, and the numbers that it is given.
// Must not know: what it computes.
#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>

#include "gpu/gl.h"

namespace tyg {

/// The text of one file of kernels/.
std::string textOf(std::string_view file);
/// The whole text of the program whose main() is in this file, with the files that it includes. `defines`: lines of
/// GLSL that stand before all else.
std::string programOf(std::string_view file, const std::string& defines);

/// Made, used and destroyed in the thread of its context.
class Kernel {
 public:
  /// `name` is what messages call it. Throws std::runtime_error with the driver's words.
  Kernel(const Gl& gl, const std::string& name, const std::string& text);
  ~Kernel();
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;

  void use() const { gl_.UseProgram(program_); }
  // Numbers by name, while the program is in use; a name that it does not use is passed over.
  void set(const char* name, int value) { gl_.Uniform1i(location(name), value); }
  void set(const char* name, float value) { gl_.Uniform1f(location(name), value); }
  void set(const char* name, double value) { gl_.Uniform1d(location(name), value); }
  void set(const char* name, const std::array<float, 3>& v) { gl_.Uniform3f(location(name), v[0], v[1], v[2]); }
  void set(const char* name, const std::array<double, 3>& v) { gl_.Uniform3d(location(name), v[0], v[1], v[2]); }

 private:
  GLint location(const char* name);

  const Gl& gl_;
  GLuint program_ = 0;
  std::map<std::string, GLint, std::less<>> locations_;
};

}  // namespace tyg
