// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "scale.h"

namespace circle_voronoi {
namespace {

/// A ring of that share of its radius is made of points alone that are one but for rounding.
constexpr double kNothing = 0x1p-30;

constexpr std::array<Vector, 4> kAxes = {{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

Point centerOf(const Circle& c) { return {c.x, c.y}; }
Point onAxis(const Circle& c, std::size_t k) { return {c.x + c.r * kAxes[k].x, c.y + c.r * kAxes[k].y}; }

/// The quarter of the circle in which a direction lies: from an axis to before the next.
std::size_t quarterOf(Vector v) {
  if (v.y >= 0) return v.x > 0 ? 0 : v.y > 0 ? 1 : 2;
  return v.x < 0 ? 2 : 3;
}

}  // namespace

std::optional<Chord> chordOf(Point from, Point to, bool hasFrom, bool hasTo, const Circle& disc) {
  if (hasFrom && hasTo) return Chord{};
  const double unit = unitFor(disc.r);
  const double size = lengthOf(vectorTo(from, to)) / unit;
  const Vector along = measuredIn(size, measuredIn(unit, vectorTo(from, to)));
  const Vector toCenter = measuredIn(unit, vectorTo(from, centerOf(disc)));
  const double foot = dot(along, toCenter);
  const double height = std::abs(cross(along, toCenter));
  const double r = disc.r / unit;
  const double half = std::sqrt(std::max((r - height) * (r + height), 0.0));
  Chord chord;
  if (!hasFrom) chord.from = std::clamp((foot - half) / size, 0.0, 1.0);
  if (!hasTo) chord.to = std::clamp((foot + half) / size, 0.0, 1.0);
  // With no end inside it may pass the disc by.
  if (!hasFrom && !hasTo && !(height < r && chord.from < chord.to)) return std::nullopt;
  return chord;
}

Ring::Ring(const ConvexPolygon* polygon, const std::optional<Circle>& disc) {
  if (disc) disc_ = *disc;
  if (polygon == nullptr) {
    takeDisc();
  } else if (!disc) {
    takePolygon(*polygon);
  } else {
    takeCommon(*polygon);
  }
  reach_.reserve(elements_.size() + 1);
  reach_.push_back(0);
  for (const Element& element : elements_) {
    reach_.push_back(reach_.back() + lengthOf(vectorTo(element.start, element.end)));
  }
}

void Ring::takeDisc() {
  for (std::size_t k = 0; k < kAxes.size(); ++k) {
    elements_.push_back({onAxis(disc_, k), onAxis(disc_, (k + 1) % kAxes.size()), disc_.r, kCircleOfRing});
  }
}

void Ring::takePolygon(const ConvexPolygon& polygon) {
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    addSegment(polygon.corners()[k], polygon.cornerAfter(k), static_cast<std::int32_t>(k));
  }
}

void Ring::takeCommon(const ConvexPolygon& polygon) {
  const Point center = centerOf(disc_);
  const auto corners = polygon.corners();
  std::vector<bool> isInside;
  for (const Point& corner : corners) isInside.push_back(lengthOf(vectorTo(center, corner)) <= disc_.r);
  struct Part {
    Point start;
    Point end;
    std::size_t side;
  };
  std::vector<Part> parts;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const Point to = polygon.cornerAfter(k);
    const auto chord = chordOf(corners[k], to, isInside[k], isInside[(k + 1) % corners.size()], disc_);
    if (!chord) continue;
    const Vector side = vectorTo(corners[k], to);
    const auto pointAt = [&](double share) {
      return share == 0   ? corners[k]
             : share == 1 ? to
                          : Point{corners[k].x + share * side.x, corners[k].y + share * side.y};
    };
    parts.push_back({pointAt(chord->from), pointAt(chord->to), k});
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    addSegment(parts[i].start, parts[i].end, static_cast<std::int32_t>(parts[i].side));
    const Point next = parts[(i + 1) % parts.size()].start;
    if (parts[i].end != next) addArc(parts[i].end, next);
  }
  double size = 0;
  for (const Element& element : elements_) size += lengthOf(vectorTo(element.start, element.end));
  // Nothing is cut off then, or nothing left, but for rounding.
  if (size > kNothing * disc_.r) return;
  elements_.clear();
  if (polygon.contains(center)) takeDisc();
}

void Ring::addSegment(Point from, Point to, std::int32_t side) {
  if (from != to) elements_.push_back({from, to, 0, side});
}

/// The arc counter-clockwise from one point of the circle to another, in quarters.
void Ring::addArc(Point from, Point to) {
  const Point center = centerOf(disc_);
  const Vector u = vectorTo(center, from);
  const Vector v = vectorTo(center, to);
  const std::size_t last = quarterOf(v);
  std::size_t quarter = quarterOf(u);
  const bool isOneQuarter = quarter == last && turn(u, v) >= 0;
  const bool isNothing = lengthOf(vectorTo(from, to)) <= kRounding * disc_.r;
  if (!isOneQuarter && !isNothing) {
    do {
      quarter = (quarter + 1) % kAxes.size();
      const Point axis = onAxis(disc_, quarter);
      if (from != axis) elements_.push_back({from, axis, disc_.r, kCircleOfRing});
      from = axis;
    } while (quarter != last);
  }
  if (from != to) elements_.push_back({from, to, disc_.r, kCircleOfRing});
}

Point Ring::middle() const {
  const Point first = elements_.front().start;
  Vector sum;
  for (const Element& element : elements_) {
    const Vector v = vectorTo(first, element.start);
    sum = {sum.x + v.x / static_cast<double>(elements_.size()), sum.y + v.y / static_cast<double>(elements_.size())};
  }
  return {first.x + sum.x, first.y + sum.y};
}

std::size_t Ring::elementAt(double place) const {
  const auto after = std::upper_bound(reach_.begin(), reach_.end() - 1, place);
  return static_cast<std::size_t>(after - reach_.begin()) - 1;
}

/// Of an arc: where the ray from the center through the point of the chord meets it.
Point Ring::pointOn(const Element& element, double share) const {
  const Vector chord = vectorTo(element.start, element.end);
  const Point p = {element.start.x + share * chord.x, element.start.y + share * chord.y};
  if (element.r == 0) return p;
  const Vector v = vectorTo(centerOf(disc_), p);
  const double factor = element.r / lengthOf(v);
  return {disc_.x + factor * v.x, disc_.y + factor * v.y};
}

double Ring::shareOn(const Element& element, Point p) const {
  const Vector chord = vectorTo(element.start, element.end);
  if (element.r == 0) {
    const double size = lengthOf(chord);
    return std::clamp(dot(measuredIn(size, chord), vectorTo(element.start, p)) / size, 0.0, 1.0);
  }
  const double unit = unitFor(element.r);
  const auto seen = [&](Point q) { return measuredIn(unit, vectorTo(centerOf(disc_), q)); };
  const double before = cross(seen(element.start), seen(p));
  const double whole = before + cross(seen(p), seen(element.end));
  return whole > 0 ? std::clamp(before / whole, 0.0, 1.0) : before > 0 ? 1 : 0;
}

Point Ring::at(double place) const {
  const std::size_t k = elementAt(place);
  return pointOn(elements_[k], (place - reach_[k]) / (reach_[k + 1] - reach_[k]));
}

double Ring::placeNear(Point p, std::optional<std::int32_t> side) const {
  double nearest = kInfinite;
  double place = 0;
  const auto consider = [&](std::size_t k) {
    const double share = shareOn(elements_[k], p);
    const double gap = lengthOf(vectorTo(p, pointOn(elements_[k], share)));
    if (gap < nearest) {
      nearest = gap;
      place = reach_[k] + share * (reach_[k + 1] - reach_[k]);
    }
  };
  for (std::size_t k = 0; k < elements_.size(); ++k) {
    if (!side || elements_[k].side == *side) consider(k);
  }
  // The side may have nothing but a point in common with the disc.
  return side && nearest == kInfinite ? placeNear(p) : place;
}

std::vector<Ring::Element> Ring::between(double from, double to, Point start, Point end) const {
  std::vector<Element> parts;
  std::size_t k = elementAt(from < total() ? from : from - total());
  const auto add = [&](Point p) {
    if (start != p) parts.push_back({start, p, elements_[k].r, elements_[k].side});
    start = p;
  };
  for (int round = 0; round < 3; ++round) {
    for (std::size_t j = 0; j < elements_.size(); ++j) {
      const double place = reach_[j] + round * total();
      if (!(from < place && place < to)) continue;
      add(elements_[j].start);
      k = j;
    }
  }
  add(end);
  return parts;
}

}  // namespace circle_voronoi
