// SPDX-License-Identifier: GPL-3.0-or-later
// Regions, the parts of cells inside them, fits of areas, largest empty discs and clearest paths.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "arrays.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/clearest_path.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/curve.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/fit_areas.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi/region_queries.h"
#include "circle_voronoi/treemap.h"
#include "errors.h"
#include "interruptible.h"
#include "module.h"

namespace py = pybind11;

namespace circle_voronoi::python {
namespace {

/// The tolerance of polygons and paths as a share of the size of their box or region.
constexpr double kDefaultTolerance = 1e-5;

using SharedDiagram = std::shared_ptr<Diagram>;
using SharedRegion = std::shared_ptr<Region>;

SharedRegion readSharedRegion(const std::string& text, const std::string& name, bool dissolve) {
  return interruptible([=](const Cancellation&) {
    return std::make_shared<Region>(valueOf(readRegion(text, name, {.dissolve = dissolve})));
  });
}

/// The rings of a region, each an array of points; by the even-odd rule.
SharedRegion regionOfRings(const std::vector<Doubles>& rings, bool dissolve) {
  std::vector<Region::Ring> copies;
  for (const Doubles& ring : rings) copies.push_back(pointsOf(ring));
  return std::make_shared<Region>(valueOf(Region::fromRings(copies, {.dissolve = dissolve})));
}

py::tuple tupleOf(const Box& box) { return py::make_tuple(box.minX, box.minY, box.maxX, box.maxY); }

SharedRegion regionOfBox(const std::array<double, 4>& bounds) {
  return std::make_shared<Region>(valueOf(Region::from(Box{bounds[0], bounds[1], bounds[2], bounds[3]})));
}

/// The limits of cells: a region and a maximum distance. Without a region, cells that a maximum distance cuts lie in
/// the box that files have by default.
struct Limits {
  SharedRegion region;
  std::optional<double> maxDistance;

