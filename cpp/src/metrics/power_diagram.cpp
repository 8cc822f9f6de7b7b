// SPDX-License-Identifier: GPL-3.0-or-later
#include "power_diagram.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "certificate_message.h"
#include "judge_power.h"
#include "radical_center.h"
#include "regular_triangulation.h"
#include "spatial_order.h"
#include "topology.h"

namespace circle_voronoi {
namespace {

/// The circles among which a diagram is computed: the one of largest weight, and the first, at each place.
struct PlacedCircles {
  std::vector<int> indices;  ///< in spatial order
  std::vector<int> others;   ///< circles at the places of others, in increasing order
};

PlacedCircles onePerPlace(std::span<const Circle> circles) {
  std::vector<int> order(circles.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
  const auto rank = [&](int i) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    return std::tuple(c.x, c.y, -c.r, i);
  };
  std::sort(order.begin(), order.end(), [&](int i, int j) { return rank(i) < rank(j); });
  PlacedCircles candidates;
  std::vector<int> firsts;
  std::vector<Point> places;
  for (const int i : order) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    if (!places.empty() && places.back() == Point{c.x, c.y}) {
      candidates.others.push_back(i);
    } else {
      firsts.push_back(i);
      places.push_back({c.x, c.y});
    }
  }
  for (const int k : spatialOrder(places)) candidates.indices.push_back(firsts[static_cast<std::size_t>(k)]);
  std::sort(candidates.others.begin(), candidates.others.end());
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
    if (isLine_)
      return dual_
          .origin[points_[static_cast<std::size_t>(dual_.target(found))].p == place ? dual_.twin[found] : found];
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

}  // namespace

Result<Diagram> powerDiagram(std::vector<Circle> circles, bool weights) {
  Diagram diagram;
  diagram.metric = Metric::power;
  diagram.weights = weights;
  const PlacedCircles candidates = onePerPlace(circles);
  std::vector<WeightedPoint> points;
  points.reserve(candidates.indices.size());
  for (const int i : candidates.indices) points.push_back(weightedPoint(circles[static_cast<std::size_t>(i)], weights));
  RegularTriangulation found = regularTriangulation(points);

  // Without the hidden ones.
  std::vector<int> siteOf(points.size(), 0);
  for (const int i : found.hidden) siteOf[static_cast<std::size_t>(i)] = kNone;
  std::vector<WeightedPoint> sites;
  std::vector<CircleIndex> indices;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (siteOf[i] == kNone) continue;
    siteOf[i] = static_cast<int>(sites.size());
    sites.push_back(points[i]);
    indices.emplace_back(candidates.indices[i]);
  }
  Dual& dual = found.dual;
  for (int& corner : dual.origin) {
    if (corner != kPointAtInfinity) corner = siteOf[static_cast<std::size_t>(corner)];
  }
  std::vector<HiddenPoint> hidden;
  std::vector<CircleIndex> hiddenIndices;
  {
    std::vector<int> all;
    for (const int i : found.hidden) all.push_back(candidates.indices[static_cast<std::size_t>(i)]);
    // In spatial order, so that each is found near the one before.
    HiddenFinder finder(sites, dual);
    const auto add = [&](int i) {
      const WeightedPoint point = weightedPoint(circles[static_cast<std::size_t>(i)], weights);
      hidden.push_back({point, sites.size() < 2 ? 0 : finder.beside(point.p)});
      hiddenIndices.emplace_back(i);
    };
    std::for_each(all.begin(), all.end(), add);
    std::for_each(candidates.others.begin(), candidates.others.end(), add);
  }
  Verdict verdict = judgePower(sites, dual);
  if (verdict.isRight()) verdict = judgeHiddenPoints(sites, dual, hidden);
  if (!verdict.isRight()) {
    return Error{ErrorCode::notCertified, kNone,
                 "The construction of the power diagram did not lead to a certified one."};
  }
  for (std::size_t k = 0; k < hidden.size(); ++k) {
    diagram.hidden.push_back({hiddenIndices[k], indices[static_cast<std::size_t>(hidden[k].beside)]});
  }
  std::sort(diagram.hidden.begin(), diagram.hidden.end(),
            [](const HiddenCircle& a, const HiddenCircle& b) { return a.circle < b.circle; });
  for (int face = 0; face < dual.faceCount(); ++face) {
    if (!dual.isFinite(face)) continue;
    auto corners = cornersOf(dual, 3 * face);
    // The same bits whatever corner comes first.
    std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end()), corners.end());
    const auto& [a, b, c] = corners;
    const auto point = [&](int corner) { return sites[static_cast<std::size_t>(corner)]; };
    diagram.vertices.push_back(radicalCenter(point(a), point(b), point(c)));
  }
  for (int& corner : dual.origin) {
    if (corner != kPointAtInfinity) corner = indices[static_cast<std::size_t>(corner)];
  }
  const Threads threads;
  const std::vector<VertexIndex> vertices = verticesOf(dual, threads);
  Topology topology = topologyOf(std::move(dual), vertices, static_cast<int>(circles.size()), diagram.links, threads);
  if (indices.size() == 1) topology.hull = {indices[0]};
  diagram.vertexCircles = std::move(topology.vertexCircles);
  diagram.edges = std::move(topology.edges);
  diagram.hull = std::move(topology.hull);
  rotateHull(diagram.hull);
  diagram.circles = std::move(circles);
  diagram.certificate.flaw = Flaw::none;
  return diagram;
}

}  // namespace circle_voronoi
