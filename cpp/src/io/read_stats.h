// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/stats.h"
#include "json_reader.h"

namespace circle_voronoi {

/// Reads the `stats` of a diagram. Missing and unknown fields, and fields of another type, stay empty. A certificate is
/// skipped.
Stats readStats(JsonReader& reader);

}  // namespace circle_voronoi
