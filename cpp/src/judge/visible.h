// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/diagram.h"
#include "topology.h"

namespace circle_voronoi {

/// The circles of a diagram that are not hidden.
struct Visible {
  std::vector<Circle> circles;
  std::vector<CircleIndex> indices;  ///< of each its index in the input
  std::vector<std::int32_t> sites;   ///< of each input circle its place in `circles`, kNone if hidden

  /// The hidden circles are a list of existing ones.
  Visible(std::span<const Circle> all, std::span<const HiddenCircle> hidden);
};

/// Returns the topology in terms of visible circles. An index of no visible circle becomes kNone, which no topology
/// accepts.
Topology visibleTopology(const Diagram& diagram, const std::vector<std::int32_t>& sites);

/// Returns the certificate of a topology for which there is no dual.
Certificate certificateOf(const TopologyFlaw& wrong, const Visible& visible);

/// Returns a certificate with the part of a diagram whose sides are linked wrongly, or without a flaw if there is none.
/// `right` has the correct links, indexed by visible circles.
Certificate judgeSides(const Diagram& diagram, const Links& right, const Visible& visible);

}  // namespace circle_voronoi
