// SPDX-License-Identifier: GPL-3.0-or-later
#include "dissolve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <set>
#include <span>
#include <unordered_map>
#include <utility>

#include "at.h"
#include "bit_cast.h"
#include "circle_voronoi/limits.h"
#include "guarded.h"
#include "in_circle.h"
#include "meetings.h"
#include "rounded.h"
#include "scale.h"
#include "two_part.h"

namespace circle_voronoi {
namespace {

/// Returns the cross product of two vectors with a small relative error, also where they are nearly parallel. A
/// crossing of such segments would otherwise be off by many steps of the grid.
double accurateCross(Vector u, Vector v) {
  const TwoPart left = product(u.x, v.y);
  const TwoPart right = product(u.y, v.x);
  const TwoPart difference = sum(left.value, -right.value);
  return difference.value + (difference.rest + (left.rest - right.rest));
}

/// A part of the boundary of a polygon.
struct Piece {
  Segment segment;
  std::int32_t polygon;
};

/// Segments that meet at their ends only, and the polygons of their pieces. Segment k has the polygons from offsets[k]
/// to before offsets[k + 1].
struct Arrangement {
  std::vector<Point> points;
  std::vector<Segment> segments;
  std::vector<std::size_t> offsets;
  std::vector<std::int32_t> polygons;
};

/// Divides the sides of rings where they cross, touch or overlap, until they meet at their ends only.
///
/// Crossing points are rounded, which moves the sides through them. This may create new crossings, so the division is
/// repeated as long as few are left. One or two rounds usually suffice. Sides that nearly coincide can cross anew
/// without end; then all points move to a grid, and each side is led through the centers of the squares of the grid in
/// which it meets an end or a crossing: snap rounding (J. D. Hobby, "Practical segment intersection with finite
/// precision output", 1999). As the squares are found with exact signs, no two sides cross after that.
class Noder {
 public:
  Noder(const Rings& rings, std::span<const std::int32_t> polygonOfRing) {
    for (std::size_t r = 0; r + 1 < rings.offsets.size(); ++r) {
      const std::size_t begin = at(rings.offsets[r]);
      const std::size_t end = at(rings.offsets[r + 1]);
      for (std::size_t k = begin; k < end; ++k) {
        add(indexOf(rings.points[k]), indexOf(rings.points[k + 1 == end ? begin : k + 1]), polygonOfRing[r], pieces_);
      }
    }
    givenPoints_ = points_;
    givenPieces_ = pieces_;
  }

  Arrangement run() {
    if (!divideByRounding()) snap();
    Arrangement result;
    result.segments = std::move(segments_);
    for (const Piece& piece : pieces_) {
      if (result.offsets.empty() || piece.segment != result.segments[result.offsets.size() - 1]) {
        result.offsets.push_back(result.polygons.size());
      }
      result.polygons.push_back(piece.polygon);
    }
    result.offsets.push_back(result.polygons.size());
    result.points = std::move(points_);
    return result;
  }

 private:
  /// After the first round, each may find as many meetings as this, or half of those of the first round.
  static constexpr std::size_t kFew = 64;
  static constexpr int kMostRounds = 12;
  /// The steps of the first and the coarsest grid, as shares of a power of two up to the largest coordinate, and the
  /// factor to each next step. A grid is too fine if squares and sides meet more often than this, for each side and
  /// crossing.
  static constexpr double kFinestGrid = 0x1p-51;
  static constexpr double kCoarsestGrid = 0x1p-33;
  static constexpr double kCoarser = 0x1p6;
  static constexpr std::size_t kMostMeetings = 8;

  /// A point inside a segment at which it is divided.
  struct Split {
    std::size_t segment;
    std::int32_t point;
    double along;
  };

  struct Hash {
    std::size_t operator()(const Point& p) const {
      const auto mixed = bitCast<std::uint64_t>(p.x) * 0x9E3779B97F4A7C15 ^ bitCast<std::uint64_t>(p.y);
      return static_cast<std::size_t>((mixed ^ (mixed >> 29)) * 0xBF58476D1CE4E5B9 >> 20);
    }
  };

