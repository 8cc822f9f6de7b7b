// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "circle_voronoi/diagram.h"
#include "judge.h"
#include "topology.h"

namespace circle_voronoi {

/// A verdict on a dual in terms of its topology; circles stay as they are.
Certificate certificateOf(const Verdict& verdict, const Dual& dual, const Topology& topology);

/// One sentence on what a certificate found, with the indices concerned; empty if certified.
std::string messageOf(const Certificate& certificate, const Diagram& diagram);

}  // namespace circle_voronoi
