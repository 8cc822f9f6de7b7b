// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <type_traits>

#include "circle_voronoi/abi.h"

namespace circle_voronoi {

/// "None" in place of an index: no circle, no vertex, the unbounded end of an edge.
inline constexpr std::int32_t kNone = -1;

/// An index of one kind, counted from 0, or kNone. An index converts to and from an integer, but indices of different
/// kinds do not convert to each other and cannot be compared.
template <class Kind>
class Index {
 public:
  constexpr Index() = default;
  constexpr Index(std::int32_t value) : value_(value) {}
  constexpr operator std::int32_t() const { return value_; }

  constexpr Index& operator++() {
    ++value_;
    return *this;
  }

 private:
  std::int32_t value_ = kNone;
};

template <class Kind, class Other>
requires(!std::same_as<Kind, Other>) bool operator==(Index<Kind>, Index<Other>) = delete;
template <class Kind, class Other>
requires(!std::same_as<Kind, Other>) std::strong_ordering operator<=>(Index<Kind>, Index<Other>) = delete;

/// A circle of the input.
using CircleIndex = Index<struct OfCircles>;
using VertexIndex = Index<struct OfVertices>;
using EdgeIndex = Index<struct OfEdges>;
/// A side: an edge as seen from one of its two cells (Diagram).
using SideIndex = Index<struct OfSides>;
/// A side of a Region.
using RegionSideIndex = Index<struct OfRegionSides>;
/// A ring of a Region.
using RegionRingIndex = Index<struct OfRegionRings>;

}  // namespace circle_voronoi

/// Indices as keys of std::unordered_map and std::unordered_set.
template <class Kind>
struct std::hash<circle_voronoi::Index<Kind>> {
  std::size_t operator()(circle_voronoi::Index<Kind> index) const noexcept { return std::hash<std::int32_t>()(index); }
};

// Lets the algorithms of std::ranges compare indices with integers.
template <class Kind>
struct std::common_type<circle_voronoi::Index<Kind>, std::int32_t> {
  using type = std::int32_t;
};
template <class Kind>
struct std::common_type<std::int32_t, circle_voronoi::Index<Kind>> {
  using type = std::int32_t;
};
