// SPDX-License-Identifier: GPL-3.0-or-later
// Diagrams in a box whose opposite sides are glued together.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "arrays.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/periodic_queries.h"
#include "errors.h"
#include "interruptible.h"
#include "module.h"

namespace py = pybind11;

namespace circle_voronoi::python {
namespace {

using SharedPeriodicDiagram = std::shared_ptr<PeriodicDiagram>;

SharedPeriodicDiagram computedPeriodic(const Doubles& circles, std::array<double, 2> a, std::array<double, 2> b,
                                       const std::string& metric, bool weights, int threads) {
  Options options;
  options.metric = *metricFromName(metric);
  options.weights = weights;
  options.threads = threads;
  const Lattice lattice{{a[0], a[1]}, {b[0], b[1]}};
  return interruptible([circles = circlesOf(circles), lattice, options](const Cancellation& cancellation) mutable {
    options.progress = [&](Stage, double) { cancellation.check(); };
    return std::make_shared<PeriodicDiagram>(valueOf(computePeriodic(circles, lattice, options)));
  });
}

/// Circles and shifts of images as two arrays.
py::tuple arraysOf(const std::vector<CircleImage>& images) {
  std::vector<CircleIndex> circles;
  std::vector<Shift> shifts;
  for (const CircleImage& image : images) {
    circles.push_back(image.circle);
    shifts.push_back(image.shift);
  }
  return py::make_tuple(arrayOf<std::int32_t>(std::move(circles)), arrayOf<std::int32_t>(std::move(shifts)));
}

py::tuple found(const SharedPeriodicDiagram& periodic, const Doubles& points) {
  return arraysOf(interruptible([periodic, points = pointsOf(points)](const Cancellation& cancellation) {
    const PeriodicFinder finder(*periodic);
    std::vector<CircleImage> images;
    for (const Point& p : points) {
      if (images.size() % 1024 == 0) cancellation.check();
      images.push_back(valueOf(finder.find(p)));
    }
    return images;
  }));
}

/// The columns of the contact table: circle, neighbor, shift, length, gap; then area and packing fraction of each
/// circle.
py::tuple contacts(const SharedPeriodicDiagram& periodic) {
  ContactTable table = interruptible([periodic](const Cancellation&) { return contactTable(*periodic); });
  std::vector<CircleIndex> circles;
  std::vector<CircleImage> neighbors;
  std::vector<double> lengths;
  std::vector<double> gaps;
  for (const Contact& contact : table.contacts) {
    circles.push_back(contact.circle);
    neighbors.push_back(contact.neighbor);
    lengths.push_back(contact.length);
    gaps.push_back(contact.gap);
  }
  const py::tuple images = arraysOf(neighbors);
  return py::make_tuple(arrayOf<std::int32_t>(std::move(circles)), images[0], images[1],
                        arrayOf<double>(std::move(lengths)), arrayOf<double>(std::move(gaps)),
                        arrayOf<double>(std::move(table.areas)), arrayOf<double>(std::move(table.packingFractions)));
}

}  // namespace

void addPeriodic(py::module_& module) {
  py::class_<PeriodicDiagram, SharedPeriodicDiagram>(module, "PeriodicDiagram")
      .def_property_readonly(
          "diagram",
          [](const SharedPeriodicDiagram& periodic) { return std::shared_ptr<Diagram>(periodic, &periodic->diagram); })
      .def_property_readonly("circle_count", [](const PeriodicDiagram& p) { return std::int32_t{p.circleCount}; })
      .def_property_readonly("lattice",
                             [](const PeriodicDiagram& p) {
                               const auto& [a, b] = p.lattice;
                               return py::make_tuple(a.x, a.y, b.x, b.y);
                             })
      .def_property_readonly("circle_of",
                             [](const SharedPeriodicDiagram& p) {
                               return viewOf<std::int32_t>(p, std::span<const CircleIndex>(p->circleOf));
                             })
      .def_property_readonly(
          "shift_of",
          [](const SharedPeriodicDiagram& p) { return viewOf<std::int32_t>(p, std::span<const Shift>(p->shiftOf)); })
      .def("neighbors", [](const PeriodicDiagram& p, std::int32_t circle) { return arraysOf(neighbors(p, circle)); })
      .def("find", found)
      .def("contacts", contacts);
  module.def("compute_periodic", computedPeriodic);
}

}  // namespace circle_voronoi::python
