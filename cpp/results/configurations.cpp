// SPDX-License-Identifier: GPL-3.0-or-later
#include "configurations.h"

#include <cmath>

#include "random.h"

namespace circle_voronoi::results {

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
  // Two lines to the ends, bent away from the large circle, so that its centre sees the ends alone.
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

}  // namespace circle_voronoi::results
