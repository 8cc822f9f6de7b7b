// SPDX-License-Identifier: GPL-3.0-or-later
#include "csv.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>
#include <string>
#include <system_error>

#include "csv_table.h"
#include "text.h"

namespace circle_voronoi {
namespace {

using Fields = std::span<const CsvField>;
using Names = std::array<std::string_view, 4>;

/// What a header may call the columns of x, y and r.
constexpr std::array<Names, 3> kNames = {
    {{"x", "cx", "lon", "longitude"}, {"y", "cy", "lat", "latitude"}, {"r", "rad", "radius"}}};

constexpr Names kIdNames = {"id", "fid"};
constexpr Names kDoneNames = {"done"};

/// The columns of x, y and r.
using Columns = std::array<std::size_t, 3>;

/// In the order in which they are tried: a comma may be a decimal mark, and a tab or a space stand beside a separator.
constexpr std::string_view kSeparators = ";\t, ";
constexpr char kDefaultSeparator = ',';

std::string nameOfSeparator(char separator) {
  switch (separator) {
    case ';':
      return "semicolons";
    case '\t':
      return "tabs";
    case ',':
      return "commas";
    default:
      return "spaces";
  }
}

bool isName(std::string_view text, std::string_view name) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c; };
  return !name.empty() && std::ranges::equal(text, name, {}, lower);
}

bool isOneOf(const Names& names, std::string_view text) {
  return std::ranges::any_of(names, [&](std::string_view name) { return isName(text, name); });
}

bool isNameOf(std::size_t number, std::string_view text) { return isOneOf(kNames[number], text); }

/// Without the empty fields at the end.
Fields filled(Fields fields) {
  while (!fields.empty() && fields.back().text.empty()) fields = fields.first(fields.size() - 1);
  return fields;
}

/// "x, cx, lon or longitude"
std::string listOfNames(std::size_t number) {
  std::string list;
  const auto& names = kNames[number];
  const auto count = static_cast<std::size_t>(std::ranges::find(names, "") - names.begin());
  for (std::size_t i = 0; i < count; ++i) {
    list += (i == 0 ? "" : i + 1 == count ? " or " : ", ") + std::string(names[i]);
  }
  return list;
}

/// What is wrong with a field, quoted.
std::string quoting(const std::string& problem, const CsvField& field) {
  return problem + ": \"" + std::string(field.text) + "\".";
}

bool isNumber(const CsvField& field, char separator) {
  double value = 0;
  return !CsvNumberReader(separator).read(field, value);
}

/// The columns that a header names; nothing if it does not name x, y and, unless these are points, r.
std::optional<Columns> columnsOf(const CsvTable& table, bool points) {
  const Fields fields = table.fields();
  Columns columns{};
  columns.fill(kNoColumn);
  for (std::size_t number = 0; number < columns.size(); ++number) {
    const auto named = [&](const CsvField& field) { return isNameOf(number, field.text); };
    const auto found = std::ranges::find_if(fields, named);
    if (found == fields.end() && number == 2 && points) break;
    if (found == fields.end()) return std::nullopt;
    columns[number] = static_cast<std::size_t>(found - fields.begin());
  }
  for (std::size_t number = 0; number < columns.size() && columns[number] != kNoColumn; ++number) {
    const Fields rest = fields.subspan(columns[number] + 1);
    const auto other = std::ranges::find_if(rest, [&](const CsvField& field) { return isNameOf(number, field.text); });
    if (other != rest.end()) {
      throw ReadFailure{table.offset(), "the columns " + std::string(fields[columns[number]].text) + " and " +
                                            std::string(other->text) + " both mean " + std::string(kNames[number][0]) +
                                            "."};
    }
  }
  return columns;
}

bool isThreeNumbers(const CsvTable& table) {
  const Fields fields = filled(table.fields());
  return fields.size() == 3 &&
         std::ranges::all_of(fields, [&](const CsvField& field) { return isNumber(field, table.separator()); });
}

std::string threeNumbersExpected(char separator) {
  return "expected three numbers x,y,r separated by " + nameOfSeparator(separator) + ".";
}

/// Why the first record is neither a header nor a circle.
std::string problemOf(const CsvTable& table) {
  const Fields fields = filled(table.fields());
  const auto isANumber = [&](const CsvField& field) { return isNumber(field, table.separator()); };
  if (fields.size() > 1 && std::ranges::none_of(fields, isANumber)) {
    for (std::size_t number = 0; number < kNames.size(); ++number) {
      if (std::ranges::none_of(fields, [&](const CsvField& field) { return isNameOf(number, field.text); })) {
        return "no column is called " + listOfNames(number) + ".";
      }
    }
  }
  if (fields.size() > 3) {
    return "there are " + std::to_string(fields.size()) + " columns; a header has to name x, y and r.";
  }
  if (fields.size() < 3) return threeNumbersExpected(table.separator());
  double value = 0;
  CsvNumberReader reader(table.separator());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (const auto problem = reader.read(fields[i], value)) return std::string(kNames[i][0]) + *problem;
  }
  return "";
}

