// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
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

/// Returns a value with one spelling for each string.
std::string respelled(std::string_view value) {
  return value.starts_with('"') ? jsonString(JsonReader(value).string()) : oneLine(value);
}

/// Returns the columns of rows. A row without a value has null; if it has several of one name, the first counts.
std::vector<Column> columnsOf(const ParsedRows& rows, std::span<const std::string> names) {
  std::vector<Column> columns;
  for (const std::string& name : names) {
    columns.push_back({name, std::vector<std::string>(rows.properties.size(), "null")});
  }
  for (std::size_t row = 0; row < rows.properties.size(); ++row) {
    std::vector<bool> areFound(names.size());
    visitMembers(rows.properties[row], [&](std::string_view name, std::string_view value) {
      for (std::size_t k = 0; k < names.size(); ++k) {
        if (areFound[k] || !isNameOfColumn(name, names[k])) continue;
        columns[k].values[row] = respelled(value);
        areFound[k] = true;
      }
    });
  }
  return columns;
}

/// Refuses a name that no object has.
void checkMembers(const ParsedRows& rows, std::span<const std::string> names) {
  if (rows.properties.empty()) return;
  for (const std::string& name : names) {
    const auto hasName = [&](const std::string& members) {
      bool isFound = false;
      visitMembers(members, [&](std::string_view other, std::string_view) { isFound |= isNameOfColumn(other, name); });
      return isFound;
    };
    if (std::any_of(rows.properties.begin(), rows.properties.end(), hasName)) continue;
    std::string known;
    visitMembers(rows.properties.front(), [&](std::string_view other, std::string_view) {
      known += (known.empty() ? ", only " : ", ") + std::string(other);
    });
    throw ReadError{rows.offsets.front(), "no member is called " + name + known + "."};
  }
}

/// Reads rows once. A column must be named by the first line of a table, or by an object.
ParsedRows readRows(std::string_view text, std::span<const std::string> columns) {
  const char begin = firstOf(text);
  if (begin != '[' && begin != '{') return readCsvRows(text, columns);
  JsonReader reader(text);
  ParsedRows rows = begin == '[' ? readObjects(reader, text) : readFeatures(reader, text);
  reader.finish();
  checkMembers(rows, columns);
  return rows;
}

}  // namespace

Result<Table> readTable(std::string_view text, std::string_view name, std::span<const std::string> columns) {
  return guarded([&]() -> Result<Table> {
    const auto content = contentOf(text, name);
    if (!content) return content.error();
    try {
      const ParsedRows rows = readRows(content.value(), columns);
      return Table{columnsOf(rows, columns), linesAt(content.value(), rows.offsets)};
    } catch (const ReadError& failure) {
      return errorAt(name, content.value(), failure);
    }
  });
}

}  // namespace circle_voronoi
