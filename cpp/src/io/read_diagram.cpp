// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/io.h"
#include "json_reading.h"
#include "stats.h"
#include "text.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// A number of an item, or an array of numbers: `size` values from `first` on. Without a key the item is the number.
struct Field {
  std::string_view key;
  std::size_t first = 0;
  std::size_t size = 1;
  bool isArray = false;
  bool isIndex = true;
};

constexpr std::size_t kMostValues = 6;
using Values = std::array<double, kMostValues>;

std::int32_t index(double value) { return static_cast<std::int32_t>(value); }

/// A list of the format: the fields of its items, and what becomes of them.
struct Section {
  std::string_view key;
  std::vector<Field> fields;
  void (*add)(const Values& values, DiagramFile& file);
};

constexpr bool kArray = true;
constexpr bool kReal = false;

const std::vector<Section> kSections = {
    {"circles",
     {{"x", 0, 1, !kArray, kReal}, {"y", 1, 1, !kArray, kReal}, {"r", 2, 1, !kArray, kReal}},
     [](const Values& v, DiagramFile& file) {
       file.circles.push_back({v[0], v[1], v[2]});
     }},
    {"hidden",
     {{"circle", 0}, {"by", 1}},
     [](const Values& v, DiagramFile& file) {
       file.diagram.hidden.push_back({index(v[0]), index(v[1])});
     }},
    {"vertices",
     {{"x", 0, 1, !kArray, kReal},
      {"y", 1, 1, !kArray, kReal},
      {"radius", 2, 1, !kArray, kReal},
      {"circles", 3, 3, kArray}},
     [](const Values& v, DiagramFile& file) {
       file.diagram.vertices.push_back({v[0], v[1], v[2]});
       file.diagram.vertexCircles.push_back({index(v[3]), index(v[4]), index(v[5])});
     }},
    {"edges",
     {{"circles", 0, 2, kArray}, {"vertices", 2, 2, kArray}},
     [](const Values& v, DiagramFile& file) {
       file.diagram.edges.push_back({index(v[0]), index(v[1]), index(v[2]), index(v[3])});
     }},
    {"hull", {{"", 0}}, [](const Values& v, DiagramFile& file) { file.diagram.hull.push_back(index(v[0])); }},
};

/// Takes the parser's events; false stops it.
class DiagramHandler : public Json::json_sax_t {
 public:
  DiagramHandler(std::string_view text, std::string_view name, JsonPosition& position)
      : text_(text), name_(name), position_(position) {}

  Result<DiagramFile> take() && {
    if (error_) return *std::move(error_);
    if (const auto valid = validate(file_.circles); !valid) {
      Error error = valid.error();
      const int line = error.circle < 0 ? 1 : circleLines_[static_cast<std::size_t>(error.circle)];
      error.message = std::string(name_) + ":" + std::to_string(line) + ": " + error.message;
      return error;
    }
    return std::move(file_);
  }

  bool null() override { return isSkipped() || fail(expected() + ", not null."); }
  bool boolean(bool) override { return isSkipped() || fail(expected() + ", not a boolean."); }
  bool binary(Json::binary_t&) override { return isSkipped() || fail(expected() + ", not binary data."); }
  bool number_integer(Json::number_integer_t value) override { return number(negative(value)); }
  bool number_unsigned(Json::number_unsigned_t value) override { return number(static_cast<double>(value)); }
  bool number_float(Json::number_float_t value, const std::string&) override { return number(value); }

  bool string(std::string& value) override {
    if (place_ != Place::format) return isSkipped() || fail(expected() + ", not a string.");
    place_ = Place::file;
    if (value != kFormat) return fail("the format is \"" + value + "\", not \"" + std::string(kFormat) + "\".");
    seen_.insert("format");
    return true;
  }

  bool start_object(std::size_t) override {
    if (isSkipped()) return deeper();
    if (place_ == Place::outside) return go(Place::file);
    if (place_ == Place::list && !isPlainList()) {
      given_ = {};
      return go(Place::item);
    }
    return fail(expected() + ", not an object.");
  }

  bool end_object() override {
    if (isSkipped()) return shallower();
    return place_ == Place::item ? finishItem() : finishFile();
  }

  bool start_array(std::size_t) override {
    if (isSkipped()) return deeper();
    if (place_ == Place::section) return go(Place::list);
    if (place_ == Place::field && field_->isArray) return go(Place::array);
    return fail(expected() + ", not an array.");
  }

  bool end_array() override {
    if (isSkipped()) return shallower();
    if (place_ == Place::list) return go(Place::file);
    if (count_ != field_->size) return fail(expected() + ".");
    return finishField();
  }

  bool key(std::string& key) override {
    if (depth_ > 0) return true;
    return place_ == Place::file ? enterKeyOfFile(key) : enterKeyOfItem(key);
  }

  bool parse_error(std::size_t, const std::string&, const Json::exception& exception) override {
    return fail(reasonOf(exception));
  }

 private:
  /// What is to come next: a value of that kind, or in `file` and `item` a key.
  enum class Place { outside, file, format, version, section, list, item, field, array, skipped };

  static constexpr std::string_view kFormat = "circle-voronoi";
  static constexpr double kVersion = 1;

  bool fail(const std::string& reason) {
    error_ = errorAt(name_, position_.line(), reason);
    return false;
  }

