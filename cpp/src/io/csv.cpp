// SPDX-License-Identifier: GPL-3.0-or-later
#include "csv.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <system_error>
#include <vector>

#include "column_names.h"
#include "csv_table.h"
#include "read_double.h"
#include "text.h"
#include "validate.h"
#include "wkt_points.h"

namespace circle_voronoi {
namespace {

using Fields = std::span<const CsvField>;
using Names = std::vector<std::string_view>;

/// The names of a tile's columns of ids.
const Names kTileIds = {"id", "fid"};
const Names kDoneNames = {"done"};

/// The separators in the order in which they are tried, because a comma may be a decimal mark, and a tab or a space may
/// occur beside a separator.
constexpr std::string_view kSeparators = ";\t|, ";
constexpr char kDefaultSeparator = ',';

std::string nameOfSeparator(char separator) {
  switch (separator) {
    case ';':
      return "semicolons";
    case '\t':
      return "tabs";
    case '|':
      return "vertical bars";
    case ',':
      return "commas";
    default:
      return "spaces";
  }
}

bool isOneOf(const Names& names, std::string_view text) {
  return std::ranges::any_of(names, [&](std::string_view name) { return isSameName(text, name); });
}

/// Returns the fields without the empty ones at the end.
Fields filled(Fields fields) {
  while (!fields.empty() && fields.back().text.empty()) fields = fields.first(fields.size() - 1);
  return fields;
}

/// Quotes a field in its problem.
std::string quoting(const std::string& problem, const CsvField& field) {
  return problem + ": \"" + std::string(field.text) + "\".";
}

bool isNumber(const CsvField& field, char separator) {
  double value = 0;
  return !CsvNumberReader(separator).read(field, value);
}

/// The columns of x, y and r.
struct Columns {
  std::array<std::size_t, ColumnNames::kCount> places;  ///< see CsvLayout::columns
  std::optional<std::size_t> points;
  bool areNamed;  ///< whether the first record is a header
};

/// A column of points as well-known text.
struct PointColumn {
  std::size_t place;
  bool isInFirstRecord;  ///< whether there is no header
};

/// With the wrong separator no field is a point, so that the first records are searched with all separators before the
/// rest.
constexpr std::size_t kFewRecords = 100;
constexpr std::size_t kAllRecords = std::numeric_limits<std::size_t>::max();

/// Returns the column of the first field in the first records of a table that is a point; nothing if no field is one.
std::optional<PointColumn> pointColumn(CsvTable table, std::size_t records = kAllRecords) {
  const std::size_t width = table.fields().size();
  const auto placeIn = [&]() -> std::optional<std::size_t> {
    std::optional<std::size_t> found;
    for (std::size_t k = 0; k < std::min(width, table.fields().size()); ++k) {
      if (!wktPoints(textOf(table.fields()[k]))) continue;
      if (found) {
        throw ReadError{table.offset(), "there are two columns of points, #" + std::to_string(*found + 1) + " and #" +
                                            std::to_string(k + 1) + "; leave one out."};
      }
      found = k;
    }
    return found;
  };
  // Quotation marks may mean something else with another separator.
  const auto next = [&] {
    try {
      return table.next();
    } catch (const ReadError&) {
      return false;
    }
  };
  std::size_t count = 0;
  do {
    if (const auto place = placeIn()) return PointColumn{*place, count == 0};
  } while (++count < records && next());
  return std::nullopt;
}

/// Takes column k for a number. Throws ReadError if the number has a column.
void takeColumn(Columns& columns, const CsvTable& table, std::size_t number, std::size_t k) {
  std::size_t& place = columns.places[number];
  if (place != kNoColumn) {
    throw ReadError{.offset = table.offset(),
                    .reason = "the columns " + textOf(table.fields()[place]) + " and " + textOf(table.fields()[k]) +
                              " both mean " + ColumnNames::plain(number),
                    .advice = ColumnNames::advice("; choose one by ", number)};
  }
  place = k;
}

/// The columns that a header names or whose numbers are given; nothing if some that are needed are neither.
std::optional<Columns> columnsOf(const CsvTable& table, const ColumnNames& names) {
  const Fields fields = table.fields();
  Columns columns{};
  columns.places.fill(kNoColumn);
  bool areNumbers = false;
  for (std::size_t number = 0; number < columns.places.size(); ++number) {
    std::size_t& place = columns.places[number];
    for (std::size_t k = 0; k < fields.size(); ++k) {
      if (!names.means(number, textOf(fields[k]))) continue;
      takeColumn(columns, table, number, k);
      columns.areNamed = true;
    }
    if (place == kNoColumn) {
      const auto numbered = names.columnNumber(number);
      if (numbered && *numbered <= fields.size()) {
        place = *numbered - 1;
        areNumbers = areNumbers || isNumber(fields[place], table.separator());
      } else if (names.isNeeded(number)) {
        return std::nullopt;
      }
    }
  }
  columns.areNamed = columns.areNamed || !areNumbers;
  return columns;
}

/// The columns of points as well-known text in the first records and of r, for a table without columns of x and y.
std::optional<Columns> columnsWithPoints(const CsvTable& table, const ColumnNames& names, std::size_t records) {
  const auto points = pointColumn(table, records);
  if (!points) return std::nullopt;
  Columns columns{};
  columns.places.fill(kNoColumn);
  columns.points = points->place;
  columns.areNamed = !points->isInFirstRecord;
  constexpr std::size_t kRadius = ColumnNames::kRadius;
  const Fields fields = table.fields();
  for (std::size_t k = 0; columns.areNamed && k < fields.size(); ++k) {
    if (names.means(kRadius, textOf(fields[k]))) takeColumn(columns, table, kRadius, k);
  }
  std::size_t& radius = columns.places[kRadius];
  const auto numbered = names.columnNumber(kRadius);
  if (radius == kNoColumn && numbered && *numbered <= fields.size()) radius = *numbered - 1;
  return radius == kNoColumn && names.isNeeded(kRadius) ? std::nullopt : std::optional(columns);
}

/// Returns whether the first record is a circle: x, y and r, or x and y if no radius is needed.
bool isCircle(const CsvTable& table, const ColumnNames& names) {
  const Fields fields = filled(table.fields());
  const bool isPoint = fields.size() == 2 && !names.isNeeded(ColumnNames::kRadius);
  return (fields.size() == 3 || isPoint) &&
         std::ranges::all_of(fields, [&](const CsvField& field) { return isNumber(field, table.separator()); });
}

std::string numbersExpected(char separator, bool hasRadius = true) {
  return std::string("expected ") + (hasRadius ? "three numbers x,y,r" : "two numbers x,y") + " separated by " +
         nameOfSeparator(separator) + ".";
}

/// "name, lat, lon"
std::string listOfFields(Fields fields) {
  std::string list;
  for (const CsvField& field : fields) list += (list.empty() ? "" : ", ") + textOf(field);
  return list;
}

/// Returns whether the record after a header has a number beside x, y and the id.
bool hasOtherNumbers(CsvTable table, const ColumnNames& names) {
  std::vector<std::string> header;
  for (const CsvField& field : table.fields()) header.push_back(textOf(field));
  if (!table.next()) return true;
  for (std::size_t k = 0; k < std::min(header.size(), table.fields().size()); ++k) {
    const bool isKnown = names.means(0, header[k]) || names.means(1, header[k]) || names.isId(header[k]);
    if (!isKnown && isNumber(table.fields()[k], table.separator())) return true;
  }
  return false;
}

/// Returns the reason why the first record is neither a header nor a circle. In a tile it does not depend on later
/// records, which a stream may not have yet.
ReadError problemOf(const CsvTable& table, const ColumnNames& names, bool isOfTile) {
  const auto problem = [&](std::string reason, OptionAdvice advice = {}) {
    return ReadError{.offset = table.offset(), .reason = std::move(reason), .advice = std::move(advice)};
  };
  const Fields fields = filled(table.fields());
  const auto isANumber = [&](const CsvField& field) { return isNumber(field, table.separator()); };
  const auto points = isOfTile || names.isGiven(0) || names.isGiven(1) ? std::nullopt : pointColumn(table);
  if (points && points->isInFirstRecord) {
    return names.withoutRadius(problem("the points have no radius"));
  }
  if ((points || fields.size() > 1) && std::ranges::none_of(fields, isANumber)) {
    for (std::size_t number = points ? ColumnNames::kRadius : 0; number < ColumnNames::kCount; ++number) {
      if (std::ranges::none_of(fields, [&](const CsvField& field) { return names.means(number, field.text); })) {
        ReadError failure = problem("no column is called " + names.listOf(number) + ", only " + listOfFields(fields));
        if (number == ColumnNames::kRadius && !isOfTile && !hasOtherNumbers(table, names)) {
          return names.withoutRadius(std::move(failure));
        }
        failure.advice = ColumnNames::advice("; name one by ", number);
        return failure;
      }
    }
  }
  if (const std::string missing = names.missing(fields.size()); !missing.empty()) {
    return problem("no column is called " + missing +
                   "; the first line has no names, but columns are also called #1 to #" +
                   std::to_string(fields.size()) + ".");
  }
  if (fields.size() > 3 || names.areGiven()) {
    return problem("there are " + std::to_string(fields.size()) +
                   " columns; a header has to name x, y and r, or options as #1, #2 and #3.");
  }
  if (fields.size() < 3) {
    std::string reason = numbersExpected(table.separator());
    const bool arePoints = fields.size() == 2 && std::ranges::all_of(fields, isANumber);
    if (!arePoints) return problem(std::move(reason));
    reason.pop_back();  // the full stop
    return names.withoutRadius(problem(std::move(reason)));
  }
  double value = 0;
  CsvNumberReader reader(table.separator());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (const auto reason = reader.read(fields[i], value)) return problem(ColumnNames::plain(i) + *reason);
  }
  return problem("");
}

/// The column of one of the names, if there is one.
template <class IsName>
std::optional<std::size_t> columnNamed(const CsvTable& table, IsName isName) {
  const Fields fields = table.fields();
  const auto found = std::ranges::find_if(fields, [&](const CsvField& field) { return isName(field.text); });
  if (found == fields.end()) return std::nullopt;
  return static_cast<std::size_t>(found - fields.begin());
}

CsvLayout layoutFrom(const CsvTable& table, const std::optional<Columns>& columns, const ColumnNames& names,
                     bool isOfTile) {
  CsvLayout layout;
  layout.separator = table.separator();
  if (!columns) {
    layout.width = filled(table.fields()).size();
    if (names.hasNoRadii() || layout.width < 3) layout.columns[ColumnNames::kRadius] = kNoColumn;
    return layout;
  }
  layout.hasHeader = columns->areNamed;
  layout.mayBeShort = true;
  layout.width = table.fields().size();
  layout.columns = columns->places;
  layout.points = columns->points;
  if (layout.points) layout.names[0] = nameOfColumn(table, *layout.points, layout.hasHeader);
  if (const auto id = names.columnOfId(); id && *id <= layout.width) {
    layout.id = *id - 1;
    layout.idName = nameOfColumn(table, *layout.id, layout.hasHeader);
  }
  if (!layout.hasHeader) {
    if (names.hasId() && !layout.id) {
      throw ReadError{table.offset(), "no column is called " + names.id() + "; the first line has no names."};
    }
    return layout;
  }
  for (std::size_t k = 0; k < layout.names.size(); ++k) {
    if (layout.columns[k] != kNoColumn) layout.names[k] = textOf(table.fields()[layout.columns[k]]);
  }
  const auto id = columnNamed(table, [&](std::string_view name) {
    return isOfTile && !names.hasId() ? isOneOf(kTileIds, name) : names.isId(name);
  });
  if (id) layout.id = id;
  if (names.hasId() && !layout.id) {
    throw ReadError{table.offset(),
                    "no column is called " + names.id() + ", only " + listOfFields(filled(table.fields())) + "."};
  }
  if (layout.id) layout.idName = nameOfColumn(table, *layout.id, true);
  layout.done = columnNamed(table, [](std::string_view name) { return isOneOf(kDoneNames, name); });
  return layout;
}

/// The separators that a text may have: the one that it names, or all.
std::string separatorsOf(std::string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  const char named = begin == text.npos ? '\0' : separatorIn(text.substr(begin));
  if (named == 0) return std::string(kSeparators);
  if (kSeparators.find(named) != kSeparators.npos) return {named};
  throw ReadError{begin, std::string("sep=") + named +
                             " is not a separator; use commas, semicolons, tabs, vertical bars or spaces."};
}

/// Returns the layout that `layout` finds with the first record and the first separator for which there is one; nothing
/// if there is no record. Throws ReadError `problem`, with the widest first record, if no separator gives a layout.
template <class Layout, class Problem>
std::optional<CsvLayout> layoutBySeparator(std::string_view text, bool isWhole, Layout layout, Problem problem) {
  std::optional<ReadError> failure;
  std::optional<CsvTable> widest;
  for (const char separator : separatorsOf(text)) {
    CsvTable table(text, separator, isWhole);
    try {
      if (!table.next()) return std::nullopt;
    } catch (const ReadError& reason) {  // quotation marks mean something else with another separator
      if (!failure) failure = reason;
      continue;
    }
    if (auto found = layout(table)) return found;
    const std::size_t width = filled(table.fields()).size();
    const std::size_t widestWidth = widest ? filled(widest->fields()).size() : 0;
    if (width > widestWidth || (width == widestWidth && separator == kDefaultSeparator)) widest = table;
  }
  if (!widest) throw *failure;
  throw problem(*widest);
}

/// Returns the number of fields of a row. Throws ReadError if it does not fit the layout.
std::size_t countOfFields(const CsvTable& table, const CsvLayout& layout) {
  const Fields fields = table.fields();
  const std::size_t width = layout.width;
  const std::size_t count = fields.size() > width ? filled(fields).size() : fields.size();
  if (layout.mayBeShort ? count <= width : count == width) return count;
  throw ReadError{table.offset(), layout.mayBeShort ? "there are " + std::to_string(count) + " fields in " +
                                                          std::to_string(width) + " columns."
                                                    : numbersExpected(layout.separator, width > 2)};
}

/// Reads a whole number from 0 up to `most` into `value`; returns the problem if the field is not one.
std::optional<std::string> readCount(const CsvField& field, std::int64_t most, std::int64_t& value) {
  const char* end = field.text.data() + field.text.size();
  const auto [stop, code] = std::from_chars(field.text.data(), end, value);
  if (!field.text.empty() && stop == end && code == std::errc() && value >= 0 && value <= most) return std::nullopt;
  return quoting(" is no whole number from 0 to " + std::to_string(most), field);
}

}  // namespace

