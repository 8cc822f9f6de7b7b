// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "circle_voronoi/box.h"
#include "circle_voronoi/periodic_diagram.h"

namespace circle_voronoi::cli {

/// Whether numbers may be inf or -inf.
enum class Sides { finite, maybeInfinite };

/// Reads a whole text as a number. Returns nothing if the text is not a number.
std::optional<double> readNumber(std::string_view text, Sides sides = Sides::finite);

/// Reads MINX,MINY,MAXX,MAXY, or returns the text of an error. An empty text is no box. A finite box must be valid for
/// clipping.
std::string readBox(std::string_view text, Box& box, Sides sides = Sides::finite);

/// Reads the periods AX,AY,BX,BY, or returns the text of an error. An empty text is no lattice.
std::string readLattice(std::string_view text, Lattice& lattice);

}  // namespace circle_voronoi::cli
