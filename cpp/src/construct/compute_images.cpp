// SPDX-License-Identifier: GPL-3.0-or-later
#include "compute_images.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/periodic_diagram.h"
#include "guarded.h"
#include "infinity.h"
#include "integer.h"
#include "reduced_lattice.h"
#include "validate.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

// All lengths here are in the unit of the rounding, and centers and periods are integers.
//
// Cells of the given circles that close across the box (checkPeriodic) are the Voronoi cells, however few the images
// are: repeated with the periods, they cover the plane, and the theorem in judge.h needs no more. So images are added
// until the cells close, and the following theorem says when they must.
//
// Theorem. Let R be the largest radius, and H^2 = |a|^2 + |b'|^2, where b' is the part of b perpendicular to a. The
// images whose centers lie within H - (R - r) of the parallelogram of the given centers, r being their radius, decide
// all cells of the given circles. In a power diagram with the largest weight W and m = H / 2, those do that lie within
// m + sqrt(m^2 - (W - w)), w being their weight; if this root is not real, they have no cell.
//
// Proof. Let m = H / 2. Each point lies within m of an image of any circle: subtract
// multiples of b, then of a. Hence the distance f(p) from the nearest circle is at most m - R. Let p be a point of the
// closed cell of given circle i, and j an image that is as near to p. Then |p - c_i| = f(p) + r_i <= m - R + r_i and |p
// - c_j| <= m - R + r_j, so |c_i - c_j| <= H - (R - r_j) because r_i <= R. If circle i is hidden, then also by the
// nearest image of each circle that hides it. Such a circle is visible, so m - R + r_j >= 0, and the image lies within
// m <= H - (R - r_j). Powers: f(p) <= m^2 - W, so |p - c_j|^2 <= m^2 - (W - w_j), and |p - c_i| <= m. If circle i has
// no cell, its center lies in the triangle of the three circles of a vertex q, and so no farther than the farthest of
// these centers from q, within m. The three are as near to the center of i as those of cells, and circle i is hidden by
// them.

/// Coordinates of centers and periods have this many bits. The coordinates of an image are less than eight times as
/// large: the given circles lie within kWidest periods of each other in both directions, and H is at most 1.53 times
/// the distance of the sides of the reduced parallelogram.
constexpr int kBits = 50;
constexpr double kWidest = 1.5;

/// The circles, the shortest periods, and the place of each circle, in integers.
struct Torus {
  /// The unit of the rounding: a power of two, a multiple of kCoordinateStep, so that images are not rounded again.
  double unit = 1;
  Lattice lattice;  ///< rounded, in the unit of the input
  ReducedLattice reduced;
  std::vector<Vector> centers;
  std::vector<double> deficits;  ///< of each circle the largest radius minus its own; weights for Metric::power
  std::vector<Vector> moves;     ///< of each circle by how many reduced periods it was moved; empty if by none

  Metric metric = Metric::circles;

  double inUnits(double length) const { return length / unit; }
  double inInput(double length) const { return length * unit; }
};

/// Returns what decides how far a circle reaches: its radius or weight, in the unit given; the weights of a power
/// diagram are areas.
double sizeOf(const Circle& c, const Options& options, double unit) {
  if (options.metric == Metric::centers) return 0;
  if (options.metric == Metric::circles) return c.r / unit;
  return options.weights ? c.r / unit / unit : c.r / unit * (c.r / unit);
}

double largestOf(Vector v) { return std::max(std::abs(v.x), std::abs(v.y)); }

