// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/treemap.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/fit_areas.h"
#include "divide_region.h"
#include "guarded.h"
#include "named_option.h"
#include "number_text.h"
#include "polygons_of_row.h"

namespace circle_voronoi {
namespace {

[[noreturn]] void refuse(std::size_t node, const std::string& what) {
  throw ThrownError{
      {ErrorCode::badInput, static_cast<std::int64_t>(node), "Node " + std::to_string(node) + " " + what}};
}

/// Nodes with their children and values.
class Tree {
 public:
  explicit Tree(std::span<const TreemapNode> nodes) : values_(nodes.size()), children_(nodes.size()) {
    if (nodes.empty()) throw ThrownError{{ErrorCode::badInput, kNone, "The tree has no nodes."}};
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto parent = nodes[i].parent;
      if (i == 0 && parent == kNone) continue;
      if (i == 0) refuse(i, "is the root and must have the parent -1, not " + std::to_string(parent) + ".");
      if (parent < 0 || static_cast<std::size_t>(parent) >= i) {
        refuse(i, "must have the index of a node before it as its parent, not " + std::to_string(parent) + ".");
      }
      children_[static_cast<std::size_t>(parent)].push_back(i);
    }
    for (std::size_t i = nodes.size(); i-- > 0;) {
      for (const std::size_t child : children_[i]) values_[i] += values_[child];
      if (!children_[i].empty()) continue;
      values_[i] = nodes[i].value;
      if (!(values_[i] >= 0) || std::isinf(values_[i])) {
        refuse(i, "must have a finite value that is not negative, not " + numberText(values_[i]) + ".");
      }
    }
    if (std::isinf(values_[0]))
      throw ThrownError{{ErrorCode::badInput, 0, "The values sum to more than the largest number."}};
    if (values_[0] == 0) throw ThrownError{{ErrorCode::badInput, 0, "All values are zero."}};
    std::vector<int> levels(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      // Nodes without a value have no cell.
      std::erase_if(children_[i], [&](std::size_t child) { return values_[child] == 0; });
      for (const std::size_t child : children_[i]) levels[child] = levels[i] + (children_[i].size() > 1 ? 1 : 0);
    }
    levels_ = std::max(*std::ranges::max_element(levels), 1);
  }

  double value(std::size_t node) const { return values_[node]; }
  /// The children with a value.
  const std::vector<std::size_t>& children(std::size_t node) const { return children_[node]; }
  bool isDivided(std::size_t node) const { return values_[node] > 0 && !children_[node].empty(); }
  std::size_t size() const { return values_.size(); }
  /// The number of times that a leaf's cell is a part of another, at most.
  int levels() const { return levels_; }

 private:
  std::vector<double> values_;
  std::vector<std::vector<std::size_t>> children_;
  int levels_ = 0;
};

using Polygons = std::vector<std::vector<Region::Ring>>;

Polygons polygonsOf(const Region& region) {
  ClippedPolygons whole;
  whole.polygonOffsets = {0, static_cast<std::int32_t>(region.polygonCount())};
  whole.ringOffsets.assign(region.polygonOffsets().begin(), region.polygonOffsets().end());
  whole.pointOffsets.assign(region.ringOffsets().begin(), region.ringOffsets().end());
  whole.points.assign(region.points().begin(), region.points().end());
  return polygonsOfRow(whole, 0);
}

void append(const Polygons& polygons, ClippedPolygons& all) {
  const auto count = [](const auto& list) { return static_cast<std::int32_t>(list.size()); };
  for (const auto& rings : polygons) {
    for (const Region::Ring& ring : rings) {
      all.points.insert(all.points.end(), ring.begin(), ring.end());
      all.pointOffsets.push_back(count(all.points));
    }
    all.ringOffsets.push_back(count(all.pointOffsets) - 1);
  }
  all.polygonOffsets.push_back(count(all.ringOffsets) - 1);
}

class TreemapMaker {
 public:
  TreemapMaker(std::span<const TreemapNode> nodes, const Region& region, const TreemapOptions& options)
      : tree_(nodes), options_(options), regions_(nodes.size()) {
    if (!options.previous.empty() && options.previous.size() != nodes.size()) {
      throw ThrownError{{ErrorCode::badOption, kNone,
                         "There are " + std::to_string(options.previous.size()) + " earlier sites for " +
                             std::to_string(nodes.size()) + " nodes."}};
    }
    regions_[0] = region;
    map_.areas.resize(nodes.size());
    map_.sites.resize(nodes.size());
    polygons_.resize(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) map_.values.push_back(tree_.value(i));
    map_.areas[0] = region.area();
    const Point middle = middlesOfParts(region, std::vector{1.0})[0];
    map_.sites[0] = {middle.x, middle.y, 0};
    polygons_[0] = polygonsOf(region);
    curveTolerance_ = 0x1p-12 * std::sqrt(map_.areas[0]);
  }

  Treemap run() && {
    for (std::size_t i = 0; i < tree_.size(); ++i) count_ += static_cast<std::size_t>(tree_.isDivided(i));
    report();
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      if (!tree_.isDivided(i)) continue;
      divide(i);
      regions_[i].reset();
      ++done_;
      report();
    }
    const double scale = map_.areas[0] / tree_.value(0);
    for (std::size_t i = 0; i < tree_.size(); ++i) {
      const double target = tree_.value(i) * scale;
      if (target > 0) map_.error = std::max(map_.error, std::abs(map_.areas[i] - target) / target);
      append(polygons_[i], map_.polygons);
    }
    return std::move(map_);
  }