  Point point(std::int32_t index) const { return points_[at(index)]; }
  Point startOf(const Segment& segment) const { return point(segment.a); }
  Point endOf(const Segment& segment) const { return point(segment.b); }

  [[noreturn]] static void refuse() {
    throw ThrownError{{ErrorCode::tooManyCircles, kNone, "The sides of the region cross in too many points."}};
  }

  std::int32_t indexOf(Point p) {
    const auto [found, isNew] = indices_.try_emplace(p, static_cast<std::int32_t>(points_.size()));
    if (isNew) points_.push_back(p);
    if (points_.size() > kMaxRegionSides) refuse();
    return found->second;
  }

  void add(std::int32_t from, std::int32_t to, std::int32_t polygon, std::vector<Piece>& pieces) const {
    if (from == to) return;
    const bool isForward = isBefore(point(from), point(to));
    pieces.push_back({isForward ? Segment{from, to} : Segment{to, from}, polygon});
  }

  /// Takes out two pieces of one polygon in the same place, which bound nothing. Sorts the others by their segments,
  /// and lists these.
  void findSegments() {
    std::ranges::sort(pieces_, {}, [](const Piece& piece) { return std::pair(piece.segment, piece.polygon); });
    std::size_t kept = 0;
    for (const Piece& piece : pieces_) {
      const bool isPair =
          kept > 0 && pieces_[kept - 1].segment == piece.segment && pieces_[kept - 1].polygon == piece.polygon;
      if (isPair) {
        --kept;
      } else {
        pieces_[kept++] = piece;
      }
    }
    pieces_.resize(kept);
    segments_.clear();
    for (const Piece& piece : pieces_) {
      if (segments_.empty() || segments_.back() != piece.segment) segments_.push_back(piece.segment);
    }
  }

  /// Returns whether no segments meet after a few rounds.
  bool divideByRounding() {
    for (int round = 1; round <= kMostRounds; ++round) {
      findSegments();
      auto meetings = meetingsOf(points_, segments_, round == 1 ? kMaxRegionSides : std::max(kFew, crossings_ / 2));
      if (!meetings && round == 1) refuse();
      if (!meetings) return false;
      if (round == 1) crossings_ = meetings->crossings.size() + meetings->touches.size();
      std::vector<Split> splits = splitsAt(*meetings);
      if (splits.empty()) return true;
      std::ranges::sort(splits, [&](const Split& one, const Split& other) {
        if (one.segment != other.segment) return one.segment < other.segment;
        return one.along != other.along ? one.along < other.along : isBefore(point(one.point), point(other.point));
      });
      split(splits);
    }
    return false;
  }

  std::vector<Split> splitsAt(Meetings& meetings) {
    std::vector<Split> splits;
    const auto add = [&](std::int32_t segment, std::int32_t index) {
      const auto [a, b] = segments_[at(segment)];
      if (index == a || index == b) return;
      splits.push_back({at(segment), index, facing(vectorTo(point(a), point(b)), vectorTo(point(a), point(index)))});
    };
    auto& [crossings, touches] = meetings;
    std::ranges::sort(touches, [&](const Meetings::Touch& one, const Meetings::Touch& other) {
      return one.segment != other.segment ? one.segment < other.segment
                                          : isBefore(point(one.point), point(other.point));
    });
    for (const auto& [segment, index] : touches) add(segment, index);
    for (const auto& [first, second] : crossings) {
      const bool isFirst = comesFirst(segments_[at(first)], segments_[at(second)]);
      const std::int32_t one = isFirst ? first : second;
      const std::int32_t other = isFirst ? second : first;
      const Point p = crossingOf(segments_[at(one)], segments_[at(other)]);
      if (touchesNear(touches, one, other, p)) continue;
      const std::int32_t index = indexOf(p);
      add(one, index);
      add(other, index);
    }
    return splits;
  }