Result<Torus> torusOf(std::span<const Circle> circles, const Lattice& lattice, const Options& options) {
  const auto& [a, b] = lattice;
  double largest = std::max(largestOf(a), largestOf(b));
  // Not >, which is false for NaN.
  if (!(largest <= kCoordinateLimit) || !(dot(a, a) <= kInfinite) || !(dot(b, b) <= kInfinite)) {
    return Error{ErrorCode::badOption, kNone,
                 std::string("The periods must be finite numbers, at most ") + kCoordinateLimitText + "."};
  }
  for (const Circle& c : circles) largest = std::max(largest, largestOf({c.x, c.y}));
  if (auto error = tooSmallError(largest, "The circles and periods")) return *std::move(error);
  Torus torus;
  torus.metric = options.metric;
  int exponent = 0;
  std::frexp(largest, &exponent);
  torus.unit = std::max(std::ldexp(1.0, exponent - kBits), kCoordinateStep);
  const auto rounded = [&](double x) { return std::floor(torus.inUnits(x) + 0.5) + 0.0; };
  const auto roundedVector = [&](Vector v) { return Vector{rounded(v.x), rounded(v.y)}; };
  const auto asInput = [&](Vector v) { return Vector{torus.inInput(v.x), torus.inInput(v.y)}; };
  torus.reduced = reduce(roundedVector(a), roundedVector(b));
  // Periods that are parallel but for their own rounding come this near to zero.
  if (largestOf(torus.reduced.a) < 0x1p10) {
    return errorWith(ErrorCode::badOption,
                     "The periods must not be zero or parallel, up to 2^-40 of the largest coordinate.");
  }
  torus.lattice = {asInput(roundedVector(a)), asInput(roundedVector(b))};
  torus.centers.reserve(circles.size());
  torus.deficits.reserve(circles.size());
  double size = -kInfinite;
  for (const Circle& c : circles) size = std::max(size, sizeOf(c, options, torus.unit));
  for (const Circle& c : circles) {
    torus.centers.push_back(roundedVector({c.x, c.y}));
    torus.deficits.push_back(size - sizeOf(c, options, torus.unit));
  }
  return torus;
}

/// Returns the quotient, rounded down. It is below 2^41, because reduced periods are not short (torusOf).
double quotient(limbs::SignedWide numerator, limbs::SignedWide denominator) {
  const limbs::SignedWide whole = numerator / denominator;
  return static_cast<double>(static_cast<std::int64_t>(whole) - (whole * denominator > numerator ? 1 : 0));
}

limbs::SignedWide exactCross(Vector u, Vector v) {
  const auto times = [](double x, double y) {
    return limbs::SignedWide{static_cast<std::int64_t>(x)} * static_cast<std::int64_t>(y);
  };
  return times(u.x, v.y) - times(u.y, v.x);
}

/// Moves all circles into the parallelogram of the reduced periods at the origin, exactly: circles that differ by
/// periods come to the same place.
void gather(Torus& torus) {
  const auto& [a, b, ofA, ofB] = torus.reduced;
  const limbs::SignedWide area = exactCross(a, b);
  torus.moves.clear();
  for (Vector& c : torus.centers) {
    const Vector move = {-quotient(exactCross(c, b), area), -quotient(exactCross(a, c), area)};
    c = {c.x + move.x * a.x + move.y * b.x, c.y + move.x * a.y + move.y * b.y};
    torus.moves.push_back(move);
  }
}

/// The places of circles, in periods, and the parallelogram around them.
struct Spread {
  std::vector<Vector> places;
  Vector low = {kInfinite, kInfinite};
  Vector high = {-kInfinite, -kInfinite};
};

Spread spreadOf(const Torus& torus) {
  Spread spread;
  spread.places.reserve(torus.centers.size());
  for (const Vector c : torus.centers) {
    const Vector place = torus.reduced.placeOf(c);
    spread.places.push_back(place);
    spread.low = {std::min(spread.low.x, place.x), std::min(spread.low.y, place.y)};
    spread.high = {std::max(spread.high.x, place.x), std::max(spread.high.y, place.y)};
  }
  return spread;
}

/// Adds all images that lie near enough to the parallelogram of the given circles.
class Images {
 public:
  Images(std::span<const Circle> circles, const Torus& torus, const Spread& spread)
      : circles_(circles),
        torus_(torus),
        spread_(spread),
        area_(cross(torus.reduced.a, torus.reduced.b)),
        lengths_{length(torus.reduced.a), length(torus.reduced.b)},
        heights_{area_ / lengths_.y, area_ / lengths_.x} {}

  /// The distance up to which images decide everything, by the theorem above.
  double enough() const { return (1 + 0x1p-30) * length({lengths_.x, area_ / lengths_.x}); }

  /// The mean distance of circles.
  double spacing() const { return std::sqrt(area_ / static_cast<double>(circles_.size())); }

