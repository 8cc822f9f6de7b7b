// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_sweep.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <compare>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "at.h"
#include "guarded.h"
#include "in_circle.h"
#include "number_text.h"
#include "scale.h"

namespace circle_voronoi {
namespace {

std::string textOf(Point p) { return "(" + numberText(p.x) + ", " + numberText(p.y) + ")"; }

class Sweep {
 public:
  using SideName = std::function<std::string(std::int32_t)>;
  using Advise = std::function<void(Error&, std::int32_t, std::int32_t)>;

  Sweep(const Rings& rings, const SideName& sideName, const Advise& advise)
      : rings_(rings), sideName_(sideName), advise_(advise), active_(Below{this}) {
    const std::size_t count = rings.points.size();
    next_.resize(count);
    previous_.resize(count);
    ring_.resize(count);
    where_.resize(count);
    const std::size_t ringCount = rings.offsets.size() - 1;
    for (std::size_t r = 0; r < ringCount; ++r) {
      const std::int32_t begin = rings.offsets[r];
      const std::int32_t end = rings.offsets[r + 1];
      std::int32_t first = begin;
      for (std::int32_t v = begin; v < end; ++v) {
        next_[at(v)] = v + 1 == end ? begin : v + 1;
        previous_[at(v)] = v == begin ? end - 1 : v - 1;
        ring_[at(v)] = static_cast<std::int32_t>(r);
        if (isBefore(point(v), point(first))) first = v;
      }
      first_.push_back(first);
      const int turn = orientation(point(previous_[at(first)]), point(first), point(next_[at(first)]));
      order_.isCounterClockwise.push_back(turn > 0 ? 1 : 0);
    }
    order_.parent.assign(ringCount, -1);
  }

  RingOrder run() {
    struct Event {
      Point p;
      std::int32_t vertex;
    };
    std::vector<Event> events;
    events.reserve(rings_.points.size());
    for (std::size_t v = 0; v < rings_.points.size(); ++v) {
      events.push_back({rings_.points[v], static_cast<std::int32_t>(v)});
    }
    std::ranges::sort(events, [](const Event& a, const Event& b) {
      return isBefore(a.p, b.p) || (a.p == b.p && a.vertex < b.vertex);
    });
    std::vector<std::int32_t> here;
    for (std::size_t k = 0; k < events.size(); k += here.size()) {
      here.clear();
      for (std::size_t i = k; i < events.size() && events[i].p == events[k].p; ++i) here.push_back(events[i].vertex);
      if (here.size() > 1 || !passAlone(here.front())) passTogether(here);
    }
    return std::move(order_);
  }

 private:
  /// A side that the line crosses. At the side's end, the next side of the ring replaces it.
  struct Entry {
    mutable std::int32_t side;
  };
  struct Below {
    using is_transparent = void;
    const Sweep* sweep;
    bool operator()(const Entry& a, const Entry& b) const { return sweep->isBelow(a.side, b.side); }
    bool operator()(const Entry& a, Point p) const { return sweep->sideOf(a.side, p) > 0; }
    bool operator()(Point p, const Entry& a) const { return sweep->sideOf(a.side, p) < 0; }
  };
  using Active = std::set<Entry, Below>;

  Point point(std::int32_t vertex) const { return rings_.points[at(vertex)]; }
  Point startOf(std::int32_t side) const { return point(side); }
  Point endOf(std::int32_t side) const { return point(next_[at(side)]); }
  bool runsRight(std::int32_t side) const { return isBefore(startOf(side), endOf(side)); }
  Point leftOf(std::int32_t side) const { return runsRight(side) ? startOf(side) : endOf(side); }
  Point rightOf(std::int32_t side) const { return runsRight(side) ? endOf(side) : startOf(side); }

  /// 1 if a point lies above a side that the line through it crosses, 0 if it lies on it, -1 if it lies below.
  int sideOf(std::int32_t side, Point p) const { return orientation(leftOf(side), rightOf(side), p); }
  bool isOn(std::int32_t side, Point p) const { return sideOf(side, p) == 0; }

  bool isBelow(std::int32_t a, std::int32_t b) const {
    return a != b && circle_voronoi::isBelow(leftOf(a), rightOf(a), leftOf(b), rightOf(b));
  }

