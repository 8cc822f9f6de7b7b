// SPDX-License-Identifier: GPL-3.0-or-later
// Members of JSON documents, however they are written, go through every format: what a writer writes is JSON for
// another parser, and reads back with the same members.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "lines.h"
#include "random.h"
#include "report.h"

namespace circle_voronoi {
namespace {

using Json = nlohmann::json;
using Strings = std::vector<std::string>;
/// The values of members by their names.
using Values = std::map<std::string, Json>;

constexpr std::size_t kDocuments = 1000;

const std::vector<Circle> kDescribed = {{0, 0, 1}, {6.5, 0.25, 1.5}, {0, 8, 0.1}};

const Strings kMemberNames = {
    "a",       "A",        " a",       "a ",     "é",        "日本", "🙂",   "a \"b\"",      "back\\slash", "a\nb",
    "\t",      "\x01",     "{}",       "[1]",    ",",        "NA",   "#1",     "the option r", "cx",          "lon",
    "LON",     "latitude", "rad",      "RAD",    "id",       "z",    "area",   "neighbors",    "circle",      "type",
    "clipped", "bbox",     "features", "format", "geometry", "",     "input_", "properties",   "hiddenBy"};
/// Names that other names get when these mean something else.
const Strings kOwnNames = {"x", "X", "y", "r", "R", "input_x", "input_r", "input_R", "input_input_r", "input_id"};

const Strings kValueTexts = {"",     "a",       " ",    " a ",  "0",    "-1.5", "1e5",  "NA",          "null",
                             "true", "a,b",     "a;b",  "\"",   "\"\"", "é",    "🙂", "line\r\nend", "\n",
                             "\\",   "\\u0041", "\x1F", "\x7F", "<&>",  "it's", "+5",   ".5"};

/// Writes random documents.
class Documents {
 public:
  explicit Documents(Random& random) : random_(random) {}

  std::string space() {
    static const Strings kSpaces = {"", "", "", " ", "  ", "\n", "\t", "\r\n", " \n "};
    return one(kSpaces);
  }

  /// Writes a text with random escapes.
  std::string string(const std::string& text) {
    std::string result = "\"";
    const bool isEscaped = random_.below(3) == 0;
    for (const char c : text) {
      const auto code = static_cast<unsigned char>(c);
      if (code < 0x20 || c == '"' || c == '\\' || (code < 0x80 && isEscaped && random_.below(2) == 0)) {
        constexpr const char* kHex = "0123456789abcdefABCDEF";
        result += "\\u00";
        result += kHex[code >> 4];
        result += kHex[code & 15];
      } else {
        result += c;
      }
    }
    return result + "\"";
  }

  std::string number() {
    static const Strings kNumbers = {"0", "-0", "1", "-17", "1.50", "1E5", "2e-7", "0.1", "12345678901234567890"};
    return one(kNumbers);
  }

  std::string structure(int depth = 0) {
    const bool isObject = random_.below(2) == 0;
    std::string result(1, isObject ? '{' : '[');
    const std::size_t count = depth > 2 ? 0 : random_.below(3);
    for (std::size_t k = 0; k < count; ++k) {
      result += (k > 0 ? "," : "") + space();
      if (isObject) result += string(one(kMemberNames)) + space() + ":" + space();
      result += value(depth + 1) + space();
    }
    return result + space() + (isObject ? '}' : ']');
  }

  std::string value(int depth = 0) {
    switch (random_.below(5)) {
      case 0:
        return "null";
      case 1:
        return random_.below(2) == 0 ? "true" : "false";
      case 2:
        return number();
      case 3:
        return string(one(kValueTexts));
      default:
        return structure(depth);
    }
  }

  /// A value of the kind that all values of this name have in a table.
  std::string valueOfColumn(const std::string& name) {
    if (random_.below(6) == 0) return "null";
    switch (std::accumulate(name.begin(), name.end(), 0U,
                            [](unsigned sum, char c) { return sum + static_cast<unsigned char>(c); }) %
            4) {
      case 0:
        return random_.below(2) == 0 ? "true" : "false";
      case 1:
        return number();
      case 2:
        return string(one(kValueTexts));
      default:
        return structure();
    }
  }

