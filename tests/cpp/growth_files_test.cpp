// SPDX-License-Identifier: GPL-3.0-or-later
// The costs of readers and writers: n log n steps in the size of the text.
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/final_cells.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/tile.h"
#include "growth.h"
#include "steps.h"

namespace circle_voronoi::test {
namespace {

constexpr std::size_t kSize = 1000;

/// A text of a given size.
struct TextFamily {
  std::string_view name;
  std::string (*make)(std::size_t size);
};

std::string repeated(std::string_view text, std::size_t count) {
  std::string result;
  for (std::size_t k = 0; k < count; ++k) result += text;
  return result;
}

/// Items with a number each, by `item(k)`, and commas between them.
template <class Item>
std::string listed(std::size_t count, Item item) {
  std::string result;
  for (std::size_t k = 0; k < count; ++k) result += std::string(k > 0 ? "," : "") + item(std::to_string(k));
  return result;
}

std::string point(const std::string& more, const std::string& x = "1") {
  return R"({"type":"Feature","geometry":{"type":"Point","coordinates":[)" + x + R"(,2]},"properties":{"r":0.5)" +
         more + "}}";
}

std::string collection(const std::string& features, const std::string& more = "") {
  return R"({"type":"FeatureCollection")" + more + R"(,"features":[)" + features + "]}";
}

std::string square(const std::string& k) {
  return "[[" + k + ",0],[" + k + ".5,0],[" + k + ".5,1],[" + k + ",1],[" + k + ",0]]";
}

const std::vector<TextFamily> kCircleTexts = {
    {"rows", [](std::size_t n) { return "x,y,r,id,name\n" + repeated("1,2,3,4,a b\n", n); }},
    {"rows without names", [](std::size_t n) { return repeated("1 2 3\n", n); }},
    {"columns",
     [](std::size_t n) {
       return "x,y,r," + listed(n, [](const std::string& k) { return "a" + k; }) + "\n1,2,3" + repeated(",0", n) + "\n";
     }},
    {"equal names", [](std::size_t n) { return "x,y,r" + repeated(",a", n) + "\n1,2,3" + repeated(",0", n) + "\n"; }},
    {"names with equal numbers",
     [](std::size_t n) {
       return "x,y,r" + repeated(",a,a_2,a_2_2", n / 3) + "\n1,2,3" + repeated(",0,0,0", n / 3) + "\n";
     }},
    {"no names", [](std::size_t n) { return "x,y,r" + repeated(",", n) + "\n1,2,3" + repeated(",0", n) + "\n"; }},
    {"separators", [](std::size_t n) { return "x,y,r,\"" + repeated("; |\t", n) + "\"\n1,2,3,4\n"; }},
    {"quotation marks", [](std::size_t n) { return "x,y,r,a\n1,2,3,\"" + repeated("\"\"", 10 * n) + "\"\n"; }},
    {"lines of a field", [](std::size_t n) { return "x,y,r,a\n1,2,3,\"" + repeated("a\n", 10 * n) + "\"\n"; }},
    {"comments", [](std::size_t n) { return repeated("# comment\n", n) + "x,y,r\n1,2,3\n"; }},
    {"rows refused", [](std::size_t n) { return "x,y,r,id\n1,2,3,4\n" + repeated("1,2,no,7\n", n); }},
    {"fields refused", [](std::size_t n) { return "x,y,r\n1,2,3\n1,2," + std::string(30 * n, 'a') + "\n"; }},
    {"arrays", [](std::size_t n) { return "[" + listed(n, [](const std::string&) { return "[1,2,3]"; }) + "]"; }},
    {"objects",
     [](std::size_t n) {
       return "[" + listed(n, [](const std::string& k) { return R"({"x":1,"y":2,"r":3,"id":)" + k + "}"; }) + "]";
     }},
    {"members",
     [](std::size_t n) {
       return R"([{"x":1,"y":2,"r":3,)" + listed(n, [](const std::string& k) { return "\"a" + k + "\":1"; }) + "}]";
     }},
    {"equal members",
     [](std::size_t n) {
       return R"([{"x":1,"y":2,"r":3,)" + listed(n, [](const std::string&) { return "\"a\":1,\"x\":1,\"id\":1"; }) +
              "}]";
     }},
    {"nested arrays",
     [](std::size_t n) {
       return R"([{"x":1,"y":2,"r":3,"a":)" + repeated("[", 10 * n) + repeated("]", 10 * n) + "}]";
     }},
    {"escapes", [](std::size_t n) { return R"([{"x":1,"y":2,"r":3,"a":")" + repeated("\\u00e9", n) + "\"}]"; }},
    {"items after a long text",
     [](std::size_t n) {
       return R"([{"\u0061)" + repeated("long", n) + R"(":0,"x":1,"y":2,"r":3},)" +
              listed(n, [](const std::string&) { return R"({"x":1,"y":2,"r":3})"; }) + "]";
     }},
    {"items refused",
     [](std::size_t n) {
       return "[[1,2,3]," + listed(n, [](const std::string&) { return R"({"x":1,"y":"no"})"; }) + "]";
     }},
    {"features", [](std::size_t n) { return collection(listed(n, [](const std::string&) { return point(""); })); }},
    {"features after a long text",
     [](std::size_t n) {
       return collection(point(R"(,"\u0061)" + repeated("long", n) + "\":1") + "," +
                         listed(n, [](const std::string& k) { return point("", k); }));
     }},
    {"properties",
     [](std::size_t n) {
       return collection(point("," + listed(n, [](const std::string& k) { return "\"a" + k + "\":1"; })));
     }},
    {"members of a collection",
     [](std::size_t n) {
       return collection(point(""), "," + listed(n, [](const std::string& k) { return "\"a" + k + "\":1"; }));
     }},
    {"positions of a point", [](std::size_t n) { return collection(point("", "1,2" + repeated(",3", n))); }},
};

