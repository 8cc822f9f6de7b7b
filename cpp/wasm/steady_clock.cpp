// SPDX-License-Identifier: GPL-3.0-or-later
// A steady clock without exceptions. The standard library's clock may throw a system_error, which links all error
// messages and printf: 6 kB, compressed.
#include <emscripten/emscripten.h>

#include <chrono>

namespace std::chrono {

steady_clock::time_point steady_clock::now() noexcept {
  const std::chrono::duration<double, std::milli> sinceStart(emscripten_get_now());
  return time_point(duration_cast<duration>(sinceStart));
}

}  // namespace std::chrono
