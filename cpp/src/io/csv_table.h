// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace circle_voronoi {

/// A field without the white space around it and without quotation marks; those inside stay doubled.
struct CsvField {
  std::string_view text;
  bool isQuoted = false;

  /// The text with the white space inside the quotation marks.
  std::string_view whole() const {
    if (!isQuoted) return text;
    const auto isBlank = [](char c) { return c == ' ' || c == '\t'; };
    const char* begin = text.data();
    const char* end = begin + text.size();
    while (isBlank(begin[-1])) --begin;
    while (isBlank(*end)) ++end;
    return {begin, static_cast<std::size_t>(end - begin)};
  }
};

/// The largest size of a record or a comment, in bytes: a stream keeps a whole record in memory.
inline constexpr std::size_t kLongestRecord = std::size_t{1} << 26;

/// Returns the separator that the first line of a text names for Excel, as `sep=;`; 0 if it names none.
char separatorIn(std::string_view text);

/// Splits a text into records (RFC 4180), one a line but for line ends in quotation marks. Lines that are blank, hold
/// separators alone, name the separator, or begin with # are passed over.
class CsvTable {
 public:
  /// A space as the separator stands for any number of spaces and tabs. If the text is not whole, more text may follow.
  /// The last record is then left out as long as more text could change it.
  CsvTable(std::string_view text, char separator, bool isWhole = true)
      : text_(text), separator_(separator), isWhole_(isWhole) {}

  /// Moves to the next record. Returns false if there is none. Throws ReadError if quotation marks are not balanced or
  /// the record is too long.
  bool next();

  /// The position of the unread text. After the last record it is the end of a whole text, or the beginning of the
  /// unfinished line.
  std::size_t rest() const { return at_; }
  std::span<const CsvField> fields() const { return fields_; }
  /// The position of the record in the text.
  std::size_t offset() const { return begin_; }
  char separator() const { return separator_; }

 private:
  bool isAtEnd() const { return at_ == text_.size(); }
  bool isAtLineEnd() const { return isAtEnd() || text_[at_] == '\n' || text_[at_] == '\r'; }
  bool isSeparator() const { return text_[at_] == separator_; }
  void skipBlanks();
  void skipLine();
  bool endLine();
  void readRecord();
  CsvField readField();
  CsvField readQuoted();

  std::string_view text_;
  char separator_;
  bool isWhole_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  std::optional<std::size_t> open_;  ///< the quotation mark that the text does not close
  std::vector<CsvField> fields_;
};

}  // namespace circle_voronoi
