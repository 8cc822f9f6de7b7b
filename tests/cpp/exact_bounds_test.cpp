// SPDX-License-Identifier: GPL-3.0-or-later
// Cells in boxes and convex polygons whose corners and sides lie on vertices and edges of the diagram, and the largest
// empty discs there, against a clip in numbers of 160 digits.
//
// The exact signs of a clip are those of a region that is moved by (e, f), with f far smaller than e (shifted_signs.h).
// With so many digits the region can be moved indeed, and then nothing is a tie.
//
// CIRCLE_VORONOI_BOUNDS_CELLS sets the number of cells of each family.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/compute.h"
#include "in_circle.h"
#include "report.h"
#include "rings.h"
#include "same_cells.h"

namespace circle_voronoi {
namespace exact_bounds_test {
namespace {

using Real = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<160>, boost::multiprecision::et_off>;
using Random = std::mt19937_64;
using Ring = Region::Ring;

/// Pieces shorter than this share of the extent are not compared: rounding hides them.
constexpr double kVisible = 1e-11;

struct Place {
  Real x = 0, y = 0;
  friend Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y}; }
  friend Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y}; }
  friend Place operator*(const Real& f, const Place& a) { return {f * a.x, f * a.y}; }
};
Real dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }
Real cross(const Place& a, const Place& b) { return a.x * b.y - a.y * b.x; }
Real lengthOf(const Place& a) { return sqrt(dot(a, a)); }

/// The roots of a t^2 + 2 b t + c.
std::vector<Real> roots(const Real& a, const Real& b, const Real& c) {
  if (a == 0) return b == 0 ? std::vector<Real>{} : std::vector<Real>{-c / (2 * b)};
  const Real square = b * b - a * c;
  if (square < 0) return {};
  const Real sum = b < 0 ? Real(-b + sqrt(square)) : Real(-b - sqrt(square));
  if (sum == 0) return {Real(0)};
  return {sum / a, c / sum};
}

/// The parts of a cell that are compared.
struct Cell {
  Real area = 0;
  /// The number of arcs beside each neighbor, and of pieces on each side of the region, if they are long enough.
  std::map<std::int32_t, int> arcs;
  std::map<std::int32_t, int> sides;
  int loops = 0;            ///< with an area that is more than rounding
  Real clearance = -1e300;  ///< the largest of a disc around a point of the cell that meets no circle
};

/// A clip of the cell of a circle to a convex polygon that divides each side and each bisector wherever it may cross
/// anything, and asks for each piece whose border it is.
class Oracle {
 public:
  Oracle(const std::vector<Circle>& circles, const Ring& corners) : circles_(circles) {
    double extent = 0;
    for (const Point& p : corners)
      extent = std::max({extent, std::abs(p.x - corners[0].x), std::abs(p.y - corners[0].y)});
    extent_ = extent;
    const Place shift = {Real(extent) * Real("1e-50"), Real(extent) * Real("1e-125")};
    for (const Point& p : corners) corners_.push_back(Place{Real(p.x), Real(p.y)} + shift);
  }

  Cell cell(std::int32_t i) {
    own_ = i;
    places_.clear();
    parents_.clear();
    pieces_.clear();
    findCrossings();
    addSides();
    for (std::int32_t j = 0; j < static_cast<std::int32_t>(circles_.size()); ++j) {
      if (j != i) addArcs(j);
    }
    return result();
  }

 private:
  struct Piece {
    std::size_t from, to;   ///< places
    std::int32_t neighbor;  ///< -1 on the boundary of the region
    std::int32_t side;      ///< -1 on an arc
    Real area = 0;          ///< beyond the chord
  };
  /// A place where a side of the region or a bisector may be divided.
  struct Stop {
    Real at;
    std::size_t place;
  };

  Place centerOf(std::int32_t i) const { return {Real(circle(i).x), Real(circle(i).y)}; }
  const Circle& circle(std::int32_t i) const { return circles_[static_cast<std::size_t>(i)]; }
  Real distance(std::int32_t i, const Place& p) const { return lengthOf(p - centerOf(i)) - Real(circle(i).r); }
  std::size_t count() const { return corners_.size(); }
  const Place& corner(std::size_t k) const { return corners_[k % count()]; }

