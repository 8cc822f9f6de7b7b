// SPDX-License-Identifier: GPL-3.0-or-later
#include "degree_rings.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace circle_voronoi::degrees {
namespace {

const Ring kAll = {{-180, -90}, {180, -90}, {180, 90}, {-180, 90}};

double doubleArea(const Ring& ring) {
  double sum = 0;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point p = ring[k];
    const Point q = ring[k + 1 == ring.size() ? 0 : k + 1];
    sum += (p.x - ring[0].x) * (q.y - ring[0].y) - (q.x - ring[0].x) * (p.y - ring[0].y);
  }
  return sum;
}

/// Returns how far a point of the rectangle's left or right side is along its boundary, counter-clockwise from the
/// lower left corner.
double placeOf(Point p) { return p.x > 0 ? 360 + (p.y + 90) : 900 + (90 - p.y); }
constexpr double kAround = 1080;
/// The places of the corners.
constexpr double kCorners[] = {360, 540, 900, kAround};

void append(Ring& ring, Point p) {
  if (ring.empty() || ring.back() != p) ring.push_back(p);
}

/// Cuts a closed line at the antimeridian into lines from side to side of the rectangle.
class Cutter {
 public:
  explicit Cutter(const Ring& line) {
    const std::size_t first = firstOutsidePoles(line);
    if (first == line.size()) return;
    append(current_, line[first]);
    Point before = line[first];
    double pole = 0;
    for (std::size_t k = 1; k <= line.size(); ++k) {
      const Point p = line[(first + k) % line.size()];
      if (isPole(p)) {
        pole = p.y;
        continue;
      }
      if (pole != 0) {
        append(current_, {before.x, pole});
        // The region is below the north pole's side, on which the line runs west, and above the south pole's.
        const bool isAcross = pole > 0 ? p.x > before.x : p.x < before.x;
        if (isAcross) cut(pole, pole < 0);
        append(current_, {p.x, pole});
        pole = 0;
      } else if (std::abs(p.x - before.x) > 180) {
        const bool isEastward = p.x < before.x;
        // The same point in both directions.
        const Point east = isEastward ? before : p;
        const Point west = isEastward ? p : before;
        const double share = (180 - east.x) / (180 - east.x + (west.x + 180));
        cut(east.y + share * (west.y - east.y), isEastward);
      }
      append(current_, p);
      before = p;
    }
    // The last line goes on with the first.
    if (lines.empty()) {
      current_.pop_back();
      closed = std::move(current_);
    } else {
      current_.insert(current_.end(), lines.front().begin() + 1, lines.front().end());
      lines.front() = std::move(current_);
    }
  }

  std::vector<Ring> lines;
  Ring closed;  ///< the line, if nothing cuts it

 private:
  static std::size_t firstOutsidePoles(const Ring& line) {
    return static_cast<std::size_t>(std::find_if(line.begin(), line.end(), [](Point p) { return !isPole(p); }) -
                                    line.begin());
  }

  void cut(double latitude, bool isEastward) {
    const double side = isEastward ? 180 : -180;
    append(current_, {side, latitude});
    lines.push_back(std::move(current_));
    current_ = {{-side, latitude}};
  }

  Ring current_;
};

/// Closes lines along the boundary of the rectangle: each goes on, counter-clockwise, with the line that starts next.
std::vector<Polygon> closedAlongSides(const std::vector<Ring>& lines) {
  struct End {
    double place = 0;
    bool isStart = false;
    std::size_t line = 0;
  };
  std::vector<End> ends;
  for (std::size_t k = 0; k < lines.size(); ++k) {
    ends.push_back({placeOf(lines[k].front()), true, k});
    ends.push_back({placeOf(lines[k].back()), false, k});
  }
  std::stable_sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    return a.place != b.place ? a.place < b.place : a.isStart < b.isStart;
  });
  std::vector<std::size_t> next(lines.size());
  std::vector<bool> hasPredecessor(lines.size());
  std::vector<std::size_t> open;
  for (int round = 0; round < 2; ++round) {
    for (const End& end : ends) {
      if (!end.isStart && round == 0) open.push_back(end.line);
      if (end.isStart && !hasPredecessor[end.line] && !open.empty()) {
        next[open.back()] = end.line;
        hasPredecessor[end.line] = true;
        open.pop_back();
      }
    }
  }
  std::vector<Polygon> polygons;
  std::vector<bool> isDone(lines.size());
  for (std::size_t first = 0; first < lines.size(); ++first) {
    if (isDone[first]) continue;
    Ring ring;
    std::size_t k = first;
    do {
      isDone[k] = true;
      for (const Point p : lines[k]) append(ring, p);
      const double from = placeOf(lines[k].back());
      double to = placeOf(lines[next[k]].front());
      if (to < from) to += kAround;
      for (const double turn : {0.0, kAround}) {
        for (std::size_t corner = 0; corner < 4; ++corner) {
          const double place = kCorners[corner] + turn;
          if (from < place && place < to) append(ring, kAll[(corner + 1) % 4]);
        }
      }
      k = next[k];
    } while (k != first);
    if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
    // Along the antimeridian, a line may enclose nothing.
    if (ring.size() > 2 && doubleArea(ring) > 0) polygons.push_back({std::move(ring)});
  }
  return polygons;
}

}  // namespace

bool isWhole(const Ring& ring) { return ring == kAll; }

std::vector<Polygon> polygonsOf(const Ring& line) {
  if (line.empty()) return {{kAll}};
  const Cutter cutter(line);
  if (!cutter.lines.empty()) return closedAlongSides(cutter.lines);
  const double area = doubleArea(cutter.closed);
  if (cutter.closed.size() < 3 || area == 0) return {};
  if (area > 0) return {{cutter.closed}};
  // Both poles are inside.
  return {{kAll, cutter.closed}};
}

}  // namespace circle_voronoi::degrees
