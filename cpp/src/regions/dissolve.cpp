// SPDX-License-Identifier: GPL-3.0-or-later
#include "dissolve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <optional>
#include <unordered_map>
#include <utility>

#include "at.h"
#include "bit_cast.h"
#include "circle_voronoi/convex_polygon.h"
#include "circle_voronoi/limits.h"
#include "guarded.h"
#include "in_circle.h"
#include "rounded.h"
#include "scale.h"
#include "two_part.h"

namespace circle_voronoi {
namespace {

Box boxAround(Point p, Point q) {
  return {std::min(p.x, q.x), std::min(p.y, q.y), std::max(p.x, q.x), std::max(p.y, q.y)};
}

bool meet(const Box& a, const Box& b) {
  return a.minX <= b.maxX && b.minX <= a.maxX && a.minY <= b.maxY && b.minY <= a.maxY;
}

/// Returns the cross product of two vectors with a small relative error, also where they are nearly parallel. A
/// crossing of such segments would otherwise be off by many steps of the grid.
double accurateCross(Vector u, Vector v) {
  const TwoPart left = product(u.x, v.y);
  const TwoPart right = product(u.y, v.x);
  const TwoPart difference = sum(left.value, -right.value);
  return difference.value + (difference.rest + (left.rest - right.rest));
}

/// Boxes in a tree of groups, each of boxes one after the other.
class BoxTree {
 public:
  explicit BoxTree(std::vector<Box> boxes) {
    levels_.push_back(std::move(boxes));
    while (levels_.back().size() > 1) {
      const auto& below = levels_.back();
      std::vector<Box> above;
      for (std::size_t k = 0; k < below.size(); ++k) {
        if (k % kGroup == 0) above.push_back(below[k]);
        Box& box = above.back();
        box = {std::min(box.minX, below[k].minX), std::min(box.minY, below[k].minY), std::max(box.maxX, below[k].maxX),
               std::max(box.maxY, below[k].maxY)};
      }
      levels_.push_back(std::move(above));
    }
  }

  /// Calls `visit` with the index of each box that meets a box.
  template <class Visit>
  void visitMeeting(const Box& box, const Visit& visit) const {
    if (!levels_.back().empty()) visitIn(levels_.size() - 1, 0, box, visit);
  }

 private:
  static constexpr std::size_t kGroup = 8;

  template <class Visit>
  void visitIn(std::size_t level, std::size_t k, const Box& box, const Visit& visit) const {
    if (!meet(levels_[level][k], box)) return;
    if (level == 0) return visit(k);
    const std::size_t end = std::min((k + 1) * kGroup, levels_[level - 1].size());
    for (std::size_t child = k * kGroup; child < end; ++child) visitIn(level - 1, child, box, visit);
  }

  std::vector<std::vector<Box>> levels_;
};

/// A segment between two points, by their indices. Point `a` is before point `b`.
struct Segment {
  std::int32_t a;
  std::int32_t b;

  friend auto operator<=>(const Segment&, const Segment&) = default;
};

/// A part of the boundary of a polygon.
struct Piece {
  Segment segment;
  std::int32_t polygon;
  bool isNew;  ///< whether it has not been compared with others yet
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
/// repeated. A few rounds usually suffice. If not, all points move to a grid, and a side that passes through the square
/// of a point, a step of the grid wide, is led through the point: snap rounding (J. D. Hobby, "Practical segment
/// intersection with finite precision output", 1999). If that does not suffice either, the grid becomes coarser, up to
/// a step at which the result would no longer be that of the given sides.
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
  }

