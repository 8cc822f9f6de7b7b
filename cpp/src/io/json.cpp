// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <string>

#include "json_reader.h"
#include "text.h"

namespace circle_voronoi {
namespace {

constexpr std::array<std::string_view, 3> kKeys = {"x", "y", "r"};

using Numbers = std::array<double, 3>;

std::string nameOfField(std::size_t field) { return std::string(kKeys[field]); }

double readField(JsonReader& reader, std::size_t field) {
  const JsonKind kind = reader.kind();
  if (kind != JsonKind::number) {
    reader.fail("expected a number for " + nameOfField(field) + ", not " + std::string(nameOf(kind)) + ".");
  }
  return reader.number();
}

Circle readArray(JsonReader& reader, std::size_t least) {
  Numbers values{};
  std::size_t count = 0;
  reader.enterArray();
  while (reader.nextItem()) {
    if (count == values.size()) reader.fail("a circle has three numbers, not more.");
    values[count] = readField(reader, count);
    ++count;
  }
  if (count < least) reader.fail("a circle has no " + nameOfField(count) + ".");
  return {values[0], values[1], values[2]};
}

Circle readObject(JsonReader& reader, std::size_t least) {
  Numbers values{};
  std::array<bool, kKeys.size()> given{};
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    const auto field = static_cast<std::size_t>(std::ranges::find(kKeys, *key) - kKeys.begin());
    if (field == kKeys.size()) {
      reader.skip();
      continue;
    }
    if (given[field]) reader.fail(nameOfField(field) + " is given twice.");
    given[field] = true;
    values[field] = readField(reader, field);
  }
  const auto missing = static_cast<std::size_t>(std::ranges::find(given, false) - given.begin());
  if (missing < least) reader.fail("a circle has no " + nameOfField(missing) + ".");
  return {values[0], values[1], values[2]};
}

/// `least`: how many of x, y and r there have to be.
Circle readCircle(JsonReader& reader, std::size_t least) {
  const JsonKind kind = reader.kind();
  if (kind == JsonKind::array) return readArray(reader, least);
  if (kind == JsonKind::object) return readObject(reader, least);
  reader.fail("expected a circle, [x,y,r] or {\"x\":..,\"y\":..,\"r\":..}, not " + std::string(nameOf(kind)) + ".");
}

}  // namespace

Result<PlacedCircles> readJson(std::string_view text, std::string_view name, bool points) try {
  PlacedCircles result;
  JsonReader reader(text);
  reader.enterArray();
  while (reader.nextItem()) {
    result.circles.push_back(readCircle(reader, points ? 2 : 3));
    result.offsets.push_back(reader.offset());
  }
  reader.finish();
  return result;
} catch (const ReadFailure& failure) {
  return errorAt(name, text, failure.offset, failure.reason);
}

}  // namespace circle_voronoi
