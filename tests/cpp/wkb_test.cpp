// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons in well-known binary. tests/files/readings.json has points.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/io.h"
#include "circle_voronoi/region.h"

namespace circle_voronoi {
namespace {

using Ring = std::vector<Point>;

/// Writes well-known binary in hexadecimal digits.
struct Wkb {
  bool isLittle = true;
  std::string hex = {};

  Wkb& byte(unsigned value) {
    constexpr std::string_view kDigits = "0123456789abcdefABCDEF";
    hex += {kDigits[value / 16], kDigits[value % 16]};
    return *this;
  }
  template <class Number>
  Wkb& number(Number value) {
    std::array<unsigned char, sizeof(Number)> bytes{};
    std::memcpy(bytes.data(), &value, sizeof(Number));
    if (isLittle != (std::endian::native == std::endian::little)) std::ranges::reverse(bytes);
    for (const unsigned char one : bytes) byte(one);
    return *this;
  }
  Wkb& geometry(std::uint32_t type) { return byte(isLittle ? 1 : 0).number(type); }
  /// The rings of a polygon, with `more` numbers after x and y.
  Wkb& rings(const std::vector<Ring>& all, int more = 0) {
    number(static_cast<std::uint32_t>(all.size()));
    for (const Ring& ring : all) {
      number(static_cast<std::uint32_t>(ring.size()));
      for (const auto& [x, y] : ring) {
        number(x).number(y);
        for (int k = 0; k < more; ++k) number(1.5 * k);
      }
    }
    return *this;
  }
};

const std::vector<Ring> kSquareWithHole = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}},
                                           {{1, 1}, {1, 2}, {2.25, 0x1p-40}, {1, 1}}};

double areaOf(const std::string& text) {
  const auto region = readRegion(text, "test");
  EXPECT_TRUE(region) << text << ": " << region.error().message;
  return region ? region->area() : 0;
}

TEST(Wkb, IsReadLikeWellKnownText) {
  const auto expected = Region::fromRings(kSquareWithHole).value();
  for (const bool isLittle : {true, false}) {
    for (const auto& [type, more] : {std::pair(3U, 0), std::pair(1003U, 1), std::pair(2003U, 1), std::pair(3003U, 2),
                                     std::pair(0x80000003U, 1), std::pair(0xC0000003U, 2)}) {
      const std::string hex = Wkb{isLittle}.geometry(type).rings(kSquareWithHole, more).hex;
      for (const std::string& text : {hex, "\n " + hex + "\r\n"}) {
        const auto region = readRegion(text, "test");
        ASSERT_TRUE(region) << region.error().message;
        EXPECT_TRUE(std::ranges::equal(region->points(), expected.points())) << "to the bit";
        EXPECT_TRUE(std::ranges::equal(region->ringOffsets(), expected.ringOffsets()));
      }
    }
  }
}

TEST(Wkb, HasSeveralPolygonsInEitherByteOrder) {
  Wkb polygons = Wkb{}.geometry(0x20000006U).number(std::uint32_t{25832}).number(std::uint32_t{2});
  polygons.hex += Wkb{}.geometry(3).rings({{{0, 0}, {1, 0}, {0, 1}, {0, 0}}}).hex;
  polygons.hex += Wkb{false}.geometry(3).rings({{{5, 5}, {6, 5}, {5, 6}, {5, 5}}}).hex;
  EXPECT_EQ(areaOf(polygons.hex), 1);
  Wkb collection = Wkb{false}.geometry(7).number(std::uint32_t{3});
  collection.hex += Wkb{}.geometry(6).number(std::uint32_t{0}).hex + Wkb{}.geometry(3).rings({}).hex + polygons.hex;
  EXPECT_EQ(areaOf(collection.hex), 1);
}

// ST_AsHexEWKB in the manual of PostGIS.
TEST(Wkb, OfPostGisIsRead) {
  EXPECT_EQ(
      areaOf("0103000020E61000000100000005000000000000000000000000000000000000000000000000000000000000000000F0"
             "3F000000000000F03F000000000000F03F000000000000F03F000000000000000000000000000000000000000000000000"),
      1);
}

TEST(Wkb, IsRefusedWithTheReason) {
  const std::string polygon = Wkb{}.geometry(3).rings(kSquareWithHole).hex;
  std::string nested;
  for (int k = 0; k < 1'000; ++k) nested += Wkb{}.geometry(7).number(std::uint32_t{1}).hex;
  for (const auto& [text, message] : std::vector<std::pair<std::string, std::string>>{
           {polygon.substr(0, polygon.size() - 2), "test:1: the geometry (WKB) ends too early."},
           {polygon.substr(0, polygon.size() - 1), "test:1: the geometry (WKB) ends too early."},
           {polygon + "00", "test:1: expected nothing after the geometry."},
           {Wkb{}.geometry(3).number(0xFFFFFFFFU).hex, "test:1: the geometry (WKB) ends too early."},
           {Wkb{}.geometry(17).hex, "test:1: there is no geometry (WKB) of the type 17."},
           {Wkb{}.geometry(1).number(1.0).number(2.0).hex, "test:1: expected GeoJSON, POLYGON or MULTIPOLYGON."},
           {Wkb{}.geometry(3).rings({}).hex, "test:1: the region is empty."},
           {Wkb{}.geometry(3).rings({{{0, 0}, {1, std::numeric_limits<double>::infinity()}, {1, 0}}}).hex,
            "test:1: a coordinate is not a finite number."},
           {nested, "test:1: collections are nested more than 100 deep."}}) {
    const auto region = readRegion(text, "test");
    ASSERT_FALSE(region) << text;
    EXPECT_EQ(region.error().message, message) << text;
  }
}

}  // namespace
}  // namespace circle_voronoi