  /// A distance that is likely to be enough: a few times the mean distance, more for circles that reach out of the
  /// parallelogram.
  double likely() const {
    const bool arePowers = torus_.metric == Metric::power;
    double mean = 0;
    for (const double deficit : torus_.deficits) mean += deficit / static_cast<double>(circles_.size());
    double reach = 0;
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      const Vector p = spread_.places[i];
      const double depth = std::min(std::min(p.x - spread_.low.x, spread_.high.x - p.x) * heights_.x,
                                    std::min(p.y - spread_.low.y, spread_.high.y - p.y) * heights_.y);
      const double excess = mean - torus_.deficits[i];
      reach = std::max(reach, (arePowers ? std::sqrt(std::max(excess, 0.0)) : excess) - depth);
    }
    // For the circles of mean size.
    const double enough = 4.5 * spacing() + reach;
    if (!arePowers) return enough + mean;
    const double far = std::max(enough, std::sqrt(mean));
    return far + mean / far;
  }

  /// The distance to add if that is not enough, in both directions.
  Vector step() const { return {std::max(spacing(), heights_.x / 4), std::max(spacing(), heights_.y / 4)}; }

  /// The gaps between the parallelogram of the given circles and its images, in both directions.
  Vector gaps() const {
    const auto gap = [](double low, double high, double height) { return std::max(1 - (high - low), 0.0) * height; };
    return {gap(spread_.low.x, spread_.high.x, heights_.x), gap(spread_.low.y, spread_.high.y, heights_.y)};
  }

  /// The circles and their images within a distance in each direction, or less if they are smaller than the largest.
  PeriodicDiagram within(Vector halo) const {
    std::vector<Bounds> bounds;
    bounds.reserve(circles_.size());
    double count = 0;
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      bounds.push_back(boundsOf(i, {reachOf(i, halo.x), reachOf(i, halo.y)}));
      const auto& [first, last] = bounds.back();
      count += (last.x - first.x + 1) * (last.y - first.y + 1);
    }
    if (!(count <= static_cast<double>(kMaxCircles))) {
      throw ThrownError{{ErrorCode::tooManyCircles, kNone,
                         "The circles and their images are more than " + std::to_string(kMaxCircles) + "."}};
    }
    PeriodicDiagram images;
    images.circleCount = static_cast<std::int32_t>(circles_.size());
    images.lattice = torus_.lattice;
    images.diagram.circles.reserve(static_cast<std::size_t>(count));
    images.circleOf.reserve(static_cast<std::size_t>(count));
    images.shiftOf.reserve(static_cast<std::size_t>(count));
    for (std::size_t i = 0; i < circles_.size(); ++i) add(images, i, {});
    for (std::size_t i = 0; i < circles_.size(); ++i) {
      const auto& [first, last] = bounds[i];
      for (double k = first.x; k <= last.x; ++k) {
        for (double l = first.y; l <= last.y; ++l) {
          if (k != 0 || l != 0) add(images, i, {k, l});
        }
      }
    }
    return images;
  }

 private:
  /// The first and the last image in each direction.
  struct Bounds {
    Vector first;
    Vector last;
  };

  /// The distance for a circle where the largest have `halo`, by the theorem above.
  double reachOf(std::size_t i, double halo) const {
    if (torus_.metric != Metric::power) return halo - torus_.deficits[i];
    const double half = halo / 2;
    return half + std::sqrt(std::max(half * half - torus_.deficits[i], 0.0));
  }

  /// A little more than `halo`, which makes up for rounding.
  Bounds boundsOf(std::size_t i, Vector halo) const {
    const auto first = [](double low, double place, double reach) {
      const double slack = 0x1p-40 * (1 + std::abs(low) + std::abs(place) + std::abs(reach));
      return std::min(0.0, std::ceil(low - reach - place - slack));
    };
    const Vector reach = {halo.x * lengths_.y / area_, halo.y * lengths_.x / area_};
    const Vector p = spread_.places[i];
    return {{first(spread_.low.x, p.x, reach.x), first(spread_.low.y, p.y, reach.y)},
            {-first(-spread_.high.x, -p.x, reach.x), -first(-spread_.high.y, -p.y, reach.y)}};
  }

  void add(PeriodicDiagram& images, std::size_t i, Vector move) const {
    const ReducedLattice& lattice = torus_.reduced;
    const Vector a = lattice.a;
    const Vector b = lattice.b;
    const Vector c = torus_.centers[i];
    images.diagram.circles.push_back({torus_.inInput(c.x + move.x * a.x + move.y * b.x),
                                      torus_.inInput(c.y + move.x * a.y + move.y * b.y), circles_[i].r});
    images.circleOf.push_back(static_cast<std::int32_t>(i));
    const Vector moved = torus_.moves.empty() ? Vector{} : torus_.moves[i];
    const auto shift = [&](std::size_t period) {
      const double times = (move.x + moved.x) * lattice.ofA[period] + (move.y + moved.y) * lattice.ofB[period];
      if (std::abs(times) < 0x1p30) return static_cast<std::int32_t>(times);
      throw ThrownError{{ErrorCode::badOption, static_cast<std::int32_t>(i),
                         "An image of circle " + std::to_string(i) + " is 2^30 periods away."}};
    };
    images.shiftOf.push_back({shift(0), shift(1)});
  }

  std::span<const Circle> circles_;
  const Torus& torus_;
  const Spread& spread_;
  double area_;
  Vector lengths_;
  Vector heights_;  ///< the widths of the reduced parallelogram across b and across a
};