/// The column of one of the names, if there is one.
std::optional<std::size_t> columnNamed(const Names& names, const CsvTable& table) {
  const Fields fields = table.fields();
  const auto found = std::ranges::find_if(fields, [&](const CsvField& field) { return isOneOf(names, field.text); });
  if (found == fields.end()) return std::nullopt;
  return static_cast<std::size_t>(found - fields.begin());
}

CsvLayout layoutFrom(const CsvTable& table, const std::optional<Columns>& header) {
  CsvLayout layout;
  layout.separator = table.separator();
  if (!header) return layout;
  layout.hasHeader = true;
  layout.width = table.fields().size();
  layout.columns = *header;
  layout.id = columnNamed(kIdNames, table);
  layout.done = columnNamed(kDoneNames, table);
  return layout;
}

/// What is wrong with a field as a whole number from 0 up to `most`; otherwise nothing, and `value` is set.
std::optional<std::string> readCount(const CsvField& field, std::int64_t most, std::int64_t& value) {
  const char* end = field.text.data() + field.text.size();
  const auto [stop, code] = std::from_chars(field.text.data(), end, value);
  if (!field.text.empty() && stop == end && code == std::errc() && value >= 0 && value <= most) return std::nullopt;
  return quoting(" is no whole number from 0 to " + std::to_string(most), field);
}

}  // namespace

std::optional<CsvLayout> layoutOf(std::string_view text, bool isWhole, bool points) {
  std::optional<ReadFailure> failure;
  std::optional<CsvTable> widest;
  for (const char separator : kSeparators) {
    CsvTable table(text, separator, isWhole);
    try {
      if (!table.next()) return std::nullopt;
    } catch (const ReadFailure& reason) {  // quotation marks mean something else with another separator
      if (!failure) failure = reason;
      continue;
    }
    const auto header = columnsOf(table, points);
    if (header || isThreeNumbers(table)) return layoutFrom(table, header);
    const std::size_t width = filled(table.fields()).size();
    const std::size_t widestWidth = widest ? filled(widest->fields()).size() : 0;
    if (width > widestWidth || (width == widestWidth && separator == kDefaultSeparator)) widest = table;
  }
  if (!widest) throw *failure;
  throw ReadFailure{widest->offset(), problemOf(*widest)};
}

std::optional<std::string> CsvNumberReader::read(const CsvField& field, double& value) {
  std::string_view digits = field.text;
  if (digits.empty()) return " is empty.";
  // from_chars knows no leading plus.
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
  const auto [stop, code] = std::from_chars(digits.data(), end, value);
  if (stop != end || code == std::errc::invalid_argument) return quoting(" is not a number", field);
  if (code != std::errc()) return quoting(" is beyond the range of a double", field);
  return std::nullopt;
}

std::size_t CsvRowReader::read(std::string_view text, PlacedCircles& circles, bool isLast) {
  CsvTable table(text, layout_.separator, isLast);
  if (layout_.hasHeader && !isPastHeader_) (void)table.next();
  isPastHeader_ = true;
  std::array<double, 3> values{};
  while (table.next()) {
    const Fields fields = table.fields();
    const std::size_t width = layout_.width;
    const std::size_t count = fields.size() > width ? filled(fields).size() : fields.size();
    const bool isRow = layout_.hasHeader ? count <= width : count == width;
    if (!isRow) {
      throw ReadFailure{table.offset(), layout_.hasHeader ? "there are " + std::to_string(count) + " fields in " +
                                                                std::to_string(width) + " columns."
                                                          : threeNumbersExpected(layout_.separator)};
    }
    const auto fieldOf = [&](std::size_t column) { return column < count ? fields[column] : CsvField{}; };
    for (std::size_t i = 0; i < values.size() && layout_.columns[i] != kNoColumn; ++i) {
      if (const auto problem = numbers_.read(fieldOf(layout_.columns[i]), values[i])) {
        throw ReadFailure{table.offset(), std::string(kNames[i][0]) + *problem};
      }
    }
    if (isOfTile_) readNames(table, fieldOf, circles);
    circles.circles.push_back({values[0], values[1], values[2]});
    circles.offsets.push_back(table.offset());
  }
  return table.rest();
}

template <class FieldOf>
void CsvRowReader::readNames(const CsvTable& table, FieldOf fieldOf, PlacedCircles& circles) {
  std::int64_t id = next_++;
  std::int64_t done = 0;
  const auto read = [&](std::optional<std::size_t> column, const Names& names, std::int64_t most, std::int64_t& value) {
    if (!column) return;
    if (const auto problem = readCount(fieldOf(*column), most, value)) {
      throw ReadFailure{table.offset(), std::string(names[0]) + *problem};
    }
  };
  read(layout_.id, kIdNames, kMostId, id);
  read(layout_.done, kDoneNames, 1, done);
  circles.ids.push_back(id);
  circles.done.push_back(done != 0);
}

Result<PlacedCircles> readCsv(std::string_view text, std::string_view name, bool points) try {
  const auto layout = layoutOf(text, true, points);
  if (!layout) return errorAt(name, text, 0, "the text is empty but for comments.");
  PlacedCircles circles;
  CsvRowReader(*layout).read(text, circles);
  return circles;
} catch (const ReadFailure& failure) {
  return errorAt(name, text, failure.offset, failure.reason);
}

}  // namespace circle_voronoi