  bool comesFirst(const Segment& s, const Segment& t) const {
    return s.a != t.a ? isBefore(startOf(s), startOf(t)) : isBefore(endOf(s), endOf(t));
  }

  /// Whether two segments cross at a point on one that lies on the other, too. Its rounded crossing is given.
  bool touchesNear(const std::vector<Meetings::Touch>& touches, std::int32_t one, std::int32_t other,
                   Point crossing) const {
    const auto next = std::ranges::lower_bound(touches, one, {}, &Meetings::Touch::segment);
    auto place = std::partition_point(next, touches.end(), [&](const Meetings::Touch& touch) {
      return touch.segment == one && isBefore(point(touch.point), crossing);
    });
    const auto isCommon = [&](const Meetings::Touch& touch) {
      const auto& [a, b] = segments_[at(other)];
      return touch.segment == one && orientation(point(a), point(b), point(touch.point)) == 0;
    };
    return (place != touches.end() && isCommon(*place)) || (place != touches.begin() && isCommon(*std::prev(place)));
  }

  /// Returns the rounded crossing of two segments, moved into the bounding boxes of both, so that no point leaves a
  /// side along an axis. Adding zero turns -0 into +0.
  Point crossingOf(const Segment& s, const Segment& t) const {
    const Point p = startOf(s);
    const Point q = endOf(s);
    const Point u = startOf(t);
    const Point v = endOf(t);
    const Vector along = vectorTo(p, q);
    const Vector across = vectorTo(u, v);
    const double slope = accurateCross(along, across);
    const double share = slope == 0 ? 0.5 : accurateCross(vectorTo(p, u), across) / slope;
    const auto within = [](double value, double a, double b, double c, double d) {
      const double low = std::max(std::min(a, b), std::min(c, d));
      return std::clamp(value, low, std::max(low, std::min(std::max(a, b), std::max(c, d))));
    };
    const double x = p.x + share * (q.x - p.x);
    const double y = p.y + share * (q.y - p.y);
    return {rounded(within(x, p.x, q.x, u.x, v.x)) + 0.0, rounded(within(y, p.y, q.y, u.y, v.y)) + 0.0};
  }

  /// Divides pieces at points of their segments. The points are sorted by segments, and along each segment.
  void split(const std::vector<Split>& splits) {
    std::vector<Piece> pieces;
    std::size_t segment = 0;
    std::size_t next = 0;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const auto& [its, polygon] = pieces_[k];
      if (k > 0 && its != pieces_[k - 1].segment) {
        while (next < splits.size() && splits[next].segment == segment) ++next;
        ++segment;
      }
      std::int32_t last = its.a;
      for (std::size_t s = next; s < splits.size() && splits[s].segment == segment; ++s) {
        add(last, splits[s].point, polygon, pieces);
        last = splits[s].point;
      }
      add(last, its.b, polygon, pieces);
    }
    pieces_ = std::move(pieces);
  }

  void snap() {
    double size = 0;
    for (const Point& p : givenPoints_) size = std::max({size, std::abs(p.x), std::abs(p.y)});
    const double unit = powerOfTwoIn(size);
    const double coarsest = std::max(kCoarsestGrid * unit, 2 * kCoordinateStep);
    grid_ = std::max(kFinestGrid * unit, 2 * kCoordinateStep);
    for (; !snapToGrid(grid_ >= coarsest); grid_ *= kCoarser) {
    }
  }

