// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <iterator>
#include <numeric>
#include <sstream>
#include <vector>

#include "three_touch_disc.h"

namespace circle_voronoi::test {
namespace {

using Triple = std::array<CircleIndex, 3>;

/// The circles on the left and on the right of an unbounded edge, seen toward infinity.
using UnboundedEnd = std::array<std::int32_t, 2>;

// --- differences of lists ---

void print(std::ostream& out, const std::convertible_to<std::int32_t> auto& item) { out << std::int32_t{item}; }

template <class List>
void print(std::ostream& out, const List& list) {
  out << '(';
  std::string_view separator;
  for (const auto& item : list) {
    out << separator;
    print(out, item);
    separator = " ";
  }
  out << ')';
}

template <class Item>
std::string listDifference(std::string_view what, std::vector<Item> actual, std::vector<Item> expected) {
  std::ranges::sort(actual);
  std::ranges::sort(expected);
  std::vector<Item> extra;
  std::vector<Item> missing;
  std::ranges::set_difference(actual, expected, std::back_inserter(extra));
  std::ranges::set_difference(expected, actual, std::back_inserter(missing));
  if (extra.empty() && missing.empty()) return {};
  std::ostringstream message;
  message << what << ": " << missing.size() << " missing, " << extra.size() << " unexpected";
  if (!missing.empty()) print(message << "; missing ", missing[0]);
  if (!extra.empty()) print(message << "; unexpected ", extra[0]);
  return message.str();
}

// --- what identifies a diagram ---

Triple canonical(Triple triple) {
  std::ranges::rotate(triple, std::ranges::min_element(triple));
  return triple;
}

std::vector<Triple> triplesOf(const Diagram& diagram) {
  std::vector<Triple> triples = diagram.vertexCircles;
  std::ranges::transform(triples, triples.begin(), canonical);
  return triples;
}

std::vector<UnboundedEnd> unboundedEndsOf(const Diagram& diagram) {
  std::vector<UnboundedEnd> ends;
  for (const Edge& edge : diagram.edges) {
    if (edge.end == kNone) ends.push_back({edge.left, edge.right});
    if (edge.start == kNone) ends.push_back({edge.right, edge.left});
  }
  return ends;
}

std::vector<std::int32_t> hiddenOf(const Diagram& diagram) {
  std::vector<std::int32_t> hidden;
  for (const HiddenCircle& h : diagram.hidden) hidden.push_back(h.circle);
  return hidden;
}

// --- merging ---

class Partition {
 public:
  explicit Partition(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
  int find(int item) {
    while (parent_[item] != item) item = parent_[item] = parent_[parent_[item]];
    return item;
  }
  void join(int i, int j) { parent_[find(i)] = find(j); }

 private:
  std::vector<int> parent_;
};

/// The circles of a vertex of any degree; none: infinity.
using MergedVertex = std::vector<std::int32_t>;

/// Two circles, the lower index first and on the left, and the two ends of their common edge.
using MergedEdge = std::array<MergedVertex, 3>;

struct Merged {
  std::vector<MergedVertex> vertices;
  std::vector<MergedEdge> edges;
};

Merged merge(const Diagram& diagram, std::span<const Circle> circles) {
  double extent = 0;
  for (const Circle& c : circles) {
    extent = std::max(extent, length(between(circles[0], c)) + c.r);
  }
  // Rounding errors are several decades below `near`, and the parts of the inputs compared this way several above.
  const double near = 1e-8 * extent;
  const double far = 1e6 * extent;

  const int infinity = static_cast<int>(diagram.vertexCircles.size());
  std::vector<Vertex> discs(infinity);
  Partition partition(discs.size() + 1);
  for (int v = 0; v < infinity; ++v) {
    const auto& [i, j, k] = diagram.vertexCircles[v];
    const auto disc = threeTouchDisc(circles[i], circles[j], circles[k]);
    if (disc && disc->disc.r < far) {
      discs[v] = disc->disc;
    } else {
      partition.join(v, infinity);
    }
  }
  const auto isInfinite = [&](int v) { return partition.find(v) == partition.find(infinity); };
  const auto vertexOr = [&](std::int32_t end) { return end == kNone ? infinity : end; };
  std::vector<bool> isShort;
  for (const Edge& edge : diagram.edges) {
    const int s = vertexOr(edge.start);
    const int e = vertexOr(edge.end);
    isShort.push_back(s != infinity && e != infinity && isInfinite(s) == isInfinite(e) &&
                      (isInfinite(s) || length({discs[s].x - discs[e].x, discs[s].y - discs[e].y}) <= near));
  }
  for (std::size_t i = 0; i < diagram.edges.size(); ++i) {
    if (isShort[i]) partition.join(diagram.edges[i].start, diagram.edges[i].end);
  }

  std::vector<MergedVertex> vertices(discs.size() + 1);
  for (int v = 0; v < infinity; ++v) {
    if (isInfinite(v)) continue;
    MergedVertex& merged = vertices[partition.find(v)];
    merged.insert(merged.end(), diagram.vertexCircles[v].begin(), diagram.vertexCircles[v].end());
  }
  for (MergedVertex& vertex : vertices) {
    std::ranges::sort(vertex);
    vertex.erase(std::unique(vertex.begin(), vertex.end()), vertex.end());
  }

  Merged merged;
  for (const MergedVertex& vertex : vertices) {
    if (!vertex.empty()) merged.vertices.push_back(vertex);
  }
  for (std::size_t i = 0; i < diagram.edges.size(); ++i) {
    if (isShort[i]) continue;
    auto [left, right, start, end] = diagram.edges[i];
    if (left > right) {
      std::swap(left, right);
      std::swap(start, end);
    }
    merged.edges.push_back({MergedVertex{left, right}, vertices[partition.find(vertexOr(start))],
                            vertices[partition.find(vertexOr(end))]});
  }
  return merged;
}

}  // namespace

std::string structureProblem(const Diagram& diagram, std::size_t circleCount) {
  const int n = static_cast<int>(circleCount);
  const int vertexCount = static_cast<int>(diagram.vertexCircles.size());
  const int visibleCount = n - static_cast<int>(diagram.hidden.size());
  const auto at = [](std::string_view what, std::size_t index) {
    return std::string(what) + " " + std::to_string(index) + " ";
  };
  std::vector<bool> isHidden(circleCount, false);
  for (std::size_t i = 0; i < diagram.hidden.size(); ++i) {
    const auto& [circle, by] = diagram.hidden[i];
    if (circle < 0 || circle >= n || by < 0 || by >= n) return at("hidden circle", i) + "is out of range";
    if (i > 0 && circle <= diagram.hidden[i - 1].circle) return at("hidden circle", i) + "is out of order";
    isHidden[circle] = true;
  }
  for (const HiddenCircle& hidden : diagram.hidden) {
    if (isHidden[hidden.by]) return at("circle", hidden.circle) + "is hidden by a hidden one";
  }
  const auto isVisible = [&](std::int32_t i) { return i >= 0 && i < n && !isHidden[i]; };

  if (diagram.vertices.size() != diagram.vertexCircles.size()) return "not every vertex has its circles";
  for (std::size_t v = 0; v < diagram.vertexCircles.size(); ++v) {
    if (!std::ranges::all_of(diagram.vertexCircles[v], isVisible)) return at("vertex", v) + "has a wrong circle";
  }
  std::vector<std::array<int, 3>> edgesInCorner(diagram.vertexCircles.size(), {0, 0, 0});
  for (std::size_t e = 0; e < diagram.edges.size(); ++e) {
    const Edge& edge = diagram.edges[e];
    if (!isVisible(edge.left) || !isVisible(edge.right)) return at("edge", e) + "has a wrong circle";
    struct End {
      std::int32_t vertex, left, right;  // looking away from the vertex
    };
    for (const auto& [v, left, right] :
         {End{edge.start, edge.left, edge.right}, End{edge.end, edge.right, edge.left}}) {
      if (v == kNone) continue;
      if (v < 0 || v >= vertexCount) return at("edge", e) + "has a vertex out of range";
      const Triple& triple = diagram.vertexCircles[v];
      int corner = 0;
      while (corner < 3 && !(triple[corner] == right && triple[(corner + 1) % 3] == left)) ++corner;
      if (corner == 3) return at("edge", e) + at("does not fit vertex", v);
      ++edgesInCorner[v][corner];
    }
  }
  for (std::size_t v = 0; v < edgesInCorner.size(); ++v) {
    if (edgesInCorner[v] != std::array{1, 1, 1}) return at("vertex", v) + "has not one edge for each pair of circles";
  }

  // With the point at infinity a triangulation of m + 1 vertices on the sphere is dual to the diagram.
  const int unboundedCount = static_cast<int>(unboundedEndsOf(diagram).size());
  if (visibleCount >= 2 && vertexCount + unboundedCount != 2 * visibleCount - 2) return "Euler's formula does not hold";
  if (visibleCount < 2 && !diagram.edges.empty()) return "there is an edge without two circles";

  std::vector<UnboundedEnd> hullSteps;
  for (std::size_t i = 0; i < diagram.hull.size() && visibleCount >= 2; ++i) {
    // Counter-clockwise, the next circle lies to the left when looking outwards.
    hullSteps.push_back({diagram.hull[(i + 1) % diagram.hull.size()], diagram.hull[i]});
  }
  if (visibleCount == 1 && diagram.hull.size() != 1) return "the hull of one circle is not that circle";
  return listDifference("hull", hullSteps, unboundedEndsOf(diagram));
}

Diagram renamed(Diagram diagram, const std::vector<std::int32_t>& names) {
  const auto rename = [&](CircleIndex& i) { i = names[static_cast<std::size_t>(i)]; };
  for (auto& triple : diagram.vertexCircles) std::ranges::for_each(triple, rename);
  for (Edge& edge : diagram.edges) {
    rename(edge.left);
    rename(edge.right);
  }
  for (HiddenCircle& hidden : diagram.hidden) {
    rename(hidden.circle);
    rename(hidden.by);
  }
  std::ranges::for_each(diagram.hull, rename);
  return diagram;
}

std::string difference(const Diagram& actual, const Diagram& expected) {
  std::string problem = listDifference("hidden circles", hiddenOf(actual), hiddenOf(expected));
  if (problem.empty()) problem = listDifference("vertices", triplesOf(actual), triplesOf(expected));
  if (problem.empty()) problem = listDifference("unbounded ends", unboundedEndsOf(actual), unboundedEndsOf(expected));
  return problem;
}

std::string differenceAfterMerging(const Diagram& actual, const Diagram& expected, std::span<const Circle> circles) {
  std::string problem = listDifference("hidden circles", hiddenOf(actual), hiddenOf(expected));
  if (!problem.empty()) return problem;
  const Merged mergedActual = merge(actual, circles);
  const Merged mergedExpected = merge(expected, circles);
  problem = listDifference("merged vertices", mergedActual.vertices, mergedExpected.vertices);
  if (problem.empty()) problem = listDifference("merged edges", mergedActual.edges, mergedExpected.edges);
  return problem;
}

std::string problemInGeneralPosition(const Diagram& diagram, const Diagram& exact, std::span<const Circle> circles) {
  const std::string problem = structureProblem(diagram, circles.size());
  return problem.empty() ? difference(diagram, exact) : problem;
}

std::string problemInDegeneratePosition(const Diagram& diagram, const Diagram& exact, std::span<const Circle> circles) {
  const std::string problem = structureProblem(diagram, circles.size());
  if (!problem.empty()) return problem;
  // Merging knows coordinates to rounding, which may tell the same diagrams apart over hundreds of decades.
  return difference(diagram, exact).empty() ? std::string() : differenceAfterMerging(diagram, exact, circles);
}

}  // namespace circle_voronoi::test
