// SPDX-License-Identifier: GPL-3.0-or-later
// The core as a JavaScript module. Its only caller is web/lib/wasm/library.ts, which gives the values their types.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "certify_circles.h"
#include "circle_voronoi/final_cells.h"
#include "circle_voronoi/periodic_diagram.h"
#include "compute_circles.h"
#include "compute_images.h"
#include "option_names.h"
#include "trace_arrays.h"
#include "values.h"

namespace {

using namespace circle_voronoi;
using emscripten::val;

/// A callback throws this to end the computation.
struct Stopped {};

// Converts an option's value into its field; returns the error, or an empty text.

std::string take(const val& given, std::string_view, bool& field) {
  field = given.as<bool>();
  return "";
}

std::string take(const val& given, std::string_view name, std::optional<int>& field) {
  if (!given.isNumber()) return "The number of " + std::string(name) + " is not a number.";
  field = given.as<int>();
  return "";
}

template <class Value>
std::string take(const val& given, std::string_view name, Value& field) {
  const auto values = namedValues<Value>();
  const std::string text = given.isString() ? given.as<std::string>() : "";
  std::string names;
  for (const auto& value : values) {
    if (text == value.name) {
      field = value.value;
      return "";
    }
    names += names.empty() ? "" : &value == &values.back() ? " or " : ", ";
    names += value.name;
  }
  return "Unknown " + std::string(name) + ": the choice is " + names + ".";
}

/// `options` has the members of the table of option names, and `progress`; each may be undefined. `progress` is called
/// with the name of a stage and the finished part of it, and returns whether to go on. It must not throw.
Result<Options> optionsFrom(const val& options) {
  Options result;
  std::string problem;
  const auto read = [&](const auto& option) {
    const val given = options[std::string(option.name)];
    if (problem.empty() && !given.isUndefined()) problem = take(given, option.name, result.*option.value);
  };
  std::apply([&](const auto&... option) { (read(option), ...); }, kOptions);
  if (!problem.empty()) return Error{ErrorCode::badOption, kNone, problem};
  const val progress = options["progress"];
  if (!progress.isUndefined()) {
    result.progress = [progress](Stage stage, double done) {
      if (progress(std::string(stageName(stage)), done).isFalse()) throw Stopped{};
    };
  }
  return result;
}

val computeValue(const val& coordinates, const val& options) {
  return valueOf([&] {
    const Result<Options> chosen = optionsFrom(options);
    if (!chosen.ok()) return errorValue(chosen.error());
    const auto circles = itemsFrom<double, Circle>(coordinates);
    const Result<Diagram> diagram = computeCircles(circles, chosen.value());
    return diagram.ok() ? diagramValue(diagram.value()) : errorValue(diagram.error());
  });
}

/// `lattice`: ax, ay, bx, by.
val computePeriodicValue(const val& coordinates, const val& lattice, const val& options) {
  return valueOf([&] {
    const Result<Options> chosen = optionsFrom(options);
    if (!chosen.ok()) return errorValue(chosen.error());
    const auto circles = itemsFrom<double, Circle>(coordinates);
    const Lattice periods = itemsFrom<double, Lattice>(lattice).at(0);
    const Result<PeriodicDiagram> periodic = computeImages(circles, periods, chosen.value(), computeCircles);
    if (!periodic.ok()) return errorValue(periodic.error());
    return periodicValue(periodic.value());
  });
}

val traceValue(const val& coordinates, const val& options) {
  return valueOf([&] {
    Result<Options> chosen = optionsFrom(options);
    if (!chosen.ok()) return errorValue(chosen.error());
    TraceArrays events;
    Options traced = std::move(chosen).value();
    traced.observer = events.observer();
    const Result<Diagram> diagram = computeCircles(itemsFrom<double, Circle>(coordinates), traced);
    if (!diagram.ok()) return errorValue(diagram.error());
    val result = val::object();
    result.set("diagram", diagramValue(diagram.value()));
    result.set("events", events.value());
    return result;
  });
}

// In the following functions, `value` is a diagram as `compute` in web/lib returns it.

val certifyValue(const val& value) {
  return valueOf([&] {
    const Result<Certificate> certificate = certifyCircles(diagramFrom(value));
    return certificate.ok() ? certificateValue(certificate.value()) : errorValue(certificate.error());
  });
}

/// `box`: minX, minY, maxX, maxY.
val finalCellsValue(const val& value, const val& box, double maxRadius) {
  return valueOf([&] {
    const MissingCircles missing = {itemsFrom<double, Box>(box).at(0), maxRadius};
    const Result<FinalCells> cells = finalCells(diagramFrom(value), missing);
    if (!cells.ok()) return errorValue(cells.error());
    val result = val::object();
    result.set("neededHalo", float64Array(cells.value().neededHalo));
    result.set("vertices", typedArray<std::uint8_t>("Uint8Array", cells.value().vertices));
    result.set("edges", typedArray<std::uint8_t>("Uint8Array", cells.value().edges));
    return result;
  });
}

val errorCodeNames() {
  val names = val::array();
  // Past the last code the name is empty.
  for (int code = 0; !errorCodeName(static_cast<ErrorCode>(code)).empty(); ++code) {
    names.call<void>("push", std::string(errorCodeName(static_cast<ErrorCode>(code))));
  }
  return names;
}

val traceKindNames() {
  val names = val::array();
  for (int kind = 0; !traceKindName(static_cast<TraceKind>(kind)).empty(); ++kind) {
    names.call<void>("push", std::string(traceKindName(static_cast<TraceKind>(kind))));
  }
  return names;
}

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi) {
  emscripten::function("compute", &computeValue);
  emscripten::function("computePeriodic", &computePeriodicValue);
  emscripten::function("trace", &traceValue);
  emscripten::function("traceKindNames", &traceKindNames);
  emscripten::function("certify", &certifyValue);
  emscripten::function("finalCells", &finalCellsValue);
  emscripten::function("errorCodeNames", &errorCodeNames);
}
