// Owners of OpenGL objects, and shader programs made from the embedded texts.
// Must not know: what is drawn with them. Everything here belongs to the context that is current when it is made.
#pragma once

#include <glad/gl.h>

#include <span>
#include <string_view>

#include <glm/glm.hpp>

namespace tyg {

/// An OpenGL object that is deleted with its owner.
template <class Kind>
class GlObject {
 public:
  GlObject() : name_(Kind::make()) {}
  ~GlObject() { Kind::destroy(name_); }
  GlObject(const GlObject&) = delete;
  GlObject& operator=(const GlObject&) = delete;
  [[nodiscard]] GLuint name() const { return name_; }

 private:
  GLuint name_;
};

struct GlBufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenBuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteBuffers(1, &name); }
};
struct GlTextureKind {
  static GLuint make() {
    GLuint name = 0;
    glGenTextures(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteTextures(1, &name); }
};
struct GlVertexArrayKind {
  static GLuint make() {
    GLuint name = 0;
    glGenVertexArrays(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteVertexArrays(1, &name); }
};
struct GlFramebufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenFramebuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteFramebuffers(1, &name); }
};
struct GlRenderbufferKind {
  static GLuint make() {
    GLuint name = 0;
    glGenRenderbuffers(1, &name);
    return name;
  }
  static void destroy(GLuint name) { glDeleteRenderbuffers(1, &name); }
};
using GlBuffer = GlObject<GlBufferKind>;
using GlTexture = GlObject<GlTextureKind>;
using GlVertexArray = GlObject<GlVertexArrayKind>;
using GlFramebuffer = GlObject<GlFramebufferKind>;
using GlRenderbuffer = GlObject<GlRenderbufferKind>;

/// Binds the framebuffer again that was bound before.
class FramebufferGuard {
 public:
  FramebufferGuard() { glGetIntegerv(GL_FRAMEBUFFER_BINDING, &before_); }
  ~FramebufferGuard() { glBindFramebuffer(GL_FRAMEBUFFER, static_cast<GLuint>(before_)); }
  FramebufferGuard(const FramebufferGuard&) = delete;
  FramebufferGuard& operator=(const FramebufferGuard&) = delete;

 private:
  GLint before_ = 0;
};

/// A vertex and a fragment shader, `STEM.vert` and `STEM.frag` of shaders/; or a vertex shader alone, whose outputs are
/// written into a buffer.
class GlProgram {
 public:
  /// `defines`: lines of GLSL that both begin with, after their version. `written`: the output of a vertex shader
  /// alone, null with a fragment shader. Throws std::runtime_error with the driver's log where they do not compile or
  /// link.
  explicit GlProgram(std::string_view stem, std::string_view defines = {}, const char* written = nullptr);
  ~GlProgram();
  GlProgram(const GlProgram&) = delete;
  GlProgram& operator=(const GlProgram&) = delete;

  void use() const { glUseProgram(name_); }
  /// Uniforms of the program in use. A name that the shaders do not use is passed over, as OpenGL does.
  void set(const char* uniform, int value) const { glUniform1i(at(uniform), value); }
  void set(const char* uniform, float value) const { glUniform1f(at(uniform), value); }
  void set(const char* uniform, const glm::vec2& value) const { glUniform2fv(at(uniform), 1, &value[0]); }
  void set(const char* uniform, const glm::vec3& value) const { glUniform3fv(at(uniform), 1, &value[0]); }
  void set(const char* uniform, const glm::vec4& value) const { glUniform4fv(at(uniform), 1, &value[0]); }
  void set(const char* uniform, std::span<const glm::vec3> values) const {
    glUniform3fv(at(uniform), static_cast<GLsizei>(values.size()), &values[0][0]);
  }
  void set(const char* uniform, std::span<const glm::vec4> values) const {
    glUniform4fv(at(uniform), static_cast<GLsizei>(values.size()), &values[0][0]);
  }
  void set(const char* uniform, const glm::mat4& value) const {
    glUniformMatrix4fv(at(uniform), 1, GL_FALSE, &value[0][0]);
  }

 private:
  [[nodiscard]] GLint at(const char* uniform) const { return glGetUniformLocation(name_, uniform); }
  GLuint name_ = 0;
};

}  // namespace tyg