  Arrangement run() {
    for (int round = 1;; ++round) {
      cancelPairs();
      findSegments();
      findSplits();
      if (splits_.empty()) break;
      split();
      if (round % kPatience == 0) coarsen();
    }
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
  static constexpr int kPatience = 12;
  /// The steps of the first and the coarsest grid, as shares of the largest coordinate, and the factor to each next
  /// step.
  static constexpr double kFirstGrid = 0x1p-46;
  static constexpr double kCoarsestGrid = 0x1p-34;
  static constexpr double kCoarser = 0x1p6;

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

  std::int32_t indexOf(Point p) {
    const auto [found, isNew] = indices_.try_emplace(p, static_cast<std::int32_t>(points_.size()));
    if (isNew) points_.push_back(p);
    if (points_.size() > kMaxRegionSides) {
      throw ThrownError{{ErrorCode::tooManyCircles, kNone, "The sides of the region cross in too many points."}};
    }
    return found->second;
  }

  void add(std::int32_t from, std::int32_t to, std::int32_t polygon, std::vector<Piece>& pieces) const {
    if (from == to) return;
    const bool isForward = isBefore(point(from), point(to));
    pieces.push_back({isForward ? Segment{from, to} : Segment{to, from}, polygon, true});
  }

  /// Two pieces of one polygon in the same place bound nothing. Sorts the others by their segments.
  void cancelPairs() {
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
  }

  void findSegments() {
    segments_.clear();
    isNew_.clear();
    for (const Piece& piece : pieces_) {
      if (segments_.empty() || segments_.back() != piece.segment) {
        segments_.push_back(piece.segment);
        isNew_.push_back(false);
      }
      if (piece.isNew) isNew_.back() = true;
    }
  }

  /// Returns a box around a segment and the squares of its ends.
  Box boxOf(const Segment& segment) const {
    const Box box = boxAround(point(segment.a), point(segment.b));
    const double half = grid_ / 2;
    return {box.minX - half, box.minY - half, box.maxX + half, box.maxY + half};
  }

  /// The segments in an order in which those near one another are mostly one after the other: along a curve of
  /// G. M. Morton.
  std::vector<std::size_t> spatialOrder() const {
    Box all = {0, 0, 0, 0};
    if (!points_.empty()) all = boxAround(points_[0], points_[0]);
    for (const Point& p : points_) {
      all = {std::min(all.minX, p.x), std::min(all.minY, p.y), std::max(all.maxX, p.x), std::max(all.maxY, p.y)};
    }
    const auto place = [](double value, double from, double to) {
      constexpr double kCells = 65535;
      return to > from ? static_cast<std::uint32_t>(std::clamp((value - from) / (to - from), 0.0, 1.0) * kCells) : 0;
    };
    const auto spread = [](std::uint64_t bits) {
      bits = (bits | bits << 8) & 0x00FF00FF;
      bits = (bits | bits << 4) & 0x0F0F0F0F;
      bits = (bits | bits << 2) & 0x33333333;
      return (bits | bits << 1) & 0x55555555;
    };
    std::vector<std::pair<std::uint64_t, std::size_t>> order;
    order.reserve(segments_.size());
    for (std::size_t k = 0; k < segments_.size(); ++k) {
      const Point p = point(segments_[k].a);
      order.emplace_back(spread(place(p.x, all.minX, all.maxX)) | spread(place(p.y, all.minY, all.maxY)) << 1, k);
    }
    std::ranges::sort(order);
    std::vector<std::size_t> result;
    for (const auto& [code, k] : order) result.push_back(k);
    return result;
  }

  void findSplits() {
    splits_.clear();
    const std::vector<std::size_t> order = spatialOrder();
    std::vector<Box> boxes;
    for (const std::size_t k : order) boxes.push_back(boxOf(segments_[k]));
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < order.size(); ++i) {
      if (!isNew_[order[i]]) continue;
      tree.visitMeeting(boxes[i], [&](std::size_t j) {
        if (i != j && (i < j || !isNew_[order[j]])) splitWhereTheyMeet(order[i], order[j]);
      });
    }
  }

  void splitWhereTheyMeet(std::size_t i, std::size_t j) {
    const auto [a, b] = segments_[i];
    const auto [c, d] = segments_[j];
    if (grid_ > 0) {
      for (const std::int32_t end : {c, d}) splitIfInSquare(i, end);
      for (const std::int32_t end : {a, b}) splitIfInSquare(j, end);
    }
    const int ofC = orientation(point(a), point(b), point(c));
    const int ofD = orientation(point(a), point(b), point(d));
    if (ofC * ofD > 0) return;
    const int ofA = orientation(point(c), point(d), point(a));
    const int ofB = orientation(point(c), point(d), point(b));
    if (ofA * ofB > 0) return;
    if (ofC * ofD < 0 && ofA * ofB < 0) {
      const std::int32_t crossing = indexOf(crossingOf(segments_[i], segments_[j]));
      splitAt(i, crossing);
      splitAt(j, crossing);
      return;
    }
    const auto splitIfWithin = [&](std::size_t k, std::int32_t end, int side) {
      const Point p = point(end);
      if (side == 0 && isBefore(point(segments_[k].a), p) && isBefore(p, point(segments_[k].b))) splitAt(k, end);
    };
    splitIfWithin(i, c, ofC);
    splitIfWithin(i, d, ofD);
    splitIfWithin(j, a, ofA);
    splitIfWithin(j, b, ofB);
  }