  std::size_t addPlace(const Place& p) {
    places_.push_back(p);
    parents_.push_back(places_.size() - 1);
    return places_.size() - 1;
  }
  std::size_t rootOf(std::size_t place) const { return parents_[place] == place ? place : rootOf(parents_[place]); }

  bool isNearest(const Place& p, std::int32_t beside) const {
    const Real own = distance(own_, p);
    for (std::int32_t j = 0; j < static_cast<std::int32_t>(circles_.size()); ++j) {
      if (j != own_ && j != beside && distance(j, p) < own) return false;
    }
    return true;
  }
  bool isInside(const Place& p) const {
    // Rounding may turn a corner of a convex polygon the other way by as little.
    bool isOdd = false;
    for (std::size_t k = 0; k < count(); ++k) {
      const Place& a = corner(k);
      const Place& b = corner(k + 1);
      if ((a.y > p.y) != (b.y > p.y)) isOdd ^= (cross(b - a, p - a) > 0) == (b.y > a.y);
    }
    return isOdd;
  }

  /// Finds where the sides of the region cross the bisectors of the circle.
  void findCrossings() {
    onSide_.assign(count(), {});
    onBisector_.assign(circles_.size(), {});
    for (std::size_t k = 0; k < count(); ++k) cornerPlaces_.resize(count()), cornerPlaces_[k] = addPlace(corner(k));
    const Place c = centerOf(own_);
    for (std::int32_t j = 0; j < static_cast<std::int32_t>(circles_.size()); ++j) {
      if (j == own_) continue;
      const Place u = centerOf(j) - c;
      const Real s = Real(circle(j).r) - Real(circle(own_).r);
      const Real whole = dot(u, u) - s * s;
      for (std::size_t k = 0; k < count(); ++k) {
        // With x = p + t v seen from the center, (whole - 2 u . x)^2 = 4 s^2 x . x.
        const Place p = corner(k) - c;
        const Place v = corner(k + 1) - corner(k);
        const Real rest = whole - 2 * dot(u, p);
        const Real slope = dot(u, v);
        const auto crossings =
            s == 0 ? roots(0, slope, -rest)
                   : roots(4 * (slope * slope - s * s * dot(v, v)), -2 * (rest * slope + 2 * s * s * dot(p, v)),
                           rest * rest - 4 * s * s * dot(p, p));
        for (const Real& t : crossings) {
          const Place x = p + t * v;
          const Real left = whole - 2 * dot(u, x);
          if (!(t > 0 && t < 1) || (s != 0 && left * s < 0) || lengthOf(x) + s < 0) continue;
          const std::size_t place = addPlace(corner(k) + t * v);
          onSide_[k].push_back({t, place});
          onBisector_[static_cast<std::size_t>(j)].push_back({heightOn(j, place), place});
        }
      }
    }
  }

  /// The position of a place along the bisector of a neighbor.
  Real heightOn(std::int32_t j, std::size_t place) const {
    const Place u = centerOf(j) - centerOf(own_);
    return cross(u, places_[place] - centerOf(own_)) / lengthOf(u);
  }

  void addSides() {
    for (std::size_t k = 0; k < count(); ++k) {
      std::vector<Stop> stops = onSide_[k];
      stops.push_back({0, cornerPlaces_[k]});
      stops.push_back({1, cornerPlaces_[(k + 1) % count()]});
      addPieces(
          stops, [&](const Real& t) { return corner(k) + t * (corner(k + 1) - corner(k)); },
          [&](const Place& p) { return isNearest(p, -1); }, -1, static_cast<std::int32_t>(k));
    }
  }

