// SPDX-License-Identifier: GPL-3.0-or-later
// Circles on a sphere, as a JavaScript module of its own: few pages need it. Its only caller is web/lib/wasm/sphere.ts.
// A diagram is its address, and lives until it is deleted.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "circle_voronoi/sphere.h"
#include "values.h"

namespace {

using namespace circle_voronoi;
using emscripten::val;

/// A diagram with what finds places in it.
struct Globe {
  explicit Globe(SphereDiagram computed) : diagram(std::move(computed)), finder(diagram) {}
  Globe(const Globe&) = delete;
  Globe& operator=(const Globe&) = delete;

  const SphereDiagram diagram;
  const SphereFinder finder;
};

const Globe& globeOf(std::uintptr_t address) { return *reinterpret_cast<const Globe*>(address); }

std::optional<double> numberFrom(const val& number) {
  if (number.isUndefined()) return {};
  return number.as<double>();
}

std::uintptr_t addressOfNew(SphereDiagram diagram) {
  return reinterpret_cast<std::uintptr_t>(new Globe(std::move(diagram)));
}

/// `caps`: longitude, latitude and r of each.
val computeSphereValue(const val& caps, double radius, bool weights) {
  return valueOf([&] {
    auto diagram = computeSphere(itemsFrom<double, Cap>(caps), {radius, weights});
    if (!diagram.ok()) return errorValue(diagram.error());
    val result = val::object();
    result.set("caps", float64Array(diagram->caps));
    result.set("radius", diagram->radius);
    result.set("weights", diagram->weights);
    result.set("rounding", diagram->rounding);
    result.set("vertices", float64Array(diagram->vertices));
    result.set("vertexCaps", int32Array(diagram->vertexCaps));
    result.set("edges", int32Array(diagram->edges));
    result.set("hidden", int32Array(diagram->hidden));
    result.set("nextSide", int32Array(diagram->links.nextSide));
    result.set("vertexSides", int32Array(diagram->links.vertexSides));
    result.set("firstSide", int32Array(diagram->links.firstSide));
    result.set("address", addressOfNew(std::move(diagram).value()));
    return result;
  });
}

/// Takes the arrays of a diagram that another thread has computed.
val createGlobe(const val& value) {
  return valueOf([&] {
    SphereDiagram diagram;
    diagram.caps = itemsFrom<double, Cap>(value["caps"]);
    diagram.radius = value["radius"].as<double>();
    diagram.weights = value["weights"].as<bool>();
    diagram.rounding = value["rounding"].as<double>();
    diagram.vertices = itemsFrom<double, SphereVertex>(value["vertices"]);
    diagram.vertexCaps = itemsFrom<std::int32_t, std::array<CircleIndex, 3>>(value["vertexCaps"]);
    diagram.edges = itemsFrom<std::int32_t, Edge>(value["edges"]);
    diagram.hidden = itemsFrom<std::int32_t, HiddenCircle>(value["hidden"]);
    diagram.links.nextSide = itemsFrom<std::int32_t, SideIndex>(value["nextSide"]);
    diagram.links.vertexSides = itemsFrom<std::int32_t, std::array<SideIndex, 3>>(value["vertexSides"]);
    diagram.links.firstSide = itemsFrom<std::int32_t, SideIndex>(value["firstSide"]);
    if (const auto checked = checkSphere(diagram); !checked.ok()) return errorValue(checked.error());
    val result = val::object();
    result.set("address", addressOfNew(std::move(diagram)));
    return result;
  });
}

void deleteGlobe(std::uintptr_t address) { delete &globeOf(address); }

// The following functions take an address, and caps that exist.

std::int32_t findCap(std::uintptr_t address, double longitude, double latitude) {
  return globeOf(address).finder.find(longitude, latitude);
}

double distanceFromCap(std::uintptr_t address, std::int32_t cap, double longitude, double latitude) {
  return distanceFrom(globeOf(address).diagram, cap, longitude, latitude);
}

val neighborsOfCap(std::uintptr_t address, std::int32_t cap) {
  return valueOf([&] { return int32Array(neighbors(globeOf(address).diagram, cap)); });
}

val areasOfCaps(std::uintptr_t address, const val& maxDistance) {
  return valueOf([&] { return float64Array(areas(globeOf(address).diagram, numberFrom(maxDistance))); });
}

val perimetersOfCaps(std::uintptr_t address, const val& maxDistance) {
  return valueOf([&] { return float64Array(perimeters(globeOf(address).diagram, numberFrom(maxDistance))); });
}

val polygonsOfCaps(std::uintptr_t address, const val& tolerance, const val& maxDistance) {
  return valueOf([&] {
    const auto polygons = cellPolygons(globeOf(address).diagram, {numberFrom(tolerance), numberFrom(maxDistance)});
    if (!polygons.ok()) return errorValue(polygons.error());
    val result = val::object();
    result.set("points", float64Array(polygons->points));
    result.set("pointOffsets", int32Array(polygons->pointOffsets));
    result.set("ringOffsets", int32Array(polygons->ringOffsets));
    result.set("polygonOffsets", int32Array(polygons->polygonOffsets));
    return result;
  });
}

/// Longitude, latitude and distance of the place, and the caps near it or -1; both are empty without caps.
val farthestPlaceValue(std::uintptr_t address) {
  return valueOf([&] {
    std::vector<SphereVertex> places;
    std::vector<std::array<CircleIndex, 3>> caps;
    if (const auto farthest = farthestPlace(globeOf(address).diagram)) {
      places.push_back(farthest->place);
      caps.push_back(farthest->caps);
    }
    val result = val::object();
    result.set("place", float64Array(places));
    result.set("caps", int32Array(caps));
    return result;
  });
}

/// Two caps and their gap, or undefined.
val closestPairValue(std::uintptr_t address) {
  return valueOf([&] {
    const auto pair = closestPair(globeOf(address).diagram);
    if (!pair) return val::undefined();
    val result = val::object();
    result.set("first", std::int32_t{pair->first});
    result.set("second", std::int32_t{pair->second});
    result.set("gap", pair->gap);
    return result;
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi_sphere) {
  emscripten::function("computeSphere", &computeSphereValue);
  emscripten::function("createGlobe", &createGlobe);
  emscripten::function("deleteGlobe", &deleteGlobe);
  emscripten::function("findCap", &findCap);
  emscripten::function("distanceFromCap", &distanceFromCap);
  emscripten::function("neighborsOfCap", &neighborsOfCap);
  emscripten::function("areasOfCaps", &areasOfCaps);
  emscripten::function("perimetersOfCaps", &perimetersOfCaps);
  emscripten::function("polygonsOfCaps", &polygonsOfCaps);
  emscripten::function("farthestPlace", &farthestPlaceValue);
  emscripten::function("closestPair", &closestPairValue);
}
