// SPDX-License-Identifier: GPL-3.0-or-later
#include "steps.h"

#include <cstddef>
#include <cstdlib>
#include <new>

namespace {

std::int64_t steps = 0;

void countBytes(std::size_t size) { steps += static_cast<std::int64_t>(size / 64); }

}  // namespace

extern "C" {

// The compiler calls this function at the start of each basic block (-fsanitize-coverage=trace-pc).
void __sanitizer_cov_trace_pc() { ++steps; }

// Insertion into the middle of an array is one call of memmove, not many basic blocks. These definitions replace those
// of the C library in this program. growth.cmake keeps the compiler from turning their loops into calls of themselves.
void* memmove(void* to, const void* from, std::size_t size) {
  countBytes(size);
  auto* const target = static_cast<unsigned char*>(to);
  const auto* const source = static_cast<const unsigned char*>(from);
  if (target < source) {
    for (std::size_t i = 0; i < size; ++i) target[i] = source[i];
  } else {
    for (std::size_t i = size; i > 0; --i) target[i - 1] = source[i - 1];
  }
  return to;
}

void* memcpy(void* to, const void* from, std::size_t size) { return memmove(to, from, size); }

void* memset(void* to, int value, std::size_t size) {
  countBytes(size);
  auto* const target = static_cast<unsigned char*>(to);
  for (std::size_t i = 0; i < size; ++i) target[i] = static_cast<unsigned char>(value);
  return to;
}

int memcmp(const void* one, const void* other, std::size_t size) {
  countBytes(size);
  const auto* const a = static_cast<const unsigned char*>(one);
  const auto* const b = static_cast<const unsigned char*>(other);
  for (std::size_t i = 0; i < size; ++i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

}  // extern "C"

void* operator new(std::size_t size) {
  countBytes(size);
  void* const memory = std::malloc(size > 0 ? size : 1);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}

void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace circle_voronoi::test {

std::int64_t stepsOf(const std::function<void()>& work) {
  const std::int64_t before = steps;
  work();
  return steps - before;
}

}  // namespace circle_voronoi::test
