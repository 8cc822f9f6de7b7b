// SPDX-License-Identifier: GPL-3.0-or-later
#include "independent_clip.h"

#include <algorithm>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>

namespace circle_voronoi::test {
namespace {

using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<100>, boost::multiprecision::et_off>;

using std::abs;
using std::asinh;
using std::atan2;
using std::cos;
using std::cosh;
using std::hypot;
using std::isfinite;
using std::sin;
using std::sinh;
using std::sqrt;

template <class Real>
struct Place {
  Real x = 0, y = 0;

  friend Place operator+(const Place& a, const Place& b) { return {a.x + b.x, a.y + b.y}; }
  friend Place operator-(const Place& a, const Place& b) { return {a.x - b.x, a.y - b.y}; }
  friend Place operator*(const Real& f, const Place& a) { return {f * a.x, f * a.y}; }
  friend Real dot(const Place& a, const Place& b) { return a.x * b.x + a.y * b.y; }
  friend Real cross(const Place& a, const Place& b) { return a.x * b.y - a.y * b.x; }
  friend Place turned(const Place& a) { return {-a.y, a.x}; }
  friend Real lengthOf(const Place& a) { return sqrt(dot(a, a)); }
};

/// The roots of a t^2 + 2 b t + c.
template <class Real>
std::vector<Real> roots(const Real& a, const Real& b, const Real& c) {
  const Real square = b * b - a * c;
  if (square < 0) return {-b / a};
  const Real root = sqrt(square);
  const Real sum = b < 0 ? Real(-b + root) : Real(-b - root);
  return {sum / a, c / sum};
}

/// Whether a circle has no cell because of another, or of an identical one before it.
bool isHidden(const std::vector<Circle>& circles, std::size_t i, Metric metric) {
  const auto exact = [](double value) { return Long(value); };
  for (std::size_t j = 0; j < circles.size(); ++j) {
    const Circle& c = circles[i];
    const Circle& d = circles[j];
    const bool isSame = c.x == d.x && c.y == d.y && (metric == Metric::centers || c.r == d.r);
    if (isSame && j < i) return true;
    if (isSame || i == j || metric != Metric::circles) continue;
    const Long x = exact(c.x) - exact(d.x);
    const Long y = exact(c.y) - exact(d.y);
    const Long s = exact(d.r) - exact(c.r);
    if (s >= 0 && x * x + y * y <= s * s) return true;
  }
  return false;
}

template <class Real>
class BruteForce {
  using Spot = Place<Real>;
  struct Segment {
    Spot from, to;
  };

 public:
  BruteForce(const std::vector<Circle>& circles, const Region& region, Metric metric, std::optional<double> maxDistance,
             const Real& rounding, bool weights = false)
      : metric_(metric), areas_(circles.size()) {
    if (maxDistance) maxDistance_ = Real(*maxDistance);
    const Box box = region.bounds();
    // Relative to a corner of the region.
    origin_ = {Real(region.points()[0].x), Real(region.points()[0].y)};
    size_ = std::max(Real(box.maxX) - Real(box.minX), Real(box.maxY) - Real(box.minY));
    for (std::size_t r = 0; r < region.ringCount(); ++r) {
      const auto begin = static_cast<std::size_t>(region.ringOffsets()[r]);
      const auto end = static_cast<std::size_t>(region.ringOffsets()[r + 1]);
      for (std::size_t k = begin; k < end; ++k) {
        sides_.push_back({placed(region.points()[k]), placed(region.points()[k + 1 == end ? begin : k + 1])});
      }
    }
    Real least = size_;
    Real farthest = 0;
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const Circle& c = circles[i];
      if (isHidden(circles, i, metric)) continue;
      indices_.push_back(i);
      centers_.push_back(placed({c.x, c.y}));
      radii_.push_back(Real(metric == Metric::circles ? c.r : 0));
      weights_.push_back(metric != Metric::power ? Real(0) : weights ? Real(c.r) : Real(c.r) * Real(c.r));
      farthest = std::max(farthest, lengthOf(centers_.back()) + abs(radii_.back()));
      for (std::size_t k = 0; k + 1 < centers_.size(); ++k) {
        const Real distance = lengthOf(centers_.back() - centers_[k]);
        if (distance > 0) least = std::min(least, distance);
      }
    }
    // A border counts as if the region were moved by this distance.
    const Real step = std::max(Real(least * sqrt(rounding)), Real(rounding * (size_ + farthest) * 1000));
    shift_ = {step, step * Real(0.7)};
  }

  std::vector<double> run() {
    for (const Segment& side : sides_) addSide(side);
    for (std::size_t i = 0; i < centers_.size(); ++i) {
      for (std::size_t j = i + 1; j < centers_.size(); ++j) addBisector(i, j);
      if (maxDistance_) addCircle(i);
    }
    std::vector<double> areas;
    for (const Real& area : areas_) areas.push_back(static_cast<double>(area));
    return areas;
  }

