// SPDX-License-Identifier: GPL-3.0-or-later
// The power diagram as a JavaScript module of its own, because few pages need it. Its only caller is
// web/lib/wasm/metrics.ts.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <string>

#include "certify_power.h"
#include "compute_images.h"
#include "power_diagram.h"
#include "validate.h"
#include "values.h"

namespace {

using namespace circle_voronoi;

/// A callback throws this to end the computation.
struct Stopped {};

/// `reporter` is undefined or an object: its method `tell` is called with the name of a stage and the finished part of
/// it, and must not throw. If its property `isStopped` is true afterwards, the computation ends. Functions that return
/// a value would need more of Emscripten's script than the modules next to which this script is compressed.
Options powerOptions(bool weights, const val& reporter) {
  Options options;
  options.metric = Metric::power;
  options.weights = weights;
  if (!reporter.isUndefined()) {
    options.progress = [&reporter](Stage stage, double done) {
      reporter.call<void>("tell", std::string(stageName(stage)), done);
      if (reporter["isStopped"].isTrue()) throw Stopped{};
    };
  }
  return options;
}

/// Returns the diagram with its circles, which are rounded.
val powerDiagramValue(const val& coordinates, bool weights, const val& reporter) {
  return valueOf([&] {
    const Options options = powerOptions(weights, reporter);
    const Result<Diagram> diagram = powerDiagram(itemsFrom<double, Circle>(coordinates), options);
    if (!diagram.ok()) return errorValue(diagram.error());
    val result = diagramValue(diagram.value());
    result.set("circles", float64Array(diagram.value().circles));
    return result;
  });
}

/// `lattice`: ax, ay, bx, by.
val periodicPowerValue(const val& coordinates, const val& lattice, bool weights, const val& reporter) {
  return valueOf([&] {
    const auto circles = itemsFrom<double, Circle>(coordinates);
    const Lattice periods = itemsFrom<double, Lattice>(lattice).at(0);
    const auto periodic = computeImages(circles, periods, powerOptions(weights, reporter), powerDiagram);
    return periodic.ok() ? periodicValue(periodic.value()) : errorValue(periodic.error());
  });
}

/// `value` is a diagram as `compute` in web/lib returns it.
val certifyPowerValue(const val& value) {
  return valueOf([&] {
    const Result<Certificate> certificate = certifyPower(diagramFrom(value));
    return certificate.ok() ? certificateValue(certificate.value()) : errorValue(certificate.error());
  });
}

/// Checks circles, and returns them rounded.
val validCirclesValue(const val& coordinates, bool weights) {
  return valueOf([&] {
    const auto circles = validate(itemsFrom<double, Circle>(coordinates), weights);
    if (!circles.ok()) return errorValue(circles.error());
    val result = val::object();
    result.set("circles", float64Array(circles.value()));
    return result;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi_metrics) {
  emscripten::function("powerDiagram", &powerDiagramValue);
  emscripten::function("periodicPower", &periodicPowerValue);
  emscripten::function("certifyPower", &certifyPowerValue);
  emscripten::function("validCircles", &validCirclesValue);
}
