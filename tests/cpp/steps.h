// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>

namespace circle_voronoi::test {

/// Returns the steps that the library takes while `work` runs: executed basic blocks, and each 64 bytes that are
/// allocated, copied, moved, filled or compared. The number does not depend on the machine's speed. Only libraries that
/// growth.cmake compiles count, and only one thread may run.
std::int64_t stepsOf(const std::function<void()>& work);

}  // namespace circle_voronoi::test
