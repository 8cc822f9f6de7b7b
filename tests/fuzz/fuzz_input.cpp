// SPDX-License-Identifier: GPL-3.0-or-later
#include "fuzz_input.h"

#include <bit>
#include <cmath>
#include <cstring>

namespace circle_voronoi::fuzz {
namespace {

using Bytes = std::span<const std::uint8_t>;

double small(std::uint8_t byte) { return static_cast<std::int8_t>(byte); }

/// Radii are mostly small, so that circles are not mostly hidden.
double smallRadius(std::uint8_t byte) { return byte < 128 ? byte % 8 : byte - 128; }

double bits(Bytes bytes) {
  std::uint64_t word = 0;
  std::memcpy(&word, bytes.data(), sizeof word);
  return std::bit_cast<double>(word);
}

Circle integers(Bytes bytes) { return {small(bytes[0]), small(bytes[1]), smallRadius(bytes[2])}; }

Circle farIntegers(Bytes bytes) {
  const Circle c = integers(bytes);
  return {c.x * 0x1p-20 + 0x1p20, c.y * 0x1p-20 - 0x1p21, c.r * 0x1p-20};
}

Circle doubles(Bytes bytes) { return {bits(bytes), bits(bytes.subspan(8)), bits(bytes.subspan(16))}; }

Circle scaledIntegers(Bytes bytes) {
  const auto scale = [](std::uint8_t byte) { return std::ldexp(1.0, 4 * static_cast<std::int8_t>(byte)); };
  const Circle c = integers(bytes);
  return {c.x * scale(bytes[3]), c.y * scale(bytes[4]), c.r * scale(bytes[5])};
}

struct Format {
  std::size_t size;
  Circle (*read)(Bytes);
  std::size_t mostCircles;
};

constexpr Format kFormats[] = {{3, integers, kMostCircles},
                               {3, farIntegers, kMostCircles},
                               {24, doubles, kMostCircles / 2},
                               {6, scaledIntegers, kMostCircles / 2}};

template <class Item>
Item* pick(std::vector<Item>& list, std::uint8_t index) {
  return list.empty() ? nullptr : &list[index % list.size()];
}

void apply(const Edit& edit, Diagram& diagram) {
  switch (edit.field % 5) {
    case 0:
      if (auto* triple = pick(diagram.vertexCircles, edit.item)) (*triple)[edit.field / 5 % 3] = edit.value;
      break;
    case 1:
      if (auto* e = pick(diagram.edges, edit.item)) {
        const std::uint8_t part = edit.field / 5 % 4;
        if (part < 2) (part == 0 ? e->left : e->right) = edit.value;
        if (part >= 2) (part == 2 ? e->start : e->end) = edit.value;
      }
      break;
    case 2:
      if (auto* circle = pick(diagram.hull, edit.item)) *circle = edit.value;
      break;
    case 3:
      if (auto* hidden = pick(diagram.hidden, edit.item)) hidden->by = edit.value;
      break;
    default:
      if (auto* vertex = pick(diagram.vertices, edit.item)) vertex->x = edit.value;
  }
}

}  // namespace

Input decode(Bytes bytes) {
  Input input;
  if (bytes.empty()) return input;
  const std::uint8_t head = bytes[0];
  bytes = bytes.subspan(1);
  for (int edits = head >> 2 & 7; edits > 0 && bytes.size() >= 3; --edits) {
    const Bytes tail = bytes.last(3);
    input.edits.push_back({tail[0], tail[1], static_cast<std::int8_t>(tail[2])});
    bytes = bytes.first(bytes.size() - 3);
  }
  const Format& format = kFormats[head & 3];
  while (bytes.size() >= format.size && input.circles.size() < format.mostCircles) {
    input.circles.push_back(format.read(bytes));
    bytes = bytes.subspan(format.size);
  }
  return input;
}

Diagram corrupted(Diagram diagram, std::span<const Edit> edits) {
  for (const Edit& edit : edits) apply(edit, diagram);
  return diagram;
}

}  // namespace circle_voronoi::fuzz
