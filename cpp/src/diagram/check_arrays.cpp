// SPDX-License-Identifier: GPL-3.0-or-later
#include "check_arrays.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>

#include "validate.h"

namespace circle_voronoi {
namespace {

/// An item that does not fit: the kind of its array, and its index.
struct Item {
  const char* thing;
  std::size_t index;
};

bool isIndex(std::int32_t index, std::size_t count) { return index >= 0 && static_cast<std::size_t>(index) < count; }

/// The first item for which a condition fails.
template <class Items, class Condition>
std::optional<Item> firstWithout(const char* thing, const Items& items, Condition condition) {
  const auto found = std::find_if_not(items.begin(), items.end(), condition);
  if (found == items.end()) return std::nullopt;
  return Item{thing, static_cast<std::size_t>(found - items.begin())};
}

std::optional<Item> outsideRange(const Diagram& diagram) {
  const std::size_t circles = diagram.circles.size();
  const std::size_t vertices = diagram.vertices.size();
  const std::size_t sides = 2 * diagram.edges.size();
  const auto isCircle = [&](CircleIndex i) { return isIndex(i, circles); };
  const auto areAll = [](const auto& triple, auto condition) {
    return std::all_of(triple.begin(), triple.end(), condition);
  };
  const auto isEnd = [&](VertexIndex v) { return v == kNone || isIndex(v, vertices); };
  const auto isSide = [&](SideIndex side) { return isIndex(side, sides); };
  auto place = firstWithout("vertex", diagram.vertices, [](const Vertex& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.r);
  });
  if (!place) {
    place = firstWithout("vertex", diagram.vertexCircles, [&](const auto& triple) { return areAll(triple, isCircle); });
  }
  if (!place) {
    place = firstWithout("edge", diagram.edges, [&](const Edge& edge) {
      return isCircle(edge.left) && isCircle(edge.right) && edge.left != edge.right && isEnd(edge.start) &&
             isEnd(edge.end);
    });
  }
  if (!place) {
    place = firstWithout("hidden circle", diagram.hidden, [&](const HiddenCircle& hidden) {
      return isCircle(hidden.circle) && (hidden.by == kNone || isCircle(hidden.by));
    });
  }
  if (!place) place = firstWithout("place of the hull", diagram.hull, isCircle);
  if (!place) place = firstWithout("side", diagram.links.nextSide, isSide);
  if (!place) {
    place =
        firstWithout("vertex", diagram.links.vertexSides, [&](const auto& triple) { return areAll(triple, isSide); });
  }
  if (!place) {
    place =
        firstWithout("circle", diagram.links.firstSide, [&](SideIndex side) { return side == kNone || isSide(side); });
  }
  return place;
}

/// Precondition: all indices are in range.
std::optional<Item> wronglyLinked(const Diagram& diagram) {
  const auto& [nextSide, vertexSides, firstSide] = diagram.links;
  // In the order of the array, so that no access waits for another one.
  for (std::size_t k = 0; k < nextSide.size(); ++k) {
    const auto side = SideIndex(static_cast<std::int32_t>(k));
    const SideIndex next = nextSide[k];
    if (diagram.circleOf(next) != diagram.circleOf(side) || diagram.originOf(next) != diagram.targetOf(side)) {
      return Item{"side", k};
    }
  }
  // A side leads to sides of the same cell, so cycles around different cells have no side in common.
  std::size_t count = 0;
  for (std::size_t i = 0; i < firstSide.size(); ++i) {
    const SideIndex first = firstSide[i];
    if (first == kNone) continue;
    if (diagram.circleOf(first) != static_cast<std::int32_t>(i)) return Item{"circle", i};
    SideIndex side = first;
    do {
      if (++count > nextSide.size()) return Item{"circle", i};
      side = nextSide[static_cast<std::size_t>(side)];
    } while (side != first);
  }
  if (count != nextSide.size()) return Item{"side", count};
  const auto& hull = diagram.hull;
  const auto isUnbounded = [](const Edge& edge) {
    return std::size_t{edge.start == kNone} + std::size_t{edge.end == kNone};
  };
  std::size_t unbounded = 0;
  for (const Edge& edge : diagram.edges) unbounded += isUnbounded(edge);
  if (unbounded != (hull.size() > 1 ? hull.size() : 0)) return Item{"place of the hull", 0};
  for (std::size_t v = 0; v < vertexSides.size(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) {
      const SideIndex side = vertexSides[v][k];
      const bool isHere = diagram.originOf(side) == static_cast<std::int32_t>(v);
      if (!isHere || diagram.circleOf(side) != diagram.vertexCircles[v][k]) return Item{"vertex", v};
    }
  }
  return std::nullopt;
}

Error doNotFit(const std::string& where) {
  return {ErrorCode::badInput, kNone,
          "The arrays of the diagram do not fit together" + where + ". They must not be changed."};
}

Result<void> checkCircle(const Diagram& diagram, std::size_t i) {
  if (const auto error = errorOf(diagram.circles[i], diagram.weights, diagram.metric)) {
    return Error{error->code, static_cast<std::int64_t>(i), "Circle " + std::to_string(i) + " " + error->what};
  }
  // Integers of fixed size hold multiples of the step alone.
  if (normalized(diagram.circles[i], diagram.weights, diagram.metric) != diagram.circles[i]) {
    return Error{
        ErrorCode::badInput, static_cast<std::int64_t>(i),
        "Circle " + std::to_string(i) + " has a number that is not a multiple of 2^-96, or an area of 2^-192."};
  }
  return {};
}

bool fitInLength(const Diagram& diagram) {
  return diagram.vertexCircles.size() == diagram.vertices.size() &&
         diagram.links.nextSide.size() == 2 * diagram.edges.size() &&
         diagram.links.vertexSides.size() == diagram.vertices.size() &&
         diagram.links.firstSide.size() == diagram.circles.size();
}

/// Returns the first side or vertex of a cell that does not fit.
std::optional<Item> wronglyLinked(const Diagram& diagram, CircleIndex circle) {
  const std::vector<SideIndex>& nextSide = diagram.links.nextSide;
  const auto isCircle = [&](CircleIndex i) { return isIndex(i, diagram.circles.size()); };
  const auto isRightEnd = [&](VertexIndex v) {
    if (v == kNone) return true;
    if (!isIndex(v, diagram.vertices.size())) return false;
    const Vertex& vertex = diagram.vertices[static_cast<std::size_t>(v)];
    const auto& circles = diagram.vertexCircles[static_cast<std::size_t>(v)];
    return std::isfinite(vertex.x) && std::isfinite(vertex.y) && std::isfinite(vertex.r) &&
           std::all_of(circles.begin(), circles.end(), isCircle);
  };
  const auto isRight = [&](SideIndex side) {
    if (!isIndex(side, nextSide.size())) return false;
    const auto& [left, right, start, end] = diagram.edges[static_cast<std::size_t>(Diagram::edgeOf(side))];
    return isCircle(left) && isCircle(right) && left != right && isRightEnd(start) && isRightEnd(end) &&
           diagram.circleOf(side) == circle;
  };
  const SideIndex first = diagram.links.firstSide[static_cast<std::size_t>(circle)];
  if (first == kNone) return std::nullopt;
  SideIndex side = first;
  std::size_t count = 0;
  do {
    const SideIndex next = isRight(side) ? nextSide[static_cast<std::size_t>(side)] : SideIndex();
    const bool isLinked = next != kNone && isRight(next) && diagram.originOf(next) == diagram.targetOf(side);
    if (!isLinked || ++count > nextSide.size()) return Item{"circle", static_cast<std::size_t>(circle)};
    side = next;
  } while (side != first);
  return std::nullopt;
}

}  // namespace

