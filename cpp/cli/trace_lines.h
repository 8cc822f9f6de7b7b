// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <iosfwd>

#include "circle_voronoi/trace.h"

namespace circle_voronoi::cli {

/// Writes an event as one line of JSON: its kind and, where it has them, its disc, its circles, its vertex and its
/// numbers. Numbers keep all digits.
void writeTraceEvent(std::ostream& out, const TraceEvent& event);

}  // namespace circle_voronoi::cli
