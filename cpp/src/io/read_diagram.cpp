// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "circle_voronoi/io.h"
#include "guarded.h"
#include "json_reader.h"
#include "members.h"
#include "read_stats.h"
#include "text.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

constexpr std::string_view kFormat = "circle-voronoi";
constexpr double kVersion = 1;

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

/// A list of the format: the fields of its items, and the function that stores an item.
struct Section {
  std::string_view key;
  std::vector<Field> fields;
  void (*add)(const Values& values, Diagram& diagram);
  void (*clear)(Diagram& diagram);

  /// Whether its items are numbers, not objects.
  bool isPlain() const { return fields.front().key.empty(); }
};

constexpr bool kArray = true;
constexpr bool kReal = false;

const std::array<Section, 5> kSections = {{
    {"circles",
     {{"x", 0, 1, !kArray, kReal}, {"y", 1, 1, !kArray, kReal}, {"r", 2, 1, !kArray, kReal}},
     [](const Values& v, Diagram& diagram) {
       diagram.circles.push_back({v[0], v[1], v[2]});
     },
     [](Diagram& diagram) { diagram.circles.clear(); }},
    {"hidden",
     {{"circle", 0}, {"by", 1}},
     [](const Values& v, Diagram& diagram) {
       diagram.hidden.push_back({index(v[0]), index(v[1])});
     },
     [](Diagram& diagram) { diagram.hidden.clear(); }},
    {"vertices",
     {{"x", 0, 1, !kArray, kReal}, {"y", 1, 1, !kArray, kReal}, {"r", 2, 1, !kArray, kReal}, {"circles", 3, 3, kArray}},
     [](const Values& v, Diagram& diagram) {
       diagram.vertices.push_back({v[0], v[1], v[2]});
       diagram.vertexCircles.push_back({index(v[3]), index(v[4]), index(v[5])});
     },
     [](Diagram& diagram) {
       diagram.vertices.clear();
       diagram.vertexCircles.clear();
     }},
    {"edges",
     {{"circles", 0, 2, kArray}, {"vertices", 2, 2, kArray}},
     [](const Values& v, Diagram& diagram) {
       diagram.edges.push_back({index(v[0]), index(v[1]), index(v[2]), index(v[3])});
     },
     [](Diagram& diagram) { diagram.edges.clear(); }},
    {"hull",
     {{"", 0}},
     [](const Values& v, Diagram& diagram) { diagram.hull.push_back(index(v[0])); },
     [](Diagram& diagram) { diagram.hull.clear(); }},
}};

class DiagramReader {
 public:
  DiagramReader(std::string_view text, Keep keep) : reader_(text), text_(text), keep_(keep) {}

  void read() {
    expect(JsonKind::object, [] { return "an object"; });
    reader_.enterObject();
    while (const auto key = reader_.nextKey()) readMember(*key);
    if (!hasFormat_) reader_.fail("there is no format; a diagram has \"format\": \"circle-voronoi\".");
    if (!hasVersion_) reader_.fail("there is no version.");
    for (std::size_t i = 0; i < kSections.size(); ++i) {
      if (!hasSection_[i]) reader_.fail("there is no list of " + std::string(kSections[i].key) + ".");
    }
    reader_.finish();
  }

  Diagram diagram;
  CircleAttributes attributes;
  bool isPeriodic = false;
  std::vector<std::size_t> circleOffsets;  ///< where each circle ends in the text

 private:
  /// Fails unless the next value is of that kind. `what` names the expected value.
  template <class What>
  void expect(JsonKind kind, What what) {
    const JsonKind found = reader_.kind();
    if (found != kind) reader_.fail("expected " + std::string(what()) + ", not " + std::string(nameOf(found)) + ".");
  }

  void readMember(std::string_view key) {
    const auto section = std::ranges::find(kSections, key, &Section::key);
    if (section != kSections.end()) {
      hasSection_[static_cast<std::size_t>(section - kSections.begin())] = true;
      readSection(*section);
    } else if (key == "format") {
      hasFormat_ = true;
      readFormat();
    } else if (key == "version") {
      hasVersion_ = true;
      expect(JsonKind::number, [] { return "a number for version"; });
      if (reader_.number() != kVersion) reader_.fail("the version is not 1, the only one that can be read.");
    } else if (key == "metric") {
      readMetric();
    } else if (key == "weights") {
      expect(JsonKind::boolean, [] { return "true or false for weights"; });
      diagram.weights = reader_.boolean();
    } else if (key == "stats") {
      diagram.stats = readStats(reader_);
    } else if (key == "lattice") {
      isPeriodic = true;
      reader_.skip();
    } else if (key == "collection" && keep_ == Keep::attributes) {
      attributes.collection.clear();
      if (reader_.kind() != JsonKind::object) return reader_.skip();
      attributes.collection = readMembers(reader_, text_);
    } else {
      reader_.skip();
    }
  }

  void readFormat() {
    expect(JsonKind::string, [] { return "a string for format"; });
    const std::string format(reader_.string());
    if (format != kFormat) {
      reader_.fail("the format is \"" + format + "\", not \"" + std::string(kFormat) + "\".");
    }
  }

  void readMetric() {
    expect(JsonKind::string, [] { return "a string for metric"; });
    const std::string name(reader_.string());
    const auto metric = metricFromName(name);
    if (metric) {
      diagram.metric = *metric;
      return;
    }
    reader_.fail("there is no metric \"" + name + "\"; it is circles, centers or power.");
  }