  void addArcs(std::int32_t j) {
    const Place c = centerOf(own_);
    const Place u = centerOf(j) - c;
    const Real d = lengthOf(u);
    const Real s = Real(circle(j).r) - Real(circle(own_).r);
    const Real bb = (d * d - s * s) / 4;
    if (!(bb > 0)) return;
    std::vector<Stop> stops = onBisector_[static_cast<std::size_t>(j)];
    for (std::int32_t l = 0; l < static_cast<std::int32_t>(circles_.size()); ++l) {
      if (l == own_ || l == j) continue;
      for (const Place& p : verticesOf(j, l)) {
        const std::size_t place = addPlace(p);
        stops.push_back({heightOn(j, place), place});
      }
    }
    const Place along = Real(1 / d) * u;
    const auto pointAt = [&](const Real& h) {
      const Real x = d / 2 - s / 2 * sqrt(1 + h * h / bb);
      return c + x * along + h * Place{-along.y, along.x};
    };
    const std::size_t first = pieces_.size();
    addPieces(
        stops, pointAt, [&](const Place& p) { return isInside(p) && isNearest(p, j); }, j, -1);
    // Seen with the cell on the left the arc goes upwards. Between it and its chord lies the integral of x over h.
    const auto integral = [&](const Real& h) {
      const Real b = sqrt(bb);
      const Real y = h / b;
      return -(s / 2) * b * (y * sqrt(1 + y * y) + log(y + sqrt(1 + y * y))) / 2;
    };
    for (std::size_t k = first; k < pieces_.size(); ++k) {
      const Real low = heightOn(j, pieces_[k].from);
      const Real high = heightOn(j, pieces_[k].to);
      const auto x = [&](const Real& h) { return -s / 2 * sqrt(1 + h * h / bb); };
      if (s != 0) pieces_[k].area = integral(high) - integral(low) - (high - low) * (x(low) + x(high)) / 2;
    }
  }