std::optional<CsvLayout> layoutOf(std::string_view text, const ReadOptions& options, bool isWhole, bool isOfTile) {
  const ColumnNames names(options);
  const auto layout = [&](const CsvTable& table) -> std::optional<CsvLayout> {
    const auto columns = columnsOf(table, names);
    if (!columns && (names.areGiven() || !isCircle(table, names))) return std::nullopt;
    return layoutFrom(table, columns, names, isOfTile);
  };
  try {
    return layoutBySeparator(text, isWhole, layout,
                             [&](const CsvTable& table) { return problemOf(table, names, isOfTile); });
  } catch (const ReadError&) {
    if (isOfTile || names.isGiven(0) || names.isGiven(1)) throw;
    for (const std::size_t records : {kFewRecords, kAllRecords}) {
      for (const char separator : separatorsOf(text)) {
        CsvTable table(text, separator);
        try {
          (void)table.next();
        } catch (const ReadError&) {
          continue;
        }
        const auto columns = columnsWithPoints(table, names, records);
        if (columns) return layoutFrom(table, columns, names, isOfTile);
      }
    }
    throw;
  }
}

ParsedRows readCsvRows(std::string_view text, std::span<const std::string> columns) {
  const auto missingIn = [&](const CsvTable& table) {
    return std::ranges::find_if(columns, [&](const std::string& column) {
      return std::ranges::none_of(table.fields(),
                                  [&](const CsvField& field) { return isNameOfColumn(textOf(field), column); });
    });
  };
  const auto layoutWith = [&](const CsvTable& table) -> std::optional<CsvLayout> {
    if (missingIn(table) != columns.end()) return std::nullopt;
    CsvLayout layout;
    layout.separator = table.separator();
    layout.hasHeader = true;
    layout.mayBeShort = true;
    layout.width = table.fields().size();
    layout.columns.fill(kNoColumn);
    return layout;
  };
  const auto layout = layoutBySeparator(text, true, layoutWith, [&](const CsvTable& table) {
    return ReadError{table.offset(), "no column is called " + *missingIn(table) + ", only " +
                                         listOfFields(filled(table.fields())) + "."};
  });
  if (!layout) throw ReadError{0, "the text is empty but for comments."};
  ParsedRows rows;
  CsvTable table(text, layout->separator);
  (void)table.next();
  while (table.next()) {
    (void)countOfFields(table, *layout);
    rows.offsets.push_back(table.offset());
  }
  rows.properties = attributesOf(text, *layout, 0, {}).properties;
  return rows;
}