 private:
  void report() const {
    if (options_.progress) options_.progress(done_, count_);
  }

  void divide(std::size_t node) {
    const auto& children = tree_.children(node);
    const Region& region = *regions_[node];
    if (children.size() == 1) {
      const std::size_t child = children[0];
      map_.areas[child] = map_.areas[node];
      map_.sites[child] = {map_.sites[node].x, map_.sites[node].y, 0};
      polygons_[child] = polygons_[node];
      if (tree_.isDivided(child)) regions_[child] = std::move(regions_[node]);
      return;
    }
    std::vector<double> values;
    for (const std::size_t child : children) values.push_back(tree_.value(child));
    AreaFitOptions options;
    const bool areLeaves = std::ranges::none_of(children, [&](std::size_t child) { return tree_.isDivided(child); });
    options.metric = areLeaves ? options_.metric : Metric::power;
    options.shares = true;
    options.tolerance = options_.tolerance / (2 * tree_.levels());
    options.onStep = [this](const AreaFitStep&) { report(); };
    const std::optional<std::vector<Circle>> before = previousSites(node);
    options.relax = options_.relax.value_or(before ? 0 : kDefaultTreemapRelax);
    const std::vector<Circle> sites = before ? *before : startingSites(node, values, options.metric);
    const auto fit = fitAreas(sites, values, region, options);
    if (!fit) refuseNode(node, fit.error());
    const auto clipped = ClippedDiagram::from(fit->diagram, region);
    if (!clipped) refuseNode(node, clipped.error());
    const ClippedPolygons polygons = clipped->polygons(curveTolerance_);
    for (std::size_t k = 0; k < children.size(); ++k) {
      const std::size_t child = children[k];
      map_.sites[child] = fit->diagram.circles[k];
      map_.areas[child] = fit->areas[k];
      polygons_[child] = polygonsOfRow(polygons, k);
      if (!tree_.isDivided(child)) continue;
      auto its = Region::fromPolygons(polygons_[child]);
      if (!its) refuseNode(child, its.error());
      regions_[child] = std::move(its).value();
    }
  }

  [[noreturn]] static void refuseNode(std::size_t node, Error error) {
    error.circle = static_cast<std::int64_t>(node);
    throw ThrownError{
        withPrefix(std::move(error), "The cell of node " + std::to_string(node) + " cannot be divided: ")};
  }

  /// Sites in the middle of parts of the right areas, with the weights of discs as large.
  std::vector<Circle> startingSites(std::size_t node, std::span<const double> values, Metric metric) const {
    const std::vector<Point> middles = middlesOfParts(*regions_[node], values);
    const double scale = map_.areas[node] / tree_.value(node) / std::numbers::pi;
    std::vector<Circle> sites;
    for (std::size_t k = 0; k < values.size(); ++k) {
      const double square = values[k] * scale;
      sites.push_back({middles[k].x, middles[k].y, metric == Metric::power ? square : std::sqrt(square)});
    }
    return sites;
  }

  /// The earlier sites of the children of a node, or nothing if one is new or lies elsewhere now.
  std::optional<std::vector<Circle>> previousSites(std::size_t node) const {
    if (options_.previous.empty()) return {};
    std::vector<Circle> sites;
    for (const std::size_t child : tree_.children(node)) {
      const auto& before = options_.previous[child];
      if (!before || !regions_[node]->contains({before->x, before->y})) return {};
      sites.push_back(*before);
    }
    return sites;
  }

  Tree tree_;
  const TreemapOptions& options_;
  std::vector<std::optional<Region>> regions_;  ///< of the nodes that are to be divided
  double curveTolerance_ = 0;
  std::size_t done_ = 0;
  std::size_t count_ = 0;
  std::vector<Polygons> polygons_;  ///< of each node
  Treemap map_;
};

void checkOptions(const TreemapOptions& options) {
  const auto refuse = [](std::string message) { throw ThrownError{{ErrorCode::badOption, kNone, std::move(message)}}; };
  if (!(options.tolerance > 0 && options.tolerance < 1)) {
    Error error = {ErrorCode::badOption, kNone, ""};
    append(error,
           {"", "tolerance", " must be above 0 and below 1 (got " + numberText(options.tolerance) + ").", "tolerance"});
    throw ThrownError{std::move(error)};
  }
  if (options.relax.value_or(0) < 0) {
    refuse("The option relax must not be negative (got " + std::to_string(*options.relax) + ").");
  }
  if (options.metric == Metric::centers) refuse("A treemap needs weights, which the metric centers has not.");
}

}  // namespace

Result<Treemap> treemap(std::span<const TreemapNode> nodes, const Region& region, const TreemapOptions& options) {
  return guarded([&]() -> Result<Treemap> {
    checkOptions(options);
    TreemapOptions own = options;
    own.progress = lettingThrough(options.progress);
    return TreemapMaker(nodes, region, own).run();
  });
}

}  // namespace circle_voronoi