  /// The points at the same distance from the circle and two others.
  std::vector<Place> verticesOf(std::int32_t j, std::int32_t l) const {
    const Place c = centerOf(own_);
    const auto plane = [&](std::int32_t i) {
      const Place u = centerOf(i) - c;
      const Real s = Real(circle(i).r) - Real(circle(own_).r);
      return std::array<Real, 4>{u.x, u.y, s, (dot(u, u) - s * s) / 2};
    };
    const auto m = plane(j);
    const auto n = plane(l);
    using Vector3 = std::array<Real, 3>;
    const auto product = [](const auto& a, const auto& b) {
      return Vector3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const Vector3 direction = product(m, n);
    const Real square = direction[0] * direction[0] + direction[1] * direction[1] + direction[2] * direction[2];
    if (square == 0) return {};
    const Vector3 a = product(n, direction);
    const Vector3 b = product(direction, m);
    Vector3 p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (m[3] * a[k] + n[3] * b[k]) / square;
    const auto form = [](const Vector3& v, const Vector3& w) { return Real(v[0] * w[0] + v[1] * w[1] - v[2] * w[2]); };
    std::vector<Place> result;
    for (const Real& t : roots(form(direction, direction), form(p, direction), form(p, p))) {
      const Real radius = p[2] + t * direction[2];
      if (radius < 0 || radius + m[2] < 0 || radius + n[2] < 0) continue;
      result.push_back(c + Place{p[0] + t * direction[0], p[1] + t * direction[1]});
    }
    return result;
  }

  /// Adds what belongs to the cell of a line that is divided at stops.
  template <class PointAt, class IsIn>
  void addPieces(std::vector<Stop>& stops, PointAt pointAt, IsIn isIn, std::int32_t neighbor, std::int32_t side) {
    std::ranges::sort(stops, [](const Stop& a, const Stop& b) { return a.at < b.at; });
    bool goesOn = false;
    for (std::size_t k = 0; k + 1 < stops.size(); ++k) {
      const bool isPart = isIn(pointAt((stops[k].at + stops[k + 1].at) / 2));
      if (isPart && goesOn) pieces_.back().to = stops[k + 1].place;
      if (isPart && !goesOn) pieces_.push_back({stops[k].place, stops[k + 1].place, neighbor, side});
      goesOn = isPart;
    }
  }

  Cell result() {
    Cell cell;
    const Real same = Real(extent_) * Real("1e-130");
    for (std::size_t a = 0; a < places_.size(); ++a) {
      for (std::size_t b = 0; b < a; ++b) {
        if (abs(places_[a].x - places_[b].x) < same && abs(places_[a].y - places_[b].y) < same) {
          parents_[rootOf(a)] = rootOf(b);
        }
      }
    }
    for (const Piece& piece : pieces_) parents_[rootOf(piece.from)] = rootOf(piece.to);
    std::map<std::size_t, Real> areas;
    for (const Piece& piece : pieces_) {
      const Place from = places_[piece.from] - corner(0);
      const Place to = places_[piece.to] - corner(0);
      const Real its = cross(from, to) / 2 + piece.area;
      areas[rootOf(piece.from)] += its;
      // The distance from a circle has no maximum inside a piece.
      cell.clearance =
          std::max({cell.clearance, distance(own_, places_[piece.from]), distance(own_, places_[piece.to])});
      cell.area += its;
      if (lengthOf(to - from) < kVisible * extent_) continue;
      if (piece.side >= 0) ++cell.sides[piece.side];
      if (piece.neighbor >= 0) ++cell.arcs[piece.neighbor];
    }
    for (const auto& [root, area] : areas) cell.loops += area > kVisible * extent_ * extent_ ? 1 : 0;
    return cell;
  }

  const std::vector<Circle>& circles_;
  std::vector<Place> corners_;
  double extent_ = 0;
  std::int32_t own_ = 0;
  std::vector<Place> places_;
  std::vector<std::size_t> parents_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> cornerPlaces_;
  std::vector<std::vector<Stop>> onSide_;
  std::vector<std::vector<Stop>> onBisector_;
};

/// The cell as the library finds it.
Cell cellOf(const ClippedDiagram& clipped, std::int32_t i, double extent) {
  Cell cell;
  cell.area = clipped.area(i);
  for (const auto& loop : clipped.outline(i)) {
    cell.loops += area({loop}) > kVisible * extent * extent ? 1 : 0;
    for (const OutlinePiece& piece : loop) {
      const Point from = piece.curve.start;
      const Point to = piece.curve.end;
      if (std::hypot(to.x - from.x, to.y - from.y) < kVisible * extent) continue;
      if (piece.regionSide != kNone) ++cell.sides[piece.regionSide];
      if (piece.neighbor != kNone) ++cell.arcs[piece.neighbor];
    }
  }
  return cell;
}

int below(Random& random, int count) { return std::uniform_int_distribution<int>(0, count - 1)(random); }
double unit(Random& random) { return std::uniform_real_distribution<double>(0, 1)(random); }

std::vector<Circle> circlesOf(Random& random, bool areIntegers, double offset) {
  std::vector<Circle> circles;
  const int count = 2 + below(random, 3);
  for (int k = 0; k < count; ++k) {
    if (areIntegers) {
      circles.push_back({offset + below(random, 41) - 20, -offset + below(random, 41) - 20, double(below(random, 9))});
    } else {
      circles.push_back({offset + 40 * unit(random) - 20, 40 * unit(random) - 20 - offset, 8 * unit(random)});
    }
  }
  return circles;
}

/// A convex polygon around a point: corners of a large circle, or integers.
Ring polygonAround(Random& random, Point middle, bool isInteger) {
  Ring ring;
  const int count = 3 + below(random, 3);
  double angle = unit(random);
  for (int k = 0; k < count; ++k) {
    angle += (0.3 + 0.7 * unit(random)) * 7 / count;
    const double size = 12 + 18 * unit(random);
    Point p = {middle.x + size * std::cos(angle), middle.y + size * std::sin(angle)};
    if (isInteger) p = {std::round(p.x), std::round(p.y)};
    ring.push_back(p);
  }
  return ring;
}

/// Inserts a point on a side, moved away from the region by a share of the side that rounding nearly hides.
void insertCorner(Random& random, Ring& ring) {
  const auto k = static_cast<std::size_t>(below(random, static_cast<int>(ring.size())));
  const Point a = ring[k];
  const Point b = ring[(k + 1) % ring.size()];
  const double share = below(random, 2) == 0 ? 0.5 : unit(random);
  const double off = below(random, 3) == 0 ? 0 : std::pow(10, -13 - 4 * unit(random));
  ring.insert(ring.begin() + static_cast<std::ptrdiff_t>(k) + 1,
              {a.x + share * (b.x - a.x) + off * (b.y - a.y), a.y + share * (b.y - a.y) - off * (b.x - a.x)});
}

/// A triple of whole numbers a^2 + b^2 = c^2 in any direction, as a vector and its length.
std::pair<Vector, int> pythagorean(Random& random) {
  constexpr std::array<std::array<int, 3>, 7> kTriples = {
      {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {7, 24, 25}, {20, 21, 29}, {0, 1, 1}, {1, 0, 1}}};
  const auto& [a, b, c] = kTriples[static_cast<std::size_t>(below(random, 7))];
  const double x = below(random, 2) == 0 ? a : -a;
  const double y = below(random, 2) == 0 ? b : -b;
  return {below(random, 2) == 0 ? Vector{x, y} : Vector{y, x}, c};
}

/// Circles with whole numbers that touch one disc around (0, 0), on a small grid, or anywhere.
std::vector<Circle> circlesInTies(Random& random) {
  const int kind = below(random, 4);
  const int radius = 1 + below(random, 60);
  const double common = below(random, 2) == 0 ? 0 : 0.25;
  std::vector<Circle> circles;
  for (int k = 2 + below(random, 5); k > 0; --k) {
    if (kind == 0) {
      const auto [v, length] = pythagorean(random);
      const int factor = radius / length + 1 + below(random, 4);
      circles.push_back({factor * v.x, factor * v.y, static_cast<double>(factor * length - radius)});
    } else if (kind == 3) {
      circles.push_back({6 * unit(random), 6 * unit(random), unit(random)});
    } else {
      circles.push_back({static_cast<double>(below(random, 7)), static_cast<double>(below(random, 7)),
                         kind == 1 ? common : below(random, 4) / 4.0});
    }
  }
  return circles;
}

/// A contact with the diagram: a vertex or a point of an edge, and the direction of the edge there.
struct Touch {
  Point point;
  Vector along;
};

std::optional<Touch> touchOf(const Diagram& diagram, Random& random, bool isVertex) {
  if (diagram.edges.empty()) return std::nullopt;
  const EdgeCurve curve = edgeCurve(diagram, below(random, static_cast<int>(diagram.edges.size())));
  const double from = std::max(curve.from, 0.1);
  const double to = std::max(std::min(curve.to, 10.0), from);
  const double s = isVertex && !curve.startsAtInfinity() ? curve.from
                   : isVertex && !curve.endsAtInfinity() ? curve.to
                                                         : from + unit(random) * (to - from);
  if (!(s > 1e-6 && s < 1e6)) return std::nullopt;
  const Point p = pointAt(curve.bisector, s * (1 - 1e-6));
  const Point q = pointAt(curve.bisector, s * (1 + 1e-6));
  // Along a straight edge the side follows it to the bit, where numbers allow it.
  const Vector along = curve.isStraight() ? curve.bisector.across : Vector{q.x - p.x, q.y - p.y};
  const double size = std::hypot(along.x, along.y);
  if (!(size > 0)) return std::nullopt;
  Touch touch = {pointAt(curve.bisector, s), {along.x / size, along.y / size}};
  if (isVertex && !curve.startsAtInfinity()) touch.point = curve.start;
  if (isVertex && curve.startsAtInfinity() && !curve.endsAtInfinity()) touch.point = curve.end;
  return touch;
}

struct Input {
  std::vector<Circle> circles;
  Ring ring;
};

enum class Kind {
  nearlyStraightCorners,
  integers,
  farIntegers,
  sidesThroughTies,
  sidesAlongEqualCircles,
  cornerAtVertex,
  cornerOnEdge,
  sideAlongEdge,
  sideThroughVertex,
  sideTangent
};

/// A polygon in contact with the diagram of circles, with its corners in either order.
Ring ringAt(const Touch& touch, Kind kind, double size, Random& random) {
  const auto& [p, along] = touch;
  // Quarters of whole numbers half of the time.
  const auto step = [&] {
    const Vector v = {size * (2 * unit(random) - 1), size * (2 * unit(random) - 1)};
    return below(random, 2) == 0 ? v : Vector{std::round(4 * v.x) / 4, std::round(4 * v.y) / 4};
  };
  const Vector u = step();
  const Vector v = step();
  const auto at = [&](Vector w, double factor = 1) { return Point{p.x + factor * w.x, p.y + factor * w.y}; };
  const Vector line = {along.x * size, along.y * size};
  if (kind == Kind::sideAlongEdge) return {at(line, -unit(random)), at(line, 0.1 + 0.9 * unit(random)), at(u)};
  if (kind == Kind::sideThroughVertex) return {at(u, -1), at(u), at(v)};
  if (kind == Kind::sideTangent) return {at(line, -1), at(line), at(u)};
  if (below(random, 2) == 0) return {p, at(u), at(v)};
  return {p, at(u), {p.x + u.x + v.x, p.y + u.y + v.y}, at(v)};
}

Input contactOf(Kind kind, Random& random) {
  Input input = {circlesInTies(random), {}};
  const auto diagram = compute(input.circles);
  const bool isVertex = kind == Kind::cornerAtVertex || kind == Kind::sideThroughVertex;
  const auto touch = diagram ? touchOf(*diagram, random, isVertex) : std::nullopt;
  if (!touch || std::hypot(touch->point.x, touch->point.y) > 1e4) return input;
  double size = 1;
  for (const Circle& c : input.circles) size = std::max({size, std::abs(c.x), std::abs(c.y)});
  input.ring = ringAt(*touch, kind, size, random);
  return input;
}

Input inputOf(Kind kind, Random& random) {
  if (kind >= Kind::cornerAtVertex) return contactOf(kind, random);
  const bool areIntegers =
      kind != Kind::nearlyStraightCorners && (kind != Kind::sidesThroughTies || below(random, 2) == 0);
  const double offset = kind == Kind::farIntegers ? 1 << (10 + below(random, 6)) : 0;
  std::vector<Circle> circles = circlesOf(random, areIntegers, offset);
  const Point middle = {circles[0].x, circles[0].y};
  Ring ring = polygonAround(random, middle, areIntegers);
  if (below(random, 2) == 0) {
    const Point p = ring[0];
    const double size = areIntegers ? 1 + below(random, 30) : 30 * unit(random);
    ring = {{p.x, p.y}, {p.x + size, p.y}, {p.x + size, p.y + size}, {p.x, p.y + size}};
  }
  if (kind == Kind::sidesThroughTies) {
    const auto diagram = compute(circles);
    const auto tie = diagram ? touchOf(*diagram, random, below(random, 2) == 0) : std::nullopt;
    if (tie && std::hypot(tie->point.x - middle.x, tie->point.y - middle.y) < 200) {
      const auto& [x, y] = tie->point;
      const double w = 1 + below(random, 20);
      ring = {{x - w, y}, {x + 2 * w, y}, {x + w, y + w}, {x - w, y + w}};
    }
  }
  if (kind == Kind::sidesAlongEqualCircles) {
    // The bisector of the first two circles.
    circles[1].r = circles[0].r;
    const Vector u = {circles[1].x - circles[0].x, circles[1].y - circles[0].y};
    const Point m = {circles[0].x + u.x / 2, circles[0].y + u.y / 2};
    const double t = (1 + below(random, 8)) / 4.0;
    ring = {{m.x + t * u.y, m.y - t * u.x}, {m.x + u.x, m.y + u.y}, {m.x - t * u.y, m.y + t * u.x}};
  }
  for (int k = below(random, 3) + (kind == Kind::nearlyStraightCorners ? 1 : 0); k > 0; --k) insertCorner(random, ring);
  return {std::move(circles), std::move(ring)};
}

std::string textOf(const Input& input) {
  std::string text;
  char line[160];
  for (const Circle& c : input.circles) {
    std::snprintf(line, sizeof line, "{%.17g, %.17g, %.17g}, ", c.x, c.y, c.r);
    text += line;
  }
  text += "in ";
  for (const Point& p : input.ring) {
    std::snprintf(line, sizeof line, "{%.17g, %.17g}, ", p.x, p.y);
    text += line;
  }
  return text;
}

/// Returns whether a region of one ring turns left at each of its corners, or goes straight on.
bool isConvex(const Region& region) {
  const auto points = region.points();
  const std::size_t n = points.size();
  for (std::size_t k = 0; k < n; ++k) {
    if (orientation(points[k], points[(k + 1) % n], points[(k + 2) % n]) < 0) return false;
  }
  return true;
}

/// Expects that all cells are those of the oracle, and so is the largest empty disc. Returns the number of cells; none
/// if the input is none.
int expectRight(const Input& input) {
  const auto made = Region::fromRings(std::array{input.ring});
  const auto diagram = compute(input.circles);
  if (!made || !isConvex(*made) || !diagram) return 0;
  SCOPED_TRACE(textOf(input));
  const Region& region = *made;
  const auto clipped = ClippedDiagram::from(*diagram, region);
  EXPECT_TRUE(clipped) << clipped.error().message;
  if (!clipped) return 0;
  // The points of the region begin with the smallest corner, or another one: the oracle has its order.
  const Ring corners(region.points().begin(), region.points().end());
  // Without circles that have no cell.
  std::vector<std::int32_t> indices;
  std::vector<Circle> visible;
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(input.circles.size()); ++i) {
    if (!diagram->hasCell(i)) continue;
    indices.push_back(i);
    visible.push_back(input.circles[static_cast<std::size_t>(i)]);
  }
  Oracle oracle(visible, corners);
  double extent = 0;
  double farthest = 0;
  for (const Point& p : corners) {
    extent = std::max({extent, std::abs(p.x - corners[0].x), std::abs(p.y - corners[0].y)});
    farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
  }
  for (const Circle& c : visible) farthest = std::max({farthest, std::abs(c.x), std::abs(c.y), c.r});
  Real clearance = -1e300;
  for (std::size_t k = 0; k < indices.size(); ++k) {
    const std::int32_t i = indices[k];
    Cell right = oracle.cell(static_cast<std::int32_t>(k));
    std::map<std::int32_t, int> arcs;
    for (const auto& [neighbor, count] : right.arcs) arcs[indices[static_cast<std::size_t>(neighbor)]] = count;
    right.arcs = std::move(arcs);
    const Cell found = cellOf(*clipped, i, extent);
    clearance = std::max(clearance, right.clearance);
    EXPECT_LE(std::abs(static_cast<double>(found.area - right.area)), 1e-12 * region.area() + 1e-14 * extent * farthest)
        << "area of cell " << i;
    EXPECT_EQ(found.arcs, right.arcs) << "neighbors of cell " << i;
    EXPECT_EQ(found.sides, right.sides) << "sides of cell " << i;
    EXPECT_EQ(found.loops, right.loops) << "loops of cell " << i;
    test::expectSameAlone(*clipped, i);
  }
  EXPECT_NEAR(clipped->largestEmptyDisc()->disc.r, static_cast<double>(clearance), 1e-12 * (extent + farthest));
  return static_cast<int>(indices.size());
}