std::optional<std::string> CsvNumberReader::read(const CsvField& field, double& value) {
  std::string_view digits = field.text;
  if (digits.empty()) return " is empty.";
  // readDouble knows no leading plus.
  const bool hasPlus = digits.size() > 1 && digits[0] == '+' && digits[1] != '-';
  if (hasPlus) digits.remove_prefix(1);
  const std::size_t mark = digits.find_first_of(".,");
  std::string withPoint;
  if (mark != std::string_view::npos) {
    const bool isComma = digits[mark] == ',';
    if (isComma) {
      const bool isInside = mark + 1 < digits.size() && digits[mark + 1] >= '0' && digits[mark + 1] <= '9';
      if (!isInside || !(mayBeComma_ || field.isQuoted)) return quoting(" is not a number", field);
      withPoint = digits;
      withPoint[mark] = '.';
      digits = withPoint;
    }
    if (mark_ != 0 && mark_ != field.text[mark + (hasPlus ? 1 : 0)]) {
      return quoting(" has another decimal mark than the numbers before it", field);
    }
    mark_ = isComma ? ',' : '.';
  }
  const char* end = digits.data() + digits.size();
  const auto [stop, code] = readDouble(digits.data(), end, value);
  if (stop != end || code == std::errc::invalid_argument) return quoting(" is not a number", field);
  if (code != std::errc()) return quoting(" is beyond the range of a double", field);
  return std::nullopt;
}

