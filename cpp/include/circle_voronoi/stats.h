// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/method.h"

namespace circle_voronoi {

/// The work of each stage.
struct Counts {
  std::int64_t circles = 0;          ///< circles of the input
  std::int64_t hidden = 0;           ///< hidden circles among them
  std::int64_t samples = 0;          ///< sample points on circles (paper, section 5)
  std::int64_t antipodalDiscs = 0;   ///< candidate pairs, each with one antipodal disc (AD)
  std::int64_t threeTouchDiscs = 0;  ///< three-touch discs (TTDs) formed
  std::int64_t events = 0;           ///< discs taken from the queue
  std::int64_t leftoverCycles = 0;   ///< cycles of leftover directed edges; 1 in a right diagram of two circles or more
  std::int64_t resamplings = 0;      ///< how often more samples were taken (Options::resample)
  std::int64_t flips = 0;            ///< edges flipped
  std::int64_t repairs = 0;          ///< places where a local diagram was spliced in
  std::int64_t filtered = 0;         ///< predicates decided in floating point, with an error bound
  std::int64_t refined = 0;          ///< predicates decided with twice the digits, for near ties
  std::int64_t inCircle = 0;         ///< predicates decided by the exact in-circle test of centers (equal radii)
  std::int64_t exact = 0;            ///< predicates decided in integer arithmetic
};

/// Wall-clock seconds of each stage.
struct Seconds {
  double order = 0;        ///< checking the circles, and bringing them into spatial order
  double triangulate = 0;  ///< finding hidden circles, and the Delaunay triangulation of the centers
  double sample = 0;
  double pair = 0;
  double touch = 0;
  double flip = 0;
  double repair = 0;
  double certify = 0;
  double assemble = 0;  ///< vertices, edges, hull and links from the certified dual
  double total = 0;
};

/// Statistics of a computation. A member is empty if it does not apply or is not known.
struct Stats {
  std::optional<Method> method;          ///< the method asked for
  std::optional<Way> way;                ///< the construction that made the result
  std::optional<Candidates> candidates;  ///< of the touching disc method
  Counts counts;
  Seconds seconds;
};

/// A member of a struct and its name in JSON and JavaScript.
template <class Struct, class Member>
struct NamedMember {
  std::string_view name;
  Member Struct::*member;
};

/// All members of Counts.
inline constexpr auto kCountMembers = std::to_array<NamedMember<Counts, std::int64_t>>({
    {"circles", &Counts::circles},
    {"hidden", &Counts::hidden},
    {"samples", &Counts::samples},
    {"antipodalDiscs", &Counts::antipodalDiscs},
    {"threeTouchDiscs", &Counts::threeTouchDiscs},
    {"events", &Counts::events},
    {"leftoverCycles", &Counts::leftoverCycles},
    {"resamplings", &Counts::resamplings},
    {"flips", &Counts::flips},
    {"repairs", &Counts::repairs},
    {"filtered", &Counts::filtered},
    {"refined", &Counts::refined},
    {"inCircle", &Counts::inCircle},
    {"exact", &Counts::exact},
});
static_assert(sizeof(Counts) == kCountMembers.size() * sizeof(std::int64_t), "each count has a name");

/// All members of Seconds: the stages in the order of Stage, then the total.
inline constexpr auto kSecondsMembers = std::to_array<NamedMember<Seconds, double>>({
    {"order", &Seconds::order},
    {"triangulate", &Seconds::triangulate},
    {"sample", &Seconds::sample},
    {"pair", &Seconds::pair},
    {"touch", &Seconds::touch},
    {"flip", &Seconds::flip},
    {"repair", &Seconds::repair},
    {"certify", &Seconds::certify},
    {"assemble", &Seconds::assemble},
    {"total", &Seconds::total},
});
static_assert(sizeof(Seconds) == kSecondsMembers.size() * sizeof(double), "each time has a name");

}  // namespace circle_voronoi