class ExactBounds : public testing::TestWithParam<std::pair<const char*, Kind>> {};

TEST_P(ExactBounds, CellsAndDiscsAreThoseOfAClipWithManyDigits) {
  const auto [name, kind] = GetParam();
  const char* text = std::getenv("CIRCLE_VORONOI_BOUNDS_CELLS");
  const int most = text == nullptr ? 150 : std::atoi(text);
  Random random(test::seedOr(58) + static_cast<std::uint64_t>(kind));
  int cells = 0;
  while (cells < most && !HasFailure()) cells += expectRight(inputOf(kind, random));
  if (text != nullptr) std::printf("%s: %d cells\n", name, cells);
}

INSTANTIATE_TEST_SUITE_P(Families, ExactBounds,
                         testing::Values(std::pair{"nearlyStraightCorners", Kind::nearlyStraightCorners},
                                         std::pair{"integers", Kind::integers},
                                         std::pair{"farIntegers", Kind::farIntegers},
                                         std::pair{"sidesThroughTies", Kind::sidesThroughTies},
                                         std::pair{"sidesAlongEqualCircles", Kind::sidesAlongEqualCircles},
                                         std::pair{"cornerAtVertex", Kind::cornerAtVertex},
                                         std::pair{"cornerOnEdge", Kind::cornerOnEdge},
                                         std::pair{"sideAlongEdge", Kind::sideAlongEdge},
                                         std::pair{"sideThroughVertex", Kind::sideThroughVertex},
                                         std::pair{"sideTangent", Kind::sideTangent}),
                         [](const auto& instance) { return std::string(instance.param.first); });

