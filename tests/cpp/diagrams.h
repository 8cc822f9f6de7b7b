// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <span>
#include <utility>

#include "circle_voronoi/compute.h"

namespace circle_voronoi::test {

/// Computes a diagram and expects success.
inline Diagram diagramOf(std::span<const Circle> circles, const Options& options = {}) {
  auto diagram = compute(circles, options);
  EXPECT_TRUE(diagram) << diagram.error().message;
  return std::move(diagram).value();
}

}  // namespace circle_voronoi::test