  [[nodiscard]] bool areSet() const { return region != nullptr || maxDistance.has_value(); }
};

/// A diagram in a region, with the memory that it refers to.
struct Clip {
  SharedDiagram diagram;
  SharedRegion region;
  ClippedDiagram clipped;
};

Clip clipOf(const SharedDiagram& diagram, const Limits& limits) {
  const SharedRegion region =
      limits.region != nullptr
          ? limits.region
          : std::make_shared<Region>(valueOf(Region::from(exportBox(*diagram, limits.maxDistance))));
  return {diagram, region, valueOf(ClippedDiagram::from(*diagram, *region, limits.maxDistance))};
}

/// A measure of each cell: of its part inside by `ofClip` if there are limits, otherwise of the whole cell by
/// `ofWhole`.
template <class Value>
py::array measured(const SharedDiagram& diagram, const Limits& limits, Value (*ofWhole)(const Diagram&, CircleIndex),
                   std::vector<Value> (ClippedDiagram::*ofClip)() const) {
  return arrayOf<double>(interruptible([=](const Cancellation& cancellation) {
    if (limits.areSet()) return (clipOf(diagram, limits).clipped.*ofClip)();
    std::vector<Value> values;
    for (std::size_t i = 0; i < diagram->circles.size(); ++i) {
      if (i % 1024 == 0) cancellation.check();
      values.push_back(ofWhole(*diagram, static_cast<std::int32_t>(i)));
    }
    return values;
  }));
}

py::array areas(const SharedDiagram& diagram, const SharedRegion& region, std::optional<double> maxDistance) {
  return measured(diagram, {region, maxDistance}, cellArea, &ClippedDiagram::areas);
}

py::array centroids(const SharedDiagram& diagram, const SharedRegion& region, std::optional<double> maxDistance) {
  return measured(diagram, {region, maxDistance}, cellCentroid, &ClippedDiagram::centroids);
}

py::array perimeters(const SharedDiagram& diagram, const SharedRegion& region, std::optional<double> maxDistance) {
  return measured(diagram, {region, maxDistance}, cellPerimeter, &ClippedDiagram::perimeters);
}

/// The box to which polygons and drawings are clipped without other limits.
py::tuple exportBounds(const Diagram& diagram, std::optional<double> maxDistance) {
  return tupleOf(exportBox(diagram, maxDistance));
}

/// Whether the limits, or without them the box of `exportBounds`, cut each cell.
py::array clippedCells(const SharedDiagram& diagram, const SharedRegion& region, std::optional<double> maxDistance) {
  return arrayOf<std::uint8_t>(interruptible([=](const Cancellation&) {
           const Clip clip = clipOf(diagram, {region, maxDistance});
           std::vector<std::uint8_t> are(diagram->circles.size());
           for (std::size_t i = 0; i < are.size(); ++i) {
             are[i] = clip.clipped.placeOf(static_cast<std::int32_t>(i)) == ClippedDiagram::Place::cut ? 1 : 0;
           }
           return are;
         }))
      .attr("view")("bool");
}

/// Offsets of polygons by circle, of rings by polygon and of points by ring, and the points.
py::tuple polygons(const SharedDiagram& diagram, const SharedRegion& region, std::optional<double> maxDistance,
                   std::optional<double> tolerance) {
  ClippedPolygons result = interruptible([=](const Cancellation&) {
    const Clip clip = clipOf(diagram, {region, maxDistance});
    const Box box = clip.region->bounds();
    return clip.clipped.polygons(
        tolerance.value_or(kDefaultTolerance * std::max(box.maxX - box.minX, box.maxY - box.minY)));
  });
  return py::make_tuple(
      arrayOf<std::int32_t>(std::move(result.polygonOffsets)), arrayOf<std::int32_t>(std::move(result.ringOffsets)),
      arrayOf<std::int32_t>(std::move(result.pointOffsets)), arrayOf<double>(std::move(result.points)));
}

py::array neighborsInside(const SharedDiagram& diagram, std::int32_t circle, const SharedRegion& region,
                          std::optional<double> maxDistance) {
  return arrayOf<std::int32_t>(interruptible([=](const Cancellation&) {
    return clipOf(diagram, {region, maxDistance}).clipped.neighbors(circle);
  }));
}

/// The pairs of circles whose cells share a part of an edge inside, each once, in the order of neighborPairs.
py::array pairsInside(const SharedDiagram& diagram, const SharedRegion& region, std::optional<double> maxDistance) {
  return arrayOf<std::int32_t>(interruptible([=](const Cancellation&) {
    std::vector<std::array<CircleIndex, 2>> pairs;
    const Clip clip = clipOf(diagram, {region, maxDistance});
    for (const EdgeIndex edge : clip.clipped.edges().edge) {
      const Edge& ends = diagram->edges[static_cast<std::size_t>(edge)];
      pairs.push_back({std::min(ends.left, ends.right), std::max(ends.left, ends.right)});
    }
    std::ranges::sort(pairs);
    const auto repeated = std::ranges::unique(pairs);
    pairs.erase(repeated.begin(), repeated.end());
    return pairs;
  }));
}

/// The parts of edges inside, as cubic Bezier curves: the edge of each curve, and its four points.
py::tuple edgeCurves(const SharedDiagram& diagram, const SharedRegion& region, double tolerance) {
  std::vector<EdgeIndex> edges;
  std::vector<CubicBezier> curves;
  std::tie(edges, curves) = interruptible([=](const Cancellation& cancellation) {
    std::pair<std::vector<EdgeIndex>, std::vector<CubicBezier>> found;
    const Clip clip = clipOf(diagram, {region, {}});
    for (std::size_t e = 0; e < diagram->edges.size(); ++e) {
      if (e % 1024 == 0) cancellation.check();
      const EdgeIndex edge = static_cast<std::int32_t>(e);
      for (const EdgeCurve& part : clip.clipped.edgeParts(edge)) {
        for (const CubicBezier& curve : cubicBeziers(part, tolerance)) {
          found.first.push_back(edge);
          found.second.push_back(curve);
        }
      }
    }
    return found;
  });
  const auto count = static_cast<py::ssize_t>(curves.size());
  return py::make_tuple(arrayOf<std::int32_t>(std::move(edges)),
                        arrayOf<double>(std::move(curves)).reshape({count, py::ssize_t{4}, py::ssize_t{2}}));
}

/// Center x, y and radius, and the circles it touches; None if there is no disc.
py::object discOf(const std::optional<EmptyDisc>& found) {
  if (!found) return py::none();
  std::vector<CircleIndex> touched(found->circles.begin(), found->circles.end());
  std::erase(touched, kNone);
  const Vertex& disc = found->disc;
  return py::make_tuple(disc.x, disc.y, disc.r, arrayOf<std::int32_t>(std::move(touched)));
}

py::object largestEmptyDisc(const SharedDiagram& diagram, const SharedRegion& region, bool inside) {
  return discOf(interruptible([=](const Cancellation&) {
    if (region == nullptr) return largestEmptyDiscCenteredInHull(*diagram);
    if (inside) return valueOf(largestEmptyDiscInside(*diagram, *region));
    return clipOf(diagram, {region, {}}).clipped.largestEmptyDisc();
  }));
}

/// Returns a box around circles and points that is so large that no path gains clearance outside: at its sides the
/// clearance is larger than at the ends of the path.
Region farAround(const Diagram& diagram, Point p, Point q) {
  Box box = exportBox(diagram.circles);
  for (const Point end : {p, q}) {
    box = {std::min(box.minX, end.x), std::min(box.minY, end.y), std::max(box.maxX, end.x), std::max(box.maxY, end.y)};
  }
  const double size = 2 * std::max(box.maxX - box.minX, box.maxY - box.minY);
  return valueOf(Region::from(Box{box.minX - size, box.minY - size, box.maxX + size, box.maxY + size}));
}

/// Clearance, edges and points of a path; None if the region has none.
py::object pathBetween(const SharedDiagram& diagram, std::array<double, 2> start, std::array<double, 2> end,
                       const SharedRegion& region, std::optional<double> tolerance) {
  auto found = interruptible([=](const Cancellation&) {
    const Point p{start[0], start[1]};
    const Point q{end[0], end[1]};
    return valueOf(clearestPath(*diagram, p, q, region == nullptr ? farAround(*diagram, p, q) : *region));
  });
  if (!found) return py::none();
  const Box box = exportBox(diagram->circles);
  const double near = tolerance.value_or(kDefaultTolerance * std::max(box.maxX - box.minX, box.maxY - box.minY));
  std::vector<Point> points;
  for (const EdgeCurve& curve : found->curves) {
    const std::vector<Point> more = polyline(curve, near);
    points.insert(points.end(), more.begin() + (points.empty() ? 0 : 1), more.end());
  }
  if (points.empty()) points.push_back({start[0], start[1]});
  return py::make_tuple(found->clearance, arrayOf<std::int32_t>(std::move(found->edges)),
                        arrayOf<double>(std::move(points)));
}

/// The options of fits as Python passes them: metric, shares, tolerance, max_steps, relax.
using FitArguments = std::tuple<std::string, bool, double, int, int>;

/// `fit(sites, areas, options)`, and the tuple of its result, whose second item is what `diagramOf` takes from it.
template <class Fit, class DiagramOf>
py::tuple fitted(const Doubles& sites, const Doubles& areas, const FitArguments& arguments, Fit fit,
                 DiagramOf diagramOf) {
  const auto& [metric, shares, tolerance, maxSteps, relax] = arguments;
  AreaFitOptions options{.metric = *metricFromName(metric),
                         .shares = shares,
                         .tolerance = tolerance,
                         .maxSteps = maxSteps,
                         .relax = relax};
  auto found = interruptible([options, fit, sites = circlesOf(sites),
                              areas = itemsOf<double>(areas)](const Cancellation& cancellation) mutable {
    options.onStep = [&](const AreaFitStep&) { cancellation.check(); };
    return valueOf(fit(sites, areas, options));
  });
  return py::make_tuple(arrayOf<double>(std::move(found.weights)), diagramOf(found),
                        arrayOf<double>(std::move(found.areas)), found.error, found.steps, found.tolerance);
}

py::tuple fittedInRegion(const Doubles& sites, const Doubles& areas, const SharedRegion& region,
                         const FitArguments& arguments) {
  return fitted(
      sites, areas, arguments,
      [region](const auto& circles, const auto& targets, const AreaFitOptions& options) {
        return fitAreas(circles, targets, *region, options);
      },
      [](AreaFit& fit) { return std::make_shared<Diagram>(std::move(fit.diagram)); });
}

py::tuple fittedInBox(const Doubles& sites, const Doubles& areas, std::array<double, 2> a, std::array<double, 2> b,
                      const FitArguments& arguments) {
  return fitted(
      sites, areas, arguments,
      [lattice = Lattice{{a[0], a[1]}, {b[0], b[1]}}](const auto& circles, const auto& targets,
                                                      const AreaFitOptions& options) {
        return fitAreas(circles, targets, lattice, options);
      },
      [](PeriodicAreaFit& fit) { return std::make_shared<PeriodicDiagram>(std::move(fit.periodic)); });
}

/// `previous`: for each node x, y and weight of its earlier site, which are NaN for a new node; no rows without an
/// earlier treemap. Returns values, areas and sites of the nodes, and their polygons as `polygons` does.
py::tuple treemapOf(const Ints& parents, const Doubles& values, const SharedRegion& region, const std::string& metric,
                    std::optional<int> relax, double tolerance, const Doubles& previous) {
  TreemapOptions options;
  options.metric = *metricFromName(metric);
  options.relax = relax;
  options.tolerance = tolerance;
  std::vector<std::optional<Circle>> sites;
  for (const Circle& site : circlesOf(previous)) {
    sites.push_back(std::isnan(site.x) ? std::nullopt : std::optional(site));
  }
  std::vector<TreemapNode> nodes;
  for (py::ssize_t i = 0; i < parents.size(); ++i) nodes.push_back({parents.at(i), values.at(i)});
  Treemap map = interruptible([=](const Cancellation& cancellation) mutable {
    options.previous = sites;
    options.progress = [&](std::size_t, std::size_t) { cancellation.check(); };
    return valueOf(treemap(nodes, *region, options));
  });
  ClippedPolygons& cells = map.polygons;
  return py::make_tuple(arrayOf<double>(std::move(map.values)), arrayOf<double>(std::move(map.areas)),
                        arrayOf<double>(std::move(map.sites)), arrayOf<std::int32_t>(std::move(cells.polygonOffsets)),
                        arrayOf<std::int32_t>(std::move(cells.ringOffsets)),
                        arrayOf<std::int32_t>(std::move(cells.pointOffsets)), arrayOf<double>(std::move(cells.points)));
}

}  // namespace

void addRegions(py::module_& module) {
  py::class_<Region, SharedRegion>(module, "Region")
      .def_property_readonly("area", &Region::area)
      .def_property_readonly("bounds", [](const Region& region) { return tupleOf(region.bounds()); })
      .def_property_readonly("points",
                             [](const SharedRegion& region) { return viewOf<double>(region, region->points()); })
      .def_property_readonly(
          "ring_offsets",
          [](const SharedRegion& region) { return viewOf<std::int32_t>(region, region->ringOffsets()); })
      .def_property_readonly("polygon_offsets", [](const SharedRegion& region) {
        return viewOf<std::int32_t>(region, region->polygonOffsets());
      });
  module.def("read_region", readSharedRegion);
  module.def("region_of_rings", regionOfRings);
  module.def("region_of_box", regionOfBox);
  module.def("export_box", exportBounds);
  module.def("areas", areas);
  module.def("centroids", centroids);
  module.def("perimeters", perimeters);
  module.def("clipped_cells", clippedCells);
  module.def("polygons", polygons);
  module.def("neighbors_inside", neighborsInside);
  module.def("pairs_inside", pairsInside);
  module.def("edge_curves", edgeCurves);
  module.def("largest_empty_disc", largestEmptyDisc);
  module.def("clearest_path", pathBetween);
  module.def("fit_areas", fittedInRegion);
  module.def("fit_areas_in_box", fittedInBox);
  module.def("treemap", treemapOf);
}

}  // namespace circle_voronoi::python
