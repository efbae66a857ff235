// GLSL knows no #include: the files that a program names take the place of their lines.
#include "gpu/kernel.h"

#include <algorithm>
#include <stdexcept>
#include <string_view>

#include "gpu/embedded_kernels.h"

namespace tyg {
namespace {

constexpr GLsizei kLongestLog = 4096;

template <class GetLog>
[[noreturn]] void refuse(const std::string& what, const GetLog& getLog) {
  std::string log(kLongestLog, '\0');
  GLsizei used = 0;
  getLog(kLongestLog, &used, log.data());
  log.resize(static_cast<std::size_t>(used));
  throw std::runtime_error("compute kernel " + what + " here: " + log);
}

}  // namespace

std::string textOf(std::string_view file) {
  const auto found = std::ranges::find(embeddedKernels(), file, &EmbeddedKernel::name);
  if (found == embeddedKernels().end()) throw std::runtime_error("no kernel " + std::string(file) + " is built in");
  return std::string(found->text);
}

std::string programOf(std::string_view file, const std::string& defines) {
  constexpr std::string_view kInclude = "#include \"";
  std::string text = textOf(file);
  for (std::size_t line = text.find(kInclude); line != std::string::npos; line = text.find(kInclude, line)) {
    const std::size_t name = line + kInclude.size(), end = text.find('"', name);
    text.replace(line, end + 1 - line, textOf(text.substr(name, end - name)));
  }
  return "#version 430 core\n" + defines + text;
}

Kernel::Kernel(const Gl& gl, const std::string& name, const std::string& text) : gl_(gl) {
  const GLuint shader = gl.CreateShader(GL_COMPUTE_SHADER);
  const char* start = text.data();
  const auto length = static_cast<GLint>(text.size());
  gl.ShaderSource(shader, 1, &start, &length);
  gl.CompileShader(shader);
  GLint worked = GL_FALSE;
  gl.GetShaderiv(shader, GL_COMPILE_STATUS, &worked);
  if (worked == GL_FALSE) {
    refuse(name + " does not compile",
           [&](GLsizei most, GLsizei* used, char* log) { gl.GetShaderInfoLog(shader, most, used, log); });
  }
  program_ = gl.CreateProgram();
  gl.AttachShader(program_, shader);
  gl.LinkProgram(program_);
  gl.DeleteShader(shader);
  gl.GetProgramiv(program_, GL_LINK_STATUS, &worked);
  if (worked == GL_FALSE) {
    refuse(name + " does not link",
           [&](GLsizei most, GLsizei* used, char* log) { gl.GetProgramInfoLog(program_, most, used, log); });
  }
}

Kernel::~Kernel() { gl_.DeleteProgram(program_); }

GLint Kernel::location(const char* name) {
  const auto known = locations_.find(std::string_view(name));
  if (known != locations_.end()) return known->second;
  return locations_[name] = gl_.GetUniformLocation(program_, name);
}

}  // namespace tyg