  std::vector<IndependentCell> cells() {
    const std::vector<double> areas = run();
    std::vector<IndependentCell> cells(areas.size());
    std::vector<std::vector<Piece>> piecesOf(areas.size());
    for (const Piece& piece : pieces_) {
      // Pieces of length zero are left out. Rounding moves the ends of others at tangents by the root of its bound.
      if (lengthOf(piece.to - piece.from) <= least() && piece.isShort) continue;
      piecesOf[piece.cell].push_back(piece);
      IndependentCell& cell = cells[piece.cell];
      const auto length = static_cast<double>(lengthOf(piece.to - piece.from));
      if (piece.neighbor >= 0) cell.neighbors[piece.neighbor] += length;
      if (piece.side >= 0) cell.sides[piece.side] += length;
    }
    for (std::size_t i = 0; i < cells.size(); ++i) {
      cells[i].area = areas[i];
      cells[i].loops = loopsOf(piecesOf[i]);
    }
    return cells;
  }

 private:
  struct Piece {
    std::size_t cell;
    std::int32_t neighbor;  ///< or -1
    std::int32_t side;      ///< or -1
    Spot from, to;
    bool isShort = true;  ///< whether it is no longer than its chord is
  };

  Real least() const { return size_ * Real(1e-35); }

  /// The lengths of the closed loops, if no two pieces begin at one place.
  std::optional<std::vector<double>> loopsOf(const std::vector<Piece>& pieces) const {
    std::vector<std::size_t> next(pieces.size(), pieces.size());
    for (std::size_t a = 0; a < pieces.size(); ++a) {
      for (std::size_t b = 0; b < pieces.size(); ++b) {
        if (lengthOf(pieces[b].from - pieces[a].to) > least() * 1000) continue;
        if (next[a] != pieces.size()) return std::nullopt;
        next[a] = b;
      }
      if (next[a] == pieces.size()) return std::nullopt;
    }
    std::vector<double> lengths;
    std::vector<bool> isDone(pieces.size(), false);
    for (std::size_t a = 0; a < pieces.size(); ++a) {
      if (isDone[a]) continue;
      double& length = lengths.emplace_back();
      for (std::size_t b = a; !isDone[b]; b = next[b]) {
        isDone[b] = true;
        length += static_cast<double>(lengthOf(pieces[b].to - pieces[b].from));
      }
    }
    return lengths;
  }

  Spot placed(Point p) const { return {Real(p.x) - origin_.x, Real(p.y) - origin_.y}; }

  Real distance(std::size_t i, Spot p) const {
    const Spot v = p - centers_[i];
    if (metric_ == Metric::power) return dot(v, v) - weights_[i];
    return lengthOf(v) - radii_[i];
  }
  std::size_t nearestTo(Spot p) const {
    std::size_t best = 0;
    for (std::size_t i = 1; i < centers_.size(); ++i) {
      if (distance(i, p) < distance(best, p)) best = i;
    }
    return best;
  }
  bool isInRegion(Spot p) const {
    bool isOdd = false;
    for (const auto& [a, b] : sides_) {
      if ((a.y > p.y) == (b.y > p.y)) continue;
      isOdd ^= (cross(b - a, p - a) > 0) == (b.y > a.y);
    }
    return isOdd;
  }

  void addSide(const Segment& side) {
    const Spot along = side.to - side.from;
    std::vector<Real> shares = {0, 1};
    for (std::size_t i = 0; i < centers_.size(); ++i) {
      for (std::size_t j = i + 1; j < centers_.size(); ++j) {
        for (const Real& t : crossings(i, j, side.from, along)) {
          if (t > 0 && t < 1) shares.push_back(t);
        }
      }
    }
    for (std::size_t i = 0; maxDistance_ && i < centers_.size(); ++i) {
      const Spot toStart = side.from - centers_[i];
      const Real radius = reachOf(i);
      for (const Real& t : roots(dot(along, along), dot(along, toStart), dot(toStart, toStart) - radius * radius)) {
        if (t > 0 && t < 1) shares.push_back(t);
      }
    }
    std::ranges::sort(shares);
    for (std::size_t k = 1; k < shares.size(); ++k) {
      const Spot from = side.from + shares[k - 1] * along;
      const Spot to = side.from + shares[k] * along;
      const Spot middle = half() * (from + to) + shift_;
      const std::size_t nearest = nearestTo(middle);
      if (!isNear(nearest, middle)) continue;
      areas_[indices_[nearest]] += cross(from, to) / 2;
      pieces_.push_back({indices_[nearest], -1, static_cast<std::int32_t>(&side - sides_.data()), from, to});
    }
  }

