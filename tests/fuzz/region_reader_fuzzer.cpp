// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target over what makes regions: readRegion, and the union of polygons. The first byte says which. With an
// even one the rest is the text of a file. With an odd one each two bytes are a point of a ring, on a small grid, so
// that sides are shared and touch, or a rounding step beside it; a byte of 255 ends a ring, one of 254 a polygon. If
// the remainder by 4 is 3, they are a ring of any numbers, and those after a byte of 255 say by how many units in the
// last place the corners of its copies are off. For all inputs,
// - a text is a region, or an error says so on one line;
// - polygons with `dissolve` are a region, or have no area;
// - a union is valid, is its own union, and contains the points that its polygons contain, except points on a side;
// - the union of copies has the area of one, but for the last places, and no more sides than their crossings make.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "circle_voronoi/io.h"
#include "circle_voronoi/region.h"
#include "rings.h"

namespace circle_voronoi::fuzz {
namespace {

using Ring = Region::Ring;
using Polygons = std::vector<std::vector<Ring>>;

constexpr RegionOptions kDissolve = {.dissolve = true};

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

void checkRegion(const Region& region) {
  const auto same = Region::fromArrays(region.points(), region.ringOffsets(), region.polygonOffsets());
  require(same.ok(), "a region is not valid: " + (same ? std::string() : same.error().message));
  require(region.area() >= 0, "an area is negative");
  for (const Point& p : region.points()) require(std::isfinite(p.x) && std::isfinite(p.y), "a point is not finite");
}

void tryText(std::string_view text) {
  for (const bool dissolve : {false, true}) {
    const auto region = readRegion(text, "text", {.dissolve = dissolve});
    if (region) {
      checkRegion(*region);
      continue;
    }
    const std::string& message = region.error().message;
    require(region.error().code != ErrorCode::internal, "an internal error: " + message);
    require(message.starts_with("text:") && message.ends_with(".") && message.find('\n') == message.npos,
            "an error is not one line: " + message);
  }
}

void requireNoArea(const Error& error) {
  require(error.message == "The region has no area.", "polygons have no union: " + error.message);
}

void tryUnion(const std::uint8_t* data, std::size_t size) {
  Polygons polygons = {{{}}};
  for (std::size_t k = 0; k + 1 < size; ++k) {
    if (data[k] == 254 && !polygons.back().back().empty()) {
      polygons.push_back({{}});
    } else if (data[k] == 255 && !polygons.back().back().empty()) {
      polygons.back().emplace_back();
    } else {
      const auto coordinate = [](std::uint8_t byte) { return byte / 4 + std::ldexp(byte % 4, -48); };
      polygons.back().back().push_back({coordinate(data[k]), coordinate(data[k + 1])});
      ++k;
    }
  }
  const auto region = Region::fromPolygons(polygons, kDissolve);
  if (!region) {
    requireNoArea(region.error());
    return;
  }
  checkRegion(*region);
  for (int k = 0; k < 64; ++k) {
    const Point p = {k % 8 * 8 + 3.37, k / 8 * 8 + 2.71};
    bool isOn = false;
    bool isIn = false;
    for (const auto& polygon : polygons) {
      bool isInOne = false;
      for (const Ring& ring : polygon) {
        isOn |= test::distanceToRing(ring, p) < 1e-9;
        isInOne ^= test::isInRing(ring, p);
      }
      isIn |= isInOne;
    }
    require(isOn || region->contains(p) == isIn, "a point is on the other side");
  }
}

double movedBy(double value, int steps) {
  for (int k = 0; k < std::abs(steps); ++k) value = std::nextafter(value, steps < 0 ? -1e300 : 1e300);
  return value;
}

void tryCopies(const std::uint8_t* data, std::size_t size) {
  Ring ring;
  std::size_t k = 0;
  for (; k + 1 < size && data[k] != 255 && ring.size() < 40; k += 2) ring.push_back({data[k] / 7.0, data[k + 1] / 9.0});
  Polygons polygons = {{ring}};
  for (++k; !ring.empty() && k + ring.size() <= size && polygons.size() < 30; k += ring.size()) {
    Ring copy = ring;
    for (std::size_t i = 0; i < copy.size(); ++i) {
      const int both = data[k + i];
      copy[i] = {movedBy(copy[i].x, both / 16 - 8), movedBy(copy[i].y, both % 16 - 8)};
    }
    polygons.push_back({std::move(copy)});
  }
  const auto one = Region::fromPolygons(std::vector<std::vector<Ring>>{{ring}}, kDissolve);
  const auto region = Region::fromPolygons(polygons, kDissolve);
  for (const auto* result : {&one, &region}) {
    if (!*result) requireNoArea(result->error());
  }
  if (!region) return;
  checkRegion(*region);
  double way = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point q = ring[i + 1 == ring.size() ? 0 : i + 1];
    way += std::hypot(q.x - ring[i].x, q.y - ring[i].y);
  }
  constexpr double kLastPlaces = 200 * 0x1p-52 * 37;
  const double difference = std::abs(region->area() - (one ? one->area() : 0));
  require(difference <= kLastPlaces * (1 + way), "the copies have another area");
  // Two sides cross once at most, except where they are rounded.
  const std::size_t sides = ring.size() * polygons.size();
  require(region->sideCount() <= 4 * sides * (sides + 1), "copies have too many sides");
}

}  // namespace
}  // namespace circle_voronoi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace circle_voronoi::fuzz;
  if (size == 0) return 0;
  if (data[0] % 2 == 0) {
    tryText({reinterpret_cast<const char*>(data) + 1, size - 1});
  } else if (data[0] % 4 == 1) {
    tryUnion(data + 1, size - 1);
  } else {
    tryCopies(data + 1, size - 1);
  }
  return 0;
}
