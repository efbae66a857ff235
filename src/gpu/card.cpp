// Tasks are handed over one by one, and whoever hands one over waits: the card's work is ordered by its callers.
#include "gpu/card.h"

#include <fmt/core.h>

#include <stdexcept>
#include <utility>

namespace tyg {

Card::Card(const ContextOpener& open) {
  thread_ = std::thread([this, open] { work(open); });
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return started_; });
  if (!failure_) return;
  lock.unlock();
  thread_.join();
  std::rethrow_exception(failure_);
}

Card::Card(GlFinder find) { begin(find); }

Card::~Card() {
  if (draws()) return;
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Card::run(const std::function<void()>& task) {
  const std::lock_guard caller(oneCaller_);
  if (draws()) {
    constexpr int kMost = 16;                                                   // a lost context reports one for ever
    for (int k = 0; k < kMost && gl_.GetError() != GL_NO_ERROR; ++k) continue;  // somebody else's
    return task();
  }
  std::unique_lock lock(mutex_);
  task_ = &task;
  changed_.notify_all();
  changed_.wait(lock, [&] { return task_ == nullptr; });
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void Card::begin(GlFinder find) {
  if (gladLoadGLContext(&gl_, find) < GLAD_MAKE_VERSION(4, 3)) {
    throw std::runtime_error("it offers less than OpenGL 4.3");
  }
  name_ = reinterpret_cast<const char*>(gl_.GetString(GL_RENDERER));
  GLint64 largest = 0;
  gl_.GetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &largest);
  largestBuffer_ = static_cast<std::size_t>(largest);
  constexpr GLint kBlocks = 13;  // bindings of the kernels
  GLint blocks = 0;
  gl_.GetIntegerv(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, &blocks);
  if (blocks < kBlocks) {
    throw std::runtime_error(fmt::format("its programs see {} blocks of memory, {} are needed", blocks, kBlocks));
  }
}

void Card::work(const ContextOpener& open) {
  try {
    context_ = open();
    begin(context_.find);
  } catch (...) {
    failure_ = std::current_exception();
    context_ = {};
  }
  std::unique_lock lock(mutex_);
  started_ = true;
  changed_.notify_all();
  if (failure_) return;
  for (;;) {
    changed_.wait(lock, [&] { return task_ != nullptr || ends_; });
    if (task_ == nullptr) break;
    lock.unlock();
    try {
      (*task_)();
    } catch (...) {
      failure_ = std::current_exception();
    }
    lock.lock();
    task_ = nullptr;
    changed_.notify_all();
  }
  kernels_.clear();
  context_ = {};
}

Kernel& Card::kernel(const std::string& file, const std::string& defines) {
  std::unique_ptr<Kernel>& kernel = kernels_[file + defines];
  if (!kernel) kernel = std::make_unique<Kernel>(gl_, file, programOf(file, defines));
  return *kernel;
}

void Card::refuseErrors() const {
  const GLenum error = gl_.GetError();
  if (error == GL_NO_ERROR) return;
  if (error == GL_OUT_OF_MEMORY) throw std::runtime_error("the graphics card has not enough memory for this sheet");
  throw std::runtime_error(fmt::format("the graphics card's driver reports OpenGL error {:#x}", error));
}

}  // namespace tyg
