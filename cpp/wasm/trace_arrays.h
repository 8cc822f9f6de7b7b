// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <vector>

#include "circle_voronoi/trace.h"

namespace circle_voronoi {

/// Events as they come, field by field.
class TraceArrays {
 public:
  /// Returns an observer that adds each event.
  Observer observer();
  emscripten::val value() const;

 private:
  std::vector<std::uint8_t> kinds_;
  std::vector<double> discs_;
  std::vector<std::int32_t> circles_;
  std::vector<std::int32_t> vertices_;
  std::vector<std::int32_t> numbers_;
};

}  // namespace circle_voronoi