const std::vector<TextFamily> kRegionTexts = {
    {"corners",
     [](std::size_t n) {
       std::string ring;
       for (std::size_t k = 0; k < n; ++k) ring += std::to_string(k) + " " + std::to_string(k * k % 7) + ",";
       return "POLYGON((" + ring + std::to_string(n) + " -9,0 -9))";
     }},
    {"polygons in WKT",
     [](std::size_t n) {
       return "MULTIPOLYGON(" +
              listed(n, [](const std::string& k) { return "((" + k + " 0," + k + ".5 0," + k + ".5 1))"; }) + ")";
     }},
    {"polygons",
     [](std::size_t n) {
       return R"({"type":"MultiPolygon","coordinates":[)" +
              listed(n, [](const std::string& k) { return "[" + square(k) + "]"; }) + "]}";
     }},
    {"features",
     [](std::size_t n) {
       return collection(listed(n, [](const std::string& k) {
         return R"({"type":"Feature","properties":{"a":1},"geometry":{"type":"Polygon","coordinates":[)" + square(k) +
                "]}}";
       }));
     }},
    {"equal members",
     [](std::size_t n) {
       return R"({"type":"Polygon",)" +
              listed(n, [](const std::string& k) { return "\"coordinates\":[" + square(k) + "]"; }) + "}";
     }},
};

/// Expects n log n steps of work on a text.
void expectTextGrowth(std::string_view function, const TextFamily& family,
                      const std::function<void(std::string_view)>& work) {
  SCOPED_TRACE(function);
  expectGrowth(family.name, kSize, [&](std::size_t size) {
    const std::string text = family.make(size);
    return static_cast<double>(stepsOf([&] { work(text); }));
  });
}

TEST(GrowthOfFiles, OfCirclesRead) {
  for (const TextFamily& family : kCircleTexts) {
    expectTextGrowth("readCircleFile", family,
                     [](std::string_view text) { (void)readCircleFile(text, "test", {.skipInvalid = true}); });
    expectTextGrowth("readCircles", family, [](std::string_view text) { (void)readCircles(text, "test"); });
    expectTextGrowth("holdsDiagram", family, [](std::string_view text) { (void)holdsDiagram(text); });
  }
}

TEST(GrowthOfFiles, OfRegionsRead) {
  for (const TextFamily& family : kRegionTexts) {
    expectTextGrowth("readRegion", family, [](std::string_view text) { (void)readRegion(text, "test"); });
  }
}