std::size_t CsvRowReader::read(std::string_view text, ParsedCircles& circles, bool isLast) {
  CsvTable table(text, layout_.separator, isLast);
  if (layout_.hasHeader && !isPastHeader_) (void)table.next();
  isPastHeader_ = true;
  while (table.next()) {
    const Fields fields = table.fields();
    const std::size_t count = countOfFields(table, layout_);
    const auto fieldOf = [&](std::size_t column) { return column < count ? fields[column] : CsvField{}; };
    if (!skipsInvalid_) {
      readCircle(table, fieldOf, circles);
    } else {
      try {
        readCircle(table, fieldOf, circles);
      } catch (const ReadError& failure) {
        skipped_.push_back(failure);
      }
    }
    ++next_;
  }
  return table.rest();
}

template <class FieldOf>
void CsvRowReader::readCircle(const CsvTable& table, FieldOf fieldOf, ParsedCircles& circles) {
  const auto fail = [&](std::string reason, ErrorCode code = ErrorCode::badInput) {
    if (layout_.id && !fieldOf(*layout_.id).text.empty()) {
      reason.pop_back();  // the full stop
      reason += " (circle " + std::to_string(next_) + ", " + layout_.idName + " " + textOf(fieldOf(*layout_.id)) + ").";
    }
    throw ReadError{table.offset(), std::move(reason), code, next_};
  };
  std::array<double, 3> values{};
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (layout_.columns[i] == kNoColumn) continue;
    const CsvField field = fieldOf(layout_.columns[i]);
    if (const auto problem = numbers_.read(field, values[i])) fail(layout_.names[i] + *problem);
    if (!std::isfinite(values[i])) {
      fail(layout_.names[i] + quoting(" is not a finite number", field), ErrorCode::nonFinite);
    }
  }
  const auto check = [&](const Circle& circle) {
    if (!skipsInvalid_) return;  // `validate` reports it, with the index in the whole text
    if (const auto error = errorOf(circle, weights_)) {
      fail("Circle " + std::to_string(next_) + " " + error->what, error->code);
    }
  };
  const auto add = [&](const Circle& circle) {
    circles.circles.push_back(circle);
    circles.offsets.push_back(table.offset());
  };
  if (!layout_.points) {
    const Circle circle = {values[0], values[1], values[2]};
    check(circle);
    if (isOfTile_) readNames(table, fieldOf, circles);
    return add(circle);
  }
  const CsvField field = fieldOf(*layout_.points);
  const auto points = wktPoints(textOf(field));
  if (!points) fail(layout_.names[0] + quoting(" is no POINT or MULTIPOINT", field));
  if (!points->srid.empty() && !srid_.empty() && points->srid != srid_) {
    fail("the SRID is " + points->srid + ", but that of the rows before it is " + srid_ + ".");
  }
  for (const Point& p : points->points) check({p.x, p.y, values[2]});
  if (!points->srid.empty()) srid_ = points->srid;
  for (const Point& p : points->points) add({p.x, p.y, values[2]});
}

