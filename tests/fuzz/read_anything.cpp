// SPDX-License-Identifier: GPL-3.0-or-later
#include "read_anything.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>
#include <sstream>
#include <vector>

#include "circle_voronoi/certify.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/table.h"
#include "circle_voronoi/tile.h"
#include "utf8.h"

namespace circle_voronoi::fuzz {
namespace {

constexpr std::string_view kName = "text";
constexpr std::optional<int> kAllDigits;

template <class Write, class... Values>
std::string written(Write write, const Values&... values) {
  std::ostringstream out;
  const Result<void> done = write(out, values...);
  return done ? out.str() : done.error().message;
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
    const auto again = readCircles(written(write, circles.value(), CircleAttributes{}), kName);
    if (!again || !isSame(again.value(), circles.value())) return "circles do not come back";
  }
  return std::nullopt;
}

/// The circles that a stream reads from a text in pieces of a given size, up to the error, which is set.
Tile readInPieces(std::string_view text, std::size_t size, std::optional<Error>& error) {
  Tile all;
  TileStream stream{std::string(kName)};
  const auto add = [&](const Result<Tile>& tile) {
    if (!tile) {
      error = tile.error();
      return;
    }
    const auto& [circles, ids, done] = tile.value();
    all.circles.insert(all.circles.end(), circles.begin(), circles.end());
    all.ids.insert(all.ids.end(), ids.begin(), ids.end());
    all.done.insert(all.done.end(), done.begin(), done.end());
  };
  for (std::size_t i = 0; i < text.size() && !error; i += size) add(stream.read(text.substr(i, size)));
  if (!error) add(stream.end());
  return all;
}

/// A tile is the same in pieces, of a few characters if it is short, and so is its error.
std::optional<std::string> tryTile(std::string_view text) {
  std::optional<Error> error;
  const Tile whole = readInPieces(text, text.size(), error);
  std::optional<Error> other;
  const Tile inPieces = readInPieces(text, 1 + text.size() / 50, other);
  const bool isOneError = error && other && error->message == other->message && error->circle == other->circle;
  if ((error || other) && !isOneError) return "the error of a tile is another in pieces";
  if (error && !isOneLine(*error, text)) return "the error of a tile is not one line of text: " + error->message;
  const auto tile = readTile(text, kName);
  if (tile && (error || tile.value().circles.size() != whole.circles.size())) return "a stream reads another tile";
  if (error) return std::nullopt;
  const bool isOneTile =
      isSame(whole.circles, inPieces.circles) && whole.ids == inPieces.ids && whole.done == inPieces.done;
  return isOneTile ? std::nullopt : std::optional<std::string>("a tile is another in pieces");
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

/// A table comes back from each format that keeps types.
std::optional<std::string> tryTable(std::string_view text) {
  const std::vector<std::string> names = {"x", "r"};
  const auto table = readTable(text, kName, names);
  if (!table) {
    if (isOneLine(table.error(), text)) return std::nullopt;
    return "the error of readTable is not one line of text: " + table.error().message;
  }
  const auto isTheSame = [&](const std::string& copy) {
    const auto again = readTable(copy, kName, names);
    return again && std::ranges::equal(again->columns, table->columns, {}, &Column::values, &Column::values);
  };
  ClippedPolygons polygons;
  polygons.polygonOffsets.resize(table->lines.size() + 1);
  for (const auto write : {writeTableJson, writeTableGeoJson}) {
    if (!isTheSame(written(write, table->columns, polygons))) return "a table does not come back";
  }
  (void)readTable(written(writeTableCsv, table->columns), kName, names);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> readAnything(std::string_view text) {
  (void)holdsDiagram(text);
  auto problem = tryCircles(text);
  if (!problem) problem = tryTile(text);
  if (!problem) problem = tryTable(text);
  return problem ? problem : tryDiagram(text);
}

}  // namespace circle_voronoi::fuzz
