// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_stats.h"

#include <algorithm>
#include <optional>

namespace circle_voronoi {
namespace {

template <class Value>
void take(JsonReader& reader, std::optional<Value> fromName(std::string_view), std::optional<Value>& value) {
  if (reader.kind() != JsonKind::string) return reader.skip();
  value = fromName(reader.string());
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
void takeFields(JsonReader& reader, const std::array<NamedMember<Struct, Field>, count>& fields, Struct& values) {
  if (reader.kind() != JsonKind::object) return reader.skip();
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    const auto field = std::ranges::find(fields, *key, &NamedMember<Struct, Field>::name);
    if (field == fields.end()) {
      reader.skip();
    } else {
      take(reader, values.*(field->member));
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
      take(reader, methodFromName, stats.method);
    } else if (*key == "way") {
      take(reader, wayFromName, stats.way);
    } else if (*key == "candidates") {
      take(reader, candidatesFromName, stats.candidates);
    } else if (*key == "counts") {
      takeFields(reader, kCountMembers, stats.counts);
    } else if (*key == "seconds") {
      takeFields(reader, kSecondsMembers, stats.seconds);
    } else {
      reader.skip();
    }
  }
  return stats;
}

}  // namespace circle_voronoi
