// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numeric>
#include <optional>
#include <utility>

#include "circle_voronoi/tile.h"
#include "csv.h"
#include "guarded.h"
#include "utf8.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

/// Where the last line of a text ends that is whole and in which no quotation mark is open; 0 if there is none.
std::size_t wholeLines(std::string_view text) {
  // A CR at the end may be half of a line end.
  std::size_t end = text.ends_with('\r') ? text.size() - 1 : text.size();
  while (end > 0) {
    const std::size_t last = text.find_last_of("\r\n", end - 1);
    if (last == text.npos) return 0;
    const std::string_view lines = text.substr(0, last + 1);
    if (std::ranges::count(lines, '"') % 2 == 0) return lines.size();
    end = lines.rfind('"');
  }
  return 0;
}

/// Whether a text has nothing but a byte-order mark and blanks.
bool isBlankText(std::string_view text) {
  return withoutByteOrderMark(text).find_first_not_of(" \t\r\n") == std::string_view::npos;
}

}  // namespace

class TileStream::Impl {
 public:
  Impl(std::string name, const ReadOptions& options) : name_(std::move(name)), options_(options) {}

  Result<Tile> read(std::string_view piece) {
    rest_ += piece;
    const std::size_t size = wholeLines(rest_);
    // What tells of the encoding stands in the first bytes, so a blank beginning waits for more.
    const bool isBlank = !isBegun_ && isBlankText(std::string_view(rest_).substr(0, size));
    if ((size == 0 || isBlank) && !isOverLong()) return Tile{};
    auto tile = readLines(std::string_view(rest_).substr(0, size));
    rest_.erase(0, size);
    return tile;
  }

  Result<Tile> end() {
    auto tile = readLines(rest_);
    if (tile && !rows_) return errorAt(name_, "", 0, "the text is empty but for comments.");
    return tile;
  }

 private:
  /// Whether what there is cannot be the beginning of a line.
  bool isOverLong() const { return rest_.size() > (std::size_t{1} << 26); }

  Result<Tile> readLines(std::string_view text) {
    if (isOverLong() && text.empty())
      return errorAt(name_, "", 0, "a line is too long, or a quotation mark is not closed.", linesBefore_);
    if (!isBegun_ && !text.empty()) {
      const auto content = contentOf(text, name_);
      if (!content && !isBlankText(text)) return content.error();
      if (content) {
        text = content.value();
        const char begin = text[text.find_first_not_of(" \t\r\n")];
        if (begin == '[' || begin == '{') return errorAt(name_, "", 0, "a tile has to be a table (CSV), not JSON.");
        isBegun_ = true;
      }
    }
    PlacedCircles circles;
    try {
      if (!rows_) {
        const auto layout = layoutOf(text);
        if (layout) rows_.emplace(*layout, true);
      }
      if (rows_) rows_->read(text, circles);
    } catch (const ReadFailure& failure) {
      return errorAt(name_, text, failure.offset, failure.reason, linesBefore_);
    }
    if (const auto judged = validate(circles.circles, options_.weights, circlesBefore_); !judged) {
      const auto before = static_cast<std::int64_t>(circlesBefore_);
      Error error = judged.error();
      error.circle -= before;
      error = placed(error, circles.offsets, name_, text, linesBefore_);
      error.circle += before;
      return error;
    }
    circlesBefore_ += circles.circles.size();
    linesBefore_ += lineEnds(text);
    return Tile{std::move(circles.circles), std::move(circles.ids), std::move(circles.done)};
  }

  std::string name_;
  ReadOptions options_;
  std::string rest_;  ///< the beginning of a line
  bool isBegun_ = false;
  std::size_t linesBefore_ = 0;
  std::size_t circlesBefore_ = 0;
  std::optional<CsvRowReader> rows_;
};

TileStream::TileStream(std::string name, const ReadOptions& options)
    : impl_(std::make_unique<Impl>(std::move(name), options)) {}
TileStream::TileStream(TileStream&&) noexcept = default;
TileStream& TileStream::operator=(TileStream&&) noexcept = default;
TileStream::~TileStream() = default;

Result<Tile> TileStream::read(std::string_view piece) {
  return guarded([&] { return impl_->read(piece); });
}

Result<Tile> TileStream::end() {
  return guarded([&] { return impl_->end(); });
}

namespace {

/// The tile in the order of its ids; an error if two are equal.
Result<Tile> ordered(Tile tile, std::string_view name) {
  const auto& ids = tile.ids;
  const auto isRising = [&](auto less) { return std::ranges::adjacent_find(ids, less) == ids.end(); };
  if (isRising(std::ranges::greater_equal{})) return tile;
  std::vector<std::size_t> order(ids.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return ids[i]; });
  Tile result;
  for (const std::size_t i : order) {
    if (!result.ids.empty() && result.ids.back() == ids[i]) {
      return Error{ErrorCode::badInput, -1,
                   std::string(name) + ": the id " + std::to_string(ids[i]) + " is given twice."};
    }
    result.circles.push_back(tile.circles[i]);
    result.ids.push_back(ids[i]);
    result.done.push_back(tile.done[i]);
  }
  return result;
}

}  // namespace

Result<Tile> readTile(std::string_view text, std::string_view name, const ReadOptions& options) {
  return guarded([&]() -> Result<Tile> {
    TileStream stream(std::string(name), options);
    auto tile = stream.read(text);
    if (!tile) return tile;
    auto last = stream.end();
    if (!last) return last;
    Tile all = std::move(tile).value();
    const Tile& rest = last.value();
    all.circles.insert(all.circles.end(), rest.circles.begin(), rest.circles.end());
    all.ids.insert(all.ids.end(), rest.ids.begin(), rest.ids.end());
    all.done.insert(all.done.end(), rest.done.begin(), rest.done.end());
    return ordered(std::move(all), name);
  });
}

}  // namespace circle_voronoi
