// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/periodic.h"

namespace circle_voronoi::cli {

/// Whether numbers may be inf or -inf.
enum class Sides { finite, maybeInfinite };

/// All of the text as a number; nothing if it is none.
std::optional<double> readNumber(std::string_view text, Sides sides = Sides::finite);

/// Reads MINX,MINY,MAXX,MAXY, or returns an error in words; an empty text is no box. A finite box is one to clip to.
std::string readBox(std::string_view text, Box& box, Sides sides = Sides::finite);

/// Reads the periods AX,AY,BX,BY, or returns an error in words; an empty text is no lattice.
std::string readLattice(std::string_view text, Lattice& lattice);

}  // namespace circle_voronoi::cli