Result<void> checkArrays(const Diagram& diagram, std::span<const CircleIndex> circles) {
  if (!fitInLength(diagram)) return doNotFit(" in their lengths");
  for (const CircleIndex circle : circles) {
    if (const auto item = wronglyLinked(diagram, circle)) {
      return doNotFit(std::string(" at ") + item->thing + " " + std::to_string(item->index));
    }
    if (auto checked = checkCircle(diagram, static_cast<std::size_t>(circle)); !checked) return checked;
    for (const SideIndex side : diagram.sides(circle)) {
      const CircleIndex neighbor = diagram.neighborOf(side);
      if (auto checked = checkCircle(diagram, static_cast<std::size_t>(neighbor)); !checked) return checked;
      const VertexIndex origin = diagram.originOf(side);
      if (origin == kNone) continue;
      for (const CircleIndex corner : diagram.vertexCircles[static_cast<std::size_t>(origin)]) {
        if (auto checked = checkCircle(diagram, static_cast<std::size_t>(corner)); !checked) return checked;
      }
    }
  }
  return {};
}

Result<void> checkArrays(const Diagram& diagram) {
  for (std::size_t i = 0; i < diagram.circles.size(); ++i) {
    if (auto checked = checkCircle(diagram, i); !checked) return checked;
  }
  if (!fitInLength(diagram)) return doNotFit(" in their lengths");
  auto place = outsideRange(diagram);
  if (!place) place = wronglyLinked(diagram);
  if (place) return doNotFit(std::string(" at ") + place->thing + " " + std::to_string(place->index));
  return {};
}

}  // namespace circle_voronoi
