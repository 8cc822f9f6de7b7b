// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "circle_voronoi/diagram.h"
#include "judge.h"
#include "topology.h"

namespace circle_voronoi {

/// Converts a verdict on a dual to the indices of its topology. Indices of circles do not change.
Certificate certificateOf(const Verdict& verdict, const Dual& dual, const Topology& topology);

/// Returns one sentence on the flaw that a certificate found, with the indices concerned. Returns an empty string if
/// the diagram is certified.
std::string messageOf(const Certificate& certificate, const Diagram& diagram);

}  // namespace circle_voronoi
