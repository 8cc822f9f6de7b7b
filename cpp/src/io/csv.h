// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "csv_table.h"
#include "text.h"

namespace circle_voronoi {

/// Reads numbers, whose decimal mark is a point, or a comma where that separates no fields, but not both.
class CsvNumberReader {
 public:
  explicit CsvNumberReader(char separator) : mayBeComma_(separator == ';' || separator == '\t' || separator == '|') {}

  /// Reads a number into `value`; returns the problem if the field is not one.
  std::optional<std::string> read(const CsvField& field, double& value);

  /// The decimal mark of the numbers that were read; 0 if they had none.
  char mark() const { return mark_; }
  bool mayBeComma() const { return mayBeComma_; }

 private:
  bool mayBeComma_;
  char mark_ = 0;
};

/// The index of a missing column.
inline constexpr std::size_t kNoColumn = std::numeric_limits<std::size_t>::max();

/// The layout of a table of circles.
struct CsvLayout {
  char separator = ',';
  bool hasHeader = false;
  bool mayBeShort = false;  ///< whether rows may end before the last column
  std::size_t width = 3;
  /// The columns of x, y and r; kNoColumn for r if all radii are 0, and for x and y if `points` is given.
  std::array<std::size_t, 3> columns = {0, 1, 2};
  std::optional<std::size_t> points;  ///< the column of points as well-known text
  /// The names of these columns in the header; that of `points`, if it is given, in place of x.
  std::array<std::string, 3> names = {"x", "y", "r"};
  std::optional<std::size_t> id;    ///< the column of the ids
  std::string idName;               ///< its name in the header
  std::optional<std::size_t> done;  ///< of a tile (tile.h)
};

/// Returns the layout that makes the first record a header or a circle; nothing if there is no record. See CsvTable for
/// `isWhole`: the beginning of a text has the layout of the text, or none yet. Throws ReadError.
std::optional<CsvLayout> layoutOf(std::string_view text, const ReadOptions& options, bool isWhole = true,
                                  bool isOfTile = false);

/// Reads the rows of a table, whose text may come in pieces.
class CsvRowReader {
 public:
  /// `isOfTile`: also read the columns `id`, by default the row numbers from 0, and `done`.
  explicit CsvRowReader(const CsvLayout& layout, const ReadOptions& options, bool isOfTile = false)
      : layout_(layout),
        weights_(options.weights),
        skipsInvalid_(options.skipInvalid),
        isOfTile_(isOfTile),
        numbers_(layout.separator) {}

  /// Adds the circles of a piece. Returns the offset of the rest, which the next piece must begin with. The rest is
  /// empty if this piece ends the text (`isLast`). Throws ReadError, after adding the circles before the failure.
  std::size_t read(std::string_view text, ParsedCircles& circles, bool isLast = true);

  /// The rows that were skipped, in their order.
  const std::vector<ReadError>& skipped() const { return skipped_; }
  /// The decimal mark of x, y and r; 0 if they had none.
  char decimalMark() const { return numbers_.mark(); }
  /// The number of the reference system that the points name (EWKT); empty if they name none.
  const std::string& srid() const { return srid_; }

 private:
  static constexpr std::int64_t kMostId = std::numeric_limits<std::int64_t>::max();

  template <class FieldOf>
  void readCircle(const CsvTable& table, FieldOf fieldOf, ParsedCircles& circles);
  template <class FieldOf>
  void readNames(const CsvTable& table, FieldOf fieldOf, ParsedCircles& circles);

  CsvLayout layout_;
  bool weights_;
  bool skipsInvalid_;
  bool isOfTile_;
  CsvNumberReader numbers_;
  bool isPastHeader_ = false;
  std::int64_t next_ = 0;
  std::vector<ReadError> skipped_;
  std::string srid_;
};

/// A field as text: without the doubling of quotation marks.
std::string textOf(const CsvField& field);

/// A field as text, with the white space inside its quotation marks.
std::string wholeTextOf(const CsvField& field);

/// The name of a column: "column 1" if it has none.
std::string nameOfColumn(const CsvTable& table, std::size_t place, bool hasHeader);

/// The attributes of the circles in a table's rows. `mark`: the decimal mark of x, y and r, or 0.
CircleAttributes attributesOf(std::string_view text, const CsvLayout& layout, char mark,
                              const std::vector<ReadError>& skipped);

}  // namespace circle_voronoi
