// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's algorithms as printed as a JavaScript module of its own, for the tutorial. Its only caller is
// web/tutorial/printed-rules.ts.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "printed_algorithm.h"
#include "values.h"

namespace {

using namespace circle_voronoi;

using Circles = std::array<std::int32_t, 2>;

/// Runs the printed algorithm with the printed rules of these names. Returns for each segment its two circles and its
/// ends, and for each leftover directed edge its circles, its disc of R_min and the vectors from their centers to its
/// footpoints.
val printedValue(const val& coordinates, const val& asPrinted) {
  return valueOf([&] {
    const auto circles = itemsFrom<double, Circle>(coordinates);
    const auto isPrinted = [&](const char* rule) { return asPrinted.call<bool>("includes", std::string(rule)); };
    const AsPrinted rules = {isPrinted("side"), isPrinted("third"), isPrinted("crossing"), isPrinted("inside")};
    const PrintedResult printed = runPrinted(circles, pairAll(static_cast<int>(circles.size())), rules);
    std::vector<Circles> segmentCircles;
    std::vector<std::array<Vertex, 2>> segmentDiscs;
    for (const auto& [a, b, from, to] : printed.segments) {
      segmentCircles.push_back({a, b});
      segmentDiscs.push_back({from, to});
    }
    std::vector<Circles> leftoverCircles;
    std::vector<Vertex> leftoverDiscs;
    std::vector<std::array<Vector, 2>> leftoverFeet;
    for (const PrintedEdge& edge : printed.leftover) {
      leftoverCircles.push_back({edge.a, edge.b});
      leftoverDiscs.push_back(edge.disc);
      leftoverFeet.push_back({edge.fromA, edge.fromB});
    }
    val result = val::object();
    result.set("segmentCircles", int32Array(segmentCircles));
    result.set("segmentDiscs", float64Array(segmentDiscs));
    result.set("leftoverCircles", int32Array(leftoverCircles));
    result.set("leftoverDiscs", float64Array(leftoverDiscs));
    result.set("leftoverFeet", float64Array(leftoverFeet));
    return result;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi_printed) { emscripten::function("printed", &printedValue); }