  /// Returns whether this made few enough pieces. The last grid takes them all.
  bool snapToGrid(bool isLast) {
    moveToGrid();
    const std::size_t few = isLast ? kMaxRegionSides : kMostMeetings * (givenPieces_.size() + crossings_);
    const auto meetings = meetingsOf(points_, segments_, few);
    if (!meetings && isLast) refuse();
    if (!meetings) return false;
    for (const auto& [first, second] : meetings->crossings) {
      indexOf(centerOfCrossing(segments_[at(first)], segments_[at(second)]));
    }
    std::optional<std::vector<Split>> splits = splitsInSquares(few);
    if (!splits && isLast) refuse();
    if (!splits) return false;
    // A segment goes through squares from left to right, and all the way up or all the way down.
    std::ranges::sort(*splits, [&](const Split& one, const Split& other) {
      if (one.segment != other.segment) return one.segment < other.segment;
      const Point p = point(one.point);
      const Point q = point(other.point);
      if (p.x != q.x) return p.x < q.x;
      return startOf(segments_[one.segment]).y < endOf(segments_[one.segment]).y ? p.y < q.y : p.y > q.y;
    });
    split(*splits);
    findSegments();
    return true;
  }

  double onGrid(double value) const { return std::floor(value / grid_ + 0.5) * grid_ + 0.0; }

  void moveToGrid() {
    points_.clear();
    indices_.clear();
    pieces_.clear();
    for (const auto& [segment, polygon] : givenPieces_) {
      const auto moved = [&](std::int32_t end) {
        return indexOf({onGrid(givenPoints_[at(end)].x), onGrid(givenPoints_[at(end)].y)});
      };
      const std::int32_t from = moved(segment.a);
      add(from, moved(segment.b), polygon, pieces_);
    }
    findSegments();
  }

  /// Returns the center of the square in which two segments cross. The left and the lower side of a square belong to
  /// it.
  Point centerOfCrossing(const Segment& s, const Segment& t) const {
    const auto placed = [&](double guess, Point a, Point b, Point c, Point d) {
      double center = onGrid(guess);
      while (sideOfCrossing(a, b, c, d, center - grid_ / 2) > 0) center -= grid_;
      while (sideOfCrossing(a, b, c, d, center + grid_ / 2) <= 0) center += grid_;
      return center + 0.0;
    };
    const Point guess = crossingOf(s, t);
    const auto turned = [](Point p) { return Point{p.y, p.x}; };
    const std::array ends = {startOf(s), endOf(s), startOf(t), endOf(t)};
    const auto& [a, b, c, d] = ends;
    return {placed(guess.x, a, b, c, d), placed(guess.y, turned(a), turned(b), turned(c), turned(d))};
  }

  /// Finds the squares of points that segments go through, unless there are too many. A segment that meets a square
  /// meets one of its diagonals.
  std::optional<std::vector<Split>> splitsInSquares(std::size_t most) const {
    std::vector<Point> points = points_;
    std::unordered_map<Point, std::int32_t, Hash> corners;
    const double half = grid_ / 2;
    const auto cornerAt = [&](double x, double y) {
      const auto [found, isNew] = corners.try_emplace({x + 0.0, y + 0.0}, static_cast<std::int32_t>(points.size()));
      if (isNew) points.push_back(found->first);
      return found->second;
    };
    std::vector<Segment> segments = segments_;
    for (const auto& [x, y] : points_) {
      for (const double rise : {half, -half}) {
        const std::int32_t from = cornerAt(x - half, y - rise);
        segments.push_back({from, cornerAt(x + half, y + rise)});
      }
    }
    // The diagonals of each square cross, perhaps at a point.
    const auto meetings = meetingsOf(points, segments, most + 3 * points_.size());
    if (!meetings) return {};
    std::vector<Segment> places;  // a segment and the point of a square
    const auto squareOf = [&](std::int32_t diagonal) {
      return static_cast<std::int32_t>((at(diagonal) - segments_.size()) / 2);
    };
    const auto isDiagonal = [&](std::int32_t segment) { return at(segment) >= segments_.size(); };
    for (const auto& [first, second] : meetings->crossings) {
      if (isDiagonal(first) == isDiagonal(second)) continue;
      places.push_back(isDiagonal(first) ? Segment{second, squareOf(first)} : Segment{first, squareOf(second)});
    }
    for (const auto& [segment, touched] : meetings->touches) {
      if (isDiagonal(segment)) continue;
      if (at(touched) < points_.size()) {
        places.push_back({segment, touched});
        continue;
      }
      const auto [x, y] = points[at(touched)];
      for (const Point center :
           {Point{x - half, y - half}, {x + half, y - half}, {x - half, y + half}, {x + half, y + half}}) {
        const auto found = indices_.find({center.x + 0.0, center.y + 0.0});
        if (found != indices_.end()) places.push_back({segment, found->second});
      }
    }
    std::ranges::sort(places);
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<Split> splits;
    for (const auto& [segment, square] : places) {
      const Segment& its = segments_[at(segment)];
      if (square != its.a && square != its.b && goesThrough(its, point(square)))
        splits.push_back({at(segment), square, 0});
    }
    return splits;
  }

