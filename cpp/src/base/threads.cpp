// SPDX-License-Identifier: GPL-3.0-or-later
#include "threads.h"

#include <string>

#ifndef CIRCLE_VORONOI_ONE_THREAD
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#endif

namespace circle_voronoi {

std::optional<Error> Threads::refusalOf(int count) {
  if (count >= 0) return {};
  return Error{ErrorCode::badOption, kNone,
               "The number of threads must not be negative (got " + std::to_string(count) + ")."};
}

#ifndef CIRCLE_VORONOI_ONE_THREAD

Threads::Threads(int count)
    : count_(count > 0 ? count : std::max(1, static_cast<int>(std::thread::hardware_concurrency()))) {}

void Threads::run(std::size_t count, const std::function<void(std::size_t)>& task) const {
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::mutex mutex;
  const auto work = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) task(i);
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  std::vector<std::thread> helpers;
  const std::size_t wanted = std::min(count, static_cast<std::size_t>(count_));
  try {
    helpers.reserve(wanted);
    while (helpers.size() + 1 < wanted) helpers.emplace_back(work);
  } catch (const std::exception&) {
    // The others do what one that cannot be had would have done.
  }
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
}

#else

Threads::Threads(int) : count_(1) {}

void Threads::run(std::size_t count, const std::function<void(std::size_t)>& task) const {
  for (std::size_t i = 0; i < count; ++i) task(i);
}

#endif

}  // namespace circle_voronoi