  /// Passes a vertex where nothing else is. Returns whether that is so; otherwise nothing is changed.
  bool passAlone(std::int32_t v) {
    const Point p = point(v);
    const std::int32_t in = previous_[at(v)];
    const bool inEnds = isBefore(startOf(in), p);
    const bool outEnds = isBefore(endOf(v), p);
    if (inEnds != outEnds) {
      const auto place = where_[at(inEnds ? in : v)];
      if (touchesBeside(place, std::next(place), p)) return false;
      const std::int32_t side = inEnds ? v : in;
      place->side = side;
      where_[at(side)] = place;
      checkBeside(place, std::next(place));
      return true;
    }
    refuseSpike(v);
    if (inEnds) {
      auto first = where_[at(in)];
      auto second = where_[at(v)];
      if (std::next(first) != second) std::swap(first, second);
      if (std::next(first) != second || touchesBeside(first, std::next(second), p)) return false;
      const auto after = active_.erase(first, std::next(second));
      checkBeside(after, after);
      return true;
    }
    const auto after = active_.lower_bound(p);
    if (touchesBeside(after, after, p)) return false;
    insert(in, after);
    insert(v, after);
    const auto first = where_[at(isBelow(in, v) ? in : v)];
    const auto last = std::next(first);
    checkBeside(first, std::next(last));
    if (v == first_[at(ring_[at(v)])]) setParent(first);
    return true;
  }

  /// Whether a point lies on the side before `begin` or on the side at `end`.
  bool touchesBeside(Active::iterator begin, Active::iterator end, Point p) const {
    return (begin != active_.begin() && isOn(std::prev(begin)->side, p)) ||
           (end != active_.end() && isOn(end->side, p));
  }

  void insert(std::int32_t side, Active::iterator hint) { where_[at(side)] = active_.insert(hint, Entry{side}); }

  /// Passes a point that several vertices share, or that lies on other sides.
  void passTogether(const std::vector<std::int32_t>& vertices) {
    const Point p = point(vertices.front());
    for (const std::int32_t v : vertices) refuseSpike(v);

    // A way of a ring through the point, by the ends of its two sides.
    struct Pass {
      std::int32_t in;
      std::int32_t out;
      std::array<Point, 2> ends;
    };
    std::vector<Pass> passes;
    for (const std::int32_t v : vertices) {
      passes.push_back({previous_[at(v)], v, {startOf(previous_[at(v)]), endOf(v)}});
    }
    std::vector<Active::iterator> ending;
    const auto [begin, end] = rangeAt(p);
    for (auto it = begin; it != end; ++it) {
      if (rightOf(it->side) == p) {
        ending.push_back(it);
      } else {
        passes.push_back({it->side, it->side, {startOf(it->side), endOf(it->side)}});
      }
    }

    // The directions in which sides leave, counter-clockwise.
    struct Way {
      Point to;
      std::size_t pass;
      std::int32_t side;
    };
    std::vector<Way> ways;
    for (std::size_t k = 0; k < passes.size(); ++k) {
      ways.push_back({passes[k].ends[0], k, passes[k].in});
      ways.push_back({passes[k].ends[1], k, passes[k].out});
    }
    const auto compare = [p](const Way& a, const Way& b) {
      const bool isLeft = isBefore(a.to, p);
      if (isLeft != isBefore(b.to, p)) return isLeft ? 1 : -1;
      return -orientation(p, a.to, b.to);
    };
    std::ranges::sort(ways, [&](const Way& a, const Way& b) { return compare(a, b) < 0; });
    for (std::size_t k = 1; k < ways.size(); ++k) {
      if (compare(ways[k - 1], ways[k]) == 0) refuse(ways[k - 1].side, ways[k].side, "overlap beside", p);
    }
    std::vector<const Way*> open;
    for (const Way& way : ways) {
      if (!open.empty() && open.back()->pass == way.pass) {
        open.pop_back();
      } else {
        open.push_back(&way);
      }
    }
    if (!open.empty()) refuse(open[0]->side, open[1]->side, "cross at", p);

    std::ranges::sort(passes, {}, [&](const Pass& pass) { return ring_[at(pass.in)]; });
    for (std::size_t k = 1; k < passes.size(); ++k) {
      if (ring_[at(passes[k - 1].in)] == ring_[at(passes[k].in)]) {
        refuse(passes[k - 1].out, passes[k].out, "touch at", p);
      }
    }
    if (passes.size() > 1) {
      for (const Pass& pass : passes) order_.touches.push_back({touchCount_, ring_[at(pass.in)]});
      ++touchCount_;
    }

    for (const auto it : ending) active_.erase(it);
    for (const std::int32_t v : vertices) {
      for (const std::int32_t side : {previous_[at(v)], v}) {
        if (leftOf(side) == p) where_[at(side)] = active_.insert(Entry{side}).first;
      }
    }
    const auto [first, last] = rangeAt(p);
    checkBeside(first, last);
    for (auto it = first; it != last; ++it) {
      if (it != first) check(std::prev(it)->side, it->side);
    }
    for (auto it = first; it != last; ++it) {
      const std::int32_t ring = ring_[at(it->side)];
      // The lower of the two sides at the first vertex of a ring comes first.
      if (leftOf(it->side) == p && point(first_[at(ring)]) == p && !std::exchange(hasParent_[ring], true)) {
        setParent(it);
      }
    }
  }

