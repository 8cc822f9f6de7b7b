// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_anything.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <sstream>
#include <vector>

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/tile.h"
#include "utf8.h"

namespace circle_voronoi::fuzz {
namespace {

constexpr std::string_view kName = "text";
constexpr std::optional<int> kAllDigits;

template <class Write, class... Values>
std::string written(Write write, const Values&... values) {
  std::ostringstream out;
  write(out, values...);
  return out.str();
}

/// -0 and 0 are different.
bool isSame(std::span<const Circle> circles, std::span<const Circle> others) {
  return circles.size() == others.size() &&
         (circles.empty() || std::memcmp(circles.data(), others.data(), circles.size_bytes()) == 0);
}

bool isUtf8(std::string_view text) {
  while (!text.empty()) {
    const std::size_t size = sizeOfUtf8(text);
    if (size == 0) return false;
    text.remove_prefix(size);
  }
  return true;
}

bool isOneLine(const Error& error, std::string_view text) {
  const std::string begin = std::string(kName) + ":";
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  if (!error.message.starts_with(begin) || std::ranges::any_of(error.message, isControl)) return false;
  if (!isUtf8(error.message)) return false;
  const long line = std::strtol(error.message.c_str() + begin.size(), nullptr, 10);
  const auto isLineEnd = [](char c) { return c == '\n' || c == '\r'; };
  return line >= 1 && line <= 1 + std::ranges::count_if(text, isLineEnd);
}

std::optional<std::string> tryCircles(std::string_view text) {
  const auto circles = readCircles(text, kName);
  if (!circles) {
    if (isOneLine(circles.error(), text)) return std::nullopt;
    return "the error of readCircles is not one line of text: " + circles.error().message;
  }
  for (const auto write : {writeCirclesCsv, writeCirclesJson, writeCirclesGeoJson}) {
    const auto again = readCircles(written(write, circles.value()), kName);
    if (!again || !isSame(again.value(), circles.value())) return "circles do not come back";
  }
  return std::nullopt;
}

/// A tile that can be read as a whole can be read in pieces, of a few characters if it is short.
std::optional<std::string> tryTile(std::string_view text) {
  const std::size_t size = 5 + text.size() / 50;
  const auto tile = readTile(text, kName);
  TileStream stream{std::string(kName)};
  std::size_t count = 0;
  bool isRead = true;
  const auto add = [&](const Result<Tile>& piece) {
    isRead = isRead && piece;
    if (isRead) count += piece.value().circles.size();
  };
  for (std::size_t i = 0; i < text.size() && isRead; i += size) add(stream.read(text.substr(i, size)));
  if (isRead) add(stream.end());
  if (!tile || (isRead && count == tile.value().circles.size())) return std::nullopt;
  return "a tile is another in pieces";
}

std::optional<std::string> tryDiagram(std::string_view text) {
  const auto read = readDiagram(text, kName);
  if (!read) {
    if (isOneLine(read.error(), text)) return std::nullopt;
    return "the error of readDiagram is not one line of text: " + read.error().message;
  }
  const Diagram& diagram = read.value();
  if (!certify(diagram)) return "certify rejects circles that readDiagram takes";
  (void)written(writeDiagramCsv, diagram, kAllDigits);
  const std::string json = written(writeJson, diagram, kAllDigits);
  const auto again = readDiagram(json, kName);
  if (!again) return "a diagram does not come back: " + again.error().message;
  if (written(writeJson, again.value(), kAllDigits) != json) return "a diagram comes back another";
  return std::nullopt;
}

}  // namespace

std::optional<std::string> readAnything(std::string_view text) {
  (void)holdsDiagram(text);
  auto problem = tryCircles(text);
  if (!problem) problem = tryTile(text);
  return problem ? problem : tryDiagram(text);
}

}  // namespace circle_voronoi::fuzz
