// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include "attribute_writer.h"
#include "checks.h"
#include "circle_voronoi/io.h"
#include "members.h"
#include "validate.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

bool isPlainName(std::string_view name) {
  return std::ranges::any_of(std::array{"x", "y", "r"}, [&](const char* plain) { return isSameName(name, plain); });
}

/// Items, each written by `item(out, i, circle)`, on a line each.
template <class Item>
void writeLines(Writer& out, std::span<const Circle> circles, Item item) {
  for (std::size_t i = 0; i < circles.size(); ++i) {
    out << (i == 0 ? "\n" : ",\n");
    item(out, i, circles[i]);
  }
}

/// Writes circles that `readCircleFile` accepts.
template <class Body>
Result<void> writingCircles(std::ostream& stream, std::span<const Circle> circles, const CircleAttributes& attributes,
                            Body body) {
  const auto valid = guarded([&] { return validate(circles, true); });
  if (!valid) return valid.error();
  if (auto checked = checkAttributes(attributes, circles.size()); !checked) return checked;
  return writing(stream, body);
}

/// The attributes of circles as columns of a table.
class AttributeColumns {
 public:
  explicit AttributeColumns(const CircleAttributes& attributes)
      : attributes_(attributes),
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
    for (const std::string& name : names_) out << "," << quoted(name);
  }

  void writeRow(Writer& out, std::size_t i) {
    if (names_.empty()) return;
    for (std::string& field : fields_) field.clear();
    if (hasIds_) fields_[0] = fieldOf(entryOf(attributes_.ids, i));
    if (hasHeights_) fields_[hasIds_ ? 1 : 0] = entryOf(attributes_.heights, i);
    visit(i, [&](std::string_view name, std::string_view value) {
      fields_[places_.at(std::string(name))] = fieldOf(value);
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

  static std::string quoted(const std::string& text) {
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

  /// Writes a JSON value as a field that reads back as the same value.
  static std::string fieldOf(std::string_view value) {
    if (value == "null" || value.empty()) return "";
    if (value.front() != '"')
      return value.front() == '{' || value.front() == '[' ? quoted(std::string(value)) : std::string(value);
    JsonReader reader(value);
    std::string text(reader.string());
    // A text that would read as another value is quoted.
    return isText(text) ? quoted(text) : "\"" + text + "\"";
  }

  /// Whether a field is text even in a column whose other fields are numbers or booleans.
  static bool isText(const std::string& text) {
    return text.find_first_of(",\"\r\n") != text.npos ||
           !(isJsonNumber(text) || isMissingNumber(text) || text == "true" || text == "false");
  }

  const CircleAttributes& attributes_;
  bool hasIds_;
  bool hasHeights_;
  std::size_t count_;
  std::vector<std::string> names_;
  std::vector<std::string> fields_;  ///< of a row
  std::unordered_map<std::string, std::size_t> places_;
};

}  // namespace

Result<void> writeCirclesCsv(std::ostream& stream, std::span<const Circle> circles,
                             const CircleAttributes& attributes) {
  return writingCircles(stream, circles, attributes, [&](Writer& out) {
    AttributeColumns columns(attributes);
    out << "x,y,r";
    columns.writeHeader(out);
    out << "\n";
    for (std::size_t i = 0; i < circles.size(); ++i) {
      out << circles[i].x << "," << circles[i].y << "," << circles[i].r;
      columns.writeRow(out, i);
      out << "\n";
    }
  });
}

Result<void> writeCirclesJson(std::ostream& stream, std::span<const Circle> circles,
                              const CircleAttributes& attributes) {
  return writingCircles(stream, circles, attributes, [&](Writer& out) {
    out << "[";
    writeLines(out, circles, [&](Writer& line, std::size_t i, const Circle& c) {
      const std::string_view height = entryOf(attributes.heights, i);
      const std::string_view id = entryOf(attributes.ids, i);
      line << "{\"x\": " << c.x << ", \"y\": " << c.y << ", \"r\": " << c.r;
      if (!height.empty()) line << ", \"z\": " << height;
      if (!id.empty()) line << ", \"id\": " << id;
      const auto isOwn = [&](std::string_view name) {
        return isPlainName(name) || (!id.empty() && isSameName(name, "id")) ||
               (!height.empty() && isSameName(name, "z"));
      };
      visitProperties(attributes, i, isOwn, [&](std::string_view name, std::string_view value) {
        line << ", " << jsonString(name) << ": " << value;
      });
      line << "}";
    });
    out << "\n]\n";
  });
}

Result<void> writeCirclesGeoJson(std::ostream& stream, std::span<const Circle> circles,
                                 const CircleAttributes& attributes) {
  return writingCircles(stream, circles, attributes, [&](Writer& out) {
    writeCollectionStart(out, &attributes);
    writeLines(out, circles, [&](Writer& line, std::size_t i, const Circle& c) {
      writeFeatureStart(line, &attributes, i);
      line << R"("r":)" << c.r;
      const auto isOwn = [](std::string_view name) { return isSameName(name, "r"); };
      visitProperties(attributes, i, isOwn, [&](std::string_view name, std::string_view value) {
        line << "," << jsonString(name) << ":" << value;
      });
      line << R"(},"geometry":{"type":"Point","coordinates":[)" << c.x << "," << c.y;
      if (const auto height = entryOf(attributes.heights, i); !height.empty()) line << "," << height;
      line << "]}}";
    });
    out << "\n]}\n";
  });
}

}  // namespace circle_voronoi