  /// The sides that a point lies on, its ends included.
  std::pair<Active::iterator, Active::iterator> rangeAt(Point p) { return active_.equal_range(p); }

  /// `lower` is the lower side at the first vertex of a ring.
  void setParent(Active::iterator lower) {
    if (lower == active_.begin()) return;
    const std::int32_t side = std::prev(lower)->side;
    const std::int32_t ring = ring_[at(side)];
    const bool isInside = runsRight(side) == (order_.isCounterClockwise[at(ring)] != 0);
    order_.parent[at(ring_[at(lower->side)])] = isInside ? ring : order_.parent[at(ring)];
  }

  /// Checks the sides before `begin` and at `end` against those between.
  void checkBeside(Active::iterator begin, Active::iterator end) const {
    const bool hasBefore = begin != active_.begin();
    const bool hasAfter = end != active_.end();
    if (begin == end) {
      if (hasBefore && hasAfter) check(std::prev(begin)->side, end->side);
      return;
    }
    if (hasBefore) check(std::prev(begin)->side, begin->side);
    if (hasAfter) check(std::prev(end)->side, end->side);
  }

  /// Refuses two sides that cross. Where an end of one lies on the other, the line has yet to come there.
  void check(std::int32_t a, std::int32_t b) const {
    const Point p = startOf(a);
    const Point q = endOf(a);
    const Point u = startOf(b);
    const Point v = endOf(b);
    if (orientation(p, q, u) * orientation(p, q, v) >= 0 || orientation(u, v, p) * orientation(u, v, q) >= 0) return;
    const Vector along = vectorTo(p, q);
    const Vector across = vectorTo(u, v);
    const double slope = cross(along, across);
    const double share = slope == 0 ? 0.5 : std::clamp(cross(vectorTo(p, u), across) / slope, 0.0, 1.0);
    refuse(a, b, "cross at", {p.x + share * (q.x - p.x), p.y + share * (q.y - p.y)});
  }

  /// Refuses a ring that goes back on its own side.
  void refuseSpike(std::int32_t v) const {
    const std::int32_t in = previous_[at(v)];
    const Point p = point(v);
    if (isBefore(startOf(in), p) != isBefore(endOf(v), p) || orientation(startOf(in), p, endOf(v)) != 0) return;
    refuse(in, v, "overlap beside", p);
  }

  [[noreturn]] void refuse(std::int32_t a, std::int32_t b, const char* what, Point p) const {
    std::string first = sideName_(std::min(a, b));
    first[0] = 'S';
    Error error = {ErrorCode::badOption, kNone,
                   first + " and " + sideName_(std::max(a, b)) + " " + what + " " + textOf(p) + "."};
    advise_(error, a, b);
    throw ThrownError{std::move(error)};
  }

  const Rings& rings_;
  const SideName& sideName_;
  const Advise& advise_;
  std::vector<std::int32_t> next_;
  std::vector<std::int32_t> previous_;
  std::vector<std::int32_t> ring_;
  std::vector<std::int32_t> first_;  ///< of each ring the leftmost vertex, of several the lowest
  std::map<std::int32_t, bool> hasParent_;
  Active active_;
  std::vector<Active::iterator> where_;  ///< of each side that is active
  std::int32_t touchCount_ = 0;
  RingOrder order_;
};

}  // namespace

bool isBelow(Point a, Point b, Point c, Point d) {
  if (isBefore(c, a)) {
    const int sign = orientation(c, d, a);
    return (sign != 0 ? sign : orientation(c, d, b)) < 0;
  }
  const int sign = a == c ? 0 : orientation(a, b, c);
  return (sign != 0 ? sign : orientation(a, b, d)) > 0;
}

RingOrder orderOf(const Rings& rings, const std::function<std::string(std::int32_t side)>& sideName,
                  const std::function<void(Error& error, std::int32_t a, std::int32_t b)>& advise) {
  return Sweep(rings, sideName, advise).run();
}

std::optional<RingOrder> orderIfApart(const Rings& rings) {
  try {
    return orderOf(
        rings, [](std::int32_t) { return std::string("side"); }, [](Error&, std::int32_t, std::int32_t) {});
  } catch (const ThrownError&) {
    return std::nullopt;
  }
}

}  // namespace circle_voronoi
