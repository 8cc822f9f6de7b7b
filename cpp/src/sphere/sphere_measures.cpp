// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "at.h"
#include "circle_voronoi/sphere.h"
#include "sphere_cell.h"

namespace circle_voronoi {
namespace {

using sphere::CellPart;
using sphere::CellSide;
using sphere::Places;

// Nodes and weights of Gauss and Legendre for eight points, those above 0.
constexpr std::array kNodes = {0.18343464249564980494, 0.52553240991632898582, 0.79666647741362673959,
                               0.96028985649753623168};
constexpr std::array kWeights = {0.36268378337836198297, 0.31370664587788728734, 0.22238103445337447054,
                                 0.10122853629037625915};
/// Halving ends where it changes no more than this share. The error is then smaller still.
constexpr double kChange = 0x1p-42;
constexpr int kMostHalvings = 50;

template <class Function>
double gauss(Function function, double from, double to) {
  const double middle = (from + to) / 2;
  const double half = (to - from) / 2;
  double sum = 0;
  for (std::size_t k = 0; k < kNodes.size(); ++k) {
    sum += kWeights[k] * (function(middle - half * kNodes[k]) + function(middle + half * kNodes[k]));
  }
  return half * sum;
}

/// Returns an integral by halving its range. `whole` is its value before, and noise(x) the rounding error of the
/// function at x.
template <class Function, class Noise>
double refined(Function function, Noise noise, double from, double to, double whole, int halvings = 0) {
  const double middle = (from + to) / 2;
  const double first = gauss(function, from, middle);
  const double second = gauss(function, middle, to);
  const double change = std::abs(first + second - whole);
  const double rounding = noise(middle) * std::abs(to - from);
  if (change <= std::max(kChange * std::abs(first + second), rounding) || halvings == kMostHalvings) {
    return first + second;
  }
  return refined(function, noise, from, middle, first, halvings + 1) +
         refined(function, noise, middle, to, second, halvings + 1);
}

/// Returns the bearing of a border where its angle is a right angle; nothing if it has none.
std::optional<double> crossingOf(const CellSide& side) {
  const double offset = side.border.offset;
  if (!(std::abs(offset) < side.amplitude)) return std::nullopt;
  return angleOf(std::sqrt((side.amplitude - offset) * (side.amplitude + offset)), -offset);
}

/// Returns the range of bearings in which a border is beyond a right angle.
double angleBeyondEquator(const CellSide& side, const CellPart& part) {
  const auto crossing = crossingOf(side);
  if (!crossing) return side.border.offset < 0 ? part.to - part.from : 0;
  // Around the farthest point of the border.
  double sum = 0;
  for (const double middle : {-kPi, kPi, 3 * kPi}) {
    const double reach = kPi - *crossing;
    sum += std::max(std::min(part.to, middle + reach) - std::max(part.from, middle - reach), 0.0);
  }
  return sum;
}

/// Returns the integral over bearings of a function of the cotangent of the angle to a border. Where the cotangent is
/// large, the function may change abruptly where it is 0.
///
/// The tangent of half the bearing from the nearest or the farthest point of the border makes the cotangent rational.
template <class Function>
double alongBorder(const CellSide& side, double from, double to, Function function) {
  std::vector<double> stops = {from};
  const auto addStops = [&](double first) {
    for (double stop = first - 4 * kPi; stop < to; stop += 2 * kPi) {
      if (stop > from) stops.push_back(stop);
    }
  };
  const double offset = side.border.offset;
  if (const auto crossing = crossingOf(side)) {
    addStops(*crossing);
    addStops(-*crossing);
  }
  addStops(kPi / 2);
  addStops(-kPi / 2);
  stops.push_back(to);
  std::sort(stops.begin() + 1, stops.end() - 1);
  double total = 0;
  for (std::size_t s = 0; s + 1 < stops.size(); ++s) {
    const double half = std::floor((stops[s] + stops[s + 1]) / (2 * kPi) + 0.5);
    const double amplitude = half - 2 * std::floor(half / 2) == 0 ? side.amplitude : -side.amplitude;
    const auto tangent = [&](double angle) {
      const SineCosine arc = sineCosine((angle - half * kPi) / 2);
      return arc.sine / arc.cosine;
    };
    const auto cotangent = [&](double x) { return amplitude * ((1 - x * x) / (1 + x * x)) + offset; };
    const auto integrand = [&](double x) { return function(cotangent(x)) * 2 / (1 + x * x); };
    const auto noise = [&](double x) {
      const double rounding = 0x1p-50 * (side.amplitude + std::abs(offset));
      return std::abs(function(cotangent(x) + rounding) - function(cotangent(x) - rounding));
    };
    const double begin = tangent(stops[s]);
    const double end = tangent(stops[s + 1]);
    if (begin != end) total += refined(integrand, noise, begin, end, gauss(integrand, begin, end));
  }
  return total;
}

/// Returns the integral of 1 - cos of the angle to a border.
double areaToBorder(const CellSide& side, const CellPart& part) {
  if (side.border.offset != 0) {
    // Beyond a right angle, 2 less the same function, which is small wherever the cotangent is large.
    const double layer = alongBorder(side, part.from, part.to, [](double cotangent) {
      const double size = std::sqrt(1 + cotangent * cotangent);
      const double depth = 1 / (size * (size + std::abs(cotangent)));
      return cotangent > 0 ? depth : -depth;
    });
    return layer + 2 * angleBeyondEquator(side, part);
  }
  // The border is a great circle. Up to half a turn from its nearest point, the integral is the difference of the
  // bearing and the arcsine of its sine times a / sqrt(1 + a^2), here without cancellation.
  const auto integral = [&](double angle) {
    const double turns = std::floor(angle / (2 * kPi) + 0.5);
    const double rest = angle - 2 * kPi * turns;
    const SineCosine bearing = sineCosine(rest);
    const double k = side.amplitude * bearing.cosine;
    const double size = std::sqrt(1 + k * k);
    const double sum = k > 0 ? size + k : 1 / (size - k);
    const double cosine = sum * (size * bearing.cosine + side.amplitude * bearing.sine * bearing.sine);
    const double value = angleOf(std::abs(bearing.sine), cosine);
    return 2 * kPi * turns + (rest < 0 ? -value : value);
  };
  return integral(part.to) - integral(part.from);
}

/// Sums a function of the parts on borders and a function of the parts on the circle of the maximum distance over a
/// cell.
template <class OnBorder, class OnCircle>
double sumOver(const SphereDiagram& diagram, const Places& places, CircleIndex cap, std::optional<double> maxDistance,
               OnBorder onBorder, OnCircle onCircle) {
  const sphere::Reach reach = sphere::reachOf(diagram, cap, maxDistance);
  if (!diagram.hasCell(cap) || (reach.angle && !(*reach.angle > 0))) return 0;
  const SineCosine arc = reach.angle ? sineCosine(*reach.angle) : SineCosine{0, -1};
  const auto sides = sphere::sidesOf(diagram, places, cap);
  if (sides.empty()) return onCircle(arc, 2 * kPi);
  double sum = 0;
  for (const CellSide& side : sides) {
    for (const CellPart& part : sphere::partsOf(side, reach.cotangent())) {
      sum += part.isOnCircle ? onCircle(arc, part.to - part.from) : onBorder(side, part);
    }
  }
  return sum;
}

double areaOf(const SphereDiagram& diagram, const Places& places, CircleIndex cap, std::optional<double> maxDistance) {
  const double share = sumOver(diagram, places, cap, maxDistance, areaToBorder, [](const SineCosine& arc, double turn) {
    return turn * (arc.cosine > 0 ? arc.sine * arc.sine / (1 + arc.cosine) : 1 - arc.cosine);
  });
  return share * diagram.radius * diagram.radius;
}

double perimeterOf(const SphereDiagram& diagram, const Places& places, CircleIndex cap,
                   std::optional<double> maxDistance) {
  const auto onBorder = [](const CellSide& side, const CellPart& part) {
    // With K the cotangent, K' its derivative: sqrt(1 + K^2 + K'^2) / (1 + K^2).
    const double offset = side.border.offset;
    const double constant = 1 + (side.amplitude - offset) * (side.amplitude + offset);
    return std::abs(alongBorder(side, part.from, part.to, [&](double k) {
      return std::sqrt(std::max(constant + 2 * offset * k, 0.0)) / (1 + k * k);
    }));
  };
  const auto onCircle = [](const SineCosine& arc, double turn) { return turn * arc.sine; };
  return diagram.radius * sumOver(diagram, places, cap, maxDistance, onBorder, onCircle);
}

template <class Measure>
std::vector<double> ofAll(const SphereDiagram& diagram, std::optional<double> maxDistance, Measure measure) {
  const Places places(diagram);
  std::vector<double> result(diagram.caps.size());
  for (std::size_t i = 0; i < result.size(); ++i) {
    result[i] = measure(diagram, places, static_cast<std::int32_t>(i), maxDistance);
  }
  return result;
}

}  // namespace

double area(const SphereDiagram& diagram, CircleIndex cap, std::optional<double> maxDistance) {
  return areaOf(diagram, Places::ofFew(diagram), cap, maxDistance);
}

std::vector<double> areas(const SphereDiagram& diagram, std::optional<double> maxDistance) {
  return ofAll(diagram, maxDistance, areaOf);
}

double perimeter(const SphereDiagram& diagram, CircleIndex cap, std::optional<double> maxDistance) {
  return perimeterOf(diagram, Places::ofFew(diagram), cap, maxDistance);
}

std::vector<double> perimeters(const SphereDiagram& diagram, std::optional<double> maxDistance) {
  return ofAll(diagram, maxDistance, perimeterOf);
}

}  // namespace circle_voronoi
