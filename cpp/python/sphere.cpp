// SPDX-License-Identifier: GPL-3.0-or-later
// Circles on a sphere.
#include "circle_voronoi/sphere.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "arrays.h"
#include "errors.h"
#include "interruptible.h"
#include "module.h"

namespace py = pybind11;

namespace circle_voronoi::python {
namespace {

using SharedSphere = std::shared_ptr<SphereDiagram>;

SharedSphere computedSphere(const Doubles& caps, double radius, bool weights, int threads) {
  return interruptible(
      [caps = itemsOf<Cap>(caps), options = SphereOptions{radius, weights, threads}](const Cancellation&) {
        return std::make_shared<SphereDiagram>(valueOf(computeSphere(caps, options)));
      });
}

template <class Number, class Item>
py::array view(const SharedSphere& sphere, const std::vector<Item>& items) {
  return viewOf<Number>(sphere, std::span<const Item>(items));
}

py::array foundOnSphere(const SharedSphere& sphere, const Doubles& places) {
  return arrayOf<std::int32_t>(interruptible([sphere, places = pointsOf(places)](const Cancellation& cancellation) {
    const SphereFinder finder(*sphere);
    std::vector<CircleIndex> caps;
    for (const Point& p : places) {
      if (caps.size() % 1024 == 0) cancellation.check();
      caps.push_back(finder.find(p.x, p.y));
    }
    return caps;
  }));
}

py::array sphereAreas(const SharedSphere& sphere, std::optional<double> maxDistance) {
  return arrayOf<double>(
      interruptible([sphere, maxDistance](const Cancellation&) { return areas(*sphere, maxDistance); }));
}

py::array spherePerimeters(const SharedSphere& sphere, std::optional<double> maxDistance) {
  return arrayOf<double>(
      interruptible([sphere, maxDistance](const Cancellation&) { return perimeters(*sphere, maxDistance); }));
}

/// Offsets of polygons, rings and points, and the points.
py::tuple spherePolygons(const SharedSphere& sphere, std::optional<double> maxDistance,
                         std::optional<double> tolerance) {
  ClippedPolygons polygons =
      interruptible([sphere, options = SpherePolygonOptions{tolerance, maxDistance}](const Cancellation&) {
        return valueOf(cellPolygons(*sphere, options));
      });
  return py::make_tuple(
      arrayOf<std::int32_t>(std::move(polygons.polygonOffsets)), arrayOf<std::int32_t>(std::move(polygons.ringOffsets)),
      arrayOf<std::int32_t>(std::move(polygons.pointOffsets)), arrayOf<double>(std::move(polygons.points)));
}

py::object farthestPlaceOf(const SharedSphere& sphere) {
  const auto farthest = farthestPlace(*sphere);
  if (!farthest) return py::none();
  std::vector<std::int32_t> caps;
  for (const CircleIndex cap : farthest->caps) {
    if (cap != kNone) caps.push_back(cap);
  }
  const auto& [longitude, latitude, distance] = farthest->place;
  return py::make_tuple(longitude, latitude, distance, arrayOf<std::int32_t>(std::move(caps)));
}

py::object closestPairOf(const SharedSphere& sphere) {
  const auto pair = closestPair(*sphere);
  if (!pair) return py::none();
  return py::make_tuple(std::int32_t{pair->first}, std::int32_t{pair->second}, pair->gap);
}

}  // namespace

void addSphere(py::module_& module) {
  py::class_<SphereDiagram, SharedSphere>(module, "SphereDiagram")
      .def_property_readonly("caps", [](const SharedSphere& s) { return view<double>(s, s->caps); })
      .def_property_readonly("vertices", [](const SharedSphere& s) { return view<double>(s, s->vertices); })
      .def_property_readonly("vertex_caps", [](const SharedSphere& s) { return view<std::int32_t>(s, s->vertexCaps); })
      .def_property_readonly("edges", [](const SharedSphere& s) { return view<std::int32_t>(s, s->edges); })
      .def_property_readonly("hidden", [](const SharedSphere& s) { return view<std::int32_t>(s, s->hidden); })
      .def_property_readonly("radius", [](const SphereDiagram& s) { return s.radius; })
      .def_property_readonly("weights", [](const SphereDiagram& s) { return s.weights; })
      .def_property_readonly("hidden_warning", [](const SphereDiagram& s) { return hiddenWarning(s); })
      .def_property_readonly("rounding", [](const SphereDiagram& s) { return s.rounding; })
      .def("neighbors",
           [](const SphereDiagram& s, std::int32_t cap) { return arrayOf<std::int32_t>(neighbors(s, cap)); })
      .def("find", foundOnSphere)
      .def("areas", sphereAreas)
      .def("perimeters", spherePerimeters)
      .def("polygons", spherePolygons)
      .def("farthest_place", farthestPlaceOf)
      .def("closest_pair", closestPairOf);
  module.def("compute_sphere", computedSphere);
}

}  // namespace circle_voronoi::python
