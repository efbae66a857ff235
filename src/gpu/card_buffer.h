// A block of memory on the graphics card. Must not know: what is in it.
#pragma once

#include <cstddef>

#include "gpu/card.h"

namespace tyg {

/// Made, used and destroyed in the thread of its context.
class CardBuffer {
 public:
  explicit CardBuffer(Card& card) : card_(&card), gl_(&card.gl()) { gl_->GenBuffers(1, &name_); }
  ~CardBuffer() { gl_->DeleteBuffers(1, &name_); }
  CardBuffer(const CardBuffer&) = delete;
  CardBuffer& operator=(const CardBuffer&) = delete;

  [[nodiscard]] GLuint name() const { return name_; }
  /// Makes it as large as this at least; what was in it is lost where it grows.
  void reserve(std::size_t bytes) {
    if (bytes <= bytes_) return;
    bind();
    gl_->BufferData(GL_SHADER_STORAGE_BUFFER, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY);
    bytes_ = bytes;
  }
  /// From this byte on.
  void write(const void* from, std::size_t bytes, std::size_t begin = 0) {
    reserve(begin + bytes);
    gl_->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    bind();
    gl_->BufferSubData(GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(begin), static_cast<GLsizeiptr>(bytes), from);
  }
  /// What the kernels have written.
  void read(void* to, std::size_t bytes) const {
    gl_->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    card_->countRead(bytes);
    bind();
    gl_->GetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, static_cast<GLsizeiptr>(bytes), to);
  }
  /// Takes over what another one of the same size holds.
  void copyFrom(const CardBuffer& other) { copyFrom(other, 0, 0, bytes_); }
  /// So many bytes, which begin there in the other one and here in this one.
  void copyFrom(const CardBuffer& other, std::size_t there, std::size_t here, std::size_t bytes) {
    gl_->MemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
    gl_->BindBuffer(GL_COPY_READ_BUFFER, other.name_);
    bind();
    gl_->CopyBufferSubData(GL_COPY_READ_BUFFER, GL_SHADER_STORAGE_BUFFER, static_cast<GLintptr>(there),
                           static_cast<GLintptr>(here), static_cast<GLsizeiptr>(bytes));
  }
  /// Lets the kernels see it at this binding.
  void show(unsigned binding) const { gl_->BindBufferBase(GL_SHADER_STORAGE_BUFFER, binding, name_); }

 private:
  void bind() const { gl_->BindBuffer(GL_SHADER_STORAGE_BUFFER, name_); }

  Card* card_;
  const Gl* gl_;
  GLuint name_ = 0;
  std::size_t bytes_ = 0;
};

}  // namespace tyg