/// Returns whether the images of two equal circles do not hide one another in the same order everywhere. `compute`
/// shows the first of equal circles, which is the given one beside the images.
bool hasEqualCirclesApart(const PeriodicDiagram& images) {
  const auto isApart = [&](const HiddenCircle& hidden) {
    const auto circle = static_cast<std::size_t>(hidden.circle);
    const auto by = static_cast<std::size_t>(hidden.by);
    const Circle& a = images.diagram.circles[circle];
    const Circle& b = images.diagram.circles[by];
    const bool isEqual = a.x == b.x && a.y == b.y && (a.r == b.r || images.diagram.metric == Metric::centers);
    return isEqual && images.circleOf[circle] < images.circleOf[by];
  };
  return std::any_of(images.diagram.hidden.begin(), images.diagram.hidden.end(), isApart);
}

/// An error of the images.
Error ofGivenCircle(Error error, const PeriodicDiagram& images) {
  if (error.circle != kNone) error.circle = images.circleOf[static_cast<std::size_t>(error.circle)];
  if (error.code == ErrorCode::coordinateTooLarge && error.circle != kNone) {
    error.message =
        "An image of circle " + std::to_string(error.circle) + " has a coordinate beyond " + kCoordinateLimitText + ".";
  }
  return error;
}

Result<PeriodicDiagram> computeOn(std::span<const Circle> circles, Torus torus, const Options& options,
                                  ComputeFunction& compute) {
  Spread spread = spreadOf(torus);
  if (spread.high.x - spread.low.x > kWidest || spread.high.y - spread.low.y > kWidest) {
    gather(torus);
    spread = spreadOf(torus);
  }
  const Images images(circles, torus, spread);
  const double enough = images.enough();
  const double halo = images.likely();
  Vector step = images.step();
  const Vector gaps = images.gaps();
  const auto within = [&](double x, double y) { return Vector{std::min(x, enough), std::min(y, enough)}; };
  // Across a wide gap, the first images are that much farther.
  const auto across = [&](double gap) { return gap < halo ? halo : gap + halo; };
  for (Vector reach = within(across(gaps.x), across(gaps.y));;) {
    PeriodicDiagram result = images.within(reach);
    auto diagram = compute(result.diagram.circles, options);
    if (!diagram) return ofGivenCircle(diagram.error(), result);
    result.diagram = std::move(diagram).value();
    if (!result.diagram.certificate.certified()) {
      return errorWith(ErrorCode::notCertified, "The diagram of the images is not certified.");
    }
    if (torus.moves.empty() && hasEqualCirclesApart(result)) {
      gather(torus);
      return computeOn(circles, std::move(torus), options, compute);
    }
    auto checked = checkPeriodic(result);
    if (checked) return result;
    if (!(reach.x < enough || reach.y < enough)) return checked.error();
    reach = within(halo + gaps.x + step.x, halo + gaps.y + step.y);
    step = {2 * step.x, 2 * step.y};
  }
}

}  // namespace

Result<PeriodicDiagram> computeImages(std::span<const Circle> circles, const Lattice& lattice, const Options& options,
                                      ComputeFunction& compute) {
  return guarded([&]() -> Result<PeriodicDiagram> {
    if (auto valid = validatePart(circles, options.weights, 0, options.metric); !valid) return valid.error();
    auto torus = torusOf(circles, lattice, options);
    if (!torus) return torus.error();
    Options own = options;
    own.progress = lettingThrough(options.progress);
    own.observer = lettingThrough(options.observer);
    if (circles.empty()) {
      auto diagram = compute(circles, own);
      if (!diagram) return diagram.error();
      return PeriodicDiagram{std::move(diagram).value(), 0, torus.value().lattice, {}, {}};
    }
    return computeOn(circles, std::move(torus).value(), own, compute);
  });
}

}  // namespace circle_voronoi