// Inputs for which the cells in bounds were wrong or refused.
TEST(ExactBoundsFixture, CellsWithCornersNearlyOnALineOfTheirNeighborsAreRight) {
  const Input straight = {{{0, 0, 20}, {0, -300, 0}},
                          {{200, 0},
                           {105.61405064662918, 322.19297467668548},
                           {-95.385949353370833, -79.807025323314576},
                           {-296.38594935337079, -481.80702532331458}}};
  EXPECT_EQ(expectRight(straight), 2);
  const Input triangle = {{{0, -16380, 1}, {51, -16381, 2}, {50, -16380, 0.99999999999999989}},
                          {{50, -16000}, {0, -20000}, {50, -16400}}};
  EXPECT_GT(expectRight(triangle), 1);
  const Input box = {{{48, -16380, 1},
                      {52, -16381, 1},
                      {51, -16381, 2},
                      {50, -16383, 2},
                      {50, -16380, 0.99999999999999989},
                      {49, -16384, 0}},
                     {{49, -16381}, {50, -16381}, {50, -16380}, {49, -16380}}};
  EXPECT_GT(expectRight(box), 1);
}

// tests/fixtures/clips has more of them.
TEST(ExactBoundsFixture, CellsAndDiscsInBoundsThatMeetVerticesAndEdgesAreRight) {
  struct Case {
    const char* what;
    std::vector<Circle> circles;
    Ring ring;
  };
  const std::vector<Case> cases = {
      {"corners at vertices of points",
       {{2.8524783578565245, 1.7988141566511384, 0},
        {0.074535261823752919, 3.0815385103318431, 0},
        {2.9029702836826612, 3.2152136908776723, 0},
        {2.174503533233723, 3.0583487895023627, 0}},
       {{1.1090889966844617, 1.6726283296341318},
        {2.6727750445118703, 2.5143199723779221},
        {1.1942078980591633, 9.3806552394240477}}},
      {"a side along an edge", {{3, 0, .5}, {2, 0, .5}}, {{2, -.25}, {2.5, -1}, {2.5, .5}}},
      {"a side along an edge, beside a corner on the line of centers",
       {{3, 0, .5}, {2, 0, .5}},
       {{2, 0}, {2.5, -1}, {2.5, 1}}},
      {"a disc that touches three points and a side",
       {{0, 1, 0}, {2, 2, 0}, {1, 0, 0}},
       {{1, .5}, {1.25, 1.5}, {.5, -.5}}},
      {"a corner on an edge", {{2, 0, 0}, {1, 1, .2}, {2, 2, .2}}, {{1.25, .75}, {2.5, .5}, {1, 2}}},
      {"corners on the diagonal of a grid",
       {{1, 2, .75}, {0, 0, .25}, {2, 1, .75}},
       {{.5, .5}, {2.5, 1}, {1.25, 1.25}}},
      {"a corner at the center of three circles",
       {{2, 0, .5}, {0, 2, .5}, {-2, 0, .5}},
       {{0, 0}, {0, 2.5}, {-.75, .25}}},
      {"circles that nearly touch from inside",
       {{6.187499999996362, -6, 0.046875}, {6.156249999998181, -5.9999999999956026, 0.015625000001818989}},
       {{6.15, -6.1}, {6.17, -6.1}, {6.15, -6}}},
  };
  for (const auto& [what, circles, ring] : cases) {
    SCOPED_TRACE(what);
    EXPECT_GT(expectRight({circles, ring}), 0);
  }
}

