// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <limits>
#include <string>

#include "json_reading.h"
#include "stats.h"

namespace circle_voronoi {
namespace {

/// Names have small letters and hyphens. Nothing else is taken, as it is written again without escapes.
void take(const Json& value, std::string& name) {
  if (!value.is_string()) return;
  const auto& text = value.get_ref<const std::string&>();
  const auto fits = [](char c) { return c == '-' || (c >= 'a' && c <= 'z'); };
  if (std::all_of(text.begin(), text.end(), fits)) name = text;
}

void take(const Json& value, std::int64_t& count) {
  if (value.is_number_unsigned() && value.get<std::uint64_t>() <= std::numeric_limits<std::int64_t>::max()) {
    count = value.get<std::int64_t>();
  }
}

void take(const Json& value, double& seconds) {
  if (value.is_number()) seconds = value.get<double>();
}

template <class Struct, class Field, std::size_t count>
void takeFields(const Json& object, const std::array<NamedField<Struct, Field>, count>& fields, Struct& values) {
  for (const auto& [name, field] : fields) take(at(object, name), values.*field);
}

}  // namespace

Stats readStats(std::string_view text) {
  const Json json = Json::parse(text);
  Stats stats;
  take(at(json, "method"), stats.method);
  take(at(json, "way"), stats.way);
  take(at(json, "candidates"), stats.candidates);
  takeFields(at(json, "counts"), kCounts, stats.counts);
  takeFields(at(json, "seconds"), kSeconds, stats.seconds);
  return stats;
}

}  // namespace circle_voronoi
