// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/metric.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {

/// A node of the tree of a treemap.
struct TreemapNode {
  std::int32_t parent = -1;  ///< the index of a node before this one; -1 for the root, which is the first node
  double value = 0;          ///< of a leaf; the value of a node with children is the sum of theirs
};

struct TreemapOptions {
  /// The borders between the children of a node: straight for Metric::power. Metric::circles curves them where no child
  /// has children.
  Metric metric = Metric::power;
  /// The number of times that the sites in a node move to the centers of mass of their cells, so that these become
  /// rounder. By default kDefaultTreemapRelax, and 0 where `previous` has all children of the node.
  std::optional<int> relax = {};
  /// The largest relative error of the area of each cell, above 0 and below 1.
  double tolerance = 1e-9;
  /// For each node its site in an earlier treemap with its weight, or nothing if it is new. The children of a node stay
  /// where they were, unless they are relaxed, so the treemap changes little if values do. If one of them is new or
  /// lies outside the cell of the node now, all of them begin anew. Empty if there is no earlier treemap.
  std::span<const std::optional<Circle>> previous = {};
  /// Called with the number of nodes whose cells are divided, and of all that are to be, whenever it has changed and
  /// after each step in between. To cancel, throw: the exception passes through `treemap`. The callback may call any
  /// function of the library.
  std::function<void(std::size_t done, std::size_t count)> progress = {};
};

inline constexpr int kDefaultTreemapRelax = 8;

/// The cells of the nodes of a tree.
struct Treemap {
  std::vector<double> values;  ///< for each node its value, or the sum of those below
  std::vector<double> areas;   ///< for each node the area of its cell; 0 if its value is 0
  /// For each node the site of its cell in the diagram of the cells of its siblings, with its weight, which is 0 for an
  /// only child and the root.
  std::vector<Circle> sites;
  /// For each node its cell: no polygon if the value is 0, several if the region is not convex. A cell with curved
  /// borders is rounded to 2^-12 of the root of the region's area.
  ClippedPolygons polygons;
  double error = 0;  ///< the largest relative error of an area
};

/// Divides a region among the nodes of a tree, so that each area is in proportion to the node's value and the children
/// of a node fill its cell (M. Balzer, O. Deussen, "Voronoi Treemaps", 2005). The cells of the children are those of a
/// fit of areas in the cell of their parent (`fitAreas`). With a convex region and straight borders, all cells are
/// convex.
///
/// Sites begin in the middle of the parts into which lines divide the parent's cell, with the right areas. So the
/// result depends on values and region alone, and the same input gives the same bits on every platform. Takes the steps
/// of a fit for the children of each node.
///
/// Errors: badInput, with a node as `circle`, if there are no nodes, a parent does not come before its child, a second
/// node has no parent, a value of a leaf is negative or not finite, or all are zero; badOption; notConverged and the
/// other codes of `fitAreas` with the node whose cell cannot be divided.
CIRCLE_VORONOI_API Result<Treemap> treemap(std::span<const TreemapNode> nodes, const Region& region,
                                           const TreemapOptions& options = {});

}  // namespace circle_voronoi
