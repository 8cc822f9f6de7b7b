// SPDX-License-Identifier: GPL-3.0-or-later
// Families and figures as a JavaScript module of its own, for the page. Its only caller is
// web/app/generators/generators.ts.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <cstddef>
#include <cstdint>
#include <string>

#include "circle_voronoi_families/figures.h"
#include "values.h"

namespace {

using namespace circle_voronoi;

/// A name and its meaning.
val infoValue(std::string_view name, std::string_view description) {
  val result = val::object();
  result.set("name", std::string(name));
  result.set("description", std::string(description));
  return result;
}

val familiesValue() {
  val result = val::array();
  for (const FamilyInfo& family : families()) {
    val info = infoValue(family.name, family.description);
    info.set("isDisjoint", family.isDisjoint);
    info.set("isDegenerate", family.isDegenerate);
    result.call<void>("push", info);
  }
  return result;
}

val figuresValue() {
  val result = val::array();
  for (const Figure& figure : figures()) result.call<void>("push", infoValue(figure.name, figure.description));
  return result;
}

/// Returns x, y and r of each circle, or undefined for an unknown family. The seed is a JavaScript number, exact up to
/// 2^53.
val generateValue(const std::string& name, double count, double seed) {
  const auto family = familyFromName(name);
  if (!family) return val::undefined();
  return float64Array(generate(*family, static_cast<std::size_t>(count), static_cast<std::uint64_t>(seed)));
}

/// Returns x, y and r of each circle of a figure, or undefined for an unknown figure.
val figureValue(const std::string& name) {
  for (const Figure& figure : figures()) {
    if (figure.name == name) return float64Array(circlesOf(figure));
  }
  return val::undefined();
}

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi_families) {
  emscripten::function("families", &familiesValue);
  emscripten::function("figures", &figuresValue);
  emscripten::function("generate", &generateValue);
  emscripten::function("figure", &figureValue);
}
