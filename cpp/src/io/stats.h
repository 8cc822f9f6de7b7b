// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "circle_voronoi/diagram.h"
#include "json_reader.h"

namespace circle_voronoi {

/// A number of a struct, with its name in JSON.
template <class Struct, class Field>
struct NamedField {
  std::string_view name;
  Field Struct::*field;
};

inline constexpr auto kCounts = std::to_array<NamedField<Counts, std::int64_t>>({
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
static_assert(sizeof(Counts) == kCounts.size() * sizeof(std::int64_t), "each count has a name");

inline constexpr auto kSeconds = std::to_array<NamedField<Seconds, double>>({
    {"hide", &Seconds::hide},
    {"sample", &Seconds::sample},
    {"pair", &Seconds::pair},
    {"touch", &Seconds::touch},
    {"flip", &Seconds::flip},
    {"repair", &Seconds::repair},
    {"certify", &Seconds::certify},
    {"total", &Seconds::total},
});
static_assert(sizeof(Seconds) == kSeconds.size() * sizeof(double), "each time has a name");

/// Reads the `stats` of a diagram as far as they are there; what is missing or of another type is left empty, as is any
/// certificate.
Stats readStats(JsonReader& reader);

}  // namespace circle_voronoi