  /// Where a line crosses the bisector of two circles: its shares, and perhaps others.
  std::vector<Real> crossings(std::size_t i, std::size_t j, Spot p, Spot along) const {
    const Spot d = centers_[j] - centers_[i];
    const Spot x = p - half() * (centers_[i] + centers_[j]);
    const Real s = radii_[i] - radii_[j];
    if (s == 0) {
      // 2 (x + t along) . d = w_i - w_j
      return {((weights_[i] - weights_[j]) / 2 - dot(x, d)) / dot(along, d)};
    }
    // 4 (x . d)^2 - 4 s^2 x . x = s^2 (d . d - s^2)
    const Real ad = dot(along, d);
    const Real xd = dot(x, d);
    return roots(ad * ad - s * s * dot(along, along), ad * xd - s * s * dot(along, x),
                 xd * xd - s * s * dot(x, x) - s * s * (dot(d, d) - s * s) / 4);
  }

  /// The points that have the same distance from three circles, and perhaps others.
  std::vector<Spot> vertices(std::size_t i, std::size_t j, std::size_t k) const {
    const Spot u = centers_[j] - centers_[i];
    const Spot v = centers_[k] - centers_[i];
    const Real determinant = cross(u, v);
    const Real su = radii_[j] - radii_[i];
    const Real sv = radii_[k] - radii_[i];
    // 2 u . x + 2 su rho = gu, the same of v, with rho = |x|.
    const Real gu = dot(u, u) - su * su + weights_[i] - weights_[j];
    const Real gv = dot(v, v) - sv * sv + weights_[i] - weights_[k];
    const auto solve = [&](Real a, Real b) {
      return Spot{(a * v.y - b * u.y) / determinant, (u.x * b - v.x * a) / determinant};
    };
    const Spot base = solve(gu / 2, gv / 2);
    if (su == 0 && sv == 0) return {centers_[i] + base};
    std::vector<Spot> result;
    const Spot slope = solve(-su, -sv);
    for (const Real& rho : roots(dot(slope, slope) - 1, dot(base, slope), dot(base, base))) {
      result.push_back(centers_[i] + base + rho * slope);
    }
    if (abs(determinant) < Real(1e-9) * lengthOf(u) * lengthOf(v)) {
      // Centers on a line: x = h d + k turned(d), h from one equation as a function of rho, rho from both.
      const Real length = lengthOf(u);
      const Spot d = (1 / length) * u;
      const Real lu = length;
      const Real lv = dot(v, d);
      const Real denominator = su * lv - sv * lu;
      const Real rho = (gu * lv - gv * lu) / (2 * denominator);
      const Real h = (gu / 2 - su * rho) / lu;
      const Real square = rho * rho - h * h;
      if (square >= 0) {
        for (const Real& k2 : {Real(sqrt(square)), Real(-sqrt(square))}) {
          result.push_back(centers_[i] + h * d + k2 * turned(d));
        }
      }
    }
    return result;
  }

  void addBisector(std::size_t i, std::size_t j) {
    const Spot d = centers_[j] - centers_[i];
    const Real length = lengthOf(d);
    const Real s = radii_[i] - radii_[j];
    if (!(length > abs(s))) return;
    const Spot along = (1 / length) * d;
    const Spot across = turned(along);
    const Real a = s / 2;
    const Real b = sqrt((length - s) * (length + s)) / 2;
    Spot middle = half() * (centers_[i] + centers_[j]);
    if (s == 0) middle = middle + ((weights_[i] - weights_[j]) / (2 * length)) * along;
    const auto pointAt = [&](Real t) {
      return s == 0 ? middle + t * across : middle + Real(a * cosh(t)) * along + Real(b * sinh(t)) * across;
    };
    std::vector<Real> parameters;
    const auto divide = [&](Spot p) {
      const Real height = dot(p - middle, across);
      if (isfinite(height)) parameters.push_back(s == 0 ? height : Real(asinh(height / b)));
    };
    for (std::size_t k = 0; k < centers_.size(); ++k) {
      if (k == i || k == j) continue;
      for (const Spot& p : vertices(i, j, k)) divide(p);
    }
    for (const auto& [from, to] : sides_) {
      for (const Real& t : crossings(i, j, from, to - from)) divide(from + t * (to - from));
    }
    if (maxDistance_) {
      // The height above the line of centers, of both points at the distance.
      for (const Spot& p : pointsAtDistance(i, j)) divide(p);
    }
    std::ranges::sort(parameters);
    for (std::size_t k = 1; k < parameters.size(); ++k) {
      const Real t0 = parameters[k - 1];
      const Real t1 = parameters[k];
      const Spot p = pointAt((t0 + t1) / 2);
      if (!isInRegion(p - shift_)) continue;
      const Spot aside = shift_.x * along;
      if (nearestTo(p - aside) != i || nearestTo(p + aside) != j || !isNear(i, p - shift_)) continue;
      const Spot from = pointAt(t0);
      const Spot to = pointAt(t1);
      // The triangle of the chord and the middle, and the area between chord and branch.
      Real area = cross(from, to) / 2;
      if (s != 0) area += a * b * ((t1 - t0) - sinh(t1 - t0)) / 2;
      areas_[indices_[i]] += area;
      areas_[indices_[j]] -= area;
      pieces_.push_back({indices_[i], static_cast<std::int32_t>(indices_[j]), -1, from, to});
      pieces_.push_back({indices_[j], static_cast<std::int32_t>(indices_[i]), -1, to, from});
    }
  }

