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
#include <tuple>
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

/// The columns of x, y and radius, and whether radii are weights, whether all are 0, and whether invalid rows are
/// skipped.
using Columns = std::tuple<std::string, std::string, std::string, bool, bool, bool>;

ReadOptions readOptions(const Columns& columns) {
  const auto& [x, y, radius, weights, points, skipInvalid] = columns;
  ReadOptions options;
  options.x = x;
  options.y = y;
  options.radius = radius;
  options.weights = weights;
  if (points) options.radii = Radii::none;
  options.skipInvalid = skipInvalid;
  return options;
}

/// The circles, and for each row that was skipped the reason.
py::tuple circlesIn(std::string text, const std::string& name, const Columns& columns) {
  CircleFile file = interruptible([=, text = std::move(text)](const Cancellation&) {
    return valueOf(readCircleFile(text, name, readOptions(columns)));
  });
  std::vector<std::string> reasons;
  for (const Error& skipped : file.skipped) reasons.push_back(skipped.message);
  return py::make_tuple(arrayOf<double>(std::move(file.circles)), reasons);
}

/// For each circle the members of a JSON object.
std::vector<std::string> propertiesIn(std::string text, const std::string& name, const Columns& columns) {
  return interruptible([=, text = std::move(text)](const Cancellation&) {
    CircleFile file = valueOf(readCircleFile(text, name, readOptions(columns)));
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