TEST(ExactBoundsFixture, ACellThatTouchesASideFromOutsideHasNoArea) {
  const Diagram diagram = compute(std::vector<Circle>{{3, 0, .5}, {2, 0, .5}}).value();
  const Region triangle = test::regionFrom({{{2, -.25}, {2.5, -1}, {2.5, .5}}});
  EXPECT_NEAR(ClippedDiagram::from(diagram, triangle)->area(0), 0, 1e-40);
  EXPECT_NEAR(area(ClippedDiagram::from(diagram, triangle, .5)->outline(0)), 0, 1e-40);
}

// A cell alone had a loop that began elsewhere, and so an area with other bits (expectSameAlone).
TEST(ExactBoundsFixture, ACellWithSeveralEntriesHasTheSameBitsAlone) {
  const Input input = {{{-200, 0, 200}, {-260, 80, 140}, {-300, 140, 140}}, {{-400, 0}, {0, 420}, {0, 400}}};
  EXPECT_EQ(expectRight(input), 3);
}

// The borders of circles that nearly touch from inside: a difference of distances that cancels.
TEST(ExactBoundsFixture, CellsOfCirclesThatNearlyTouchInALargeTriangleAreRight) {
  const Input input = {{{0, 512, 512}, {8e-06, 128, 128}, {0.0005, 9.5367431640625e-07, 9.5367431640625e-07}},
                       {{0, -1000000}, {400000, 0}, {0, 0}}};
  EXPECT_EQ(expectRight(input), 3);
}

}  // namespace
}  // namespace exact_bounds_test
}  // namespace circle_voronoi
