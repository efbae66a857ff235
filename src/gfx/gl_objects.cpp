// Compiles and links the embedded shaders; what does not compile is reported with the words of the driver.
#include "gfx/gl_objects.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "gfx/embedded_shaders.h"

namespace tyg {
namespace {

constexpr GLsizei kLongestLog = 4096;

std::string_view shaderText(const std::string& file) {
  for (const EmbeddedShader& shader : embeddedShaders()) {
    if (shader.name == file) {
      return shader.text;
    }
  }
  throw std::runtime_error("no shader " + file + " is built in");
}

/// With the one file that it may include in its place (`#include "NAME"` on a line of its own), and with the defines
/// after its version.
std::string completeText(const std::string& file, std::string_view defines) {
  constexpr std::string_view kInclude = "#include \"";
  std::string text(shaderText(file));
  if (const std::size_t line = text.find(kInclude); line != std::string::npos) {
    const std::size_t name = line + kInclude.size(), end = text.find('"', name);
    text.replace(line, end + 1 - line, shaderText(text.substr(name, end - name)));
  }
  return text.insert(text.find('\n', text.find("#version")) + 1, defines);
}

/// Deletes the shader again when linking is over or has failed.
class Shader {
 public:
  Shader(GLenum stage, const std::string& file, std::string_view defines) : name_(glCreateShader(stage)) {
    const std::string text = completeText(file, defines);
    const char* start = text.data();
    const auto length = static_cast<GLint>(text.size());
    glShaderSource(name_, 1, &start, &length);
    glCompileShader(name_);
    GLint compiled = GL_FALSE;
    glGetShaderiv(name_, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_FALSE) {
      std::string log(kLongestLog, '\0');
      GLsizei used = 0;
      glGetShaderInfoLog(name_, kLongestLog, &used, log.data());
      log.resize(static_cast<std::size_t>(used));
      glDeleteShader(name_);
      throw std::runtime_error("shader " + file + " does not compile here: " + log);
    }
  }
  ~Shader() { glDeleteShader(name_); }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_;
};

}  // namespace

GlProgram::GlProgram(std::string_view stem, std::string_view defines, const char* written) {
  const Shader vertex(GL_VERTEX_SHADER, std::string(stem) + ".vert", defines);
  std::optional<Shader> fragment;
  if (written == nullptr) fragment.emplace(GL_FRAGMENT_SHADER, std::string(stem) + ".frag", defines);
  name_ = glCreateProgram();
  glAttachShader(name_, vertex.name());
  if (fragment) {
    glAttachShader(name_, fragment->name());
  } else {
    glTransformFeedbackVaryings(name_, 1, &written, GL_INTERLEAVED_ATTRIBS);
  }
  glLinkProgram(name_);
  GLint linked = GL_FALSE;
  glGetProgramiv(name_, GL_LINK_STATUS, &linked);
  if (linked == GL_FALSE) {
    std::string log(kLongestLog, '\0');
    GLsizei used = 0;
    glGetProgramInfoLog(name_, kLongestLog, &used, log.data());
    log.resize(static_cast<std::size_t>(used));
    glDeleteProgram(name_);
    throw std::runtime_error("shaders " + std::string(stem) + " do not link here: " + log);
  }
}

GlProgram::~GlProgram() { glDeleteProgram(name_); }

}  // namespace tyg
