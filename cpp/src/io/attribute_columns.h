// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "attribute_writer.h"
#include "circle_voronoi/io.h"
#include "json_reader.h"
#include "members.h"
#include "writer.h"

namespace circle_voronoi {

/// Returns a text as a field of a table, in quotation marks if it needs them.
inline std::string csvText(const std::string& text) {
  const bool isPlain = !text.empty() && text.find_first_of(",\"\r\n") == text.npos && text.front() != ' ' &&
                       text.back() != ' ' && text.front() != '\t' && text.back() != '\t' && text.front() != '#';
  if (isPlain) return text;
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"') result += '"';
    result += c;
  }
  return result + "\"";
}

/// Whether a field is text even in a column whose other fields are numbers or booleans.
inline bool isCsvText(const std::string& text) {
  return text.find_first_of(",\"\r\n") != text.npos ||
         !(isJsonNumber(text) || isMissingNumber(text) || text == "true" || text == "false");
}

/// Returns a JSON value as a field that reads back as the same value.
inline std::string csvField(std::string_view value) {
  if (value == "null" || value.empty()) return "";
  if (value.front() != '"')
    return value.front() == '{' || value.front() == '[' ? csvText(std::string(value)) : std::string(value);
  JsonReader reader(value);
  std::string text(reader.string());
  // A text that would read as another value is quoted.
  return isCsvText(text) ? csvText(text) : "\"" + text + "\"";
}

/// The attributes of circles as columns of a table.
class AttributeColumns {
 public:
  /// `ownNames`: the columns that the table has beside those of circles.
  explicit AttributeColumns(const CircleAttributes& attributes, std::span<const std::string_view> ownNames = {})
      : attributes_(attributes),
        ownNames_(ownNames),
        hasIds_(!attributes.ids.empty()),
        hasHeights_(!attributes.heights.empty()),
        count_(std::max({attributes.properties.size(), attributes.ids.size(), attributes.heights.size()})) {
    if (hasIds_) add("id");
    if (hasHeights_) add("z");
    for (std::size_t i = 0; i < count_; ++i) {
      visit(i, [&](std::string_view name, std::string_view) { add(name); });
    }
  }

  void writeHeader(Writer& out) const {
    for (const std::string& name : names_) out << "," << csvText(name);
  }

  void writeRow(Writer& out, std::size_t i) {
    if (names_.empty()) return;
    for (std::string& field : fields_) field.clear();
    if (hasIds_) fields_[0] = csvField(entryOf(attributes_.ids, i));
    if (hasHeights_) fields_[hasIds_ ? 1 : 0] = entryOf(attributes_.heights, i);
    visit(i, [&](std::string_view name, std::string_view value) {
      fields_[places_.at(std::string(name))] = csvField(value);
    });
    for (const std::string& field : fields_) out << "," << field;
  }

 private:
  /// Names that have another meaning for a reader of tables.
  bool isOwn(std::string_view name) const {
    static const ColumnNames usual{ReadOptions{}};
    for (std::size_t k = 0; k < ColumnNames::kCount; ++k) {
      if (usual.means(k, name)) return true;
    }
    if (std::ranges::any_of(ownNames_, [&](std::string_view own) { return isSameName(name, own); })) return true;
    return (hasIds_ && isSameName(name, "id")) || (hasHeights_ && isSameName(name, "z"));
  }

  template <class Visit>
  void visit(std::size_t i, Visit visit) const {
    visitProperties(
        attributes_, i, [this](std::string_view name) { return isOwn(name); }, visit);
  }

  void add(std::string_view name) {
    const auto [at, isNew] = places_.emplace(name, names_.size());
    if (!isNew) return;
    names_.emplace_back(name);
    fields_.emplace_back();
  }

  const CircleAttributes& attributes_;
  std::span<const std::string_view> ownNames_;
  bool hasIds_;
  bool hasHeights_;
  std::size_t count_;
  std::vector<std::string> names_;
  std::vector<std::string> fields_;  ///< of a row
  std::unordered_map<std::string, std::size_t> places_;
};

}  // namespace circle_voronoi
