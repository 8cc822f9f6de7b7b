// SPDX-License-Identifier: GPL-3.0-or-later
#include "shifted_signs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "homogeneous_disc.h"
#include "in_circle.h"
#include "linear_sign.h"
#include "relative_circle.h"
#include "sign_at_crossing.h"
#include "vectors.h"
#include "vertex_error.h"
#include "weighted_numbers.h"

namespace circle_voronoi {
namespace {

using exact::cross;
using exact::planeCross;
using exact::planeDot;
using exact::RelativeCircle;
using exact::seenFrom;
using exact::signOf;
using exact::Vector3;

/// Generous bounds on rounding, relative to the sizes of the summands. Nothing overflows or underflows: all numbers are
/// multiples of 2^-96 up to 2^100 (limits.h), at most six are multiplied, and vertices, of which there is one at most
/// in a product, lie within 2^876.
constexpr double kSignRounding = 0x1p-48;

double sizeOf(Vector v) { return std::abs(v.x) + std::abs(v.y); }
Vector vectorFrom(const Circle& c, Point p) { return {p.x - c.x, p.y - c.y}; }
int signOfNumber(double value) { return value > 0 ? 1 : value < 0 ? -1 : 0; }

/// The effect of a tiny shift of a line with this direction on the side of a point on it.
int sideAfterShift(const ShiftedSigns::Line& line) {
  if (line.to.y != line.from.y) return line.to.y > line.from.y ? 1 : -1;
  return line.to.x > line.from.x ? -1 : 1;
}

/// A place as a circle, for `seenFrom`: the radius is that of the circle from which it is seen.
Circle circleAt(Point p, const Circle& from) { return {p.x, p.y, from.r}; }

/// Returns the sign of |p - own| - own.r - (|p - other| - other.r): positive if the other circle is nearer.
int exactLead(const Circle& own, const Circle& other, Point corner) {
  const Circle p = circleAt(corner, own);
  return seenFrom(p, std::array{&own, &other}, [](const auto& seen, int) {
    const auto& u = seen[0].v;
    const auto& v = seen[1].v;
    // The distances a and b, with a = b + s but for the sign, s = own.r - other.r.
    const auto s = u.s - v.s;
    const auto aa = planeDot(u, u);
    const auto bb = planeDot(v, v);
    const bool isLarger = s.sign() >= 0;
    const auto& square = isLarger ? bb : aa;
    const auto signOfSum = [&](const auto& number, const auto& factor) {
      return signOf((number * number - factor * factor * square).sign(), [&] { return number.sign(); },
                    [&] { return factor.sign(); });
    };
    if (const int sign = signOfSum(isLarger ? aa - bb - s * s : aa + s * s - bb, -(s + s)); sign != 0) return sign;
    // The derivative along x, then the second one, then that along y.
    if (const int sign = signOfSum((isLarger ? v.x : u.x) * s, v.x - u.x); sign != 0) return sign;
    if (const int sign = s.sign(); sign != 0) return -sign;
    return (v.y - u.y).sign();
  });
}

Point centerPointOf(const Circle& c) { return {c.x, c.y}; }

/// Returns 1 if a line turns to the left of another one, -1 if it turns to the right, 0 if they are parallel.
int turnBetween(const ShiftedSigns::Line& first, const ShiftedSigns::Line& second) {
  const Circle origin = {first.from.x, first.from.y, 0};
  const Circle end = circleAt(first.to, origin);
  const Circle from = circleAt(second.from, origin);
  const Circle to = circleAt(second.to, origin);
  return seenFrom(origin, std::array<const Circle*, 3>{&end, &from, &to},
                  [](const auto& seen, int) { return planeCross(seen[0].v, seen[2].v - seen[1].v).sign(); });
}

}  // namespace

ShiftedSigns::ShiftedSigns(const Diagram& diagram) : diagram_(diagram), isCurved_(diagram.metric == Metric::circles) {}

/// The face of an end of a side: the vertex, or two circles and infinity.
exact::Face ShiftedSigns::faceOf(SideIndex side, bool isTarget) const {
  const VertexIndex vertex = isTarget ? diagram_.targetOf(side) : diagram_.originOf(side);
  if (vertex == kNone) {
    const Circle* own = &circle(diagram_.circleOf(side));
    const Circle* other = &circle(diagram_.neighborOf(side));
    if (isTarget) return {own, other, nullptr};
    return {other, own, nullptr};
  }
  const auto& [a, b, c] = diagram_.vertexCircles[static_cast<std::size_t>(vertex)];
  return {&circle(a), &circle(b), &circle(c)};
}

double ShiftedSigns::errorOf(VertexIndex vertex) const { return vertexError(diagram_, vertex); }

ShiftedSigns::Comparison ShiftedSigns::compare(CircleIndex own, CircleIndex other, Point corner) const {
  const Circle& c = circle(own);
  const Circle& d = circle(other);
  if (!isCurved_) return compareStraight(c, d, corner);
  const Vector toOwn = vectorFrom(c, corner);
  const Vector toOther = vectorFrom(d, corner);
  const double near = std::sqrt(dot(toOwn, toOwn));
  const double far = std::sqrt(dot(toOther, toOther));
  const double difference = c.r - d.r;
  const double value = (far - near) + difference;
  const double error = kSignRounding * (near + far + std::abs(difference));
  if (value > error) return {1, (value - error) / 2};
  if (value < -error) return {-1, -1};
  return {-exactLead(c, d, corner), -1};
}

ShiftedSigns::Comparison ShiftedSigns::compareStraight(const Circle& c, const Circle& d, Point corner) const {
  const Vector p = vectorFrom(c, corner);
  const Vector across = between(c, d);
  const double square = dot(across, across);
  const TwoPart own = weight(c);
  const TwoPart its = weight(d);
  const double value = square - 2 * dot(p, across) + ((own.value - its.value) + (own.rest - its.rest));
  const double error =
      kSignRounding * (square + 2 * sizeOf(p) * sizeOf(across) + std::abs(own.value) + std::abs(its.value));
  if (value > error) return {1, (value - error) / (2 * std::sqrt(square)) * (1 - kSignRounding)};
  if (value < -error) return {-1, -1};
  const WeightedNumbers numbers({corner, centerPointOf(c), centerPointOf(d)}, {weight(c), weight(d)});
  const auto u = numbers.between(centerPointOf(c), corner);
  const auto v = numbers.between(centerPointOf(c), centerPointOf(d));
  const auto weights = numbers.weight(weight(c)) - numbers.weight(weight(d));
  const auto twice = dotOf(u, v) + dotOf(u, v);
  if (const int sign = (dotOf(v, v) - twice + weights).sign(); sign != 0) return {sign, -1};
  // The derivatives of the value along x and along y.
  return {v.x.sign() != 0 ? -v.x.sign() : -v.y.sign(), -1};
}

int ShiftedSigns::sideOf(Point p, const Line& line) const {
  const int sign = orientation(line.from, line.to, p);
  return sign != 0 ? sign : sideAfterShift(line);
}

int ShiftedSigns::sideOfEnd(SideIndex side, bool isTarget, const Line& line) const {
  const VertexIndex vertex = isTarget ? diagram_.targetOf(side) : diagram_.originOf(side);
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  const Vector along = {line.to.x - line.from.x, line.to.y - line.from.y};
  if (vertex == kNone) {
    if (!isCurved_) {
      // The bisector goes at right angles to the line of centers; a parallel to it lies on the neighbor's side.
      const WeightedNumbers numbers({line.from, line.to, centerPointOf(own), centerPointOf(other)}, {});
      const auto direction = numbers.between(line.from, line.to);
      const auto across = numbers.between(centerPointOf(own), centerPointOf(other));
      if (const int sign = dotOf(direction, across).sign(); sign != 0) return isTarget ? sign : -sign;
      return crossOf(direction, across).sign();
    }
    const HomogeneousDisc end = isTarget ? discAtInfinity(own, other) : discAtInfinity(other, own);
    const double value = along.x * end.y - along.y * end.x;
    const double error = sizeOf(along) * (end.error + kSignRounding * (std::abs(end.x) + std::abs(end.y)));
    if (std::abs(value) > error) return signOfNumber(value);
  } else {
    const Vertex& v = diagram_.vertices[static_cast<std::size_t>(vertex)];
    const Vector toVertex = {v.x - line.from.x, v.y - line.from.y};
    const double value = along.x * toVertex.y - along.y * toVertex.x;
    const double error = sizeOf(along) * (errorOf(vertex) + kSignRounding * sizeOf(toVertex));
    if (std::abs(value) > error) return signOfNumber(value);
  }
  const exact::Face face = faceOf(side, isTarget);
  if (!isCurved_) {
    const auto& [o, a, b] = face;
    const WeightedNumbers numbers({line.from, line.to, centerPointOf(*o), centerPointOf(*a), centerPointOf(*b)},
                                  {weight(*o), weight(*a), weight(*b)});
    const auto u = numbers.between(centerPointOf(*o), centerPointOf(*a));
    const auto w = numbers.between(centerPointOf(*o), centerPointOf(*b));
    const auto from = numbers.between(centerPointOf(*o), line.from);
    const auto direction = numbers.between(line.from, line.to);
    const auto ku = dotOf(u, u) + numbers.weight(weight(*o)) - numbers.weight(weight(*a));
    const auto kw = dotOf(w, w) + numbers.weight(weight(*o)) - numbers.weight(weight(*b));
    const auto determinant = crossOf(u, w);
    const auto twice = determinant + determinant;
    // Twice the vertex times the determinant, less twice the start of the line times the determinant.
    const auto x = ku * w.y - kw * u.y - twice * from.x;
    const auto y = kw * u.x - ku * w.x - twice * from.y;
    const int sign = (direction.x * y - direction.y * x).sign();
    return sign != 0 ? sign : sideAfterShift(line);
  }
  const auto [u, v] = exact::othersOf(face, &own);
  const Circle from = circleAt(line.from, own);
  const Circle to = circleAt(line.to, own);
  const int sign = seenFrom(own, std::array{u, v, &from, &to}, [](const auto& seen, int) {
    const auto& a = seen[2].v;
    const auto direction = seen[3].v - a;
    return linearSign(seen[0], seen[1], -direction.y, direction.x, None(), direction.y * a.x - direction.x * a.y);
  });
  if (sign != 0) return sign;
  if (vertex != kNone) return sideAfterShift(line);
  // The asymptote is parallel to the line. It passes through the middle between the centers.
  const int middle = seenFrom(from, std::array<const Circle*, 3>{&own, &other, &to}, [](const auto& seen, int) {
    return planeCross(seen[2].v, seen[0].v + seen[1].v).sign();
  });
  return middle != 0 ? middle : sideAfterShift(line);
}

int ShiftedSigns::sideOfApex(SideIndex side, const Line& line) const {
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  const Vector along = {line.to.x - line.from.x, line.to.y - line.from.y};
  const Vector toOwn = {own.x - line.from.x, own.y - line.from.y};
  const Vector across = between(own, other);
  const double distance = length(across);
  // Twice the distance times the apex.
  const double difference = own.r - other.r;
  const double apart = 2 * cross(along, toOwn) + cross(along, across);
  const double value = distance * apart + difference * cross(along, across);
  const double error =
      4 * kSignRounding * sizeOf(along) * (2 * sizeOf(toOwn) + sizeOf(across)) * (distance + std::abs(difference));
  if (std::abs(value) > error) return signOfNumber(value);
  const Circle from = circleAt(line.from, own);
  const Circle to = circleAt(line.to, own);
  const int sign = seenFrom(from, std::array<const Circle*, 3>{&own, &other, &to}, [](const auto& seen, int) {
    const auto& u = seen[0].v;
    const auto d = seen[1].v - u;
    const auto& direction = seen[2].v;
    const auto turn = planeCross(direction, d);
    const auto p = -(d.s * turn);
    const auto center = planeCross(direction, u);
    const auto q = center + center + turn;
    return signOf((p * p - q * q * planeDot(d, d)).sign(), [&] { return p.sign(); }, [&] { return q.sign(); });
  });
  return sign != 0 ? sign : sideAfterShift(line);
}

int ShiftedSigns::turnFromEnd(SideIndex side, bool isTarget, Point corner) const {
  const VertexIndex vertex = isTarget ? diagram_.targetOf(side) : diagram_.originOf(side);
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  const Vector toCorner = vectorFrom(own, corner);
  Vector toEnd;
  double error = 0;
  if (vertex == kNone) {
    const HomogeneousDisc end = isTarget ? discAtInfinity(own, other) : discAtInfinity(other, own);
    toEnd = {end.x, end.y};
    error = end.error;
  } else {
    const Vertex& v = diagram_.vertices[static_cast<std::size_t>(vertex)];
    toEnd = vectorFrom(own, {v.x, v.y});
    error = errorOf(vertex);
  }
  const double value = cross(toEnd, toCorner);
  if (std::abs(value) > sizeOf(toCorner) * (error + kSignRounding * sizeOf(toEnd))) return signOfNumber(value);
  const auto [u, v] = exact::othersOf(faceOf(side, isTarget), &own);
  const Circle p = circleAt(corner, own);
  return seenFrom(own, std::array{u, v, &p}, []<class Number>(const std::array<RelativeCircle<Number>, 3>& seen, int) {
    const auto turn = [&](const Number& x, const Number& y) {
      return linearSign(seen[0], seen[1], y, -x, None(), None());
    };
    const Number one(1);
    const Number zero(0);
    if (const int sign = turn(seen[2].v.x, seen[2].v.y); sign != 0) return sign;
    if (const int sign = turn(one, zero); sign != 0) return sign;
    return turn(zero, one);
  });
}

int ShiftedSigns::turnFromNeighbor(SideIndex side, Point corner) const {
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  const int sign = orientation(centerPointOf(own), centerPointOf(other), corner);
  if (sign != 0) return sign;
  return own.y != other.y ? (other.y > own.y ? -1 : 1) : (other.x > own.x ? 1 : -1);
}

bool ShiftedSigns::hasApex(SideIndex side) const {
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  if (own.r > other.r) return false;
  // The apex of a straight line that does not span half a turn does not count.
  if (own.r == other.r && (diagram_.originOf(side) != kNone || diagram_.targetOf(side) != kNone)) return false;
  return turnFromEnd(side, false, centerPointOf(other)) > 0 && turnFromEnd(side, true, centerPointOf(other)) < 0;
}

// With the centers c and c' as seen from the start of the line, its direction d, D = c' - c and the difference s of the
// radii, the line at the height k above the middle of the centers, with 2 k = d x (c + c'), meets the hyperbola's
// branch on its side twice if and only if (2 k)^2 > s^2 |d|^2 - (d . D)^2 > 0.
bool ShiftedSigns::crossesTwice(SideIndex side, const Line& line, int center) const {
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  const Vector along = {line.to.x - line.from.x, line.to.y - line.from.y};
  const Vector across = between(own, other);
  const double s = own.r - other.r;
  const double square = dot(along, along);
  const double bound = s * s * square - dot(along, across) * dot(along, across);
  const double whole = square * (s * s + dot(across, across));
  if (bound < -8 * kSignRounding * whole) return false;
  const double height = cross(along, {own.x - line.from.x, own.y - line.from.y}) +
                        cross(along, {other.x - line.from.x, other.y - line.from.y});
  const double size = sizeOf(along) * (sizeOf({own.x - line.from.x, own.y - line.from.y}) +
                                       sizeOf({other.x - line.from.x, other.y - line.from.y}));
  if (height * center < -4 * kSignRounding * size) return false;
  if (height * height - bound < -8 * kSignRounding * (whole + size * size)) return false;
  const Circle from = circleAt(line.from, own);
  const Circle to = circleAt(line.to, own);
  return seenFrom(from, std::array<const Circle*, 3>{&own, &other, &to}, [&](const auto& seen, int) {
    const auto& [c, d, direction] = seen;
    const auto difference = d.v - c.v;
    const auto k = planeCross(direction.v, c.v + d.v);
    const auto along2 = planeDot(direction.v, difference);
    const auto least = difference.s * difference.s * planeDot(direction.v, direction.v) - along2 * along2;
    if (least.sign() <= 0 || k.sign() != center) return false;
    const int sign = (k * k - least).sign();
    // A tangent: the shift moves it to the inside if it moves it away from the center.
    return sign != 0 ? sign > 0 : sideAfterShift(line) == center;
  });
}

bool ShiftedSigns::isAheadOf(SideIndex side, const Line& line, Point corner) const {
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  const Circle p = circleAt(corner, own);
  const Circle from = circleAt(line.from, own);
  const Circle to = circleAt(line.to, own);
  return seenFrom(p, std::array<const Circle*, 4>{&own, &other, &from, &to}, [](const auto& seen, int) {
           const auto& [c, d, start, end] = seen;
           const auto direction = end.v - start.v;
           const auto difference = d.v - c.v;
           // Twice the vector from the corner to the middle of the centers.
           const auto toMiddle = c.v + d.v;
           const auto ss = difference.s * difference.s;
           const auto along = planeDot(direction, difference);
           const int sign = (ss * planeDot(toMiddle, direction) - planeDot(toMiddle, difference) * along).sign();
           if (sign != 0) return sign;
           // The shift moves the corner, but not the line through the middles of all parallel chords.
           const int alongX = (difference.x * along - ss * direction.x).sign();
           return alongX != 0 ? alongX : (difference.y * along - ss * direction.y).sign();
         }) > 0;
}

// Towards another place p moves |p - c| - |p - c'| by the difference of the unit vectors from the centers, which times
// both distances rho and rho' is linear in both: (p - c) (rho' - rho) + rho (c' - c).
int ShiftedSigns::approachAtEnd(SideIndex side, bool isTarget, const Line& line) const {
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  const auto [u, v] = exact::othersOf(faceOf(side, isTarget), &own);
  const Circle from = circleAt(line.from, own);
  const Circle to = circleAt(line.to, own);
  return seenFrom(own, std::array{u, v, &other, &from, &to}, [](const auto& seen, int) {
    const auto& neighbor = seen[2].v;
    const auto direction = seen[4].v - seen[3].v;
    return linearSign(seen[0], seen[1], neighbor.s * direction.x, neighbor.s * direction.y,
                      planeDot(direction, neighbor), None());
  });
}

bool ShiftedSigns::goesToNeighbor(SideIndex side, const Line& line) const {
  const Circle& own = circle(diagram_.circleOf(side));
  const Circle& other = circle(diagram_.neighborOf(side));
  const Circle from = circleAt(line.from, own);
  const Circle to = circleAt(line.to, own);
  return seenFrom(own, std::array<const Circle*, 3>{&other, &from, &to},
                  [](const auto& seen, int) { return planeDot(seen[0].v, seen[2].v - seen[1].v).sign(); }) > 0;
}

// With x the vector from the middle of the centers and D that between them, the branches of the hyperbola are where
// 4 (x . D)^2 - 4 s^2 x . x = s^2 (D . D - s^2), and the left side is the larger one on the inner side of each branch.
double ShiftedSigns::shareOfCrossing(CircleIndex from, CircleIndex to, const Line& line) const {
  const Circle& c = circle(from);
  const Circle& d = circle(to);
  if (!isCurved_ || c.r == d.r) {
    const WeightedNumbers numbers({line.from, line.to, centerPointOf(c), centerPointOf(d)}, {weight(c), weight(d)});
    const auto across = numbers.between(centerPointOf(c), centerPointOf(d));
    const auto start = numbers.between(centerPointOf(c), line.from);
    const auto direction = numbers.between(line.from, line.to);
    const auto half = dotOf(start, across);
    const auto way = dotOf(direction, across);
    const auto weights = isCurved_ ? FixedInteger<8>() : numbers.weight(weight(c)) - numbers.weight(weight(d));
    return (exact::floating(dotOf(across, across) + weights - half - half) / exact::floating(way + way)).times(0);
  }
  const bool isToInner = d.r < c.r;
  const Circle start = circleAt(line.from, c);
  const Circle end = circleAt(line.to, c);
  return seenFrom(start, std::array<const Circle*, 3>{&c, &d, &end}, [&](const auto& seen, int) {
    const auto& direction = seen[2].v;
    const auto across = seen[1].v - seen[0].v;
    const auto toMiddle = seen[0].v + seen[1].v;  // twice
    const auto ss = across.s * across.s;
    const auto along = planeDot(direction, across);
    const auto height = planeDot(toMiddle, across);
    const auto twice = [](const auto& value) { return value + value; };
    // a t^2 + 2 b t + c is 0.
    const auto a = twice(twice(along * along - ss * planeDot(direction, direction)));
    const auto b = twice(ss * planeDot(toMiddle, direction) - height * along);
    const auto constant = height * height - ss * (planeDot(toMiddle, toMiddle) + planeDot(across, across) - ss);
    const auto square = b * b - a * constant;
    const exact::Floating root = square.sign() > 0 ? sqrt(exact::floating(square)) : exact::Floating(0, 0);
    const exact::Floating own = isToInner ? root : -root;
    const exact::Floating minusB = exact::floating(-b);
    // The form of the root in which nothing cancels.
    if (b.sign() == 0 || (b.sign() < 0) == isToInner) return ((minusB + own) / exact::floating(a)).times(0);
    return (exact::floating(constant) / (minusB + -own)).times(0);
  });
}

int ShiftedSigns::turnFromRay(CircleIndex own, Point through, Point corner) const {
  const Point center = centerPointOf(circle(own));
  if (center != through) {
    if (const int sign = orientation(center, through, corner); sign != 0) return sign;
  }
  return corner.y != through.y ? signOfNumber(corner.y - through.y) : signOfNumber(through.x - corner.x);
}

Circle ShiftedSigns::flattened(CircleIndex i) const {
  const Circle& c = circle(i);
  return {c.x, c.y, isCurved_ ? c.r : 0};
}

/// Returns the side of a line on which the branch bulges between both crossings. Returns 0 if the line crosses it once.
///
/// The branch encloses the smaller circle. On one side of the line, it goes to infinity as the ray does from the center
/// of the larger circle to that of the smaller one.
int ShiftedSigns::bulgeSide(CircleIndex left, CircleIndex right, const Line& line) const {
  const Circle own = flattened(left);
  const Circle other = flattened(right);
  if (own.r == other.r) return 0;
  const Circle from = circleAt(line.from, own);
  const Circle to = circleAt(line.to, own);
  return seenFrom(own, std::array{&other, &from, &to}, [](const auto& seen, int) {
    const auto& across = seen[0].v;
    const auto direction = seen[2].v - seen[1].v;
    const auto along = planeDot(direction, across);
    const bool isOnce = (along * along - across.s * across.s * planeDot(direction, direction)).sign() >= 0;
    return isOnce ? 0 : planeCross(direction, across).sign() * across.s.sign();
  });
}

/// Returns whether a line for which bulgeSide is not 0 is a tangent of the hyperbola.
bool ShiftedSigns::isTangent(CircleIndex left, CircleIndex right, const Line& line) const {
  const Circle own = flattened(left);
  const Circle other = flattened(right);
  const Circle from = circleAt(line.from, own);
  const Circle to = circleAt(line.to, own);
  return seenFrom(from, std::array{&own, &other, &to}, [](const auto& seen, int) {
    const auto& [c, d, direction] = seen;
    const auto difference = d.v - c.v;
    const auto height = planeCross(direction.v, c.v + d.v);
    const auto along = planeDot(direction.v, difference);
    return (height * height + along * along - difference.s * difference.s * planeDot(direction.v, direction.v))
               .sign() == 0;
  });
}

// The lines meet at the crossing of the unmoved line if it lies on the other line. If the crossing of the other line is
// elsewhere, either side is right for `isBefore`. Otherwise both sides of the region meet there in a corner. The
// moved corner lies in one of both cells, so the line crosses the bisector after the corner, or before it.
int ShiftedSigns::sideOfCrossing(CircleIndex left, CircleIndex right, const Line& line, const Line& other) const {
  const Circle& c = circle(left);
  const Circle& d = circle(right);
  int sign = 0;
  if (isCurved_) {
    const Circle from = circleAt(line.from, c);
    const Circle to = circleAt(line.to, c);
    const Circle otherFrom = circleAt(other.from, c);
    const Circle otherTo = circleAt(other.to, c);
    sign = seenFrom(c, std::array<const Circle*, 5>{&d, &from, &to, &otherFrom, &otherTo}, [](const auto& seen, int) {
      const auto direction = seen[4].v - seen[3].v;
      return signAtCrossing(AsGiven(), seen[0], decltype(seen[0].g)(), seen[1], seen[2],
                            planeCross(direction, seen[1].v - seen[3].v), planeCross(direction, seen[2].v - seen[1].v));
    });
  } else {
    const WeightedNumbers numbers({line.from, line.to, other.from, other.to, centerPointOf(c), centerPointOf(d)},
                                  {weight(c), weight(d)});
    const auto across = numbers.between(centerPointOf(c), centerPointOf(d));
    const auto start = numbers.between(centerPointOf(c), line.from);
    const auto direction = numbers.between(other.from, other.to);
    const auto along = numbers.between(line.from, line.to);
    const auto half = dotOf(start, across);
    const auto way = dotOf(along, across);
    const auto height = dotOf(across, across) + numbers.weight(weight(c)) - numbers.weight(weight(d)) - half - half;
    sign =
        (crossOf(direction, numbers.between(other.from, line.from)) * (way + way) + crossOf(direction, along) * height)
            .sign() *
        way.sign();
  }
  if (sign != 0) return sign;
  const int turn = turnBetween(other, line);
  if (turn == 0) return 0;
  // A corner of one line that lies on the other one.
  const auto isOn = [](Point p, const Line& its) { return orientation(its.from, its.to, p) == 0; };
  const std::array corners = {line.from, line.to, other.from, other.to};
  const auto corner = std::ranges::find_if(corners, [&](Point p) { return isOn(p, line) && isOn(p, other); });
  if (corner == corners.end()) return turn;
  // The tangent moves by far less than the corner moves along it, so both crossings stay behind the corner.
  if (line.from.y == line.to.y && bulgeSide(left, right, line) != 0 && isTangent(left, right, line)) {
    return line.to.x > line.from.x ? -turn : turn;
  }
  return compare(left, right, *corner).sign > 0 ? turn : -turn;
}

// A line that crosses the branch once divides it into what lies on its right, and then on its left. A line that crosses
// it twice cuts off an interval between both crossings. Where neither crossing lies in the interval of the other line,
// the intervals have the order of their middles, where the tangents are parallel to the lines.
bool ShiftedSigns::isBefore(CircleIndex left, CircleIndex right, const Line& line, const Line& other) const {
  const int side = sideOfCrossing(left, right, line, other);
  const int otherBulge = bulgeSide(left, right, other);
  if (otherBulge == 0 || side == otherBulge) return side < 0;
  const int otherSide = sideOfCrossing(left, right, other, line);
  const int bulge = bulgeSide(left, right, line);
  if (bulge == 0 || otherSide == bulge) return otherSide > 0;
  // One line, in both directions.
  if (side == 0) return bulge > otherBulge;
  const int curving = circle(right).r > circle(left).r ? 1 : -1;
  return bulge * otherBulge * turnBetween(line, other) * curving > 0;
}

// The ray from o in the direction P crosses the line from a to b at the share N / D, with N = P x (o - a),
// D = P x (b - a).
int ShiftedSigns::turnFromRay(CircleIndex own, Point through, CircleIndex from, CircleIndex to,
                              const Line& line) const {
  const int first = turnFromRay(own, through, line.from);
  const int second = turnFromRay(own, through, line.to);
  if (first == 0 || second == 0 || first == second) return first != 0 ? first : second;
  const Circle c = flattened(from);
  const Circle d = flattened(to);
  const Circle start = circleAt(line.from, c);
  const Circle end = circleAt(line.to, c);
  const Circle place = circleAt(through, c);
  const Circle center = circleAt(centerPointOf(circle(own)), c);
  // Positive if the crossing comes after the ray, along the line.
  const int ahead =
      seenFrom(c, std::array<const Circle*, 5>{&d, &start, &end, &place, &center}, [&](const auto& seen, int) {
        auto ray = seen[3].v - seen[4].v;
        if (ray.x.sign() == 0 && ray.y.sign() == 0) ray.x = decltype(ray.x)(1);
        const auto whole = planeCross(ray, seen[2].v - seen[1].v);
        return signAtCrossing(AsGiven(), seen[0], decltype(seen[0].g)(), seen[1], seen[2],
                              planeCross(ray, seen[1].v - seen[4].v), whole) *
               whole.sign();
      });
  return ahead == 0 ? 0 : ahead > 0 ? second : first;
}

double ShiftedSigns::shareOnRay(CircleIndex own, Point through, const Line& line) const {
  const Circle& c = circle(own);
  const Circle start = circleAt(line.from, c);
  const Circle end = circleAt(line.to, c);
  const Circle place = circleAt(through, c);
  return seenFrom(start, std::array<const Circle*, 3>{&c, &end, &place}, [](const auto& seen, int) {
    auto ray = seen[2].v - seen[0].v;
    if (ray.x.sign() == 0 && ray.y.sign() == 0) ray.x = decltype(ray.x)(1);
    return (exact::floating(planeCross(ray, seen[0].v)) / exact::floating(planeCross(ray, seen[1].v))).times(0);
  });
}

}  // namespace circle_voronoi