  /// Random members, some of them given twice. `values` gets the last value of each.
  template <class ValueOf>
  std::string members(const Strings& names, Values& values, ValueOf valueOf) {
    std::string result;
    for (std::size_t k = random_.below(7); k > 0; --k) {
      const std::string name = one(names);
      const std::string text = valueOf(name);
      values[name] = Json::parse(text);
      result += (result.empty() ? "" : ",") + space() + string(name) + space() + ":" + space() + text + space();
    }
    return result.empty() ? space() : result;
  }

  const std::string& one(const Strings& list) { return list[random_.below(list.size())]; }

 private:
  Random& random_;
};

/// Expects that members have these values, each under its name or with `input_` in front. Of a table, null is as good
/// as nothing.
void expectValues(const std::string& members, const Values& expected, bool isTable, const std::string& where) {
  const std::string text = "{" + members + "}";
  ASSERT_TRUE(Json::accept(text)) << where << "\n" << text;
  Json found = Json::parse(text);
  for (const auto& [name, value] : expected) {
    std::string own = name;
    while (!(found.contains(own) && found[own] == value) && own.size() < name.size() + 30) own.insert(0, "input_");
    if (found.contains(own) && found[own] == value) {
      found.erase(own);
    } else {
      EXPECT_TRUE(isTable && value.is_null()) << where << "\n" << name << ": " << value << " is not in " << text;
    }
  }
  for (const auto& [name, value] : found.items()) {
    EXPECT_TRUE(isTable && value.is_null()) << where << "\n" << name << ": " << value << " is too much in " << text;
  }
}

std::string entryAt(const Strings& list, std::size_t i) { return list.empty() ? "" : list[i]; }

void expectAll(const CircleAttributes& attributes, const std::vector<Values>& expected, bool isTable,
               const std::string& where) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    expectValues(entryAt(attributes.properties, i), expected[i], isTable, where);
  }
}

Strings withoutNames(Strings names, const Strings& others) {
  std::erase_if(names, [&](const std::string& name) { return std::ranges::find(others, name) != others.end(); });
  return names;
}

using WriteCircles = Result<void> (*)(std::ostream&, std::span<const Circle>, const CircleAttributes&);

/// Writes circles, expects JSON unless it is a table, and reads them again.
CircleFile writtenAndRead(WriteCircles write, const CircleAttributes& attributes, const std::string& where) {
  std::ostringstream out;
  const auto written = write(out, kDescribed, attributes);
  EXPECT_TRUE(written) << written.error().message << "\n" << where;
  if (write != writeCirclesCsv) {
    EXPECT_TRUE(Json::accept(out.str())) << where << "\n" << out.str();
  }
  auto read = readCircleFile(out.str(), "written", {});
  EXPECT_TRUE(read) << read.error().message << "\n" << where << "\n" << out.str();
  if (!read) return {};
  EXPECT_EQ(read->circles, kDescribed);
  return *std::move(read);
}

/// A document of circles as JSON objects or GeoJSON points.
std::string circlesDocument(Documents& documents, bool isGeoJson, const std::vector<std::string>& members,
                            const std::string& collection) {
  std::string items;
  for (std::size_t i = 0; i < kDescribed.size(); ++i) {
    const auto& [x, y, r] = kDescribed[i];
    const std::string comma = members[i].find(':') == std::string::npos ? "" : ",";
    const auto text = [](double number) { return Json(number).dump(); };
    items += (i > 0 ? "," : "") + documents.space();
    if (isGeoJson) {
      items += R"({"type":"Feature","properties":{"r":)" + text(r) + comma + members[i] +
               R"(},"geometry":{"type":"Point","coordinates":[)" + text(x) + "," + text(y) + "]}}";
    } else {
      items += R"({"x":)" + text(x) + R"(,"y":)" + text(y) + R"(,"r":)" + text(r) + comma + members[i] + "}";
    }
  }
  if (!isGeoJson) return "[" + items + "]";
  const std::string comma = collection.find(':') == std::string::npos ? "" : ",";
  return R"({"type":"FeatureCollection")" + comma + collection + R"(,"features":[)" + items + "]}";
}

