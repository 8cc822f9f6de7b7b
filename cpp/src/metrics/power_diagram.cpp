// SPDX-License-Identifier: GPL-3.0-or-later
#include "power_diagram.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "at.h"
#include "certificate_message.h"
#include "guarded.h"
#include "journal.h"
#include "judge_power.h"
#include "radical_center.h"
#include "regular_triangulation.h"
#include "spatial_order.h"
#include "stopwatch.h"
#include "threads.h"
#include "topology.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// The circles among which a diagram is computed: the one of largest weight, and the first, at each place.
struct PlacedCircles {
  std::vector<int> indices;  ///< in spatial order
  std::vector<int> others;   ///< circles at the places of others, in spatial order
};

PlacedCircles onePerPlace(std::span<const Circle> circles, Threads threads) {
  std::vector<int> order(circles.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto rank = [&](int i) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    return std::tuple(c.x, c.y, -c.r, i);
  };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return rank(i) < rank(j); });
  // Circles of one place follow one another.
  std::vector<Point> places;
  std::vector<std::size_t> firsts;
  for (std::size_t k = 0; k < order.size(); ++k) {
    const Circle& c = circles[static_cast<std::size_t>(order[k])];
    if (!places.empty() && places.back() == Point{c.x, c.y}) continue;
    places.push_back({c.x, c.y});
    firsts.push_back(k);
  }
  firsts.push_back(order.size());
  PlacedCircles candidates;
  for (const int place : spatialOrder(places, threads)) {
    const std::size_t first = firsts[static_cast<std::size_t>(place)];
    candidates.indices.push_back(order[first]);
    for (std::size_t k = first + 1; k < firsts[static_cast<std::size_t>(place) + 1]; ++k) {
      candidates.others.push_back(order[k]);
    }
  }
  return candidates;
}

/// Finds a visible circle beside each hidden one: a corner, of few edges, of the face or the edge that contains its
/// center.
class HiddenFinder {
 public:
  HiddenFinder(std::span<const WeightedPoint> points, const Dual& dual)
      : points_(points), dual_(dual), degree_(points.size(), 0) {
    for (const int corner : dual.origin) {
      if (corner != kPointAtInfinity) ++degree_[static_cast<std::size_t>(corner)];
    }
    while (hint_ < dual.faceCount() && !dual.isFinite(hint_)) ++hint_;
    isLine_ = hint_ == dual.faceCount();
    if (isLine_) hint_ = 0;
  }

  int beside(Point place) {
    const int found = isLine_ ? edgeAround(points_, dual_, place, hint_) : faceAround(points_, dual_, place, hint_);
    if (found == kNone || (!isLine_ && !dual_.isFinite(found))) return kNone;
    hint_ = found;
    if (isLine_) {
      const bool isTarget = points_[at(dual_.target(found))].p == place;
      return dual_.origin[at(isTarget ? dual_.twin[at(found)] : found)];
    }
    const auto corners = cornersOf(dual_, 3 * found);
    return *std::min_element(corners.begin(), corners.end(),
                             [&](int a, int b) { return rank(a, place) < rank(b, place); });
  }

 private:
  /// A corner at the place comes first, then those of few edges.
  int rank(int corner, Point place) const {
    const auto i = static_cast<std::size_t>(corner);
    return points_[i].p == place ? 0 : degree_[i];
  }

  std::span<const WeightedPoint> points_;
  const Dual& dual_;
  std::vector<int> degree_;
  int hint_ = 0;
  bool isLine_ = false;
};

/// The visible sites of a triangulation with their circles, and its dual and hidden points in terms of these.
struct PowerSites {
  std::vector<WeightedPoint> sites;
  std::vector<CircleIndex> circles;  ///< of each site
  Dual dual;
  std::vector<HiddenPoint> hidden;
  std::vector<CircleIndex> hiddenCircles;  ///< of each hidden point
};

PowerSites sitesOf(RegularTriangulation found, std::span<const WeightedPoint> points, const PlacedCircles& candidates,
                   std::span<const Circle> circles, bool weights) {
  PowerSites result;
  std::vector<int> siteOf(points.size(), 0);
  for (const int i : found.hidden) siteOf[static_cast<std::size_t>(i)] = kNone;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (siteOf[i] == kNone) continue;
    siteOf[i] = static_cast<int>(result.sites.size());
    result.sites.push_back(points[i]);
    result.circles.emplace_back(candidates.indices[i]);
  }
  result.dual = std::move(found.dual);
  for (int& corner : result.dual.origin) {
    if (corner != kPointAtInfinity) corner = siteOf[static_cast<std::size_t>(corner)];
  }
  HiddenFinder finder(result.sites, result.dual);
  const auto add = [&](int i) {
    const WeightedPoint point = weightedPoint(circles[static_cast<std::size_t>(i)], weights);
    result.hidden.push_back({point, result.sites.size() < 2 ? 0 : finder.beside(point.p)});
    result.hiddenCircles.emplace_back(i);
  };
  // In spatial order, so that each is found near the one before.
  for (const int i : found.hidden) add(candidates.indices[static_cast<std::size_t>(i)]);
  for (const int i : candidates.others) add(i);
  return result;
}