  bool go(Place place) {
    place_ = place;
    count_ = 0;
    return true;
  }

  /// "vertices[3]"
  std::string item() const { return std::string(section_->key) + "[" + std::to_string(items_) + "]"; }

  std::string expected() const {
    switch (place_) {
      case Place::outside:
        return "expected an object";
      case Place::format:
        return "expected a string for format";
      case Place::version:
        return "expected a number for version";
      case Place::section:
        return "expected an array for " + std::string(section_->key);
      case Place::list:
        return "expected " + std::string(isPlainList() ? "a number" : "an object") + " for " + item();
      default: {
        const std::string numbers = field_->isArray ? std::to_string(field_->size) + " numbers" : "a number";
        return "expected " + numbers + " for " + std::string(field_->key) + " of " + item();
      }
    }
  }

  /// Whether this value belongs to another key, of any depth; a plain one is skipped then.
  bool isSkipped() {
    if (place_ != Place::skipped) return false;
    if (depth_ == 0) place_ = before_;
    return true;
  }
  bool deeper() {
    if (depth_ == 0) skippedFrom_ = position_.read() - 1;
    ++depth_;
    place_ = Place::skipped;
    return true;
  }
  bool shallower() {
    if (--depth_ > 0) return true;
    place_ = before_;
    if (isStats_) file_.diagram.stats = readStats(text_.substr(skippedFrom_, position_.read() - skippedFrom_));
    return true;
  }
  bool skip(const std::string& key) {
    isStats_ = place_ == Place::file && key == "stats";
    before_ = place_;
    return go(Place::skipped);
  }

  bool isPlainList() const { return section_->fields[0].key.empty(); }

  bool enterKeyOfFile(const std::string& key) {
    const auto section = std::ranges::find(kSections, key, &Section::key);
    if (section == kSections.end() && key != "format" && key != "version") return skip(key);
    if (seen_.contains(key)) return fail(key + " is given twice.");
    if (key == "format") return go(Place::format);
    if (key == "version") return go(Place::version);
    seen_.insert(key);
    section_ = &*section;
    items_ = 0;
    field_ = section_->fields.data();
    return go(Place::section);
  }

  bool enterKeyOfItem(const std::string& key) {
    const auto field = std::ranges::find(section_->fields, key, &Field::key);
    if (field == section_->fields.end()) return skip(key);
    field_ = &*field;
    if (given_[field_->first]) return fail(key + " of " + item() + " is given twice.");
    return go(Place::field);
  }

  bool number(double value) {
    if (isSkipped()) return true;
    switch (place_) {
      case Place::version:
        place_ = Place::file;
        seen_.insert("version");
        return value == kVersion || fail("the version is not 1, the only one that can be read.");
      case Place::list:
        return isPlainList() ? put(value) && finishItem() : fail(expected() + ", not a number.");
      case Place::field:
        return field_->isArray ? fail(expected() + ", not a number.") : put(value) && finishField();
      case Place::array:
        return count_ == field_->size ? fail(expected() + ".") : put(value);
      default:
        return fail(expected() + ", not a number.");
    }
  }

  bool put(double value) {
    constexpr double kLimit = std::numeric_limits<std::int32_t>::max();
    if (field_->isIndex && !(std::abs(value) <= kLimit && value == std::trunc(value)))
      return fail(std::string(field_->key.empty() ? "" : std::string(field_->key) + " of ") + item() + " is no index.");
    values_[field_->first + count_++] = value;
    return true;
  }

  bool finishField() {
    given_[field_->first] = true;
    return go(Place::item);
  }

  bool finishItem() {
    for (const Field& field : section_->fields) {
      if (!field.key.empty() && !given_[field.first]) return fail(item() + " has no " + std::string(field.key) + ".");
    }
    section_->add(values_, file_);
    if (section_ == kSections.data()) circleLines_.push_back(position_.line());
    ++items_;
    return go(Place::list);
  }

  bool finishFile() {
    if (!seen_.contains("format")) return fail("there is no format; a diagram has \"format\": \"circle-voronoi\".");
    if (!seen_.contains("version")) return fail("there is no version.");
    for (const Section& section : kSections) {
      if (!seen_.contains(section.key)) return fail("there is no list of " + std::string(section.key) + ".");
    }
    return true;
  }

  std::string_view text_;
  std::string_view name_;
  JsonPosition& position_;
  DiagramFile file_;
  std::vector<int> circleLines_;
  std::optional<Error> error_;

  Place place_ = Place::outside;
  Place before_ = Place::file;   ///< where a skipped value stands
  int depth_ = 0;                ///< inside a skipped value
  std::size_t skippedFrom_ = 0;  ///< where in the text it begins
  bool isStats_ = false;         ///< whether it is that of `stats`
  std::set<std::string, std::less<>> seen_;
  const Section* section_ = nullptr;
  std::size_t items_ = 0;  ///< items of the section that are complete
  const Field* field_ = nullptr;
  std::size_t count_ = 0;  ///< values of the field that are read
  Values values_{};
  std::array<bool, kMostValues> given_{};  ///< of each field, at its first value
};

}  // namespace

Result<DiagramFile> readDiagram(std::string_view text, std::string_view name) {
  JsonPosition position(text);
  DiagramHandler handler(text, name, position);
  parseJson(text, position, handler);
  return std::move(handler).take();
}

}  // namespace circle_voronoi