  /// Whether a segment between centers of squares meets the square around another one. The left and the lower side
  /// belong to the square, with the corner between them.
  bool goesThrough(const Segment& segment, Point center) const {
    const Point p = startOf(segment);
    const Point q = endOf(segment);
    const double half = grid_ / 2;
    const auto [low, high] = std::minmax(p.y, q.y);
    if (center.x < p.x || center.x > q.x || center.y < low || center.y > high) return false;
    const auto sideOf = [&](double x, double y) { return orientation(p, q, {center.x + x, center.y + y}); };
    // One that only touches a corner meets the square if this is the corner at the lower left.
    if (p.y <= q.y) return sideOf(-half, half) > 0 && sideOf(half, -half) < 0;
    return sideOf(half, half) > 0 && sideOf(-half, -half) <= 0;
  }

  std::vector<Point> points_;
  std::unordered_map<Point, std::int32_t, Hash> indices_;
  std::vector<Piece> pieces_;
  std::vector<Segment> segments_;  ///< the segments of all pieces, without duplicates
  std::vector<Point> givenPoints_;
  std::vector<Piece> givenPieces_;
  std::size_t crossings_ = 0;  ///< the meetings of the given sides
  double grid_ = 0;            ///< the step of the grid of points
};

/// The faces of an arrangement, whether each lies in a polygon, and the rings around the faces that do.
///
/// Half-edge 2 k leads from the first point of segment k to the second, 2 k + 1 back. Its face lies on its left.
class Faces {
 public:
  explicit Faces(const Arrangement& arrangement)
      : its_(arrangement), next_(2 * its_.segments.size()), face_(next_.size(), kNowhere) {
    sortAround();
    findCycles();
    joinComponents();
    findInside();
  }

  Rings rings() const {
    Rings result;
    result.offsets.push_back(0);
    std::vector<bool> isDone(next_.size(), false);
    std::vector<std::int32_t> path;
    std::vector<std::int32_t> placeOnPath(its_.points.size(), -1);
    const auto end = [&](std::size_t from) {
      for (std::size_t k = from; k < path.size(); ++k) {
        result.points.push_back(its_.points[at(path[k])]);
        placeOnPath[at(path[k])] = -1;
      }
      result.offsets.push_back(static_cast<std::int32_t>(result.points.size()));
      path.resize(from);
    };
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (isDone[start] || !isBoundary(start)) continue;
      std::size_t h = start;
      do {
        isDone[h] = true;
        const std::int32_t origin = originOf(h);
        // A part that returns to a point of the path is a ring by itself.
        if (placeOnPath[at(origin)] != -1) end(at(placeOnPath[at(origin)]));
        placeOnPath[at(origin)] = static_cast<std::int32_t>(path.size());
        path.push_back(origin);
        // Turn clockwise to the next side of the boundary: the faces between the two sides belong to the same part of
        // the inside.
        h = next_[h];
        while (!isBoundary(h)) h = next_[h ^ 1];
      } while (h != start);
      end(0);
    }
    return result;
  }

 private:
  static constexpr std::size_t kNowhere = static_cast<std::size_t>(-1);