  /// The radius of the disc in which a cell is kept.
  Real reachOf(std::size_t i) const {
    if (metric_ != Metric::power) return std::max(Real(radii_[i] + *maxDistance_), Real(0));
    return sqrt(std::max(Real(weights_[i] + *maxDistance_ * abs(*maxDistance_)), Real(0)));
  }
  bool isNear(std::size_t i, Spot p) const { return !maxDistance_ || lengthOf(p - centers_[i]) <= reachOf(i); }

  /// The points where the discs of two circles meet.
  std::vector<Spot> pointsAtDistance(std::size_t i, std::size_t j) const {
    const Spot d = centers_[j] - centers_[i];
    const Real square = dot(d, d);
    const Real u = reachOf(i);
    const Real v = reachOf(j);
    const Real along = (square + u * u - v * v) / (2 * square);
    const Real across = u * u / square - along * along;
    if (!(across >= 0)) return {};
    const Spot middle = centers_[i] + along * d;
    const Spot aside = Real(sqrt(across)) * turned(d);
    return {middle + aside, middle - aside};
  }

  /// The arcs of the circle around the disc in which a cell is kept.
  void addCircle(std::size_t i) {
    const Real radius = reachOf(i);
    if (radius == 0) return;
    const Real turn = 2 * atan2(Real(0), Real(-1));
    std::vector<Real> angles;
    const auto divide = [&](Spot p) {
      const Real angle = atan2(p.y - centers_[i].y, p.x - centers_[i].x);
      if (isfinite(angle)) angles.push_back(angle < 0 ? Real(angle + turn) : angle);
    };
    for (const auto& [from, to] : sides_) {
      const Spot along = to - from;
      const Spot toStart = from - centers_[i];
      for (const Real& t : roots(dot(along, along), dot(along, toStart), dot(toStart, toStart) - radius * radius)) {
        divide(from + t * along);
      }
    }
    for (std::size_t j = 0; j < centers_.size(); ++j) {
      if (j == i) continue;
      for (const Spot& p : pointsAtDistance(i, j)) divide(p);
    }
    if (angles.empty()) angles.push_back(0);
    std::ranges::sort(angles);
    angles.push_back(angles.front() + turn);
    const auto pointAt = [&](const Real& angle) {
      return centers_[i] + Spot{Real(radius * cos(angle)), Real(radius * sin(angle))};
    };
    for (std::size_t k = 1; k < angles.size(); ++k) {
      const Real swept = angles[k] - angles[k - 1];
      const Spot p = pointAt((angles[k] + angles[k - 1]) / 2) - shift_;
      if (!isInRegion(p) || nearestTo(p) != i) continue;
      areas_[indices_[i]] += cross(pointAt(angles[k - 1]), pointAt(angles[k])) / 2;
      areas_[indices_[i]] += radius * radius * (swept - sin(swept)) / 2;
      pieces_.push_back({indices_[i], -1, -1, pointAt(angles[k - 1]), pointAt(angles[k]), swept < 1});
    }
  }

  static Real half() { return Real(1) / 2; }

  Metric metric_;
  std::optional<Real> maxDistance_;
  Spot origin_;
  Real size_ = 0;
  Spot shift_;
  std::vector<Segment> sides_;
  std::vector<std::size_t> indices_;  ///< of circles with a cell
  std::vector<Spot> centers_;
  std::vector<Real> radii_;
  std::vector<Real> weights_;
  std::vector<Real> areas_;
  std::vector<Piece> pieces_;
};

}  // namespace

std::vector<double> areasByBruteForce(const std::vector<Circle>& circles, const Region& region, Metric metric,
                                      bool isLong, std::optional<double> maxDistance) {
  if (isLong) return BruteForce<Long>(circles, region, metric, maxDistance, Long("1e-98")).run();
  return BruteForce<long double>(circles, region, metric, maxDistance, 1e-18L).run();
}

std::vector<IndependentCell> cellsByBruteForce(const std::vector<Circle>& circles, const Region& region, Metric metric,
                                               std::optional<double> maxDistance, bool weights) {
  return BruteForce<Long>(circles, region, metric, maxDistance, Long("1e-98"), weights).cells();
}

}  // namespace circle_voronoi::test
