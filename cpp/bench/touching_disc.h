// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "circle_voronoi/compute.h"

namespace circle_voronoi {

/// Returns options for the touching disc method, with the default number of samples if none is given.
inline Options touchingDisc(Candidates candidates, std::optional<int> samples = {}) {
  Options options;
  options.method = Method::touchingDisc;
  options.candidates = candidates;
  options.samples = samples;
  return options;
}

}  // namespace circle_voronoi
