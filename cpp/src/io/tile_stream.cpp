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

class TileStream::Impl {
 public:
  Impl(std::string name, const ReadOptions& options) : name_(std::move(name)), options_(options) {}

  Result<Tile> read(std::string_view piece) {
    // Only a line end completes a record: a new one, or a CR that may have been half of one.
    const std::size_t from = rest_.empty() ? 0 : rest_.size() - 1;
    rest_ += piece;
    if (rest_.find_first_of("\r\n", from) == rest_.npos && rest_.size() <= kLongestRecord) return Tile{};
    // A long record that an earlier piece did not complete is read again only when it has become twice as long.
    if (rest_.size() < leastSize_) return Tile{};
    const std::size_t size = rest_.size();
    auto tile = readRecords(false);
    leastSize_ = rest_.size() == size && size > kShortRecord ? std::min(2 * size, kLongestRecord + 1) : 0;
    return tile;
  }

  Result<Tile> end() { return readRecords(true); }

 private:
  static constexpr std::size_t kShortRecord = 4096;

  Result<Tile> readRecords(bool isLast) {
    if (!rows_) {
      const auto isFound = readLayout(isLast);
      if (!isFound) return isFound.error();
      if (!isFound.value()) return Tile{};
    }
    ParsedCircles circles;
    std::size_t size = 0;
    std::optional<Error> failed;
    try {
      size = rows_->read(rest_, circles, isLast);
    } catch (const ReadError& reason) {
      failed = errorAt(name_, rest_, reason, linesBefore_);
    }
    // An invalid circle before the failure is reported first.
    if (const auto judged = validatePart(circles.circles, options_.weights, circlesBefore_); !judged) {
      const auto before = static_cast<std::int64_t>(circlesBefore_);
      Error error = judged.error();
      error.circle -= before;
      error = errorAtCircle(error, circles.offsets, name_, rest_, linesBefore_);
      error.circle += before;
      return error;
    }
    if (failed) return *failed;
    circlesBefore_ += circles.circles.size();
    linesBefore_ += lineEnds(std::string_view(rest_).substr(0, size));
    rest_.erase(0, size);
    return Tile{std::move(circles.circles), std::move(circles.ids), std::move(circles.done)};
  }

  /// Returns whether the text determines the layout of the table. If so, more text does not change the layout.
  Result<bool> readLayout(bool isLast) {
    const std::string_view text = withoutByteOrderMark(rest_);
    const std::string_view head = text.substr(0, kLongestRecord);
    const bool isCut = head.size() < text.size();
    const std::size_t begin = head.find_first_not_of(" \t\r\n");
    std::optional<CsvLayout> layout;
    if (begin != head.npos) {
      if (const auto content = contentOf(rest_, name_); !content) return content.error();
      if (head[begin] == '[' || head[begin] == '{') return failure("a tile has to be a table (CSV), not JSON.");
      try {
        layout = layoutOf(head, options_, isLast && !isCut, true);
      } catch (const ReadError& reason) {
        return errorAt(name_, text, reason);
      }
    }
    if (layout) {
      rest_.erase(0, rest_.size() - text.size());
      rows_.emplace(*layout, options_, true);
      return true;
    }
    if (isCut) return failure("the first 64 MiB have neither a header nor a circle.");
    if (isLast) return failure("the text is empty but for comments.");
    return false;
  }

  Error failure(const char* reason) const { return errorAt(name_, "", 0, reason); }

  std::string name_;
  ReadOptions options_;
  std::string rest_;  ///< the beginning of a record, or of the text
  std::size_t leastSize_ = 0;
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

/// Sorts the tile by id. Returns an error if two ids are equal.
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
