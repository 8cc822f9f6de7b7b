// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <compare>
#include <concepts>
#include <cstdint>
#include <type_traits>

#include "circle_voronoi/abi.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// "None" in place of an index: the unbounded end of an edge, no circle, no vertex.
inline constexpr std::int32_t kNone = -1;

/// An index of one kind, from 0, or kNone. It is a number and may be made of one, but one kind does not turn into
/// another, nor do two kinds compare.
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
/// A side: an edge as one of its two cells has it (Diagram::nextSide).
using SideIndex = Index<struct OfSides>;

}  // namespace circle_voronoi

// So that algorithms of std::ranges compare indices with numbers.
template <class Kind>
struct std::common_type<circle_voronoi::Index<Kind>, std::int32_t> {
  using type = std::int32_t;
};
template <class Kind>
struct std::common_type<std::int32_t, circle_voronoi::Index<Kind>> {
  using type = std::int32_t;
};
