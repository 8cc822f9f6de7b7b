// SPDX-License-Identifier: GPL-3.0-or-later
// The power diagram as a JavaScript module of its own, because few pages need it. Its only caller is
// web/lib/comparison.ts.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include "power_diagram.h"
#include "values.h"

namespace {

using namespace circle_voronoi;

val powerDiagramValue(const val& coordinates) {
  return valueOf([&] {
    const auto circles = itemsFrom<double, Circle>(coordinates);
    const Result<Diagram> diagram = powerDiagram(circles);
    return diagram.ok() ? diagramValue(diagram.value()) : errorValue(diagram.error());
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi_comparison) { emscripten::function("powerDiagram", &powerDiagramValue); }