  /// Splits a segment at a point if it passes through the inside of the point's square.
  void splitIfInSquare(std::size_t k, std::int32_t index) {
    const auto [a, b] = segments_[k];
    if (index == a || index == b) return;
    const auto [x, y] = point(index);
    const double half = grid_ / 2;
    const Box box = boxAround(point(a), point(b));
    if (!(box.minX < x + half && x - half < box.maxX && box.minY < y + half && y - half < box.maxY)) return;
    bool isLeft = false;
    bool isRight = false;
    for (const Point corner :
         {Point{x - half, y - half}, {x + half, y - half}, {x + half, y + half}, {x - half, y + half}}) {
      const int side = orientation(point(a), point(b), corner);
      isLeft |= side > 0;
      isRight |= side < 0;
    }
    if (isLeft && isRight) splitAt(k, index);
  }

  /// Returns the rounded crossing of two segments, moved into the bounding boxes of both, so that no point leaves a
  /// side along an axis.
  Point crossingOf(const Segment& s, const Segment& t) const {
    const Point p = point(s.a);
    const Point q = point(s.b);
    const Point u = point(t.a);
    const Point v = point(t.b);
    const Vector along = vectorTo(p, q);
    const Vector across = vectorTo(u, v);
    const double slope = accurateCross(along, across);
    const double share = slope == 0 ? 0.5 : accurateCross(vectorTo(p, u), across) / slope;
    const Box first = boxAround(p, q);
    const Box second = boxAround(u, v);
    const auto within = [](double value, double low, double high) {
      return std::clamp(value, low, std::max(low, high));
    };
    const double x = p.x + share * (q.x - p.x);
    const double y = p.y + share * (q.y - p.y);
    return rounded({within(x, std::max(first.minX, second.minX), std::min(first.maxX, second.maxX)),
                    within(y, std::max(first.minY, second.minY), std::min(first.maxY, second.maxY))});
  }

  /// Adding zero turns -0 into +0. Without a grid, numbers are rounded as those of a region.
  Point rounded(Point p) const {
    if (grid_ == 0) return {circle_voronoi::rounded(p.x) + 0.0, circle_voronoi::rounded(p.y) + 0.0};
    return {std::floor(p.x / grid_ + 0.5) * grid_ + 0.0, std::floor(p.y / grid_ + 0.5) * grid_ + 0.0};
  }

  void splitAt(std::size_t segment, std::int32_t index) {
    const auto [a, b] = segments_[segment];
    if (index == a || index == b) return;
    splits_.push_back({segment, index, facing(vectorTo(point(a), point(b)), vectorTo(point(a), point(index)))});
  }

  void split() {
    std::ranges::sort(splits_, [&](const Split& one, const Split& other) {
      if (one.segment != other.segment) return one.segment < other.segment;
      return one.along != other.along ? one.along < other.along : isBefore(point(one.point), point(other.point));
    });
    std::vector<Piece> pieces;
    std::size_t segment = 0;
    std::size_t next = 0;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const auto& [its, polygon, isNew] = pieces_[k];
      if (k > 0 && its != pieces_[k - 1].segment) {
        while (next < splits_.size() && splits_[next].segment == segment) ++next;
        ++segment;
      }
      if (next == splits_.size() || splits_[next].segment != segment) {
        pieces.push_back({its, polygon, false});
        continue;
      }
      std::int32_t last = its.a;
      for (std::size_t s = next; s < splits_.size() && splits_[s].segment == segment; ++s) {
        add(last, splits_[s].point, polygon, pieces);
        last = splits_[s].point;
      }
      add(last, its.b, polygon, pieces);
    }
    pieces_ = std::move(pieces);
  }

