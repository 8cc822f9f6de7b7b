// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_signs.h"

#include <algorithm>
#include <cmath>
#include <variant>

#include "cell_limits.h"
#include "exact.h"
#include "linear_sign.h"
#include "rounded.h"
#include "scale.h"
#include "sign_at_crossing.h"
#include "vertex_error.h"
#include "weighted_numbers.h"

namespace circle_voronoi {

/// The center of a circle or a place, as seen from the center of a disc.
template <class Number>
struct SeenSite {
  exact::Vector3<Number> v;            ///< for the metric `circles`, s is the difference of the radii
  decltype(Number() * Number()) lift;  ///< the squared radius of its disc minus that of the disc; 0 for a place
};

/// The most sites that a formula takes.
constexpr std::size_t kMostSites = 4;

/// A disc, and sites as seen from its center, in units of 2^exponent and of its square.
template <class Number>
struct SeenDisc {
  decltype(Number() * Number()) square;  ///< of the radius
  std::array<SeenSite<Number>, kMostSites> sites;
  int exponent = 0;
};

namespace {

/// A generous bound on rounding, relative to the sizes of the summands.
constexpr double kSignError = 0x1p-46;
/// Crossings are right to this share of their side.
constexpr double kCrossingError = 0x1p-42;
/// Roots of powers are right to this share (radical_center.h).
constexpr double kPowerError = 0x1p-35;
/// Chords are computed in integers where rounding of the line's distance makes a larger share of them.
constexpr double kTangentError = 0x1p-16;

double extentOf(Vector v) { return std::abs(v.x) + std::abs(v.y); }
Vector fromCenter(const Circle& c, Point p) { return {p.x - c.x, p.y - c.y}; }
int signFrom(double value) { return value > 0 ? 1 : -1; }

/// A line that meets a rim, seen from the center: its points are (h n + t u) / (2 u . u), where n is u turned to the
/// left.
template <class Direction, class Height>
struct LineForm {
  Direction u;
  Height h;
};
template <class Direction, class Height>
LineForm(Direction, Height) -> LineForm<Direction, Height>;

/// `first` and `second` are the ends of a side, or the other circle of an edge twice.
template <class View, class Seen>
auto lineForm(View view, const RimLine& line, const Seen& first, const Seen& second) {
  const auto d = view.fixed(first.v);
  PlaneVector u = {-d.y, d.x};
  auto h = view.linear(view.number(first.lift) - dot(d, d));
  if (!line.isOfEdge()) {
    u = view.fixed(second.v - first.v);
    h = twice(view.linear(cross(u, view.moved(first.v))));
  }
  return LineForm{u, h};
}

/// The point `place` / `divisor` where the straight bisectors to two circles meet, which are counter-clockwise.
template <class Place, class Divisor>
struct StraightVertex {
  Place place;
  Divisor divisor;
};
template <class Place, class Divisor>
StraightVertex(Place, Divisor) -> StraightVertex<Place, Divisor>;

template <class Seen>
auto straightVertex(const Seen& u, const Seen& w) {
  const auto ku = exact::planeDot(u.v, u.v) - u.lift;
  const auto kw = exact::planeDot(w.v, w.v) - w.lift;
  return StraightVertex{PlaneVector{ku * w.v.y - kw * u.v.y, kw * u.v.x - ku * w.v.x},
                        twice(exact::planeCross(u.v, w.v))};
}

}  // namespace

DistanceSigns::DistanceSigns(const Diagram& diagram, double maxDistance)
    : diagram_(diagram), distance_(rounded(maxDistance)) {}

Circle DistanceSigns::circle(CircleIndex i) const {
  Circle c = diagram_.circles[static_cast<std::size_t>(i)];
  if (diagram_.metric == Metric::centers) c.r = 0;
  return c;
}

double DistanceSigns::radius(CircleIndex cell) const { return reachFrom(diagram_, cell, distance_); }

/// Returns the size of the numbers whose sum the radius is.
double DistanceSigns::radiusSize(CircleIndex cell) const {
  return diagram_.metric == Metric::power ? radius(cell) : circle(cell).r + std::abs(distance_);
}

bool DistanceSigns::hasDisc(CircleIndex cell) const {
  // A sum of two doubles has the right sign, and so has the sum of a weight and a square in two parts each.
  return radius(cell) > 0;
}

bool DistanceSigns::hasCenter(CircleIndex cell) const {
  return diagram_.metric != Metric::power || std::ranges::all_of(diagram_.sides(cell), [&](SideIndex side) {
           return turnToCenter(cell, RimLine::ofEdge(diagram_.neighborOf(side))) <= 0;
         });
}

DistanceSigns::Site DistanceSigns::siteOf(CircleIndex i) const {
  const Circle& c = diagram_.circles[static_cast<std::size_t>(i)];
  return {{c.x, c.y}, i};
}

std::array<DistanceSigns::Site, 2> DistanceSigns::sitesOf(const RimLine& line) const {
  if (!line.isOfEdge()) return {{{line.from}, {line.to}}};
  const Site site = siteOf(line.neighbor);
  return {site, site};
}

/// A disc in the smallest kind of integers that holds it. A diagram with straight edges has the largest kind.
struct DistanceSigns::ExactDisc {
  std::variant<SeenDisc<FixedInteger<1>>, SeenDisc<FixedInteger<2>>, SeenDisc<FixedInteger<4>>> disc;
};

DistanceSigns::ExactDisc DistanceSigns::exactDisc(CircleIndex cell, std::span<const Site> sites) const {
  if (diagram_.metric != Metric::circles) return straightDisc(cell, sites);
  const Circle own = circle(cell);
  const Circle reach = {own.x, own.y, -distance_};
  std::array<Circle, kMostSites> circles;
  std::array<const Circle*, kMostSites + 1> pointers{};
  for (std::size_t k = 0; k < sites.size(); ++k) {
    const auto& [p, index] = sites[k];
    circles[k] = index == kNone ? Circle{p.x, p.y, own.r} : circle(index);
    pointers[k] = &circles[k];
  }
  pointers[kMostSites] = &reach;
  return exact::seenFrom(
      own, pointers,
      [&]<class Number>(const std::array<exact::RelativeCircle<Number>, kMostSites + 1>& seen, int exponent) {
        const Number radius = -seen[kMostSites].v.s;
        SeenDisc<Number> disc;
        disc.square = radius * radius;
        for (std::size_t k = 0; k < sites.size(); ++k) {
          const auto& v = seen[k].v;
          disc.sites[k] = {v, v.s * (v.s + twice(radius))};
        }
        disc.exponent = exponent;
        return ExactDisc{disc};
      });
}

DistanceSigns::ExactDisc DistanceSigns::straightDisc(CircleIndex cell, std::span<const Site> sites) const {
  std::array<Point, kMostSites + 1> points;
  std::array<TwoPart, kMostSites + 2> weights;
  const auto weightOf = [&](CircleIndex i) { return powerWeight(circle(i), diagram_.weights); };
  for (std::size_t k = 0; k < sites.size(); ++k) {
    points[k] = sites[k].p;
    weights[k] = weightOf(sites[k].circle == kNone ? cell : sites[k].circle);
  }
  const Point center = points[sites.size()] = siteOf(cell).p;
  const TwoPart own = weights[sites.size()] = weightOf(cell);
  const TwoPart more = weights[sites.size() + 1] = square(distance_);
  const WeightedNumbers numbers(std::span<const Point>(points).first(sites.size() + 1),
                                std::span<const TwoPart>(weights).first(sites.size() + 2));
  const auto weight = numbers.weight(own);
  SeenDisc<FixedInteger<4>> disc;
  disc.square = distance_ < 0 ? weight - numbers.weight(more) : weight + numbers.weight(more);
  for (std::size_t k = 0; k < sites.size(); ++k) {
    const auto [x, y] = numbers.between(center, points[k]);
    disc.sites[k] = {{x, y, {}}, numbers.weight(weights[k]) - weight};
  }
  disc.exponent = numbers.exponent();
  return {disc};
}

/// Returns formula(square, sites, exponent) of a disc and sites seen from its center, if edges are straight.
template <class Formula>
auto DistanceSigns::seenFromStraight(CircleIndex cell, std::span<const Site> sites, Formula formula) const {
  const ExactDisc exact = straightDisc(cell, sites);
  const auto& disc = *std::get_if<SeenDisc<FixedInteger<4>>>(&exact.disc);
  return formula(disc.square, disc.sites, disc.exponent);
}

/// Returns formula(square, sites, exponent) of a disc and sites seen from its center.
template <class Formula>
auto DistanceSigns::seenFromDisc(CircleIndex cell, std::span<const Site> sites, Formula formula) const {
  const ExactDisc exact = exactDisc(cell, sites);
  const auto apply = [&](const auto& disc) { return formula(disc.square, disc.sites, disc.exponent); };
  if (const auto* disc = std::get_if<SeenDisc<FixedInteger<1>>>(&exact.disc)) return apply(*disc);
  if (const auto* disc = std::get_if<SeenDisc<FixedInteger<2>>>(&exact.disc)) return apply(*disc);
  return apply(*std::get_if<SeenDisc<FixedInteger<4>>>(&exact.disc));
}

/// Returns the sign of formula(view, square, sites), where `view` is AsGiven or AsMoved.
template <class Formula>
ShiftedSign DistanceSigns::shiftedSign(CircleIndex cell, std::span<const Site> sites, Formula formula) const {
  return seenFromDisc(cell, sites, [&](const auto& square, const auto& seen, int) -> ShiftedSign {
    const int sign = formula(AsGiven(), square, seen);
    if (sign != 0) return {sign, false};
    return {formula(AsMoved(), square, seen), true};
  });
}

ShiftedSign DistanceSigns::beyond(VertexIndex vertex) const {
  const Vertex& v = diagram_.vertices[static_cast<std::size_t>(vertex)];
  const auto& indices = diagram_.vertexCircles[static_cast<std::size_t>(vertex)];
  const double value = v.r - distance_;
  const double error = diagram_.metric == Metric::power
                           ? kPowerError * (std::abs(v.r) + std::abs(distance_))
                           : 4 * vertexError(diagram_, vertex) + kSignError * radiusSize(indices[0]);
  if (std::abs(value) > error) return {signFrom(value), false};
  int sign = 0;
  if (diagram_.metric != Metric::circles) {
    sign = seenFromStraight(indices[0], std::array{siteOf(indices[1]), siteOf(indices[2])},
                            [](const auto& square, const auto& seen, int) {
                              const auto [place, divisor] = straightVertex(seen[0], seen[1]);
                              return (dot(place, place) - square * (divisor * divisor)).sign();
                            });
  } else {
    const Circle own = circle(indices[0]);
    const Circle u = circle(indices[1]);
    const Circle w = circle(indices[2]);
    const Circle reach = {own.x, own.y, -distance_};
    sign = exact::seenFrom(own, std::array{&u, &w, &reach},
                           []<class Number>(const std::array<exact::RelativeCircle<Number>, 3>& seen, int) {
                             const Number zero(0);
                             const Number one(1);
                             return linearSign(seen[0], seen[1], zero, zero, one, one * seen[2].v.s);
                           });
  }
  return {sign > 0 ? 1 : -1, sign == 0};
}

ShiftedSign DistanceSigns::beyond(const SideCrossing& crossing) const {
  if (!hasDisc(crossing.before)) return {1, false};
  const double reached = lengthOf(fromCenter(circle(crossing.before), crossing.point));
  const double value = reached - radius(crossing.before);
  const double error =
      kCrossingError * extentOf(vectorTo(crossing.from, crossing.to)) +
      kSignError * (reached + radiusSize(crossing.before) + extentOf({crossing.point.x, crossing.point.y}));
  if (std::abs(value) > error) return {signFrom(value), false};
  const std::array<Site, 3> sites = {siteOf(crossing.after), {crossing.from}, {crossing.to}};
  return shiftedSign(crossing.before, sites, [](auto view, const auto& square, const auto& seen) {
    const auto d = view.fixed(seen[0].v);
    const auto start = view.moved(seen[1].v);
    const auto direction = view.fixed(seen[2].v - seen[1].v);
    const auto s = view.number(seen[0].v.s);
    const auto lift = view.number(seen[0].lift);
    const auto along = dot(direction, d);
    if (s.sign() == 0) {
      const PlaneVector toMiddle = {d.x - twice(start.x), d.y - twice(start.y)};
      const auto way = twice(along);
      const auto height = dot(toMiddle, d) - lift;
      const PlaneVector place = {start.x * way + direction.x * height, start.y * way + direction.y * height};
      return (dot(place, place) - view.number(square) * (way * way)).sign();
    }
    // The difference of the powers of the point to both discs has the sign of its distance less the limit, times -s.
    const auto lambda = twice(dot(start, d)) - dot(d, d) + lift;
    return -s.sign() * signAtCrossing(view, seen[0], seen[0].lift, seen[1], seen[2], lambda, twice(along));
  });
}

ShiftedSign DistanceSigns::beyond(CircleIndex cell, Point corner) const {
  const Vector v = fromCenter(circle(cell), corner);
  const double reached = dot(v, v);
  const double value = reached - radius(cell) * radius(cell);
  const double size = radiusSize(cell);
  if (std::abs(value) > kSignError * (reached + size * size)) return {signFrom(value), false};
  return shiftedSign(cell, std::array<Site, 1>{{{corner}}}, [](auto view, const auto& square, const auto& seen) {
    const auto place = view.moved(seen[0].v);
    return (dot(place, place) - view.number(square)).sign();
  });
}

ShiftedSign DistanceSigns::pastApex(CircleIndex left, CircleIndex right, VertexIndex vertex) const {
  const Circle own = circle(left);
  const Circle other = circle(right);
  const Vertex& v = diagram_.vertices[static_cast<std::size_t>(vertex)];
  const Vector across = between(own, other);
  const Vector toVertex = fromCenter(own, {v.x, v.y});
  const double value = cross(across, toVertex);
  if (std::abs(value) > extentOf(across) * (vertexError(diagram_, vertex) + kSignError * extentOf(toVertex))) {
    return {signFrom(value), false};
  }
  const auto& indices = diagram_.vertexCircles[static_cast<std::size_t>(vertex)];
  const auto its = static_cast<std::size_t>(std::ranges::find(indices, left) - indices.begin());
  const CircleIndex first = indices[(its + 1) % indices.size()];
  const CircleIndex second = indices[(its + 2) % indices.size()];
  int sign = 0;
  if (diagram_.metric != Metric::circles) {
    sign = seenFromStraight(left, std::array{siteOf(first), siteOf(second), siteOf(right)},
                            [](const auto&, const auto& seen, int) {
                              return cross(AsGiven::fixed(seen[2].v), straightVertex(seen[0], seen[1]).place).sign();
                            });
  } else {
    const Circle u = circle(first);
    const Circle w = circle(second);
    sign = exact::seenFrom(own, std::array{&u, &w, &other}, [](const auto& seen, int) {
      const auto& d = seen[2].v;
      return linearSign(seen[0], seen[1], -d.y, d.x, None(), None());
    });
  }
  return {sign >= 0 ? 1 : -1, sign == 0};
}

ShiftedSign DistanceSigns::pastApex(CircleIndex left, CircleIndex right, const SideCrossing& crossing) const {
  const Circle own = circle(crossing.before);
  const int way = crossing.before == left && crossing.after == right ? 1 : -1;
  const Vector across = between(own, circle(crossing.after));
  const Vector toPoint = fromCenter(own, crossing.point);
  const double value = cross(across, toPoint);
  const double error = kCrossingError * extentOf(vectorTo(crossing.from, crossing.to)) +
                       kSignError * (extentOf(toPoint) + extentOf({crossing.point.x, crossing.point.y}));
  if (std::abs(value) > extentOf(across) * error) return {way * signFrom(value), false};
  const std::array<Site, 3> sites = {siteOf(crossing.after), {crossing.from}, {crossing.to}};
  const auto sign = shiftedSign(crossing.before, sites, [](auto view, const auto&, const auto& seen) {
    const auto d = view.fixed(seen[0].v);
    const auto start = view.moved(seen[1].v);
    const auto direction = view.fixed(seen[2].v - seen[1].v);
    return signAtCrossing(view, seen[0], seen[0].lift, seen[1], seen[2], cross(d, start), cross(d, direction));
  });
  return {way * sign.sign, sign.isTie};
}

ShiftedSign DistanceSigns::pastFoot(CircleIndex cell, Point from, Point to, Point corner) const {
  const Vector along = vectorTo(from, to);
  const Vector toCorner = fromCenter(circle(cell), corner);
  const double value = dot(along, toCorner);
  if (std::abs(value) > kSignError * extentOf(along) * extentOf(toCorner)) return {signFrom(value), false};
  return shiftedSign(cell, std::array<Site, 3>{{{from}, {to}, {corner}}}, [](auto view, const auto&, const auto& seen) {
    return dot(view.fixed(seen[1].v - seen[0].v), view.moved(seen[2].v)).sign();
  });
}

ShiftedSign DistanceSigns::pastFoot(CircleIndex cell, const SideCrossing& crossing) const {
  const Circle center = circle(cell);
  const Vector along = vectorTo(crossing.from, crossing.to);
  const Vector toPoint = fromCenter(center, crossing.point);
  const double value = dot(along, toPoint);
  const double error = kCrossingError * extentOf(along) +
                       kSignError * (extentOf(toPoint) + extentOf({crossing.point.x, crossing.point.y}));
  if (std::abs(value) > extentOf(along) * error) return {signFrom(value), false};
  const std::array<Site, 4> sites = {siteOf(crossing.after), {crossing.from}, {crossing.to}, {{center.x, center.y}}};
  return shiftedSign(crossing.before, sites, [](auto view, const auto&, const auto& seen) {
    const auto start = view.moved(seen[1].v);
    const auto foot = view.fixed(seen[3].v);
    const auto direction = view.fixed(seen[2].v - seen[1].v);
    const PlaneVector toStart = {start.x - foot.x, start.y - foot.y};
    return signAtCrossing(view, seen[0], seen[0].lift, seen[1], seen[2], dot(direction, toStart),
                          dot(direction, direction));
  });
}

DistanceSigns::SeenLine DistanceSigns::seenLine(CircleIndex cell, const RimLine& line) const {
  const Circle own = circle(cell);
  SeenLine seen;
  if (line.isOfEdge()) {
    const Circle other = circle(line.neighbor);
    const Vector across = between(own, other);
    const double apart = lengthOf(across);
    // The difference of the squared radii of both discs is s times `sum`.
    const double s = other.r - own.r;
    const bool isPower = diagram_.metric == Metric::power;
    const double sum = !isPower ? s + 2 * radius(cell) : diagram_.weights ? 1 : own.r + other.r;
    seen.along = {-across.y / apart, across.x / apart};
    seen.height = (s / apart * sum - apart) / 2;
    seen.error = std::abs(s) / apart * (isPower ? std::abs(sum) : std::abs(s) + 2 * std::abs(radius(cell))) + apart;
  } else {
    const Vector direction = vectorTo(line.from, line.to);
    const Vector toStart = fromCenter(own, line.from);
    seen.along = measuredIn(lengthOf(direction), direction);
    seen.height = cross(seen.along, toStart);
    seen.error = extentOf(toStart);
  }
  seen.error = kSignError * (seen.error + radiusSize(cell));
  return seen;
}

bool DistanceSigns::meetsRim(CircleIndex cell, const RimLine& line) const {
  if (!hasDisc(cell) || (line.isOfEdge() && !hasDisc(line.neighbor))) return false;
  const SeenLine seen = seenLine(cell, line);
  const double rest = radius(cell) - std::abs(seen.height);
  if (std::abs(rest) > seen.error) return rest > 0;
  return shiftedSign(cell, sitesOf(line), [&](auto view, const auto& square, const auto& sites) {
           const auto [u, h] = lineForm(view, line, sites[0], sites[1]);
           return (twice(twice(view.number(square))) * dot(u, u) - h * h).sign();
         }).sign > 0;
}

/// Returns half of the chord that a line cuts off a disc, right to rounding of itself.
double DistanceSigns::halfChord(CircleIndex cell, const RimLine& line) const {
  return seenFromDisc(cell, sitesOf(line), [&](const auto& square, const auto& sites, int exponent) {
    const auto [u, h] = lineForm(AsGiven(), line, sites[0], sites[1]);
    const auto chord = twice(twice(square)) * dot(u, u) - h * h;
    if (chord.sign() <= 0) return 0.0;
    return (sqrt(exact::floating(chord)) / sqrt(exact::floating(dot(u, u)))).times(exponent - 1);
  });
}

RimPoint DistanceSigns::rimPoint(CircleIndex cell, const RimLine& line, bool isAhead) const {
  const Circle own = circle(cell);
  const double r = radius(cell);
  const auto& [along, height, error] = seenLine(cell, line);
  double half = std::sqrt(std::max((r - std::abs(height)) * (r + std::abs(height)), 0.0));
  // The half has about half of the digits where the line is nearly a tangent.
  const bool isCertain = error * r < half * half * kTangentError;
  if (!isCertain) half = halfChord(cell, line);
  const double ahead = isAhead ? half : -half;
  const Vector v = {ahead * along.x - height * along.y, ahead * along.y + height * along.x};
  RimPoint result;
  result.line = line;
  result.isAhead = isAhead;
  result.place = pseudoAngle(v);
  result.error = isCertain ? 4 * error / half + kSignError : kInfinite;
  // On a line parallel to an axis exactly, and otherwise as seen from the center, since the ends may be far away.
  const bool isUpright = !line.isOfEdge() && line.from.x == line.to.x;
  const bool isLevel = !line.isOfEdge() && line.from.y == line.to.y;
  result.point = {isUpright ? line.from.x : own.x + v.x, isLevel ? line.from.y : own.y + v.y};
  return result;
}

// With the line form (u, h) of a point's line, its sign t of the root and the numbers (w, k) of the other line, the
// point is on the left of the other line if h u . w - k u . u + t (w x u) sqrt(4 R^2 u . u - h^2) is positive.
ShiftedSign DistanceSigns::leftOf(CircleIndex cell, const RimPoint& p, const RimLine& line) const {
  const auto [first, second] = sitesOf(p.line);
  const auto [third, fourth] = sitesOf(line);
  return shiftedSign(cell, std::array{first, second, third, fourth},
                     [&](auto view, const auto& square, const auto& seen) {
                       const auto [u, h] = lineForm(view, p.line, seen[0], seen[1]);
                       const auto [w, k] = lineForm(view, line, seen[2], seen[3]);
                       const auto along = dot(u, w);
                       const auto across = cross(w, u);
                       const auto uu = dot(u, u);
                       const auto root = twice(twice(view.number(square))) * (across * across);
                       const auto norm = h * h * dot(w, w) - twice(h * k * along) + k * k * uu - root;
                       return signOfRoot(norm.sign(), h * along - k * uu, p.isAhead ? across : -across);
                     });
}

/// Returns 1 if a point of an edge lies ahead, in the direction of the line of another edge, as seen from the center,
/// -1 if it lies behind.
int DistanceSigns::aheadOn(CircleIndex cell, const RimPoint& p, const RimLine& line) const {
  return seenFromDisc(cell, std::array{siteOf(p.line.neighbor), siteOf(line.neighbor)},
                      [&](const auto& square, const auto& seen, int) {
                        const auto [u, h] = lineForm(AsGiven(), p.line, seen[0], seen[0]);
                        const auto [w, k] = lineForm(AsGiven(), line, seen[1], seen[1]);
                        const auto along = dot(u, w);
                        const auto norm = h * h * dot(w, w) - twice(twice(square)) * (along * along);
                        return signOfRoot(norm.sign(), h * cross(u, w), p.isAhead ? along : -along);
                      });
}

/// Returns 1 if the center of a disc lies on the right of a line, -1 if it lies on its left.
int DistanceSigns::turnToCenter(CircleIndex cell, const RimLine& line) const {
  const SeenLine seen = seenLine(cell, line);
  if (std::abs(seen.height) > seen.error) return signFrom(seen.height);
  return shiftedSign(cell, sitesOf(line),
                     [&](auto view, const auto&, const auto& sites) {
                       return lineForm(view, line, sites[0], sites[1]).h.sign();
                     })
      .sign;
}

bool DistanceSigns::isUpper(CircleIndex cell, const RimPoint& p) const {
  const double toAxis = std::min({p.place, std::abs(p.place - 2), 4 - p.place});
  if (toAxis > p.error) return p.place < 2;
  const auto formula = [&](auto view, const auto& square, const auto& seen) {
    const auto form = lineForm(view, p.line, seen[0], seen[1]);
    const auto& u = form.u;
    const auto& h = form.h;
    const auto isOnAxis = [&](const auto& beside, const auto& ahead) {
      // The sign of h beside + t ahead sqrt(4 R^2 u . u - h^2).
      const auto norm = h * h - twice(twice(view.number(square))) * (ahead * ahead);
      return signOfRoot(norm.sign(), h * beside, p.isAhead ? ahead : -ahead);
    };
    if (const int sign = isOnAxis(u.x, u.y); sign != 0) return sign;
    if constexpr (std::is_same_v<decltype(view), AsGiven>) return 0;
    return isOnAxis(-u.y, u.x);
  };
  return shiftedSign(cell, sitesOf(p.line), formula).sign > 0;
}

bool DistanceSigns::isBefore(CircleIndex cell, const RimPoint& p, const RimPoint& q) const {
  const double error = p.error + q.error;
  const double ahead = std::abs(p.place - q.place);
  if (ahead > error && std::min(p.place, q.place) > p.error + q.error &&
      std::max(p.place, q.place) < 4 - p.error - q.error) {
    return p.place < q.place;
  }
  const bool isUpperP = isUpper(cell, p);
  if (isUpperP != isUpper(cell, q)) return isUpperP;
  return comesFirst(cell, p, q);
}

/// Returns whether one side of a cell comes after another one at one place: all vertices between them are exactly at
/// the distance.
bool DistanceSigns::isFollowedBy(SideIndex side, SideIndex other) const {
  for (SideIndex next = side;;) {
    const VertexIndex vertex = diagram_.targetOf(next);
    if (vertex == kNone || !beyond(vertex).isTie) return false;
    next = diagram_.links.nextSide[static_cast<std::size_t>(next)];
    if (next == other) return true;
    if (next == side) return false;
  }
}

/// Returns whether one point comes before another one in the same half of the rim.
///
/// The left side of a line has the rim from its second point to its first one. If the other point of the line lies in
/// the other half, the side of a point tells whether it comes before. If both lines have both points in this half, each
/// has an interval there. Where neither point lies in the interval of the other line, the intervals have the order of
/// their middles.
bool DistanceSigns::comesFirst(CircleIndex cell, const RimPoint& p, const RimPoint& q) const {
  const auto isWhole = [&](const RimPoint& its) {
    const RimPoint other = rimPoint(cell, its.line, !its.isAhead);
    return isUpper(cell, other) == isUpper(cell, its);
  };
  // Both points of one line: the interval begins with the second one if the center is on the right.
  const auto comesFirstOnLine = [&](const RimPoint& its) { return (turnToCenter(cell, its.line) > 0) == its.isAhead; };
  if (p.line == q.line) return p.isAhead != q.isAhead && comesFirstOnLine(p);
  const ShiftedSign pLeft = leftOf(cell, p, q.line);
  if (pLeft.sign == 0) {
    if (p.line.isOfEdge() && q.line.isOfEdge()) {
      const int ahead = aheadOn(cell, p, q.line);
      const bool isAtOther = ahead != 0 && (ahead > 0) != q.isAhead;
      // A corner of a power cell touches the disc from outside: nothing lies between the exit and the entry.
      return isAtOther ? !comesFirstOnLine(q) : isFollowedBy(q.side, p.side);
    }
    // Two sides on one line.
    const bool isSameWay = dot(vectorTo(p.line.from, p.line.to), vectorTo(q.line.from, q.line.to)) > 0;
    return (p.isAhead == q.isAhead) != isSameWay && comesFirstOnLine(p);
  }
  if (!isWhole(q)) return (pLeft.sign > 0) != q.isAhead;
  const ShiftedSign qLeft = leftOf(cell, q, p.line);
  // The edge of the second point meets the rim at the other point of the first line.
  if (qLeft.sign == 0) return comesFirstOnLine(p);
  if (!isWhole(p)) return (qLeft.sign > 0) == p.isAhead;
  const int pTurn = turnToCenter(cell, p.line);
  const int qTurn = turnToCenter(cell, q.line);
  // The interval of a line begins with its second point if the center is on the right of the line.
  const auto isStart = [](const RimPoint& its, int turn) { return (turn > 0) == its.isAhead; };
  if (pLeft.sign * qTurn > 0) return !isStart(q, qTurn);
  if (qLeft.sign * pTurn > 0) return isStart(p, pTurn);
  // An edge has the direction to its neighbor, turned to the left.
  const auto endsOf = [&](const RimLine& line) {
    return line.isOfEdge() ? std::array{siteOf(cell), siteOf(line.neighbor)} : sitesOf(line);
  };
  const auto [pFrom, pTo] = endsOf(p.line);
  const auto [qFrom, qTo] = endsOf(q.line);
  const int turn = seenFromDisc(cell, std::array{pFrom, pTo, qFrom, qTo}, [&](const auto&, const auto& seen, int) {
    const auto directionOf = [](const RimLine& line, const auto& from, const auto& to) {
      const auto v = to.v - from.v;
      return line.isOfEdge() ? PlaneVector{-v.y, v.x} : PlaneVector{v.x, v.y};
    };
    return cross(directionOf(p.line, seen[0], seen[1]), directionOf(q.line, seen[2], seen[3])).sign();
  });
  return pTurn * qTurn * turn > 0;
}

}  // namespace circle_voronoi
