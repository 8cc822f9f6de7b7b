// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

/// The method for building a diagram.
enum class Method {
  automatic,     ///< the fastest construction that leads to a certified diagram (ARCHITECTURE.md)
  touchingDisc,  ///< the paper's method: candidate pairs, then the event loop
  flip,          ///< edge flips from the Delaunay triangulation of the centers
};

/// The pairs of circles that get an antipodal disc in the touching disc method.
enum class Candidates {
  dynamic,   ///< neighbors in the Delaunay graph of dynamically chosen samples (paper, section 5)
  uniform,   ///< neighbors in the Delaunay graph of equally spaced samples on every circle (paper, section 4.1)
  allPairs,  ///< every pair (paper, section 3): quadratic time and memory
};

/// The construction that made a diagram.
enum class Way {
  flip,          ///< edge flips
  repair,        ///< edge flips, and local diagrams where flips did not suffice
  insert,        ///< insertion, circle by circle
  touchingDisc,  ///< the touching disc method
  edit,          ///< a DiagramEditor
};

// The names of these values in JSON, in JavaScript and on the command line, such as "auto" and "touching-disc". Past
// the last value of an enumeration the name is empty.
[[nodiscard]] CIRCLE_VORONOI_API std::string_view methodName(Method method);
[[nodiscard]] CIRCLE_VORONOI_API std::string_view candidatesName(Candidates candidates);
[[nodiscard]] CIRCLE_VORONOI_API std::string_view wayName(Way way);

// The value with a name; nothing if there is none.
[[nodiscard]] CIRCLE_VORONOI_API std::optional<Method> methodFromName(std::string_view name);
[[nodiscard]] CIRCLE_VORONOI_API std::optional<Candidates> candidatesFromName(std::string_view name);
[[nodiscard]] CIRCLE_VORONOI_API std::optional<Way> wayFromName(std::string_view name);

}  // namespace circle_voronoi
