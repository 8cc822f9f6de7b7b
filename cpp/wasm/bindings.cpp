// SPDX-License-Identifier: GPL-3.0-or-later
// The core as a JavaScript module. Its only caller is web/lib/library.ts, which gives the values their types.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/final_cells.h"
#include "values.h"

namespace {

using namespace circle_voronoi;
using emscripten::val;

/// Thrown by a callback: the computation is to end.
struct Stopped {};

Error badOption(std::string message) { return {ErrorCode::badOption, -1, std::move(message)}; }

/// `options`: `weights`, `method`, `candidates`, `samples`, `resample` and `progress`, each possibly undefined. `progress`, called
/// with the name of a stage and the part of it that is done, says whether to go on. The caller sees to it that it does
/// not throw.
Result<Options> optionsFrom(const val& options) {
  Options result;
  const val weights = options["weights"];
  if (!weights.isUndefined()) result.weights = weights.as<bool>();
  const val method = options["method"];
  if (!method.isUndefined()) {
    if (method.strictlyEquals(val("auto"))) {
      result.method = Method::automatic;
    } else if (method.strictlyEquals(val("touching-disc"))) {
      result.method = Method::touchingDisc;
    } else if (method.strictlyEquals(val("flip"))) {
      result.method = Method::flip;
    } else {
      return badOption("Unknown method: the choice is auto, touching-disc or flip.");
    }
  }
  const val candidates = options["candidates"];
  if (!candidates.isUndefined()) {
    if (candidates.strictlyEquals(val("dynamic"))) {
      result.candidates = Candidates::dynamic;
    } else if (candidates.strictlyEquals(val("uniform"))) {
      result.candidates = Candidates::uniform;
    } else if (candidates.strictlyEquals(val("all-pairs"))) {
      result.candidates = Candidates::allPairs;
    } else {
      return badOption("Unknown candidates: the choice is dynamic, uniform or all-pairs.");
    }
  }
  const val samples = options["samples"];
  if (!samples.isUndefined()) {
    if (!samples.isNumber()) return badOption("The number of samples is not a number.");
    result.samples = samples.as<int>();
  }
  const val resample = options["resample"];
  if (!resample.isUndefined()) result.resample = resample.as<bool>();
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
    const Result<Diagram> diagram = compute(circles, chosen.value());
    return diagram.ok() ? diagramValue(diagram.value()) : errorValue(diagram.error());
  });
}

// In what follows `value` is a diagram as `compute` in web/lib returns it.

val certifyValue(const val& value) {
  return valueOf([&] {
    const Result<Certificate> certificate = certify(diagramFrom(value));
    return certificate.ok() ? certificateValue(certificate.value()) : errorValue(certificate.error());
  });
}

/// `box`: minX, minY, maxX, maxY.
val finalCellsValue(const val& value, const val& box, double maxRadius) {
  return valueOf([&] {
    const Known known = {itemsFrom<double, Box>(box).at(0), maxRadius};
    const Result<FinalCells> cells = finalCells(diagramFrom(value), known);
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

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi) {
  emscripten::function("compute", &computeValue);
  emscripten::function("certify", &certifyValue);
  emscripten::function("finalCells", &finalCellsValue);
  emscripten::function("errorCodeNames", &errorCodeNames);
}
