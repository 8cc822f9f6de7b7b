// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
// The core's values as JavaScript's, for the bindings.
#include <emscripten/val.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <new>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/stats.h"

namespace circle_voronoi {

using emscripten::val;

/// A new typed array with the bytes of `items`, read as a flat list of `Scalar`.
template <class Scalar, class Item>
val typedArray(const char* arrayType, const std::vector<Item>& items) {
  static_assert(std::is_standard_layout_v<Item> && sizeof(Item) % sizeof(Scalar) == 0);
  const auto* scalars = reinterpret_cast<const Scalar*>(items.data());
  // A view of the heap dies when the memory grows; the array made from it is a copy.
  return val::global(arrayType).new_(
      emscripten::typed_memory_view(items.size() * (sizeof(Item) / sizeof(Scalar)), scalars));
}

template <class Item>
val int32Array(const std::vector<Item>& items) {
  return typedArray<std::int32_t>("Int32Array", items);
}

template <class Item>
val float64Array(const std::vector<Item>& items) {
  return typedArray<double>("Float64Array", items);
}

/// The contents of a typed array as items of `size / sizeof(Scalar)` numbers each, in one copy.
template <class Scalar, class Item>
std::vector<Item> itemsFrom(const val& array) {
  static_assert(std::is_standard_layout_v<Item> && sizeof(Item) % sizeof(Scalar) == 0);
  constexpr std::size_t kScalars = sizeof(Item) / sizeof(Scalar);
  std::vector<Item> items(array["length"].as<std::size_t>() / kScalars);
  if (!items.empty()) {
    auto* scalars = reinterpret_cast<Scalar*>(items.data());
    val(emscripten::typed_memory_view(items.size() * kScalars, scalars)).call<void>("set", array);
  }
  return items;
}

inline val errorValue(const Error& error) {
  val value = val::object();
  value.set("code", std::string(errorCodeName(error.code)));
  value.set("circle", static_cast<double>(error.circle));
  value.set("message", error.message);
  val result = val::object();
  result.set("error", value);
  return result;
}

inline val certificateValue(const Certificate& certificate) {
  val result = val::object();
  result.set("certified", certificate.certified());
  result.set("flaw", std::string(flawName(certificate.flaw)));
  result.set("circle", std::int32_t{certificate.circle});
  result.set("vertex", std::int32_t{certificate.vertex});
  result.set("edge", std::int32_t{certificate.edge});
  result.set("message", certificate.message);
  return result;
}

/// An object with a property for each member; a JavaScript number holds every count that fits in memory.
template <class Struct, class Members>
val membersValue(const Struct& values, const Members& members) {
  val result = val::object();
  for (const auto& [name, member] : members) result.set(std::string(name), static_cast<double>(values.*member));
  return result;
}

/// The name of a value, empty if there is none.
template <class Value>
std::string nameValue(std::optional<Value> value, std::string_view name(Value)) {
  return value ? std::string(name(*value)) : "";
}

inline val statsValue(const Stats& stats) {
  val result = val::object();
  result.set("method", nameValue(stats.method, methodName));
  result.set("way", nameValue(stats.way, wayName));
  result.set("candidates", nameValue(stats.candidates, candidatesName));
  result.set("counts", membersValue(stats.counts, kCountMembers));
  result.set("seconds", membersValue(stats.seconds, kSecondsMembers));
  return result;
}

inline val diagramValue(const Diagram& diagram) {
  val result = val::object();
  result.set("weights", diagram.weights);
  result.set("vertices", float64Array(diagram.vertices));
  result.set("vertexCircles", int32Array(diagram.vertexCircles));
  result.set("edges", int32Array(diagram.edges));
  result.set("hidden", int32Array(diagram.hidden));
  result.set("hull", int32Array(diagram.hull));
  result.set("nextSide", int32Array(diagram.links.nextSide));
  result.set("vertexSides", int32Array(diagram.links.vertexSides));
  result.set("firstSide", int32Array(diagram.links.firstSide));
  result.set("certificate", certificateValue(diagram.certificate));
  result.set("stats", statsValue(diagram.stats));
  return result;
}

/// `lattice`: ax, ay, bx, by. The shifts are two numbers each.
inline val periodicValue(const PeriodicDiagram& periodic) {
  val result = val::object();
  result.set("diagram", diagramValue(periodic.diagram));
  result.set("circles", float64Array(periodic.diagram.circles));
  result.set("lattice", float64Array(std::vector<Lattice>{periodic.lattice}));
  result.set("circleOf", int32Array(periodic.circleOf));
  result.set("shiftOf", int32Array(periodic.shiftOf));
  return result;
}

/// The arrays of a diagram of circles, as `compute` in web/lib returns it.
inline Diagram diagramFrom(const val& value) {
  Diagram diagram;
  diagram.weights = value["weights"].as<bool>();
  diagram.circles = itemsFrom<double, Circle>(value["circles"]);
  diagram.vertices = itemsFrom<double, Vertex>(value["vertices"]);
  diagram.vertexCircles = itemsFrom<std::int32_t, std::array<CircleIndex, 3>>(value["vertexCircles"]);
  diagram.edges = itemsFrom<std::int32_t, Edge>(value["edges"]);
  diagram.hidden = itemsFrom<std::int32_t, HiddenCircle>(value["hidden"]);
  diagram.hull = itemsFrom<std::int32_t, CircleIndex>(value["hull"]);
  diagram.links.nextSide = itemsFrom<std::int32_t, SideIndex>(value["nextSide"]);
  diagram.links.vertexSides = itemsFrom<std::int32_t, std::array<SideIndex, 3>>(value["vertexSides"]);
  diagram.links.firstSide = itemsFrom<std::int32_t, SideIndex>(value["firstSide"]);
  return diagram;
}

/// The value that `body` makes, or `{error: {code, circle, message}}`. Throws nothing, because a C++ exception would
/// reach JavaScript as a bare number.
template <class Body>
val valueOf(Body body) {
  try {
    return body();
  } catch (const std::bad_alloc&) {
    return errorValue({ErrorCode::tooManyCircles, kNone, "There is not enough memory."});
  } catch (const std::exception& exception) {
    return errorValue({ErrorCode::internal, kNone, exception.what()});
  } catch (...) {
    // A callback has stopped the computation. The caller knows this.
    return errorValue({ErrorCode::internal, kNone, "The computation failed."});
  }
}

}  // namespace circle_voronoi