template <class FieldOf>
void CsvRowReader::readNames(const CsvTable& table, FieldOf fieldOf, ParsedCircles& circles) {
  std::int64_t id = next_;
  std::int64_t done = 0;
  const auto read = [&](std::optional<std::size_t> column, const std::string& name, std::int64_t most,
                        std::int64_t& value) {
    if (!column) return;
    if (const auto problem = readCount(fieldOf(*column), most, value)) {
      throw ReadError{table.offset(), name + *problem, ErrorCode::badInput, next_};
    }
  };
  read(layout_.id, layout_.idName, kMostId, id);
  read(layout_.done, "done", 1, done);
  circles.ids.push_back(id);
  circles.done.push_back(done != 0);
}

namespace {

std::string withoutDoubling(std::string_view inside) {
  std::string text(inside);
  // The second one of two quotation marks is left out.
  std::size_t size = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    text[size++] = text[at];
    if (text[at] == '"') ++at;
  }
  text.resize(size);
  return text;
}

}  // namespace

std::string textOf(const CsvField& field) {
  return field.isQuoted ? withoutDoubling(field.text) : std::string(field.text);
}

std::string wholeTextOf(const CsvField& field) {
  return field.isQuoted ? withoutDoubling(field.whole()) : std::string(field.text);
}

std::string nameOfColumn(const CsvTable& table, std::size_t place, bool hasHeader) {
  const std::string name = hasHeader ? wholeTextOf(table.fields()[place]) : "";
  return name.empty() ? "column " + std::to_string(place + 1) : name;
}

Result<ParsedFile> readCsv(std::string_view text, std::string_view name, const ReadOptions& options, Keep keep) try {
  const auto layout = layoutOf(text, options);
  if (!layout) return errorAt(name, text, 0, "the text is empty but for comments.");
  ParsedFile result;
  CsvRowReader rows(*layout, options);
  rows.read(text, result.parsed);
  if (keep == Keep::attributes) result.attributes = attributesOf(text, *layout, rows.decimalMark(), rows.skipped());
  // The SRID 0 says that the reference system is unknown.
  if (rows.srid().find_first_not_of('0') != std::string::npos) result.crs = "EPSG:" + rows.srid();
  result.areDegrees = areDegrees(layout->names[0], layout->names[1]);
  result.skipped = rows.skipped();
  return result;
} catch (const ReadError& failure) {
  return errorAt(name, text, failure);
}

}  // namespace circle_voronoi
