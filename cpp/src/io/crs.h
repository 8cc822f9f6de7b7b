// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <optional>
#include <string>
#include <string_view>

#include "column_names.h"
#include "members.h"

namespace circle_voronoi {

/// Returns the URN of a coordinate reference system: that of EPSG:25832, or a URN itself. Returns nothing if a text is
/// neither.
inline std::optional<std::string> crsUrn(std::string_view text) {
  constexpr std::string_view kUrn = "urn:ogc:def:crs:";
  const auto isPlain = [](char c) {
    return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '.' ||
           c == '-';
  };
  if (text.size() > kUrn.size() && isSameName(text.substr(0, kUrn.size()), kUrn)) {
    const bool isRight = std::ranges::all_of(text, [&](char c) { return isPlain(c) || c == ':'; });
    return isRight ? std::optional(std::string(text)) : std::nullopt;
  }
  const std::size_t colon = text.find(':');
  if (colon == text.npos || colon == 0 || colon + 1 == text.size()) return std::nullopt;
  const std::string_view authority = text.substr(0, colon);
  const std::string_view code = text.substr(colon + 1);
  if (!std::ranges::all_of(authority, isPlain) || !std::ranges::all_of(code, isPlain)) return std::nullopt;
  std::string urn(kUrn);
  for (const char c : authority) urn += c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c;
  return urn + (isSameName(authority, "OGC") ? ":1.3:" : "::") + std::string(code);
}

/// Returns whether a URN names longitude and latitude on WGS 84, the only reference system of GeoJSON in RFC 7946.
inline bool isGeoJsonCrs(std::string_view urn) { return urn.ends_with(":EPSG::4326") || urn.ends_with(":CRS84"); }

/// Replaces the reference system among the members of a collection, as GeoJSON named it before RFC 7946.
inline void setCrs(std::string& collection, std::string_view urn) {
  Members members;
  visitMembers(collection, [&](std::string_view name, std::string_view value) {
    if (name != "crs") members.add(name, value);
  });
  if (!isGeoJsonCrs(urn)) {
    members.add("crs", R"({"type":"name","properties":{"name":)" + jsonString(urn) + "}}");
  }
  collection = members.take();
}

}  // namespace circle_voronoi
