// SPDX-License-Identifier: GPL-3.0-or-later
#include "tiler.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <system_error>

#include "command_error.h"
#include "files.h"
#include "tile_row.h"

namespace circle_voronoi::cli {
namespace {

namespace fs = std::filesystem;

constexpr const char* kWideFile = "wide.csv";
constexpr const char* kListFile = "tiles.txt";
/// The most characters that wait to be written to files.
constexpr std::size_t kMostWaiting = std::size_t{16} << 20;
/// A circle in more tiles is wide.
constexpr double kManyTiles = 64;
/// Tiles are numbered exactly.
constexpr double kMostCells = 0x1p50;

void append(std::string& text, std::string_view part) { text += part; }

/// Appends the shortest digits that read back to the same bits.
template <class Number>
void append(std::string& text, Number value) {
  std::array<char, 32> digits;
  text.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
}

void appendBox(std::string& text, const Box& box) {
  text += ' ';
  for (const double value : {box.minX, box.minY, box.maxX, box.maxY}) {
    append(text, value);
    text += ',';
  }
  text.pop_back();
}

/// Circle i of a tile as a row.
std::string rowOf(const Tile& tile, std::size_t i) {
  std::string row;
  writeTileRow(tile, i, [&](auto part) { append(row, part); });
  return row;
}

CommandError cannotWrite(const fs::path& file) {
  return {kFailure, "Cannot write " + file.string() + ": " + std::strerror(errno) + "."};
}

}  // namespace

Tiler::Tiler(fs::path folder, double size, double halo) : folder_(std::move(folder)), size_(size), halo_(halo) {
  std::error_code error;
  fs::create_directories(folder_, error);
  if (error) throw CommandError{kFailure, "Cannot make the folder " + folder_.string() + ": " + error.message() + "."};
  if (!fs::is_empty(folder_))
    throw CommandError{kBadInput, folder_.string() + " is not empty; tiles need a new folder."};
}

double Tiler::Range::count() const {
  return static_cast<double>(last.first - first.first + 1) * static_cast<double>(last.second - first.second + 1);
}

/// Returns the largest index of a tile whose box does not begin beyond a coordinate.
std::int64_t Tiler::cellOf(double coordinate) const {
  const double quotient = std::floor(coordinate / size_);
  if (!(std::abs(quotient) < kMostCells)) {
    throw CommandError{kBadInput,
                       "--size is too small for coordinates as large as these: the tiles cannot be counted."};
  }
  auto cell = static_cast<std::int64_t>(quotient);
  while (static_cast<double>(cell) * size_ > coordinate) --cell;
  while (static_cast<double>(cell + 1) * size_ <= coordinate) ++cell;
  return cell;
}

/// A little larger than the bounding box, so that rounding loses no tile. A circle of negative radius is treated as its
/// center.
Tiler::Range Tiler::rangeOf(const Circle& c) const {
  const double reach = std::max(c.r, 0.0) + halo_;
  const auto cellAt = [&](double coordinate, double way) {
    const double slack = 0x1p-40 * (std::abs(coordinate) + reach);
    const double quotient = std::floor((coordinate + way * (reach + slack)) / size_);
    return static_cast<std::int64_t>(std::clamp(quotient, -kMostCells, kMostCells));
  };
  return {{cellAt(c.y, -1), cellAt(c.x, -1)}, {cellAt(c.y, 1), cellAt(c.x, 1)}};
}

void Tiler::add(const Tile& tile) {
  for (std::size_t i = 0; i < tile.circles.size(); ++i) {
    const Circle& c = tile.circles[i];
    const std::string row = rowOf(tile, i);
    ++tiles_[{cellOf(c.y), cellOf(c.x)}].home;
    const Range range = rangeOf(c);
    if (range.count() > kManyTiles) {
      put(wide_, row);
      continue;
    }
    for (std::int64_t y = range.first.first; y <= range.last.first; ++y) {
      for (std::int64_t x = range.first.second; x <= range.last.second; ++x) put(tiles_[{y, x}], row);
    }
  }
  if (waiting_ > kMostWaiting) flush();
}

void Tiler::put(Content& content, const std::string& row) {
  if (!content.isBegun && content.text.empty()) content.text = kTileHeader;
  content.text += row;
  waiting_ += row.size();
}

std::size_t Tiler::finish() {
  flush();
  std::erase_if(tiles_, [&](const auto& entry) {
    if (entry.second.home > 0) return false;
    fs::remove(folder_ / fileOf(entry.first));
    return true;
  });
  addWide();
  flush();
  fs::remove(folder_ / kWideFile);
  writeText((folder_ / kListFile).string(), [&](std::ostream& out) {
    for (const auto& [place, content] : tiles_) {
      const auto at = [&](std::int64_t cell) { return static_cast<double>(cell) * size_; };
      const Box core = {at(place.second), at(place.first), at(place.second + 1), at(place.first + 1)};
      std::string line = fileOf(place);
      line.resize(line.size() - std::strlen(".csv"));
      line += ' ';
      line += std::to_string(content.home);
      appendBox(line, core);
      appendBox(line, {core.minX - halo_, core.minY - halo_, core.maxX + halo_, core.maxY + halo_});
      out << line << '\n';
    }
  });
  return tiles_.size();
}

/// Puts each wide circle into those of its tiles that exist.
void Tiler::addWide() {
  if (!wide_.isBegun) return;
  const std::string file = (folder_ / kWideFile).string();
  TileStream stream(file, {.weights = true});  // all circles here were validated before
  readPieces(file, [&](std::string_view piece, double) {
    const auto read = stream.read(piece);
    if (!read) throw CommandError{kFailure, read.error().message};
    const Tile& tile = read.value();
    for (std::size_t i = 0; i < tile.circles.size(); ++i) {
      const std::string row = rowOf(tile, i);
      const Range range = rangeOf(tile.circles[i]);
      auto at = tiles_.lower_bound(range.first);
      while (at != tiles_.end() && at->first <= range.last) {
        const auto [y, x] = at->first;
        if (x < range.first.second) {
          at = tiles_.lower_bound({y, range.first.second});
        } else if (x > range.last.second) {
          at = tiles_.lower_bound({y + 1, range.first.second});
        } else {
          put(at->second, row);
          ++at;
        }
      }
    }
    if (waiting_ > kMostWaiting) flush();
  });
}

void Tiler::flush() {
  const auto write = [&](Content& content, const std::string& file) {
    if (content.text.empty()) return;
    append(file, content.text);
    content.isBegun = true;
    content.text = std::string();  // frees the memory, too
  };
  for (auto& [place, content] : tiles_) write(content, fileOf(place));
  write(wide_, kWideFile);
  waiting_ = 0;
}

void Tiler::append(const std::string& file, const std::string& text) const {
  std::ofstream out(folder_ / file, std::ios::app | std::ios::binary);
  out << text << std::flush;
  if (!out) throw cannotWrite(folder_ / file);
}

std::string Tiler::fileOf(TileIndex place) const {
  std::string name = "x";
  name += std::to_string(place.second);
  name += 'y';
  name += std::to_string(place.first);
  return name += ".csv";
}

}  // namespace circle_voronoi::cli
