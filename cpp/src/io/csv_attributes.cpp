// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "column_names.h"
#include "csv.h"
#include "csv_table.h"
#include "members.h"
#include "text.h"
#include "utf8.h"
#include "wkt_points.h"

namespace circle_voronoi {
namespace {

bool isMissing(const CsvField& field) { return !field.isQuoted && isMissingNumber(field.text); }

bool isEmpty(const CsvField& field) { return field.text.empty() && !field.isQuoted; }

bool isStructure(const std::string& text) {
  if (text.empty() || (text[0] != '{' && text[0] != '[')) return false;
  try {
    JsonReader reader(text);
    reader.skip();
    reader.finish();
    return true;
  } catch (const ReadError&) {
    return false;
  }
}

/// The types that fit all fields of a column that were read.
class ColumnType {
 public:
  /// `mayBePoint`, `mayBeComma`: the decimal marks that numbers of the table may have.
  ColumnType(bool mayBePoint, bool mayBeComma) : areNumbers_(mayBePoint), areNumbersWithCommas_(mayBeComma) {}

  void add(const CsvField& field) {
    if (isEmpty(field)) return;
    const std::string text = textOf(field);
    const bool isBoolean = !field.isQuoted && (text == "true" || text == "false");
    hasValue_ = true;
    areBooleans_ = areBooleans_ && isBoolean;
    areStructures_ = areStructures_ && isStructure(text);
    if (isMissing(field)) return;
    hasNumber_ = true;
    areNumbers_ = areNumbers_ && !field.isQuoted && isJsonNumber(text);
    areNumbersWithCommas_ = areNumbersWithCommas_ && !field.isQuoted && isJsonNumber(withPoint(text));
  }

  /// The field as a value of JSON.
  std::string value(const CsvField& field) const {
    if (isEmpty(field)) return "null";
    std::string text = textOf(field);
    if (hasNumber_ && (areNumbers_ || areNumbersWithCommas_)) {
      return isMissing(field) ? "null" : areNumbers_ ? text : withPoint(text);
    }
    if (!hasValue_ || !(areBooleans_ || areStructures_)) return jsonString(wholeTextOf(field));
    return oneLine(text);
  }

  bool hasValue() const { return hasValue_; }
  bool isNumeric() const { return hasNumber_ && (areNumbers_ || areNumbersWithCommas_); }

 private:
  /// A number with a decimal comma as JSON writes it; empty if there is a point.
  static std::string withPoint(std::string text) {
    if (text.find('.') != text.npos) return "";
    if (const std::size_t comma = text.find(','); comma != text.npos) text[comma] = '.';
    return text;
  }

  bool areNumbers_;
  bool areNumbersWithCommas_;
  bool areBooleans_ = true;
  bool areStructures_ = true;
  bool hasValue_ = false;
  bool hasNumber_ = false;
};

/// Makes names different.
class DifferentNames {
 public:
  /// Returns a name, with a number after it if it was returned before: the least number from 2 that makes it new.
  std::string add(const std::string& name) {
    if (numbers_.try_emplace(name, 1).second) return name;
    while (true) {
      // All smaller numbers are taken, and stay so.
      const std::string own = name + "_" + std::to_string(++numbers_.at(name));
      if (numbers_.try_emplace(own, 1).second) return own;
    }
  }

 private:
  std::map<std::string, std::size_t> numbers_;  ///< for each name, the last number that was tried
};

/// Throws ReadError unless a text is UTF-8.
void checkUtf8(std::string_view text, std::size_t offset) {
  while (!text.empty()) {
    const std::size_t size = sizeOfUtf8(text);
    if (size == 0) throw ReadError{offset, std::string("the text is ") + kNotUtf8};
    text.remove_prefix(size);
  }
}

/// Goes through the rows of a table that are circles.
class Rows {
 public:
  Rows(std::string_view text, const CsvLayout& layout, const std::vector<ReadError>& skipped)
      : table_(text, layout.separator), skipped_(skipped) {
    if (layout.hasHeader) (void)table_.next();
  }

  bool next() {
    while (table_.next()) {
      if (skippedSoFar_ == skipped_.size() || skipped_[skippedSoFar_].offset != table_.offset()) return true;
      ++skippedSoFar_;
    }
    return false;
  }

  CsvField field(std::size_t column) const {
    return column < table_.fields().size() ? table_.fields()[column] : CsvField{};
  }
  std::size_t offset() const { return table_.offset(); }

 private:
  CsvTable table_;
  const std::vector<ReadError>& skipped_;
  std::size_t skippedSoFar_ = 0;
};

}  // namespace

CircleAttributes attributesOf(std::string_view text, const CsvLayout& layout, char mark,
                              const std::vector<ReadError>& skipped) {
  CircleAttributes result;
  struct Column {
    std::size_t index;
    std::string name;
    ColumnType type;
  };
  std::vector<Column> columns;
  DifferentNames names;
  const bool mayBeComma = mark == ',' || (mark == 0 && CsvNumberReader(layout.separator).mayBeComma());
  CsvTable header(text, layout.separator);
  (void)header.next();
  for (std::size_t k = 0; k < header.fields().size(); ++k) {
    std::string name = nameOfColumn(header, k, layout.hasHeader);
    if (k == layout.points || std::ranges::find(layout.columns, k) != layout.columns.end()) continue;
    checkUtf8(name, header.offset());
    columns.push_back({k, names.add(name), {mark != ',', mayBeComma}});
  }
  if (columns.empty() && !layout.points) return result;
  for (Rows rows(text, layout, skipped); rows.next();) {
    for (Column& column : columns) column.type.add(rows.field(column.index));
  }
  // Lines of spreadsheets end with columns that have neither a name nor values.
  std::erase_if(columns, [&](const Column& column) {
    return layout.hasHeader && header.fields()[column.index].text.empty() && !column.type.hasValue();
  });

  const auto height = std::ranges::find_if(columns, [](const Column& column) { return isSameName(column.name, "z"); });
  const bool hasHeights = height != columns.end() && height->type.isNumeric();
  for (Rows rows(text, layout, skipped); rows.next();) {
    WktPoints points = {.points = {}, .heights = {""}, .srid = ""};
    if (layout.points) points = *wktPoints(textOf(rows.field(*layout.points)));
    Members members;
    std::string id;
    for (const Column& column : columns) {
      const std::string value = column.type.value(rows.field(column.index));
      checkUtf8(value, rows.offset());
      if (column.index == layout.id && isIdValue(value)) id = value;
      if (hasHeights && column.index == height->index) {
        for (std::string& its : points.heights) its = value == "null" ? "" : value;
      }
      members.add(column.name, value);
    }
    const std::string properties = members.take();
    // Each point of a MULTIPOINT is a circle.
    for (std::string& its : points.heights) {
      if (!columns.empty()) result.properties.push_back(properties);
      if (layout.id) result.ids.push_back(id);
      if (hasHeights || layout.points) result.heights.push_back(std::move(its));
    }
  }
  if (std::ranges::all_of(result.heights, &std::string::empty)) result.heights.clear();
  return result;
}

}  // namespace circle_voronoi
