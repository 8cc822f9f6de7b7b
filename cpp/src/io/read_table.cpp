// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/table.h"
#include "column_names.h"
#include "guarded.h"
#include "json_reader.h"
#include "members.h"
#include "text.h"

namespace circle_voronoi {
namespace {

void addRow(JsonReader& reader, std::string_view text, ParsedRows& rows) {
  rows.properties.push_back(readMembers(reader, text));
  rows.offsets.push_back(reader.offset());
}

ParsedRows readObjects(JsonReader& reader, std::string_view text) {
  ParsedRows rows;
  reader.enterArray();
  while (reader.nextItem()) {
    const JsonKind kind = reader.kind();
    if (kind != JsonKind::object) {
      reader.skip();  // so that the error points to the end of the value
      reader.fail("expected an object, not " + std::string(nameOf(kind)) + ".");
    }
    addRow(reader, text, rows);
  }
  return rows;
}

void addFeature(JsonReader& reader, std::string_view text, ParsedRows& rows) {
  if (reader.kind() != JsonKind::object) {
    reader.skip();
    reader.fail("an item of the list of features is no Feature.");
  }
  std::string properties;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "properties" && reader.kind() == JsonKind::object) {
      properties = readMembers(reader, text);
    } else {
      reader.skip();
    }
  }
  rows.properties.push_back(std::move(properties));
  rows.offsets.push_back(reader.offset());
}

ParsedRows readFeatures(JsonReader& reader, std::string_view text) {
  std::optional<ParsedRows> rows;
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "features" && reader.kind() == JsonKind::array) {
      rows.emplace();
      reader.enterArray();
      while (reader.nextItem()) addFeature(reader, text, *rows);
    } else {
      reader.skip();
    }
  }
  if (!rows) throw ReadError{0, "expected an array of objects or a GeoJSON FeatureCollection."};
  return *std::move(rows);
}

ParsedRows readRows(std::string_view text, std::span<const std::string> columns) {
  const char begin = firstOf(text);
  if (begin != '[' && begin != '{') return readCsvRows(text, columns);
  JsonReader reader(text);
  ParsedRows rows = begin == '[' ? readObjects(reader, text) : readFeatures(reader, text);
  reader.finish();
  return rows;
}

/// Returns a value with one spelling for each string.
std::string respelled(std::string_view value) {
  return value.starts_with('"') ? jsonString(JsonReader(value).string()) : oneLine(value);
}

Column columnOf(const std::vector<std::string>& properties, const std::string& column) {
  Column result{column};
  for (const std::string& members : properties) {
    std::string found = "null";
    bool isFound = false;
    visitMembers(members, [&](std::string_view name, std::string_view value) {
      if (isFound || !isNameOfColumn(name, column)) return;
      found = respelled(value);
      isFound = true;
    });
    result.values.push_back(std::move(found));
  }
  return result;
}

}  // namespace

Result<Table> readTable(std::string_view text, std::string_view name, std::span<const std::string> columns) {
  return guarded([&]() -> Result<Table> {
    const auto content = contentOf(text, name);
    if (!content) return content.error();
    try {
      const ParsedRows rows = readRows(content.value(), columns);
      Table table;
      for (const std::string& column : columns) table.columns.push_back(columnOf(rows.properties, column));
      table.lines = linesAt(content.value(), rows.offsets);
      return table;
    } catch (const ReadError& failure) {
      return errorAt(name, content.value(), failure);
    }
  });
}

}  // namespace circle_voronoi