Diagram assembled(PowerSites found, std::vector<Circle> circles, bool weights, Threads threads) {
  Diagram diagram;
  diagram.metric = Metric::power;
  diagram.weights = weights;
  for (std::size_t k = 0; k < found.hidden.size(); ++k) {
    diagram.hidden.push_back({found.hiddenCircles[k], found.circles[static_cast<std::size_t>(found.hidden[k].beside)]});
  }
  std::sort(diagram.hidden.begin(), diagram.hidden.end(),
            [](const HiddenCircle& a, const HiddenCircle& b) { return a.circle < b.circle; });
  Dual& dual = found.dual;
  const std::vector<VertexIndex> vertices = verticesOf(dual, threads);
  diagram.vertices.resize(static_cast<std::size_t>(
      std::count_if(vertices.begin(), vertices.end(), [](VertexIndex vertex) { return vertex != kNone; })));
  threads.forEach(vertices.size(), [&](std::size_t face) {
    if (vertices[face] == kNone) return;
    auto corners = cornersOf(dual, 3 * static_cast<int>(face));
    // The same bits whatever corner comes first.
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const auto site = [&](std::size_t k) { return found.sites[static_cast<std::size_t>(corners[k])]; };
    diagram.vertices[static_cast<std::size_t>(vertices[face])] = radicalCenter(site(0), site(1), site(2));
  });
  for (int& corner : dual.origin) {
    if (corner != kPointAtInfinity) corner = found.circles[static_cast<std::size_t>(corner)];
  }
  Topology topology = topologyOf(std::move(dual), vertices, static_cast<int>(circles.size()), diagram.links, threads);
  if (found.circles.size() == 1) topology.hull = {found.circles[0]};
  takeTopology(diagram, std::move(topology));
  diagram.circles = std::move(circles);
  diagram.certificate.flaw = Flaw::none;
  return diagram;
}

Result<Diagram> computed(std::vector<Circle> circles, const Options& options) {
  Journal journal(options.progress);
  const Threads threads(options.threads);
  double seconds = 0;
  auto result = [&]() -> Result<Diagram> {
    const Stopwatch watch(seconds);
    std::vector<WeightedPoint> points;
    const PlacedCircles candidates = [&] {
      const Stopwatch watchOrder = journal.enter(Stage::order);
      PlacedCircles placed = onePerPlace(circles, threads);
      points.reserve(placed.indices.size());
      for (const int i : placed.indices) {
        points.push_back(weightedPoint(circles[static_cast<std::size_t>(i)], options.weights));
      }
      return placed;
    }();
    RegularTriangulation triangulation = [&] {
      const Stopwatch watchTriangulation = journal.enter(Stage::triangulate);
      return regularTriangulation(points);
    }();
    PowerSites found;
    {
      const Stopwatch watchJudge = journal.enter(Stage::certify);
      found = sitesOf(std::move(triangulation), points, candidates, circles, options.weights);
      Verdict verdict = judgePower(found.sites, found.dual);
      if (verdict.isRight()) verdict = judgeHiddenPoints(found.sites, found.dual, found.hidden);
      if (!verdict.isRight()) {
        return Error{ErrorCode::notCertified, kNone, "The construction did not lead to a certified power diagram."};
      }
    }
    const Stopwatch watchAssembly = journal.enter(Stage::assemble);
    return assembled(std::move(found), std::move(circles), options.weights, threads);
  }();
  if (!result) return result;
  Stats& stats = journal.stats;
  stats.method = Method::automatic;
  stats.way = Way::insert;
  stats.counts.circles = static_cast<std::int64_t>(result->circles.size());
  stats.counts.hidden = static_cast<std::int64_t>(result->hidden.size());
  stats.seconds.total = seconds;
  result->stats = std::move(stats);
  return result;
}

}  // namespace

Result<Diagram> powerDiagram(std::span<const Circle> circles, const Options& options) {
  return guarded([&]() -> Result<Diagram> {
    auto valid = validate(circles, options.weights, Metric::power);
    if (!valid) return valid.error();
    Options own = options;
    own.progress = lettingThrough(options.progress);
    return computed(std::move(valid).value(), own);
  });
}

}  // namespace circle_voronoi
