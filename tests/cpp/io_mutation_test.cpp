// SPDX-License-Identifier: GPL-3.0-or-later
// Random changes of good files, and random bytes: the readers survive them (read_anything.h).
#include <gtest/gtest.h>

#include <array>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi_families/families.h"
#include "random.h"
#include "read_anything.h"

namespace circle_voronoi {
namespace {

constexpr int kTrials = 10000;

/// Pieces of text that are likely to mean something to a reader.
constexpr auto kPieces = std::to_array<std::string_view>({"{",           "}",
                                                          "[",           "]",
                                                          ",",           ":",
                                                          ";",           "\"",
                                                          "\n",          "\r",
                                                          "\t",          " ",
                                                          "#",           "-",
                                                          "+",           "-0",
                                                          "0",           "1e999",
                                                          "-1",          "1e150",
                                                          "2e150",       "1,5",
                                                          "-0e-06",      "nan",
                                                          "inf",         "null",
                                                          "true",        "\\n",
                                                          "\\ud83d",     "\"x\"",
                                                          "\"r\": 1",    "\"circles\"",
                                                          "\"stats\"",   "\"type\": \"Feature\"",
                                                          "radius",      "x;y;r\n",
                                                          "\\",          "\xff",
                                                          "\xEF\xBB\xBF"});

std::string randomBytes(Random& random) {
  std::string text(random.below(60), ' ');
  for (char& c : text) c = static_cast<char>(random.below(256));
  return text;
}

/// The text with a random part cut out, doubled, or overwritten.
std::string changed(std::string text, Random& random) {
  for (std::size_t changes = 1 + random.below(4); changes > 0; --changes) {
    const std::size_t at = random.below(text.size() + 1);
    const std::size_t size = std::min<std::size_t>(random.below(20), text.size() - at);
    switch (random.below(4)) {
      case 0:
        text.erase(at, size);
        break;
      case 1:
        text.insert(at, text.substr(at, size));
        break;
      case 2:
        text.insert(at, kPieces[random.below(kPieces.size())]);
        break;
      default:
        text.replace(at, size, kPieces[random.below(kPieces.size())]);
    }
  }
  return text;
}

std::vector<std::string> goodTexts() {
  const auto circles = generate(Family::hidden, 6, 1);
  std::vector<std::string> texts;
  for (const auto write : {writeCirclesCsv, writeCirclesJson, writeCirclesGeoJson}) {
    std::ostringstream out;
    EXPECT_TRUE(write(out, circles, {}));
    texts.push_back(out.str());
  }
  texts.push_back("# trees\nname;cx;cy;rad\n\"oak; old\";1,5;2;3\n;-0;\"2,5\";0\n");
  Diagram diagram = compute(circles).value();
  diagram.stats.seconds = {.triangulate = 0.001, .certify = 1e-06, .total = 0.0015};  // fixed: equal in all runs
  std::ostringstream out;
  EXPECT_TRUE(writeJson(out, diagram));
  texts.push_back(out.str());
  return texts;
}

TEST(Readers, SurviveChangedFiles) {
  Random random(1);
  for (const std::string& good : goodTexts()) {
    ASSERT_EQ(fuzz::readAnything(good), std::nullopt);
    for (int i = 0; i < kTrials; ++i) {
      const std::string text = changed(good, random);
      ASSERT_EQ(fuzz::readAnything(text), std::nullopt) << text;
    }
  }
}

TEST(Readers, SurviveRandomBytes) {
  Random random(2);
  for (int i = 0; i < kTrials; ++i) {
    const std::string text = randomBytes(random);
    ASSERT_EQ(fuzz::readAnything(text), std::nullopt) << text;
    ASSERT_EQ(fuzz::readAnything("{" + text), std::nullopt) << text;
    ASSERT_EQ(fuzz::readAnything("[" + text), std::nullopt) << text;
  }
}

TEST(Readers, SurviveDeepNesting) {
  constexpr std::size_t kDepth = 100'000;
  std::string objects;
  std::string ends;
  for (std::size_t i = 0; i < kDepth; ++i) {
    objects += "{\"a\":";
    ends += "}";
  }
  for (const std::string begin :
       {R"({"type": "FeatureCollection", "features": )", R"({"type": "FeatureCollection", "features": [], "b": )",
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": )",
        R"({"type": "FeatureCollection", "features": [{"type": "Feature", "properties": {"b": )", R"({"stats": )",
        R"({"format": "circle-voronoi", "version": 1, "circles": [{"x": )", R"([{"x": )", R"([[1, 2, )", R"([{"b": )",
        ""}) {
    EXPECT_EQ(fuzz::readAnything(begin + objects + "1" + ends + "}"), std::nullopt);
    EXPECT_EQ(fuzz::readAnything(begin + objects), std::nullopt);
    EXPECT_EQ(fuzz::readAnything(begin + std::string(kDepth, '[')), std::nullopt);
    EXPECT_EQ(fuzz::readAnything(begin + std::string(kDepth, '[') + std::string(kDepth, ']') + "}"), std::nullopt);
  }
}

TEST(Readers, DeepNestingBesideTheCirclesIsNoError) {
  std::string deep;
  std::string ends;
  for (int i = 0; i < 100'000; ++i) {
    deep += "{\"a\":";
    ends += "}";
  }
  deep += "1" + ends;
  EXPECT_EQ(readCircles("[{\"x\": 1, \"y\": 2, \"r\": 3, \"more\": " + deep + "}]", "file").value().size(), 1U);
  EXPECT_EQ(readCircles(R"({"type": "FeatureCollection", "features": [{"type": "Feature", "id": )" + deep +
                            R"(, "geometry": {"type": "Point", "coordinates": [1, 2]}, "properties": {"r": 3}}]})",
                        "file")
                .value()
                .size(),
            1U);
  EXPECT_TRUE(readDiagram(R"({"format": "circle-voronoi", "version": 1, "more": )" + deep +
                              R"(, "circles": [], "hidden": [], "vertices": [], "edges": [], "hull": []})",
                          "file"));
}

}  // namespace
}  // namespace circle_voronoi