  void coarsen() {
    double size = 0;
    for (const Point& p : points_) size = std::max({size, std::abs(p.x), std::abs(p.y)});
    const double unit = powerOfTwoIn(size);
    grid_ = grid_ == 0 ? std::max(kFirstGrid * unit, 2 * kCoordinateStep) : kCoarser * grid_;
    if (grid_ > std::max(kCoarsestGrid * unit, 2 * kCoordinateStep)) {
      throw ThrownError{
          {ErrorCode::badOption, kNone, "Too many sides of the region nearly meet. Simplify its polygons."}};
    }
    const std::vector<Point> before = std::move(points_);
    const std::vector<Piece> pieces = std::move(pieces_);
    points_.clear();
    indices_.clear();
    pieces_.clear();
    for (const auto& [segment, polygon, isNew] : pieces) {
      const std::int32_t from = indexOf(rounded(before[at(segment.a)]));
      add(from, indexOf(rounded(before[at(segment.b)])), polygon, pieces_);
    }
  }

  std::vector<Point> points_;
  std::unordered_map<Point, std::int32_t, Hash> indices_;
  std::vector<Piece> pieces_;
  std::vector<Segment> segments_;  ///< the segments of all pieces, without duplicates
  std::vector<bool> isNew_;        ///< of each segment
  std::vector<Split> splits_;
  double grid_ = 0;  ///< the step of the grid of points; 0 for all doubles
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

  /// Joins the outer cycle of each component with the face around it. Face `cycles_` is the unbounded one.
  void joinComponents() {
    std::vector<std::size_t> faceOf(cycles_ + 1);
    std::iota(faceOf.begin(), faceOf.end(), std::size_t{0});
    std::vector<Box> boxes;
    for (const Segment& segment : its_.segments) boxes.push_back(boxAround(pointAt(segment.a), pointAt(segment.b)));
    const BoxTree tree(std::move(boxes));
    for (const std::int32_t first : firstPoints()) {
      // The unbounded side of the component is on the left of the half-edge that leaves its first point uppermost.
      const std::size_t outer = leaving_[offsets_[at(first) + 1] - 1];
      const auto below = segmentBelow(tree, pointAt(first));
      faceOf[face_[outer]] = below ? faceOf[face_[2 * *below]] : cycles_;
    }
    for (std::size_t& face : face_) face = faceOf[face];
  }

  /// The first point of each component, in their order.
  std::vector<std::int32_t> firstPoints() const {
    std::vector<std::int32_t> order;
    for (std::size_t v = 0; v + 1 < offsets_.size(); ++v) {
      if (offsets_[v] < offsets_[v + 1]) order.push_back(static_cast<std::int32_t>(v));
    }
    std::ranges::sort(order, [&](std::int32_t v, std::int32_t w) { return isBefore(pointAt(v), pointAt(w)); });
    std::vector<bool> isMet(its_.points.size(), false);
    std::vector<std::int32_t> pending;
    std::vector<std::int32_t> result;
    for (const std::int32_t first : order) {
      if (isMet[at(first)]) continue;
      isMet[at(first)] = true;
      result.push_back(first);
      pending.push_back(first);
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
    return result;
  }

  /// The uppermost segment below a point that is the first of its component.
  std::optional<std::size_t> segmentBelow(const BoxTree& tree, Point p) const {
    std::optional<std::size_t> result;
    tree.visitMeeting({p.x, -kRegionLimit, p.x, p.y}, [&](std::size_t k) {
      const Point a = pointAt(its_.segments[k].a);
      const Point b = pointAt(its_.segments[k].b);
      if (!isBefore(a, p) || !isBefore(p, b) || orientation(a, b, p) <= 0) return;
      if (!result || isBelow(its_.segments[*result], its_.segments[k])) result = k;
    });
    return result;
  }

  /// Whether one of two segments is below the other where a line crosses both.
  bool isBelow(const Segment& s, const Segment& t) const {
    const auto sideOf = [&](const Segment& segment, std::int32_t point) {
      return orientation(pointAt(segment.a), pointAt(segment.b), pointAt(point));
    };
    if (isBefore(pointAt(t.a), pointAt(s.a))) {
      const int side = sideOf(t, s.a);
      return (side != 0 ? side : sideOf(t, s.b)) < 0;
    }
    const int side = s.a == t.a ? 0 : sideOf(s, t.a);
    return (side != 0 ? side : sideOf(s, t.b)) > 0;
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