  void readSection(const Section& section) {
    expect(JsonKind::array, [&] { return "an array for " + std::string(section.key); });
    const bool isOfCircles = &section == kSections.data();
    // The last value of a key that is given twice counts, as in all of JSON.
    section.clear(diagram);
    if (isOfCircles) {
      attributes = {.collection = std::move(attributes.collection)};
      circleOffsets.clear();
    }
    reader_.enterArray();
    for (item_ = 0; reader_.nextItem(); ++item_) {
      if (section.isPlain()) {
        readValue(section, section.fields.front(), values_.front());
      } else {
        readItem(section);
      }
      section.add(values_, diagram);
      if (isOfCircles) circleOffsets.push_back(reader_.offset());
    }
    if (!isOfCircles) return;
    for (auto* list : {&attributes.properties, &attributes.ids, &attributes.heights}) {
      const bool isUsed = std::ranges::any_of(*list, [](const std::string& entry) { return !entry.empty(); });
      list->resize(isUsed ? item_ : 0);
    }
  }

  /// Reads a member of circle `item_` other than its numbers. A value of another kind counts as none.
  void readAttribute(std::string_view key) {
    const bool isId = key == "id";
    const bool isHeight = key == "z";
    if (keep_ == Keep::circles || !(isId || isHeight || key == "properties")) return reader_.skip();
    const JsonKind kind = reader_.kind();
    auto& list = isId ? attributes.ids : isHeight ? attributes.heights : attributes.properties;
    list.resize(item_ + 1);
    list[item_].clear();
    if (isId || isHeight) {
      const bool isRight = kind == JsonKind::number || (isId && kind == JsonKind::string);
      std::string value = rawValue(reader_, text_);
      if (isRight) list[item_] = std::move(value);
    } else if (kind == JsonKind::object) {
      list[item_] = readMembers(reader_, text_);
    } else {
      reader_.skip();
    }
  }

  void readItem(const Section& section) {
    expect(JsonKind::object, [&] { return "an object for " + nameOfItem(section); });
    std::array<bool, kMostValues> isGiven{};  // of each field, at its first value
    auto next = section.fields.begin();       // fields mostly come in this order
    reader_.enterObject();
    while (true) {
      auto field = next;
      if (next == section.fields.end() || !reader_.nextKeyIs(next->key)) {
        const auto key = reader_.nextKey();
        if (!key) break;
        field = std::ranges::find(section.fields, *key, &Field::key);
        if (field == section.fields.end()) {
          if (&section == kSections.data()) {
            readAttribute(*key);
          } else {
            reader_.skip();
          }
          continue;
        }
      }
      if (field == next) ++next;
      isGiven[field->first] = true;
      readField(section, *field);
    }
    for (const Field& field : section.fields) {
      if (!isGiven[field.first]) reader_.fail(nameOfItem(section) + " has no " + std::string(field.key) + ".");
    }
  }

  void readField(const Section& section, const Field& field) {
    if (!field.isArray) return readValue(section, field, values_[field.first]);
    const auto numbers = [&] { return std::to_string(field.size) + " numbers for " + nameOfField(section, field); };
    expect(JsonKind::array, numbers);
    std::size_t count = 0;
    reader_.enterArray();
    while (count < field.size && reader_.nextItem()) readValue(section, field, values_[field.first + count++]);
    if (count < field.size || reader_.nextItem()) reader_.fail("expected " + numbers() + ".");
  }

  void readValue(const Section& section, const Field& field, double& value) {
    expect(JsonKind::number, [&] { return "a number for " + nameOfField(section, field); });
    if (!field.isIndex) {
      value = reader_.number();
    } else if (const auto index = reader_.whole<std::int32_t>()) {
      value = *index;
    } else {
      reader_.fail(nameOfField(section, field) + " is no index.");
    }
  }

  /// "vertices[3]"
  std::string nameOfItem(const Section& section) const {
    return std::string(section.key) + "[" + std::to_string(item_) + "]";
  }
  std::string nameOfField(const Section& section, const Field& field) const {
    return (field.key.empty() ? "" : std::string(field.key) + " of ") + nameOfItem(section);
  }

  JsonReader reader_;
  std::string_view text_;
  Keep keep_;
  bool hasFormat_ = false;
  bool hasVersion_ = false;
  std::array<bool, kSections.size()> hasSection_{};
  std::size_t item_ = 0;
  Values values_{};
};

}  // namespace

namespace {

Result<DiagramFile> readKept(std::string_view text, std::string_view name, Keep keep) {
  return guarded([&]() -> Result<DiagramFile> {
    const auto content = contentOf(text, name);
    if (!content) return content.error();
    const std::string_view rest = content.value();
    DiagramReader reader(rest, keep);
    try {
      reader.read();
    } catch (const ReadError& failure) {
      return errorAt(name, rest, failure);
    }
    if (const auto judged = validate(reader.diagram.circles, reader.diagram.weights, reader.diagram.metric); !judged) {
      return errorAtCircle(judged.error(), reader.circleOffsets, name, rest);
    }
    const bool haveAreas = isArea(reader.diagram.weights, reader.diagram.metric);
    for (Circle& c : reader.diagram.circles) c = haveAreas ? roundedWithArea(c) : rounded(c);
    linkSides(reader.diagram);
    return DiagramFile{std::move(reader.diagram), std::move(reader.attributes), reader.isPeriodic};
  });
}

}  // namespace

Result<Diagram> readDiagram(std::string_view text, std::string_view name) {
  // Copying an error may run out of memory, too.
  return guarded([&]() -> Result<Diagram> {
    auto file = readKept(text, name, Keep::circles);
    if (!file) return file.error();
    return std::move(file.value().diagram);
  });
}

Result<DiagramFile> readDiagramFile(std::string_view text, std::string_view name) {
  return readKept(text, name, Keep::attributes);
}

}  // namespace circle_voronoi