TEST(GrowthOfFiles, OfTilesReadInPieces) {
  for (const TextFamily& family : kCircleTexts) {
    if (family.make(1).find_first_of("[{") == 0) continue;
    for (const std::size_t piece : {std::size_t{7}, std::size_t{1000}}) {
      expectTextGrowth("TileStream", family, [&](std::string_view text) {
        TileStream stream("test");
        for (std::size_t at = 0; at < text.size(); at += piece) {
          if (!stream.read(text.substr(at, piece))) return;
        }
        (void)stream.end();
      });
    }
  }
}

TEST(GrowthOfFiles, OfAttributesWritten) {
  for (const TextFamily& family : kCircleTexts) {
    for (const auto write : {writeCirclesCsv, writeCirclesJson, writeCirclesGeoJson}) {
      expectGrowth(family.name, kSize, [&](std::size_t size) {
        const auto file = readCircleFile(family.make(size), "test", {.skipInvalid = true}).value_or({});
        std::ostringstream out;
        return static_cast<double>(stepsOf([&] { (void)write(out, file.circles, file.attributes); }));
      });
    }
  }
}

/// A diagram and attributes of its circles.
struct Described {
  Diagram diagram;
  CircleAttributes attributes;
};

Described described(const GrowthInput& input) {
  Described result{compute(input.circles).value(), {}};
  for (std::size_t i = 0; i < input.circles.size(); ++i) {
    result.attributes.properties.push_back(R"("area":1,"name":"a\u0062c","number":)" + std::to_string(i));
    result.attributes.ids.push_back(std::to_string(i));
  }
  return result;
}

TEST(GrowthOfFiles, OfDiagramsWrittenAndRead) {
  using Write = Result<void> (*)(std::ostream&, const Diagram&, const CircleAttributes&);
  const auto promise = [](std::string_view name, std::string_view header, Write write) {
    expectGrowth({name, header,
                  [write](const GrowthInput& input) {
                    return [write, all = kept(described(input))] {
                      std::ostringstream out;
                      ASSERT_TRUE(write(out, all->diagram, all->attributes));
                    };
                  },
                  circleFamilies()});
  };
  promise("writeDiagramFile", "io.h", [](auto& out, const auto& diagram, const auto& attributes) {
    return writeDiagramFile(out, diagram, attributes);
  });
  promise("writeDiagramCsv", "export.h",
          [](auto& out, const auto& diagram, const auto&) { return writeDiagramCsv(out, diagram); });
  promise("writeSvg", "export.h", [](auto& out, const auto& diagram, const auto&) { return writeSvg(out, diagram); });
  promise("writeGeoJson", "export.h", [](auto& out, const auto& diagram, const auto& attributes) {
    return writeGeoJson(out, diagram, {.attributes = &attributes});
  });
  promise("writeWkt", "export.h", [](auto& out, const auto& diagram, const auto&) { return writeWkt(out, diagram); });
  promise("writeObj", "export.h", [](auto& out, const auto& diagram, const auto&) { return writeObj(out, diagram); });
  expectGrowth({"readDiagramFile", "io.h",
                [](const GrowthInput& input) {
                  const Described all = described(input);
                  std::ostringstream out;
                  EXPECT_TRUE(writeDiagramFile(out, all.diagram, all.attributes));
                  return [text = kept(out.str())] { ASSERT_TRUE(readDiagramFile(*text, "test")); };
                },
                circleFamilies()});
}

TEST(GrowthOfFiles, OfTiles) {
  expectGrowth({"finalCells, writePartsCsv, writePartsGeoJsonLines", "tile.h", ofDiagram([](const Diagram& diagram) {
                  const FinalCells final = finalCells(diagram, {exportBox(diagram.circles)}).value();
                  std::ostringstream out;
                  std::vector<std::uint8_t> isFinal(diagram.circles.size());
                  for (std::size_t i = 0; i < isFinal.size(); ++i) {
                    isFinal[i] = final.isFinal(CircleIndex(static_cast<std::int32_t>(i)));
                  }
                  ASSERT_TRUE(writePartsCsv(out, diagram, {{}, isFinal}));
                  ASSERT_TRUE(writePartsGeoJsonLines(out, diagram, {{}, isFinal}));
                }),
                circleFamilies()});
}

}  // namespace
}  // namespace circle_voronoi::test
