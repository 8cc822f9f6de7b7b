// SPDX-License-Identifier: GPL-3.0-or-later
#include "distance_signs.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "exact.h"
#include "linear_sign.h"
#include "rounded.h"
#include "scale.h"
#include "sign_at_crossing.h"
#include "vertex_error.h"

namespace circle_voronoi {
namespace {

using exact::seenFrom;

/// A generous bound on rounding, relative to the sizes of the summands.
constexpr double kSignError = 0x1p-46;
/// Crossings are right to this share of their side.
constexpr double kCrossingError = 0x1p-42;
/// Chords are computed in integers where rounding of the line's distance makes a larger share of them.
constexpr double kTangentError = 0x1p-16;

double extentOf(Vector v) { return std::abs(v.x) + std::abs(v.y); }
Vector fromCenter(const Circle& c, Point p) { return {p.x - c.x, p.y - c.y}; }
int signFrom(double value) { return value > 0 ? 1 : -1; }
/// A place as a circle of the radius of another one, for seenFrom.
Circle placeSeen(Point p, const Circle& from) { return {p.x, p.y, from.r}; }

/// A line that meets a rim, seen from the center: its points are (h n + t u) / (2 u . u), where n is u turned to the
/// left.
template <class Direction, class Height>
struct LineForm {
  Direction u;
  Height h;
};
template <class Direction, class Height>
LineForm(Direction, Height) -> LineForm<Direction, Height>;

/// `first` and `second` are the ends of a side, or the other circle of an edge twice. `radius` is that of the disc.
template <class View, class SeenCircle, class Radius>
auto lineForm(View view, const RimLine& line, const SeenCircle& first, const SeenCircle& second, const Radius& radius) {
  const auto d = view.fixed(first.v);
  const auto s = view.number(first.v.s);
  PlaneVector u = {-d.y, d.x};
  auto h = view.linear(s * (s + twice(radius)) - dot(d, d));
  if (!line.isOfEdge()) {
    u = view.fixed(second.v - first.v);
    h = twice(view.linear(cross(u, view.moved(first.v))));
  }
  return LineForm{u, h};
}

}  // namespace

DistanceSigns::DistanceSigns(const Diagram& diagram, double maxDistance)
    : diagram_(diagram), distance_(rounded(maxDistance)) {}

Circle DistanceSigns::circle(CircleIndex i) const {
  Circle c = diagram_.circles[static_cast<std::size_t>(i)];
  if (diagram_.metric != Metric::circles) c.r = 0;
  return c;
}

bool DistanceSigns::hasDisc(CircleIndex cell) const {
  // A sum of two doubles has the right sign.
  return radius(cell) > 0;
}

ShiftedSign DistanceSigns::beyond(VertexIndex vertex) const {
  const double value = diagram_.vertices[static_cast<std::size_t>(vertex)].r - distance_;
  const auto& indices = diagram_.vertexCircles[static_cast<std::size_t>(vertex)];
  const Circle own = circle(indices[0]);
  const double error = 4 * vertexError(diagram_, vertex) + kSignError * (own.r + std::abs(distance_));
  if (std::abs(value) > error) return {signFrom(value), false};
  const Circle u = circle(indices[1]);
  const Circle v = circle(indices[2]);
  const Circle reach = reachOf(own);
  const int sign = seenFrom(own, std::array{&u, &v, &reach},
                            []<class Number>(const std::array<exact::RelativeCircle<Number>, 3>& seen, int) {
                              const Number zero(0);
                              const Number one(1);
                              return linearSign(seen[0], seen[1], zero, zero, one, one * seen[2].v.s);
                            });
  return {sign > 0 ? 1 : -1, sign == 0};
}

ShiftedSign DistanceSigns::beyond(const SideCrossing& crossing) const {
  if (!hasDisc(crossing.before)) return {1, false};
  const Circle own = circle(crossing.before);
  const Circle other = circle(crossing.after);
  const double reached = lengthOf(fromCenter(own, crossing.point));
  const double value = reached - (own.r + distance_);
  const double error =
      kCrossingError * extentOf(vectorTo(crossing.from, crossing.to)) +
      kSignError * (reached + own.r + std::abs(distance_) + extentOf({crossing.point.x, crossing.point.y}));
  if (std::abs(value) > error) return {signFrom(value), false};
  const Circle from = placeSeen(crossing.from, own);
  const Circle to = placeSeen(crossing.to, own);
  const Circle reach = reachOf(own);
  return shiftedSign(own, std::array{&other, &from, &to, &reach}, [](auto view, const auto& seen) {
    const auto d = view.fixed(seen[0].v);
    const auto start = view.moved(seen[1].v);
    const auto direction = view.fixed(seen[2].v - seen[1].v);
    const auto s = view.number(seen[0].v.s);
    const auto radius = view.number(-seen[3].v.s);
    const auto along = dot(direction, d);
    if (s.sign() == 0) {
      const PlaneVector toMiddle = {d.x - twice(start.x), d.y - twice(start.y)};
      const auto way = twice(along);
      const auto height = dot(toMiddle, d);
      const PlaneVector place = {start.x * way + direction.x * height, start.y * way + direction.y * height};
      return (dot(place, place) - radius * radius * (way * way)).sign();
    }
    // The difference of the powers of the point to both discs has the sign of its distance less the limit, times -s.
    const auto lambda = twice(dot(start, d)) - dot(d, d) + s * (s + twice(radius));
    return -s.sign() * signAtCrossing(view, seen[0], seen[1], seen[2], lambda, twice(along));
  });
}

ShiftedSign DistanceSigns::beyond(CircleIndex cell, Point corner) const {
  const Circle own = circle(cell);
  const double radius = own.r + distance_;
  const Vector v = fromCenter(own, corner);
  const double square = dot(v, v);
  const double value = square - radius * radius;
  const double size = own.r + std::abs(distance_);
  if (std::abs(value) > kSignError * (square + size * size)) return {signFrom(value), false};
  const Circle p = placeSeen(corner, own);
  const Circle reach = reachOf(own);
  return shiftedSign(own, std::array{&p, &reach}, [](auto view, const auto& seen) {
    const auto place = view.moved(seen[0].v);
    const auto its = view.number(seen[1].v.s);
    return (dot(place, place) - its * its).sign();
  });
}

bool DistanceSigns::hasApex(CircleIndex left, CircleIndex right) const {
  const Circle own = circle(left);
  const Circle other = circle(right);
  const double apart = lengthOf(between(own, other));
  const double sum = radius(left) + radius(right);
  const double error = kSignError * (apart + own.r + other.r + 2 * std::abs(distance_));
  if (std::abs(sum - apart) > error) return sum > apart;
  const Circle reach = reachOf(own);
  return seenFrom(own, std::array{&other, &reach}, [](const auto& seen, int) {
    const auto both = seen[0].v.s - twice(seen[1].v.s);
    return both.sign() > 0 && (both * both - exact::planeDot(seen[0].v, seen[0].v)).sign() > 0;
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
  std::array<Circle, 3> circles;
  exact::Face face;
  std::size_t its = 0;
  for (std::size_t k = 0; k < face.size(); ++k) {
    const CircleIndex index = diagram_.vertexCircles[static_cast<std::size_t>(vertex)][k];
    circles[k] = circle(index);
    face[k] = &circles[k];
    if (index == left) its = k;
  }
  const auto [u, w] = exact::othersOf(face, &circles[its]);
  const int sign = seenFrom(circles[its], std::array<const Circle*, 3>{u, w, &other}, [](const auto& seen, int) {
    const auto& d = seen[2].v;
    return linearSign(seen[0], seen[1], -d.y, d.x, None(), None());
  });
  return {sign >= 0 ? 1 : -1, sign == 0};
}

ShiftedSign DistanceSigns::pastApex(CircleIndex left, CircleIndex right, const SideCrossing& crossing) const {
  const Circle own = circle(crossing.before);
  const Circle other = circle(crossing.after);
  const int way = crossing.before == left && crossing.after == right ? 1 : -1;
  const Vector across = between(own, other);
  const Vector toPoint = fromCenter(own, crossing.point);
  const double value = cross(across, toPoint);
  const double error = kCrossingError * extentOf(vectorTo(crossing.from, crossing.to)) +
                       kSignError * (extentOf(toPoint) + extentOf({crossing.point.x, crossing.point.y}));
  if (std::abs(value) > extentOf(across) * error) return {way * signFrom(value), false};
  const Circle from = placeSeen(crossing.from, own);
  const Circle to = placeSeen(crossing.to, own);
  const auto sign = shiftedSign(own, std::array{&other, &from, &to}, [](auto view, const auto& seen) {
    const auto d = view.fixed(seen[0].v);
    const auto start = view.moved(seen[1].v);
    const auto direction = view.fixed(seen[2].v - seen[1].v);
    return signAtCrossing(view, seen[0], seen[1], seen[2], cross(d, start), cross(d, direction));
  });
  return {way * sign.sign, sign.isTie};
}

ShiftedSign DistanceSigns::pastFoot(CircleIndex cell, Point from, Point to, Point corner) const {
  const Circle own = circle(cell);
  const Vector along = vectorTo(from, to);
  const Vector toCorner = fromCenter(own, corner);
  const double value = dot(along, toCorner);
  if (std::abs(value) > kSignError * extentOf(along) * extentOf(toCorner)) return {signFrom(value), false};
  const Circle start = placeSeen(from, own);
  const Circle end = placeSeen(to, own);
  const Circle p = placeSeen(corner, own);
  return shiftedSign(own, std::array{&start, &end, &p}, [](auto view, const auto& seen) {
    return dot(view.fixed(seen[1].v - seen[0].v), view.moved(seen[2].v)).sign();
  });
}

ShiftedSign DistanceSigns::pastFoot(CircleIndex cell, const SideCrossing& crossing) const {
  const Circle own = circle(crossing.before);
  const Circle other = circle(crossing.after);
  const Circle center = circle(cell);
  const Vector along = vectorTo(crossing.from, crossing.to);
  const Vector toPoint = fromCenter(center, crossing.point);
  const double value = dot(along, toPoint);
  const double error = kCrossingError * extentOf(along) +
                       kSignError * (extentOf(toPoint) + extentOf({crossing.point.x, crossing.point.y}));
  if (std::abs(value) > extentOf(along) * error) return {signFrom(value), false};
  const Circle from = placeSeen(crossing.from, own);
  const Circle to = placeSeen(crossing.to, own);
  return shiftedSign(own, std::array{&other, &from, &to, &center}, [](auto view, const auto& seen) {
    const auto start = view.moved(seen[1].v);
    const auto foot = view.fixed(seen[3].v);
    const auto direction = view.fixed(seen[2].v - seen[1].v);
    const PlaneVector toStart = {start.x - foot.x, start.y - foot.y};
    return signAtCrossing(view, seen[0], seen[1], seen[2], dot(direction, toStart), dot(direction, direction));
  });
}

bool DistanceSigns::meetsDisc(CircleIndex cell, Point from, Point to) const {
  const Circle own = circle(cell);
  const Vector along = vectorTo(from, to);
  const Vector toStart = fromCenter(own, from);
  const double size = lengthOf(along);
  const double height = std::abs(cross(along, toStart));
  const double reached = radius(cell) * size;
  if (std::abs(reached - height) > kSignError * extentOf(along) * (extentOf(toStart) + own.r + std::abs(distance_))) {
    return reached > height;
  }
  const Circle start = placeSeen(from, own);
  const Circle end = placeSeen(to, own);
  const Circle reach = reachOf(own);
  return shiftedSign(own, std::array{&start, &end, &reach}, [](auto view, const auto& seen) {
           const auto direction = view.fixed(seen[1].v - seen[0].v);
           const auto its = cross(direction, view.moved(seen[0].v));
           const auto radius = view.number(seen[2].v.s);
           return (radius * radius * dot(direction, direction) - its * its).sign();
         }).sign > 0;
}

/// Returns half of the chord that a line cuts off a disc, right to rounding of itself.
double DistanceSigns::halfChord(CircleIndex cell, const RimLine& line) const {
  const Circle own = circle(cell);
  const Circle reach = reachOf(own);
  const Circle first = line.isOfEdge() ? circle(line.neighbor) : placeSeen(line.from, own);
  const Circle second = line.isOfEdge() ? first : placeSeen(line.to, own);
  return seenFrom(own, std::array{&first, &second, &reach}, [&](const auto& seen, int exponent) {
    const auto diameter = twice(-seen[2].v.s);
    const auto [u, h] = lineForm(AsGiven(), line, seen[0], seen[1], -seen[2].v.s);
    const auto square = diameter * diameter * dot(u, u) - h * h;
    if (square.sign() <= 0) return 0.0;
    return (sqrt(exact::floating(square)) / sqrt(exact::floating(dot(u, u)))).times(exponent - 1);
  });
}

RimPoint DistanceSigns::rimPoint(CircleIndex cell, const RimLine& line, bool isAhead) const {
  const Circle own = circle(cell);
  const double r = radius(cell);
  Vector along;
  double height = 0;       // the distance of the line to the left of the center, seen along it
  double heightError = 0;  // a bound on its error
  if (line.isOfEdge()) {
    const Circle other = circle(line.neighbor);
    const Vector across = between(own, other);
    const double apart = lengthOf(across);
    const double s = other.r - own.r;
    along = {-across.y / apart, across.x / apart};
    height = (s / apart * (s + 2 * r) - apart) / 2;
    heightError = kSignError * (std::abs(s) / apart * (std::abs(s) + 2 * r) + apart);
  } else {
    const Vector direction = vectorTo(line.from, line.to);
    const Vector toStart = fromCenter(own, line.from);
    along = measuredIn(lengthOf(direction), direction);
    height = cross(along, toStart);
    heightError = kSignError * extentOf(toStart);
  }
  const double error = heightError + kSignError * (own.r + std::abs(distance_));
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
  const Circle own = circle(cell);
  const Circle reach = reachOf(own);
  std::array<Circle, 4> circles;
  for (std::size_t k = 0; k < 2; ++k) {
    const RimLine& its = k == 0 ? p.line : line;
    circles[2 * k] = its.isOfEdge() ? circle(its.neighbor) : placeSeen(its.from, own);
    circles[2 * k + 1] = its.isOfEdge() ? circles[2 * k] : placeSeen(its.to, own);
  }
  const auto formula = [&](auto view, const auto& seen) {
    const auto radius = view.number(-seen[4].v.s);
    const auto [u, h] = lineForm(view, p.line, seen[0], seen[1], radius);
    const auto [w, k] = lineForm(view, line, seen[2], seen[3], radius);
    const auto along = dot(u, w);
    const auto across = cross(w, u);
    const auto uu = dot(u, u);
    const auto doubled = twice(radius * across);
    const auto norm = h * h * dot(w, w) - twice(h * k * along) + k * k * uu - doubled * doubled;
    return signOfRoot(norm.sign(), h * along - k * uu, p.isAhead ? across : -across);
  };
  return shiftedSign(own, std::array<const Circle*, 5>{&circles[0], &circles[1], &circles[2], &circles[3], &reach},
                     formula);
}

/// Returns 1 if a point of an edge lies ahead, in the direction of the line of another edge, as seen from the center,
/// -1 if it lies behind.
int DistanceSigns::aheadOn(CircleIndex cell, const RimPoint& p, const RimLine& line) const {
  const Circle own = circle(cell);
  const Circle reach = reachOf(own);
  const Circle first = circle(p.line.neighbor);
  const Circle second = circle(line.neighbor);
  return seenFrom(own, std::array{&first, &second, &reach}, [&](const auto& seen, int) {
    const auto radius = -seen[2].v.s;
    const auto [u, h] = lineForm(AsGiven(), p.line, seen[0], seen[0], radius);
    const auto [w, k] = lineForm(AsGiven(), line, seen[1], seen[1], radius);
    const auto along = dot(u, w);
    const auto doubled = twice(radius * along);
    return signOfRoot((h * h * dot(w, w) - doubled * doubled).sign(), h * cross(u, w), p.isAhead ? along : -along);
  });
}

/// Returns 1 if the center of a disc lies on the right of a line, -1 if it lies on its left.
int DistanceSigns::turnToCenter(CircleIndex cell, const RimLine& line) const {
  const Circle own = circle(cell);
  const Circle reach = reachOf(own);
  const Circle first = line.isOfEdge() ? circle(line.neighbor) : placeSeen(line.from, own);
  const Circle second = line.isOfEdge() ? first : placeSeen(line.to, own);
  return shiftedSign(own, std::array{&first, &second, &reach},
                     [&](auto view, const auto& seen) {
                       return lineForm(view, line, seen[0], seen[1], view.number(-seen[2].v.s)).h.sign();
                     })
      .sign;
}

bool DistanceSigns::isUpper(CircleIndex cell, const RimPoint& p) const {
  const double toAxis = std::min({p.place, std::abs(p.place - 2), 4 - p.place});
  if (toAxis > p.error) return p.place < 2;
  const Circle own = circle(cell);
  const Circle reach = reachOf(own);
  const Circle first = p.line.isOfEdge() ? circle(p.line.neighbor) : placeSeen(p.line.from, own);
  const Circle second = p.line.isOfEdge() ? first : placeSeen(p.line.to, own);
  const auto formula = [&](auto view, const auto& seen) {
    const auto radius = view.number(-seen[2].v.s);
    const auto form = lineForm(view, p.line, seen[0], seen[1], radius);
    const auto& u = form.u;
    const auto& h = form.h;
    const auto isOnAxis = [&](const auto& beside, const auto& ahead) {
      // The sign of h beside + t ahead sqrt(4 R^2 u . u - h^2).
      const auto doubled = twice(radius * ahead);
      return signOfRoot((h * h - doubled * doubled).sign(), h * beside, p.isAhead ? ahead : -ahead);
    };
    if (const int sign = isOnAxis(u.x, u.y); sign != 0) return sign;
    if constexpr (std::is_same_v<decltype(view), AsGiven>) return 0;
    return isOnAxis(-u.y, u.x);
  };
  return shiftedSign(own, std::array{&first, &second, &reach}, formula).sign > 0;
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
      return isAtOther ? !comesFirstOnLine(q) : isFollowedBy(p.side, q.side);
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
  const auto directionOf = [&](const RimLine& line) {
    const Circle own = circle(cell);
    if (!line.isOfEdge()) return std::pair(placeSeen(line.from, own), placeSeen(line.to, own));
    // The neighbor's direction, turned to the left by the formula.
    return std::pair(own, circle(line.neighbor));
  };
  const auto [pFrom, pTo] = directionOf(p.line);
  const auto [qFrom, qTo] = directionOf(q.line);
  const bool pIsEdge = p.line.isOfEdge();
  const bool qIsEdge = q.line.isOfEdge();
  const int turn = seenFrom(circle(cell), std::array{&pFrom, &pTo, &qFrom, &qTo}, [&](const auto& seen, int) {
    const auto turned = [](const auto& v, bool isEdge) {
      return isEdge ? PlaneVector{-v.y, v.x} : PlaneVector{v.x, v.y};
    };
    return cross(turned(seen[1].v - seen[0].v, pIsEdge), turned(seen[3].v - seen[2].v, qIsEdge)).sign();
  });
  return pTurn * qTurn * turn > 0;
}

}  // namespace circle_voronoi
