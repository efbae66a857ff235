// Counts what a test program allocates: every form of new in the standard library ends in one of these.
// For one source file of a program alone.
#pragma once

#include <atomic>
#include <cstdlib>
#include <new>

namespace {

std::atomic<long> allocations{0};

#ifdef _WIN32
void* allocateAligned(std::size_t to, std::size_t size) { return _aligned_malloc(size, to); }
void freeAligned(void* memory) { _aligned_free(memory); }
#else
void* allocateAligned(std::size_t to, std::size_t size) { return std::aligned_alloc(to, (size + to - 1) / to * to); }
void freeAligned(void* memory) { std::free(memory); }
#endif

}  // namespace

#pragma GCC diagnostic ignored "-Wmismatched-new-delete"  // GCC does not see that these belong together
void* operator new(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {  // of std::stable_sort
  ++allocations;
  return std::malloc(size);
}
void* operator new(std::size_t size, std::align_val_t alignment) {
  ++allocations;
  if (void* memory = allocateAligned(static_cast<std::size_t>(alignment), size)) return memory;
  throw std::bad_alloc();
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { freeAligned(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { freeAligned(memory); }
