// SPDX-License-Identifier: GPL-3.0-or-later
// Regions, diagrams in regions and the fit of areas, as a JavaScript module of its own: pages that do not clip need not
// load it. Its only caller is web/lib/wasm/regions.ts. Regions and clipped diagrams are their addresses, and live until
// they are deleted.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "circle_voronoi/clearest_path.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/fit_areas.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi/region_queries.h"
#include "circle_voronoi/treemap.h"
#include "compute_circles.h"
#include "values.h"

namespace {

using namespace circle_voronoi;
using emscripten::val;

/// A callback throws this to end the computation.
struct Stopped {};

const Region& regionOf(std::uintptr_t address) { return *reinterpret_cast<const Region*>(address); }

template <class Item>
std::vector<Item> copyOf(std::span<const Item> items) {
  return {items.begin(), items.end()};
}

/// `points`: x and y of each. `polygonOffsets`: undefined if the rings are in any order (Region::fromRings).
val createRegion(const val& points, const val& ringOffsets, const val& polygonOffsets, bool dissolve) {
  return valueOf([&] {
    const auto corners = itemsFrom<double, Point>(points);
    const auto rings = itemsFrom<std::int32_t, std::int32_t>(ringOffsets);
    std::vector<std::int32_t> polygons;
    if (!polygonOffsets.isUndefined()) polygons = itemsFrom<std::int32_t, std::int32_t>(polygonOffsets);
    auto region = Region::fromArrays(corners, rings, polygons, {.dissolve = dissolve});
    if (!region.ok()) return errorValue(region.error());
    val result = val::object();
    result.set("points", float64Array(copyOf(region->points())));
    result.set("ringOffsets", int32Array(copyOf(region->ringOffsets())));
    result.set("polygonOffsets", int32Array(copyOf(region->polygonOffsets())));
    result.set("area", region->area());
    result.set("perimeter", region->perimeter());
    result.set("address", reinterpret_cast<std::uintptr_t>(new Region(std::move(region).value())));
    return result;
  });
}

void deleteRegion(std::uintptr_t address) { delete &regionOf(address); }

bool regionContains(std::uintptr_t address, double x, double y) { return regionOf(address).contains({x, y}); }

/// A diagram with its own memory, in a region that outlives it.
struct Clip {
  Diagram diagram;
  std::optional<ClippedDiagram> clipped;
};

const ClippedDiagram& clippedOf(std::uintptr_t address) { return *reinterpret_cast<const Clip*>(address)->clipped; }

std::optional<double> distanceFrom(const val& maxDistance) {
  if (maxDistance.isUndefined()) return {};
  return maxDistance.as<double>();
}

/// The metric with a name, which the caller has checked.
Metric metricFrom(const val& name) { return metricFromName(name.as<std::string>()).value_or(Metric::circles); }

/// `value`: a diagram as `compute` in web/lib returns it, with its metric.
val createClip(std::uintptr_t region, const val& value, const val& maxDistance) {
  return valueOf([&] {
    auto clip = std::make_unique<Clip>();
    clip->diagram = diagramFrom(value);
    clip->diagram.metric = metricFrom(value["metric"]);
    auto clipped = ClippedDiagram::from(clip->diagram, regionOf(region), distanceFrom(maxDistance));
    if (!clipped.ok()) return errorValue(clipped.error());
    clip->clipped.emplace(std::move(clipped).value());
    val result = val::object();
    result.set("address", reinterpret_cast<std::uintptr_t>(clip.release()));
    return result;
  });
}

void deleteClip(std::uintptr_t address) { delete reinterpret_cast<const Clip*>(address); }

val cellsValue(const ClippedCells& cells) {
  val result = val::object();
  result.set("loopOffsets", int32Array(cells.loopOffsets));
  result.set("isHole", typedArray<std::uint8_t>("Uint8Array", cells.isHole));
  result.set("pieceOffsets", int32Array(cells.pieceOffsets));
  result.set("x", float64Array(cells.x));
  result.set("y", float64Array(cells.y));
  result.set("side", int32Array(cells.side));
  result.set("regionSide", int32Array(cells.regionSide));
  result.set("r", float64Array(cells.r));
  return result;
}

/// Clips a cell of the diagram of a few circles (web/lib/regions/few-circles.ts). The result has the cell and its
/// measures as a row, and the data that identifies the sides of that small diagram.
val clipCell(std::uintptr_t region, const val& circles, bool weights, std::int32_t chosen, const val& maxDistance) {
  return valueOf([&] {
    Options options;
    options.weights = weights;
    const auto diagram = computeCircles(itemsFrom<double, Circle>(circles), options);
    if (!diagram.ok()) return errorValue(diagram.error());
    const std::array<CircleIndex, 1> cells = {chosen};
    const auto clipped = ClippedDiagram::ofCells(*diagram, regionOf(region), cells, distanceFrom(maxDistance));
    if (!clipped.ok()) return errorValue(clipped.error());
    val result = val::object();
    result.set("edges", int32Array(diagram->edges));
    result.set("nextSide", int32Array(diagram->links.nextSide));
    result.set("firstSide", int32Array(diagram->links.firstSide));
    result.set("cells", cellsValue(clipped->cells(cells)));
    result.set("areas", float64Array(std::vector<double>{clipped->area(chosen)}));
    result.set("centroids", float64Array(std::vector<Point>{clipped->centroid(chosen)}));
    result.set("perimeters", float64Array(std::vector<double>{clipped->perimeter(chosen)}));
    return result;
  });
}

val polygonsValue(const ClippedPolygons& polygons) {
  val result = val::object();
  result.set("polygonOffsets", int32Array(polygons.polygonOffsets));
  result.set("ringOffsets", int32Array(polygons.ringOffsets));
  result.set("pointOffsets", int32Array(polygons.pointOffsets));
  result.set("points", float64Array(polygons.points));
  return result;
}

/// The polygons inside a region of the cell of the first of some points. The rows of the other cells are empty.
val clipFirstCell(std::uintptr_t region, const val& points) {
  return valueOf([&] {
    const auto diagram = computeCircles(itemsFrom<double, Circle>(points));
    if (!diagram.ok()) return errorValue(diagram.error());
    const std::array<CircleIndex, 1> first = {CircleIndex{0}};
    const auto clipped = ClippedDiagram::ofCells(*diagram, regionOf(region), first, std::nullopt);
    if (!clipped.ok()) return errorValue(clipped.error());
    // All sides are straight: any tolerance does.
    constexpr double kTolerance = 1;
    return polygonsValue(clipped->polygons(kTolerance));
  });
}

val clippedCells(std::uintptr_t address) {
  return valueOf([&] { return cellsValue(clippedOf(address).cells()); });
}

val clippedEdges(std::uintptr_t address) {
  return valueOf([&] {
    const ClippedEdges edges = clippedOf(address).edges();
    val result = val::object();
    result.set("edge", int32Array(edges.edge));
    result.set("from", float64Array(edges.from));
    result.set("to", float64Array(edges.to));
    result.set("start", float64Array(edges.start));
    result.set("end", float64Array(edges.end));
    result.set("startSide", int32Array(edges.startSide));
    result.set("endSide", int32Array(edges.endSide));
    return result;
  });
}

/// Per cell: the area; the centroid's x and y; the perimeter.
val clippedAreas(std::uintptr_t address) {
  return valueOf([&] { return float64Array(clippedOf(address).areas()); });
}
val clippedCentroids(std::uintptr_t address) {
  return valueOf([&] { return float64Array(clippedOf(address).centroids()); });
}
val clippedPerimeters(std::uintptr_t address) {
  return valueOf([&] { return float64Array(clippedOf(address).perimeters()); });
}

/// x, y and r of the disc, and three circles or kNone; both are empty if there is none.
val discValue(const std::optional<EmptyDisc>& found) {
  val result = val::object();
  result.set("disc", float64Array(found ? std::vector{found->disc} : std::vector<Vertex>()));
  result.set("circles", int32Array(found ? std::vector{found->circles} : std::vector<std::array<CircleIndex, 3>>()));
  return result;
}

val clippedLargestEmptyDisc(std::uintptr_t address) {
  return valueOf([&] { return discValue(clippedOf(address).largestEmptyDisc()); });
}

val clippedLargestEmptyDiscInside(std::uintptr_t address) {
  return valueOf([&] {
    const ClippedDiagram& clipped = clippedOf(address);
    const auto found = largestEmptyDiscInside(clipped.diagram(), clipped.region());
    return found ? discValue(*found) : errorValue(found.error());
  });
}

/// `found`: whether there is a path. Then the clearance, the edges, x and y of the entry and the exit, and for each
/// curve its edge or kNone, whether it runs in the direction of the edge, both parameters, and x and y of both ends.
val clippedClearestPath(std::uintptr_t address, double x, double y, double toX, double toY) {
  return valueOf([&] {
    const ClippedDiagram& clipped = clippedOf(address);
    const Diagram& diagram = clipped.diagram();
    const auto path = clearestPath(diagram, {x, y}, {toX, toY}, clipped.region());
    if (!path) return errorValue(path.error());
    val result = val::object();
    result.set("found", path->has_value());
    if (!*path) return result;
    const ClearestPath& found = **path;
    std::vector<std::uint8_t> isForward;
    std::vector<std::array<double, 6>> numbers;
    for (std::size_t k = 0; k < found.curves.size(); ++k) {
      const EdgeCurve& curve = found.curves[k];
      const EdgeIndex edge = found.curveEdges[k];
      bool isAlong = true;
      if (edge != kNone) {
        const Circle& left =
            diagram.circles[static_cast<std::size_t>(diagram.edges[static_cast<std::size_t>(edge)].left)];
        isAlong = curve.bisector.left == Point{left.x, left.y};
      }
      isForward.push_back(isAlong ? 1 : 0);
      numbers.push_back({curve.from, curve.to, curve.start.x, curve.start.y, curve.end.x, curve.end.y});
    }
    result.set("clearance", found.clearance);
    result.set("edges", int32Array(found.edges));
    result.set("ends", float64Array(std::vector<Point>{found.entry.value_or(Point{}), found.exit.value_or(Point{})}));
    result.set("curveEdges", int32Array(found.curveEdges));
    result.set("isForward", typedArray<std::uint8_t>("Uint8Array", isForward));
    result.set("numbers", float64Array(numbers));
    return result;
  });
}

val clippedPolygons(std::uintptr_t address, double tolerance) {
  return valueOf([&] { return polygonsValue(clippedOf(address).polygons(tolerance)); });
}

/// The members that the results of all fits have.
template <class Fit>
val fitValue(const Fit& fit) {
  val result = val::object();
  result.set("weights", float64Array(fit.weights));
  result.set("areas", float64Array(fit.areas));
  result.set("relativeError", fit.error);
  result.set("steps", fit.steps);
  result.set("tolerance", fit.tolerance);
  return result;
}

/// `domain`: the address of a region, or a lattice as ax, ay, bx, by. `sites`: x, y and the weight to start from of
/// each. `onStep` is called with the number of steps, the largest relative error and the weights, and returns whether
/// to go on. It must not throw.
val fitAreasValue(const val& domain, const val& sites, const val& areas, const val& given) {
  return valueOf([&] {
    AreaFitOptions options;
    options.metric = metricFrom(given["metric"]);
    options.shares = given["shares"].as<bool>();
    options.tolerance = given["tolerance"].as<double>();
    options.maxSteps = given["maxSteps"].as<int>();
    options.relax = given["relax"].as<int>();
    const val onStep = given["onStep"];
    std::vector<double> weights;
    options.onStep = [&](const AreaFitStep& step) {
      weights = copyOf(step.weights);
      if (onStep(step.step, step.error, float64Array(weights)).isFalse()) throw Stopped{};
    };
    const auto failed = [&](const Error& error) {
      val result = errorValue(error);
      if (error.code == ErrorCode::notConverged) result["error"].set("weights", float64Array(weights));
      return result;
    };
    const auto circles = itemsFrom<double, Circle>(sites);
    const auto targets = itemsFrom<double, double>(areas);
    if (!domain.isNumber()) {
      const auto fit = fitAreas(circles, targets, itemsFrom<double, Lattice>(domain).at(0), options);
      if (!fit.ok()) return failed(fit.error());
      val result = fitValue(*fit);
      result.set("periodic", periodicValue(fit->periodic));
      return result;
    }
    const auto fit = fitAreas(circles, targets, regionOf(domain.as<std::uintptr_t>()), options);
    if (!fit.ok()) return failed(fit.error());
    val result = fitValue(*fit);
    result.set("circles", float64Array(fit->diagram.circles));
    result.set("diagram", diagramValue(fit->diagram));
    return result;
  });
}

/// `previous`: x, y and weight of the earlier site of each node, NaN for a new one; empty without an earlier treemap.
/// `relax`: undefined by default. `progress` is called with the numbers of nodes that are divided and that are to be,
/// and returns whether to go on. It must not throw.
val treemapValue(std::uintptr_t region, const val& parents, const val& values, const val& given) {
  return valueOf([&] {
    TreemapOptions options;
    options.metric = metricFrom(given["metric"]);
    options.tolerance = given["tolerance"].as<double>();
    const val relax = given["relax"];
    if (!relax.isUndefined()) options.relax = relax.as<int>();
    std::vector<std::optional<Circle>> previous;
    for (const Circle& site : itemsFrom<double, Circle>(given["previous"])) {
      previous.push_back(std::isnan(site.x) ? std::nullopt : std::optional(site));
    }
    options.previous = previous;
    const val progress = given["progress"];
    options.progress = [&](std::size_t done, std::size_t count) {
      if (progress(static_cast<double>(done), static_cast<double>(count)).isFalse()) throw Stopped{};
    };
    const auto all = itemsFrom<std::int32_t, std::int32_t>(parents);
    const auto numbers = itemsFrom<double, double>(values);
    std::vector<TreemapNode> nodes;
    for (std::size_t i = 0; i < all.size(); ++i) nodes.push_back({all[i], numbers[i]});
    const auto map = treemap(nodes, regionOf(region), options);
    if (!map.ok()) return errorValue(map.error());
    val result = polygonsValue(map->polygons);
    result.set("values", float64Array(map->values));
    result.set("areas", float64Array(map->areas));
    result.set("sites", float64Array(map->sites));
    return result;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi_regions) {
  emscripten::function("createRegion", &createRegion);
  emscripten::function("deleteRegion", &deleteRegion);
  emscripten::function("regionContains", &regionContains);
  emscripten::function("createClip", &createClip);
  emscripten::function("deleteClip", &deleteClip);
  emscripten::function("clipCell", &clipCell);
  emscripten::function("clipFirstCell", &clipFirstCell);
  emscripten::function("clippedCells", &clippedCells);
  emscripten::function("clippedEdges", &clippedEdges);
  emscripten::function("clippedAreas", &clippedAreas);
  emscripten::function("clippedCentroids", &clippedCentroids);
  emscripten::function("clippedPerimeters", &clippedPerimeters);
  emscripten::function("clippedLargestEmptyDisc", &clippedLargestEmptyDisc);
  emscripten::function("clippedLargestEmptyDiscInside", &clippedLargestEmptyDiscInside);
  emscripten::function("clippedClearestPath", &clippedClearestPath);
  emscripten::function("clippedPolygons", &clippedPolygons);
  emscripten::function("fitAreas", &fitAreasValue);
  emscripten::function("treemap", &treemapValue);
}
