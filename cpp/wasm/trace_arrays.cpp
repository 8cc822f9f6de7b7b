// SPDX-License-Identifier: GPL-3.0-or-later
#include "trace_arrays.h"

#include "values.h"

namespace circle_voronoi {

Observer TraceArrays::observer() {
  return [this](const TraceEvent& event) {
    kinds_.push_back(static_cast<std::uint8_t>(event.kind));
    for (const double number : {event.disc.x, event.disc.y, event.disc.r}) discs_.push_back(number);
    for (const CircleIndex circle : event.circles) circles_.push_back(circle);
    vertices_.push_back(event.vertex);
    for (const std::int32_t number : event.numbers) numbers_.push_back(number);
  };
}

emscripten::val TraceArrays::value() const {
  emscripten::val result = emscripten::val::object();
  result.set("kinds", typedArray<std::uint8_t>("Uint8Array", kinds_));
  result.set("discs", float64Array(discs_));
  result.set("circles", int32Array(circles_));
  result.set("vertices", int32Array(vertices_));
  result.set("numbers", int32Array(numbers_));
  return result;
}

}  // namespace circle_voronoi
