// The graphics card: an OpenGL context and the thread that it belongs to, and the compute programs that were made
// there. Must not know: methods, what moves.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "gpu/kernel.h"
#include "gpu/opened_context.h"

namespace tyg {

/// A context belongs to one thread, and a thread to one window system's context at a time: a card has a thread of its
/// own, or else the context and the thread of whoever draws.
class Card {
 public:
  /// Both throw std::runtime_error that says why there is no OpenGL 4.3 here. In a context and a thread of its own:
  explicit Card(const ContextOpener& open);
  /// In the context that is current in this thread, which is to do all that is done with the card, and which draws from
  /// what was computed.
  explicit Card(GlFinder find);
  ~Card();
  Card(const Card&) = delete;
  Card& operator=(const Card&) = delete;

  /// What its driver calls it.
  [[nodiscard]] const std::string& name() const { return name_; }
  /// The largest block of memory that a program may see at once, bytes.
  [[nodiscard]] std::size_t largestBuffer() const { return largestBuffer_; }

  /// Whether its context is the one that draws.
  [[nodiscard]] bool draws() const { return !thread_.joinable(); }
  /// So far, from its memory to the processor's.
  [[nodiscard]] std::size_t bytesRead() const { return bytesRead_; }

  /// Runs the task in the card's thread, waits for it, and throws what it throws. One task at a time.
  void run(const std::function<void()>& task);

  // Within a task:
  [[nodiscard]] const Gl& gl() const { return gl_; }
  /// The program of this file in kernels/ with these lines of defines, from then on the same one.
  Kernel& kernel(const std::string& file, const std::string& defines);
  /// Throws std::runtime_error where the driver has reported an error.
  void refuseErrors() const;
  void countRead(std::size_t bytes) { bytesRead_ += bytes; }

 private:
  void work(const ContextOpener& open);
  void begin(GlFinder find);

  OpenedContext context_;
  Gl gl_{};
  std::string name_;
  std::size_t largestBuffer_ = 0, bytesRead_ = 0;
  std::map<std::string, std::unique_ptr<Kernel>> kernels_;

  std::mutex oneCaller_;
  std::mutex mutex_;
  std::condition_variable changed_;
  const std::function<void()>* task_ = nullptr;  // the one that waits or runs
  std::exception_ptr failure_;                   // of the last task
  bool started_ = false, ends_ = false;
  std::thread thread_;
};

}  // namespace tyg
