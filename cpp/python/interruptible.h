// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <atomic>
#include <chrono>
#include <future>
#include <memory>
#include <thread>
#include <utility>

namespace circle_voronoi::python {

/// Thrown inside a computation that its caller no longer waits for.
struct Canceled {};

/// Tells a computation whether its caller still waits.
class Cancellation {
 public:
  /// Throws Canceled if the caller no longer waits. Progress callbacks of the library may throw.
  void check() const {
    if (isRequested_) throw Canceled{};
  }

 private:
  template <class Compute>
  friend auto interruptible(Compute compute);

  std::atomic<bool> isRequested_ = false;
};

/// Runs `compute(cancellation)` in a thread of its own without the GIL and returns its result. Ctrl-C ends the wait
/// within a twentieth of a second, even inside a stage that cannot be interrupted. The thread then ends at its next
/// check, and its result is dropped. Therefore `compute` must own all its data and must not touch Python objects.
template <class Compute>
auto interruptible(Compute compute) {
  using Value = decltype(compute(std::declval<const Cancellation&>()));
  const auto cancellation = std::make_shared<Cancellation>();
  std::packaged_task<Value()> task(
      [compute = std::move(compute), cancellation]() mutable { return compute(*cancellation); });
  std::future<Value> result = task.get_future();
  std::thread(std::move(task)).detach();
  for (;;) {
    {
      const pybind11::gil_scoped_release released;
      if (result.wait_for(std::chrono::milliseconds(50)) == std::future_status::ready) break;
    }
    if (PyErr_CheckSignals() != 0) {
      cancellation->isRequested_ = true;
      throw pybind11::error_already_set();
    }
  }
  return result.get();
}

}  // namespace circle_voronoi::python
