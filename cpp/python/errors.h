// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

#include <utility>

#include "circle_voronoi/error.h"

namespace circle_voronoi::python {

/// An Error on its way to Python, where it becomes a CircleVoronoiError.
struct Failed {
  Error error;
};

template <class T>
T valueOf(Result<T> result) {
  if (!result) throw Failed{result.error()};
  if constexpr (!std::is_void_v<T>) return std::move(result).value();
}

/// Makes Python raise circle_voronoi.CircleVoronoiError for Failed.
void translateErrors();

}  // namespace circle_voronoi::python