TEST(Members, OfCirclesGoThroughEveryFormat) {
  const std::uint64_t seed = test::seedOr(5701);
  Random random(seed);
  Documents documents(random);
  for (std::size_t trial = 0; trial < kDocuments; ++trial) {
    const bool isGeoJson = trial % 2 == 0;
    const bool isTable = trial % 4 < 2;  // then all values of a name are of one kind
    Strings names = isTable ? withoutNames(kMemberNames, {"", "id", "z"}) : kMemberNames;
    if (isGeoJson) names.insert(names.end(), {"x", "y", "lat", "input_id"});
    // These may stand for numbers of the circle, or for the height or the id if they are of another kind in a table.
    std::vector<Values> expected(kDescribed.size());
    Strings members;
    for (Values& values : expected) {
      members.push_back(documents.members(names, values, [&](const std::string& name) {
        return isTable ? documents.valueOfColumn(name) : documents.value();
      }));
    }
    Values collectionValues;
    const Strings ofCollection = withoutNames(kMemberNames, {"type", "features", "bbox", "format"});
    const std::string collection =
        documents.members(ofCollection, collectionValues, [&](const std::string&) { return documents.value(); });
    const std::string text = circlesDocument(documents, isGeoJson, members, collection);
    const std::string where = "seed " + std::to_string(seed) + ", document " + std::to_string(trial) + ": " + text;
    const auto file = readCircleFile(text, "document", {});
    ASSERT_TRUE(file) << file.error().message << "\n" << where;
    expectAll(file->attributes, expected, false, where);
    const CircleFile json = writtenAndRead(writeCirclesJson, file->attributes, where);
    expectAll(json.attributes, expected, false, where);
    const CircleFile geoJson = writtenAndRead(writeCirclesGeoJson, file->attributes, where);
    expectAll(geoJson.attributes, expected, false, where);
    if (isGeoJson) {
      expectValues(geoJson.attributes.collection, collectionValues, false, where);
    }
    const CircleFile table = writtenAndRead(writeCirclesCsv, file->attributes, where);
    if (isTable) {
      expectAll(table.attributes, expected, true, where);
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Members, OfADiagramGoThroughEveryFormat) {
  const std::uint64_t seed = test::seedOr(5702);
  Random random(seed);
  Documents documents(random);
  const Diagram diagram = compute(kDescribed).value();
  std::ostringstream plain;
  ASSERT_TRUE(writeJson(plain, diagram));
  const Json lists = Json::parse(plain.str());
  Strings names = kMemberNames;
  names.insert(names.end(), kOwnNames.begin(), kOwnNames.end());
  for (std::size_t trial = 0; trial < kDocuments; ++trial) {
    const auto valueOf = [&](const std::string&) { return documents.value(); };
    std::vector<Values> expected(kDescribed.size());
    Values collection;
    std::string circles;
    for (std::size_t i = 0; i < kDescribed.size(); ++i) {
      const auto& [x, y, r] = kDescribed[i];
      const auto text = [](double number) { return Json(number).dump(); };
      circles += (i > 0 ? "," : "") + documents.space() + R"({"x":)" + text(x) + R"(,"y":)" + text(y) + R"(,"r":)" +
                 text(r) + R"(,"properties":{)" + documents.members(names, expected[i], valueOf) + "}}";
    }
    const std::string text = R"({"format":"circle-voronoi","version":1,"collection":{)" +
                             documents.members(names, collection, valueOf) + R"(},"circles":[)" + circles +
                             R"(],"hidden":)" + lists["hidden"].dump() + R"(,"vertices":)" + lists["vertices"].dump() +
                             R"(,"edges":)" + lists["edges"].dump() + R"(,"hull":)" + lists["hull"].dump() + "}";
    const std::string where = "seed " + std::to_string(seed) + ", document " + std::to_string(trial) + ": " + text;
    const auto file = readDiagramFile(text, "document");
    ASSERT_TRUE(file) << file.error().message << "\n" << where;
    expectAll(file->attributes, expected, false, where);
    expectValues(file->attributes.collection, collection, false, where);

    std::ostringstream again;
    ASSERT_TRUE(writeDiagramFile(again, diagram, file->attributes)) << where;
    ASSERT_TRUE(Json::accept(again.str())) << where << "\n" << again.str();
    const auto back = readDiagramFile(again.str(), "written");
    ASSERT_TRUE(back) << back.error().message << "\n" << where;
    EXPECT_EQ(back->attributes.properties, file->attributes.properties);
    EXPECT_EQ(back->attributes.collection, file->attributes.collection);

    expectAll(writtenAndRead(writeCirclesJson, file->attributes, where).attributes, expected, false, where);
    const CircleFile points = writtenAndRead(writeCirclesGeoJson, file->attributes, where);
    expectAll(points.attributes, expected, false, where);
    for (const char* own : {"type", "features", "bbox"}) collection.erase(own);
    expectValues(points.attributes.collection, collection, false, where);
    (void)writtenAndRead(writeCirclesCsv, file->attributes, where);

    for (const bool areLines : {false, true}) {
      std::ostringstream cells;
      const ExportOptions options{.attributes = &file->attributes};
      ASSERT_TRUE(areLines ? writeGeoJsonLines(cells, diagram, options) : writeGeoJson(cells, diagram, options));
      Json features;
      if (areLines) {
        for (const std::string& line : test::linesOf(cells.str())) {
          ASSERT_TRUE(Json::accept(line)) << where << "\n" << line;
          features.push_back(Json::parse(line));
        }
      } else {
        ASSERT_TRUE(Json::accept(cells.str())) << where << "\n" << cells.str();
        features = Json::parse(cells.str())["features"];
      }
      ASSERT_EQ(features.size(), kDescribed.size());
      for (std::size_t i = 0; i < kDescribed.size(); ++i) {
        Json properties = features[i]["properties"];
        for (const char* own : {"circle", "r", "area", "clipped", "neighbors"}) properties.erase(own);
        const std::string members = properties.dump();
        expectValues(members.substr(1, members.size() - 2), expected[i], false, where);
      }
    }
    if (testing::Test::HasFailure()) return;
  }
}

TEST(Members, OfAnEmptyObjectAreNone) {
  for (const char* space : {"", " ", "\n", "\t \r\n"}) {
    const std::string text = R"({"format":"circle-voronoi","version":1,"collection":{)" + std::string(space) +
                             R"(},"circles":[{"x":0,"y":0,"r":1,"properties":{)" + space +
                             R"(}}],"hidden":[],"vertices":[],"edges":[],"hull":[0]})";
    const auto file = readDiagramFile(text, "test");
    ASSERT_TRUE(file) << file.error().message;
    EXPECT_TRUE(file->attributes.empty());
  }
}

TEST(Members, ThatAreNotJsonAreRefusedByEveryWriter) {
  const std::vector<Circle> circles = {{0, 0, 1}, {5, 0, 1}};
  const Diagram diagram = compute(circles).value();
  const std::vector<CircleAttributes> wrong = {{.properties = {"", "\"a\":NaN"}},
                                               {.properties = {"\"a\":1", "}"}},
                                               {.properties = {"\"a\":1}, {\"b\":2", ""}},
                                               {.properties = {"\"a\":\n1", ""}},
                                               {.properties = {"\"\\ud800\":1", ""}},
                                               {.ids = {"1", "a"}},
                                               {.ids = {"[1]", "1"}},
                                               {.heights = {"\"1\"", "1"}},
                                               {.heights = {"1e999", "1"}},
                                               {.collection = "\"a\""},
                                               {.collection = "\"a\":1,"}};
  for (const CircleAttributes& attributes : wrong) {
    std::ostringstream out;
    const std::vector<Result<void>> results = {writeCirclesCsv(out, circles, attributes),
                                               writeCirclesJson(out, circles, attributes),
                                               writeCirclesGeoJson(out, circles, attributes),
                                               writeDiagramFile(out, diagram, attributes),
                                               writeGeoJson(out, diagram, {.attributes = &attributes}),
                                               writeGeoJsonLines(out, diagram, {.attributes = &attributes})};
    for (const Result<void>& result : results) {
      ASSERT_FALSE(result);
      EXPECT_EQ(result.error().code, ErrorCode::badInput) << result.error().message;
    }
    EXPECT_EQ(out.str(), "");
  }
}

}  // namespace
}  // namespace circle_voronoi
