// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi_families/figures.h"

#include <algorithm>
#include <array>

#include "random.h"

namespace circle_voronoi {
namespace {

// clang-format off
constexpr auto kFigures = std::to_array<Figure>({
    {"5b", "two large circles with one row of small ones between their centers: neighbors all the same", oneRowBetween},
    {"5c", "the same with two rows", twoRowsBetween},
    {"5d", "a very large circle and one behind layers of tiny ones", layersBetween},
    {"6", "seven circles, of which the two largest share an edge in a gap", sevenCircles},
    {"7a", "48 equal circles around one", nullptr, Family::ring, 49},
    {"7b", "198 equal circles around one", nullptr, Family::ring, 199},
    {"9a", "four circles and a short edge", shortEdge},
    {"9b", "the edge all but gone: nearly one vertex of four circles", nearlyNoEdge},
    {"10", "12 equal circles that touch one disc", nullptr, Family::cocircularEqual, 12},
    {"11", "four equal circles on a grid", nullptr, Family::grid, 4},
    {"12", "circles that intersect, three of them mutually, and a hidden one", intersectingCircles},
    {"13a", "the circles of figure 5d with their diagram", layersBetween},
    {"13b", "convex cells, pairs with several edges, cells with two edges", severalEdges},
    {"14", "100,000 random circles", nullptr, Family::uniform, 100'000},
    {"15a", "circles of all sizes that touch one disc", nullptr, Family::cocircularVaried, 24},
    {"15b", "100 equal circles that touch one disc; 15c is its middle", nullptr, Family::cocircularEqual, 100},
    {"15d", "equal circles on a grid", nullptr, Family::grid, 100},
    {"15e", "the same, tangent", nullptr, Family::gridTangent, 100},
    {"15f", "on a grid, growing from column to column", nullptr, Family::gridColumns, 100},
});
// clang-format on

}  // namespace

std::span<const Figure> figures() { return kFigures; }

const Figure& figureOf(std::string_view name) { return *std::ranges::find(kFigures, name, &Figure::name); }

std::vector<Circle> circlesOf(const Figure& figure) {
  return figure.make != nullptr ? figure.make() : generate(figure.family, figure.count, 1);
}

std::vector<Circle> oneRowBetween() {
  return {{-2.2, 0, 1.6},    {2.2, 0, 1.6},    {0, 1.1, 0.3},   {0.1, -1.15, 0.35}, {0.2, 2.6, 0.6},
          {-0.3, -2.7, 0.5}, {-3.6, 2.4, 0.4}, {3.4, 2.7, 0.5}, {3.8, -2.2, 0.45},  {-3.5, -2.5, 0.5}};
}

std::vector<Circle> twoRowsBetween() {
  std::vector<Circle> circles = {{-2.6, 0, 2}, {2.6, 0, 2}};
  for (const int side : {-1, 1}) {
    for (double y = 0.8; y < 3.5; y += 0.5) {
      circles.push_back({-0.25, side * y, 0.12});
      circles.push_back({0.25, side * y, 0.12});
    }
  }
  return circles;
}

std::vector<Circle> shortEdge() { return {{-1.95, 0.1, 0.7}, {0, -1.95, 0.6}, {2.1, 0, 0.8}, {-0.1, 1.85, 0.5}}; }

std::vector<Circle> nearlyNoEdge() {
  // Without the added distances, all four touch the unit circle.
  return {{-1.7, 0, 0.7}, {0, -1.6 - 2e-6, 0.6}, {1.8, 0, 0.8}, {0, 1.5, 0.5}};
}

std::vector<Circle> layersBetween() {
  constexpr Circle kLarge = {600, 0, 600};
  constexpr Circle kSmall = {-1.25, 0, 1.1};
  constexpr double kTop = 2.3;
  std::vector<Circle> circles = {kLarge, kSmall};
  for (const double distance : {1.22, 1.38, 1.56, 1.76}) {
    constexpr int kPlaces = 36;
    for (int k = 0; k < kPlaces; ++k) {
      const Vector direction = directionAt((k + (distance == 1.38 || distance == 1.76 ? 0.5 : 0)) / kPlaces);
      const Point p = {kSmall.x + distance * direction.x, kSmall.y + distance * direction.y};
      if (p.x < -0.25) circles.push_back({p.x, p.y, 0.035});
    }
  }
  // Two rows of circles to the ends, bent away from the large circle, so that its center is joined to the ends only.
  for (const int side : {-1, 1}) {
    for (double y = 0.1; y < kTop; y += 0.2) circles.push_back({-0.065 - 0.055 * (1 - y / kTop), side * y, 0.012});
    circles.push_back({-0.06, side * kTop, 0.05});
  }
  return circles;
}

std::vector<Circle> sevenCircles() {
  return {{-2.6, 0, 2},    {2.6, 0, 2},       {0.05, 1.25, 0.35}, {-0.05, -1.3, 0.4},
          {0.3, 3.1, 0.7}, {-0.4, -3.2, 0.8}, {4.6, 2.6, 0.5}};
}

std::vector<Circle> intersectingCircles() {
  return {{0, 0, 1.2},     {1.3, 0.4, 1},   {0.5, 1.4, 0.9},  {3.9, 0.3, 1.1},  {5.1, 1.1, 0.8},
          {3.7, 0.2, 0.3}, {2.4, 3.1, 0.7}, {-1.9, 2.7, 0.6}, {1.9, -2.2, 0.8}, {5.2, -2, 0.6}};
}

std::vector<Circle> severalEdges() {
  return {{-3, 0, 2.8},      {3, 0, 2.75},     {0, 0, 0.1},      {0.03, 1, 0.1},    {-0.02, -0.9, 0.1},
          {0, 4.2, 1},       {0.2, -4.1, 0.9}, {-5.2, 3.4, 0.8}, {5.3, 3.2, 0.9},   {5.2, -3, 0.7},
          {-5.3, -3.2, 0.6}, {-6.2, 0.3, 0.2}, {2.7, 3.1, 0.15}, {-2.8, -3.1, 0.12}};
}

}  // namespace circle_voronoi