  std::int32_t originOf(std::size_t h) const {
    const Segment& segment = its_.segments[h / 2];
    return h % 2 == 0 ? segment.a : segment.b;
  }
  Point pointAt(std::int32_t index) const { return its_.points[at(index)]; }
  Point targetOf(std::size_t h) const { return pointAt(originOf(h ^ 1)); }

  bool isBoundary(std::size_t h) const { return isInside_[face_[h]] && !isInside_[face_[h ^ 1]]; }

  /// Sorts the half-edges that leave each point counter-clockwise from below, and links each half-edge to the next one
  /// around its face.
  void sortAround() {
    offsets_.assign(its_.points.size() + 1, 0);
    for (std::size_t h = 0; h < next_.size(); ++h) ++offsets_[at(originOf(h)) + 1];
    std::partial_sum(offsets_.begin(), offsets_.end(), offsets_.begin());
    leaving_.resize(next_.size());
    std::vector<std::size_t> filled(offsets_.begin(), offsets_.end() - 1);
    for (std::size_t h = 0; h < next_.size(); ++h) leaving_[filled[at(originOf(h))]++] = h;
    for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) {
      const auto begin = leaving_.begin() + static_cast<std::ptrdiff_t>(offsets_[v]);
      const auto end = leaving_.begin() + static_cast<std::ptrdiff_t>(offsets_[v + 1]);
      const Point p = its_.points[v];
      std::sort(begin, end, [&](std::size_t one, std::size_t other) {
        const Point q = targetOf(one);
        const Point r = targetOf(other);
        const bool isLeft = isBefore(q, p);
        if (isLeft != isBefore(r, p)) return !isLeft;
        return orientation(p, q, r) > 0;
      });
      for (auto it = begin; it != end; ++it) next_[*it ^ 1] = it == begin ? *std::prev(end) : *std::prev(it);
    }
  }

  /// Gives the half-edges of each cycle a face of their own.
  void findCycles() {
    for (std::size_t start = 0; start < next_.size(); ++start) {
      if (face_[start] != kNowhere) continue;
      for (std::size_t h = start; face_[h] == kNowhere; h = next_[h]) face_[h] = cycles_;
      ++cycles_;
    }
  }

  /// Joins the outer cycle of each component with the face around it. Face `cycles_` is the unbounded one. A line
  /// sweeps over the points and keeps the segments that it crosses, from below.
  void joinComponents() {
    std::vector<std::size_t> faceOf(cycles_ + 1);
    std::iota(faceOf.begin(), faceOf.end(), std::size_t{0});
    Active active(Below{this});
    std::vector<Active::iterator> places(its_.segments.size());
    std::vector<bool> isMet(its_.points.size(), false);
    for (const std::int32_t v : pointsInOrder()) {
      const auto leaving = std::span(leaving_).subspan(offsets_[at(v)], offsets_[at(v) + 1] - offsets_[at(v)]);
      for (const std::size_t h : leaving) {
        if (h % 2 == 1) active.erase(places[h / 2]);
      }
      const auto above = active.lower_bound(pointAt(v));
      if (!isMet[at(v)]) {
        // The unbounded side of the component is on the left of the half-edge that leaves its first point uppermost.
        faceOf[face_[leaving.back()]] = above == active.begin() ? cycles_ : faceOf[face_[2 * *std::prev(above)]];
        markComponent(v, isMet);
      }
      for (const std::size_t h : leaving) {
        if (h % 2 == 0) places[h / 2] = active.insert(above, h / 2);
      }
    }
    for (std::size_t& face : face_) face = faceOf[face];
  }

  /// Compares segments where a line crosses both, and with a point on the line.
  struct Below {
    using is_transparent = void;
    const Faces* faces;

    bool operator()(std::size_t s, std::size_t t) const {
      return isBelow(faces->startOf(s), faces->endOf(s), faces->startOf(t), faces->endOf(t));
    }
    bool operator()(std::size_t s, Point p) const { return orientation(faces->startOf(s), faces->endOf(s), p) > 0; }
    bool operator()(Point p, std::size_t s) const { return orientation(faces->startOf(s), faces->endOf(s), p) < 0; }
  };
  using Active = std::set<std::size_t, Below>;

  Point startOf(std::size_t segment) const { return pointAt(its_.segments[segment].a); }
  Point endOf(std::size_t segment) const { return pointAt(its_.segments[segment].b); }

  /// The points of segments, in the order in which the line meets them.
  std::vector<std::int32_t> pointsInOrder() const {
    std::vector<std::int32_t> order;
    for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) {
      if (offsets_[v] < offsets_[v + 1]) order.push_back(static_cast<std::int32_t>(v));
    }
    std::ranges::sort(order, [&](std::int32_t v, std::int32_t w) { return isBefore(pointAt(v), pointAt(w)); });
    return order;
  }

  /// Marks the points of the component of a point.
  void markComponent(std::int32_t first, std::vector<bool>& isMet) const {
    isMet[at(first)] = true;
    std::vector<std::int32_t> pending = {first};
    while (!pending.empty()) {
      const std::size_t v = at(pending.back());
      pending.pop_back();
      for (std::size_t k = offsets_[v]; k < offsets_[v + 1]; ++k) {
        const std::int32_t other = originOf(leaving_[k] ^ 1);
        if (isMet[at(other)]) continue;
        isMet[at(other)] = true;
        pending.push_back(other);
      }
    }
  }

  /// Walks from face to face, and keeps the polygons that contain the face where it is.
  void findInside() {
    const std::size_t faces = cycles_ + 1;
    std::vector<std::size_t> offsets(faces + 1, 0);
    for (const std::size_t face : face_) ++offsets[face + 1];
    std::partial_sum(offsets.begin(), offsets.end(), offsets.begin());
    std::vector<std::size_t> filled(offsets.begin(), offsets.end() - 1);
    std::vector<std::size_t> around(face_.size());
    for (std::size_t h = 0; h < face_.size(); ++h) around[filled[face_[h]]++] = h;

    std::vector<bool> contains;
    std::size_t count = 0;
    const auto cross = [&](std::size_t h) {
      for (std::size_t k = its_.offsets[h / 2]; k < its_.offsets[h / 2 + 1]; ++k) {
        const std::size_t polygon = at(its_.polygons[k]);
        if (contains.size() <= polygon) contains.resize(polygon + 1, false);
        count = contains[polygon] ? count - 1 : count + 1;
        contains[polygon] = !contains[polygon];
      }
    };
    struct Step {
      std::size_t face;
      std::size_t across;  ///< the half-edge by which the walk came
      std::size_t next;
    };
    isInside_.assign(faces, false);
    std::vector<bool> isMet(faces, false);
    std::vector<Step> path = {{cycles_, kNowhere, offsets[cycles_]}};
    isMet[cycles_] = true;
    while (!path.empty()) {
      Step& step = path.back();
      if (step.next == offsets[step.face + 1]) {
        if (step.across != kNowhere) cross(step.across);
        path.pop_back();
        continue;
      }
      const std::size_t h = around[step.next++];
      const std::size_t beyond = face_[h ^ 1];
      if (isMet[beyond]) continue;
      isMet[beyond] = true;
      cross(h);
      isInside_[beyond] = count > 0;
      path.push_back({beyond, h, offsets[beyond]});
    }
  }

  const Arrangement& its_;
  std::vector<std::size_t> next_;  ///< around the face of each half-edge
  std::vector<std::size_t> face_;
  std::vector<std::size_t> offsets_;  ///< for each point where its half-edges begin
  std::vector<std::size_t> leaving_;  ///< the half-edges that leave each point
  std::size_t cycles_ = 0;
  std::vector<bool> isInside_;
};

}  // namespace

Rings dissolved(const Rings& rings, std::span<const std::int32_t> polygonOfRing) {
  const Arrangement arrangement = Noder(rings, polygonOfRing).run();
  return Faces(arrangement).rings();
}

}  // namespace circle_voronoi
