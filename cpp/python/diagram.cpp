// SPDX-License-Identifier: GPL-3.0-or-later
// Bindings of `compute`, of the arrays of a diagram and of its queries.
#include "circle_voronoi/diagram.h"

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "circle_voronoi/cells.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/hidden_warning.h"
#include "circle_voronoi/queries.h"
#include "errors.h"
#include "interruptible.h"
#include "module.h"

namespace py = pybind11;

namespace circle_voronoi::python {
namespace {

using SharedDiagram = std::shared_ptr<Diagram>;

SharedDiagram computed(const Doubles& circles, const std::string& metric, bool weights, const std::string& method,
                       const std::string& candidates, std::optional<int> samples, bool resample, int threads) {
  Options options;
  options.metric = *metricFromName(metric);
  options.weights = weights;
  options.samples = samples;
  options.resample = resample;
  options.threads = threads;
  options.method = *methodFromName(method);
  options.candidates = *candidatesFromName(candidates);
  return interruptible([circles = circlesOf(circles), options](const Cancellation& cancellation) mutable {
    options.progress = [&](Stage, double) { cancellation.check(); };
    return std::make_shared<Diagram>(valueOf(compute(circles, options)));
  });
}

template <class Number, class Item>
py::array view(const SharedDiagram& diagram, const std::vector<Item>& items) {
  return viewOf<Number>(diagram, std::span<const Item>(items));
}

py::tuple certificateOf(const Certificate& certificate) {
  const auto indexOrNone = [](std::int32_t index) -> py::object {
    return index == kNone ? py::object(py::none()) : py::int_(index);
  };
  return py::make_tuple(certificate.certified(), std::string(flawName(certificate.flaw)),
                        indexOrNone(certificate.circle), indexOrNone(certificate.vertex), indexOrNone(certificate.edge),
                        certificate.message);
}

py::dict statsOf(const Stats& stats) {
  py::dict seconds;
  for (const auto& [name, member] : kSecondsMembers) seconds[py::str(name.data(), name.size())] = stats.seconds.*member;
  py::dict counts;
  for (const auto& [name, member] : kCountMembers) counts[py::str(name.data(), name.size())] = stats.counts.*member;
  py::dict result;
  result["way"] = stats.way ? py::object(py::str(std::string(wayName(*stats.way)))) : py::object(py::none());
  result["counts"] = counts;
  result["seconds"] = seconds;
  return result;
}

/// Finds nearest circles and keeps the diagram.
struct SharedFinder {
  SharedDiagram diagram;
  std::shared_ptr<const Finder> finder;

  explicit SharedFinder(SharedDiagram of) : diagram(std::move(of)), finder(std::make_shared<const Finder>(*diagram)) {}

  py::array find(const Doubles& points) const {
    auto found = interruptible(
        [own = *this, points = pointsOf(points)](const Cancellation&) { return own.finder->findAll(points); });
    return arrayOf<std::int32_t>(std::move(found));
  }
};

}  // namespace

void addDiagram(py::module_& module) {
  py::class_<Diagram, SharedDiagram>(module, "Diagram")
      .def_property_readonly("circles", [](const SharedDiagram& d) { return view<double>(d, d->circles); })
      .def_property_readonly("vertices", [](const SharedDiagram& d) { return view<double>(d, d->vertices); })
      .def_property_readonly("vertex_circles",
                             [](const SharedDiagram& d) { return view<std::int32_t>(d, d->vertexCircles); })
      .def_property_readonly("edges", [](const SharedDiagram& d) { return view<std::int32_t>(d, d->edges); })
      .def_property_readonly("hidden", [](const SharedDiagram& d) { return view<std::int32_t>(d, d->hidden); })
      .def_property_readonly("hull", [](const SharedDiagram& d) { return view<std::int32_t>(d, d->hull); })
      .def_property_readonly("next_side",
                             [](const SharedDiagram& d) { return view<std::int32_t>(d, d->links.nextSide); })
      .def_property_readonly("first_side",
                             [](const SharedDiagram& d) { return view<std::int32_t>(d, d->links.firstSide); })
      .def_property_readonly("metric", [](const Diagram& d) { return std::string(metricName(d.metric)); })
      .def_property_readonly("weights", [](const Diagram& d) { return d.weights; })
      .def_property_readonly("certificate", [](const Diagram& d) { return certificateOf(d.certificate); })
      .def_property_readonly("hidden_warning", [](const Diagram& d) { return hiddenWarning(d); })
      .def_property_readonly("stats", [](const Diagram& d) { return statsOf(d.stats); })
      .def("neighbors", [](const Diagram& d, std::int32_t i) { return arrayOf<std::int32_t>(neighbors(d, i)); })
      .def("neighbor_pairs", [](const Diagram& d) { return arrayOf<std::int32_t>(neighborPairs(d)); })
      .def("certify", [](const SharedDiagram& d) {
        return certificateOf(interruptible([d](const Cancellation&) { return valueOf(certify(*d)); }));
      });

  py::class_<SharedFinder>(module, "Finder").def(py::init<SharedDiagram>()).def("find", &SharedFinder::find);

  module.def("compute", computed);
}

}  // namespace circle_voronoi::python
