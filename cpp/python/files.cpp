// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing the text of files.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "arrays.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/region.h"
#include "errors.h"
#include "interruptible.h"
#include "module.h"

namespace py = pybind11;

namespace circle_voronoi::python {
namespace {

ReadOptions readOptions(bool weights, bool points) {
  ReadOptions options;
  options.weights = weights;
  if (points) options.radii = Radii::optional;
  return options;
}

py::array circlesIn(std::string text, const std::string& name, bool weights, bool points) {
  return arrayOf<double>(interruptible([=, text = std::move(text)](const Cancellation&) {
    return valueOf(readCircles(text, name, readOptions(weights, points)));
  }));
}

/// For each circle the members of a JSON object. Radii play no role.
std::vector<std::string> propertiesIn(std::string text, const std::string& name) {
  return interruptible([=, text = std::move(text)](const Cancellation&) {
    CircleFile file = valueOf(readCircleFile(text, name, readOptions(true, true)));
    file.attributes.properties.resize(file.circles.size());
    return std::move(file.attributes.properties);
  });
}

/// Reads a diagram and judges it.
std::shared_ptr<Diagram> diagramIn(std::string text, const std::string& name) {
  return interruptible([=, text = std::move(text)](const Cancellation&) {
    auto diagram = std::make_shared<Diagram>(valueOf(readDiagram(text, name)));
    diagram->certificate = valueOf(certify(*diagram));
    return diagram;
  });
}

using Write = std::function<Result<void>(std::ostream&, const Diagram&, const ExportOptions&)>;

const std::map<std::string, Write>& writers() {
  static const std::map<std::string, Write> all = {
      {"json", [](auto& out, const auto& d,
                  const auto& options) { return writeDiagramFile(out, d, *options.attributes, options.digits); }},
      {"csv", [](auto& out, const auto& d, const auto& options) { return writeDiagramCsv(out, d, options.digits); }},
      {"cells", writeCellsCsv},
      {"svg", writeSvg},
      {"geojson", writeGeoJson},
      {"geojsonl", writeGeoJsonLines},
      {"wkt", writeWkt},
      {"obj", writeObj},
  };
  return all;
}

py::bytes textOf(const std::shared_ptr<Diagram>& diagram, const std::string& format,
                 const std::optional<std::array<double, 4>>& bounds, const std::shared_ptr<Region>& region,
                 std::optional<double> maxDistance, std::optional<double> tolerance, std::optional<int> digits,
                 std::vector<std::string> properties) {
  return interruptible([=, attributes = CircleAttributes{.properties = std::move(properties)}](const Cancellation&) {
    std::ostringstream out;
    ExportOptions options;
    if (bounds) options.bounds = Box{(*bounds)[0], (*bounds)[1], (*bounds)[2], (*bounds)[3]};
    options.region = region.get();
    options.maxDistance = maxDistance;
    options.tolerance = tolerance;
    options.digits = digits;
    options.attributes = &attributes;
    valueOf(writers().at(format)(out, *diagram, options));
    return std::move(out).str();
  });
}

}  // namespace

void addFiles(py::module_& module) {
  module.def("holds_diagram", [](const std::string& text) { return holdsDiagram(text); });
  module.def("read_circles", circlesIn);
  module.def("read_attributes", propertiesIn);
  module.def("read_diagram", diagramIn);
  module.def("write_diagram", textOf);
}

}  // namespace circle_voronoi::python
