// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>

#include "stats.h"

namespace circle_voronoi {
namespace {

/// Names have small letters and hyphens. Nothing else is taken, as it is written again without escapes.
void take(JsonReader& reader, std::string& name) {
  if (reader.kind() != JsonKind::string) return reader.skip();
  const std::string_view text = reader.string();
  const auto fits = [](char c) { return c == '-' || (c >= 'a' && c <= 'z'); };
  if (std::ranges::all_of(text, fits)) name = text;
}

void take(JsonReader& reader, std::int64_t& count) {
  if (reader.kind() != JsonKind::number) return reader.skip();
  if (const auto value = reader.whole<std::int64_t>(); value && *value >= 0) count = *value;
}

void take(JsonReader& reader, double& seconds) {
  if (reader.kind() != JsonKind::number) return reader.skip();
  seconds = reader.number();
}

template <class Struct, class Field, std::size_t count>
void takeFields(JsonReader& reader, const std::array<NamedField<Struct, Field>, count>& fields, Struct& values) {
  if (reader.kind() != JsonKind::object) return reader.skip();
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    const auto field = std::ranges::find(fields, *key, &NamedField<Struct, Field>::name);
    if (field == fields.end()) {
      reader.skip();
    } else {
      take(reader, values.*(field->field));
    }
  }
}

}  // namespace

Stats readStats(JsonReader& reader) {
  Stats stats;
  if (reader.kind() != JsonKind::object) {
    reader.skip();
    return stats;
  }
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "method") {
      take(reader, stats.method);
    } else if (*key == "way") {
      take(reader, stats.way);
    } else if (*key == "candidates") {
      take(reader, stats.candidates);
    } else if (*key == "counts") {
      takeFields(reader, kCounts, stats.counts);
    } else if (*key == "seconds") {
      takeFields(reader, kSeconds, stats.seconds);
    } else {
      reader.skip();
    }
  }
  return stats;
}

}  // namespace circle_voronoi
