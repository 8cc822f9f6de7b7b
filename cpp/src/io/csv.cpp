// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
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

/// The columns of x, y and r.
using Columns = std::array<std::size_t, 3>;
constexpr Columns kFirstThree = {0, 1, 2};

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

bool isNameOf(std::size_t number, std::string_view text) {
  return std::ranges::any_of(kNames[number], [&](std::string_view name) { return isName(text, name); });
}

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

/// Reads numbers, whose decimal mark is a point, or a comma where that separates no fields, but not both.
class NumberReader {
 public:
  explicit NumberReader(char separator) : mayBeComma_(separator == ';' || separator == '\t') {}

  /// What is wrong with a field as a number; otherwise nothing, and `value` is set.
  std::optional<std::string> read(const CsvField& field, double& value) {
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

 private:
  static std::string quoting(const std::string& problem, const CsvField& field) {
    return problem + ": \"" + std::string(field.text) + "\".";
  }

  bool mayBeComma_;
  char mark_ = 0;  ///< of the numbers so far; 0: they had none
};

bool isNumber(const CsvField& field, char separator) {
  double value = 0;
  return !NumberReader(separator).read(field, value);
}

/// The columns that a header names; nothing if it does not name all three.
std::optional<Columns> columnsOf(const CsvTable& table) {
  const Fields fields = table.fields();
  Columns columns{};
  for (std::size_t number = 0; number < columns.size(); ++number) {
    const auto named = [&](const CsvField& field) { return isNameOf(number, field.text); };
    const auto found = std::ranges::find_if(fields, named);
    if (found == fields.end()) return std::nullopt;
    columns[number] = static_cast<std::size_t>(found - fields.begin());
  }
  for (std::size_t number = 0; number < columns.size(); ++number) {
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
  NumberReader reader(table.separator());
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (const auto problem = reader.read(fields[i], value)) return std::string(kNames[i][0]) + *problem;
  }
  return "";
}

struct Layout {
  char separator = kDefaultSeparator;
  std::optional<Columns> header;
};

/// The separator with which the first record is a header or a circle.
std::optional<Layout> layoutOf(std::string_view text) {
  std::optional<ReadFailure> failure;
  std::optional<CsvTable> widest;
  for (const char separator : kSeparators) {
    CsvTable table(text, separator);
    try {
      if (!table.next()) return std::nullopt;
    } catch (const ReadFailure& reason) {  // quotation marks mean something else with another separator
      if (!failure) failure = reason;
      continue;
    }
    const auto header = columnsOf(table);
    if (header || isThreeNumbers(table)) return Layout{separator, header};
    const std::size_t width = filled(table.fields()).size();
    const std::size_t widestWidth = widest ? filled(widest->fields()).size() : 0;
    if (width > widestWidth || (width == widestWidth && separator == kDefaultSeparator)) widest = table;
  }
  if (!widest) throw *failure;
  throw ReadFailure{widest->offset(), problemOf(*widest)};
}

PlacedCircles readTable(std::string_view text, const Layout& layout) {
  PlacedCircles result;
  CsvTable table(text, layout.separator);
  NumberReader reader(layout.separator);
  const Columns columns = layout.header.value_or(kFirstThree);
  std::size_t width = columns.size();
  if (layout.header) {
    (void)table.next();
    width = table.fields().size();
  }
  std::array<double, 3> values{};
  while (table.next()) {
    const Fields fields = table.fields();
    const std::size_t count = fields.size() > width ? filled(fields).size() : fields.size();
    const bool isRow = layout.header ? count <= width : count == width;
    if (!isRow) {
      throw ReadFailure{table.offset(), layout.header ? "there are " + std::to_string(count) + " fields in " +
                                                            std::to_string(width) + " columns."
                                                      : threeNumbersExpected(layout.separator)};
    }
    for (std::size_t i = 0; i < columns.size(); ++i) {
      const CsvField field = columns[i] < count ? fields[columns[i]] : CsvField{};
      if (const auto problem = reader.read(field, values[i])) {
        throw ReadFailure{table.offset(), std::string(kNames[i][0]) + *problem};
      }
    }
    result.circles.push_back({values[0], values[1], values[2]});
    result.offsets.push_back(table.offset());
  }
  return result;
}

}  // namespace

Result<PlacedCircles> readCsv(std::string_view text, std::string_view name) try {
  const auto layout = layoutOf(text);
  if (!layout) return errorAt(name, text, 0, "the text is empty but for comments.");
  return readTable(text, *layout);
} catch (const ReadFailure& failure) {
  return errorAt(name, text, failure.offset, failure.reason);
}

}  // namespace circle_voronoi
