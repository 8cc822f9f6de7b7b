// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace circle_voronoi {

/// A field without the white space around it and without quotation marks; those inside stay doubled.
struct CsvField {
  std::string_view text;
  bool isQuoted = false;
};

/// Splits a text into records (RFC 4180), one a line but for line ends in quotation marks. Lines that are blank, hold
/// separators alone, or begin with # are passed over.
class CsvTable {
 public:
  /// A space as the separator stands for any number of spaces and tabs.
  CsvTable(std::string_view text, char separator) : text_(text), separator_(separator) {}

  /// Goes on to the next record; false if there is none. Throws ReadFailure if quotation marks are amiss.
  bool next();

  std::span<const CsvField> fields() const { return fields_; }
  /// Where the record begins in the text.
  std::size_t offset() const { return begin_; }
  char separator() const { return separator_; }

 private:
  bool isAtEnd() const { return at_ == text_.size(); }
  bool isAtLineEnd() const { return isAtEnd() || text_[at_] == '\n' || text_[at_] == '\r'; }
  bool isSeparator() const { return text_[at_] == separator_; }
  void skipBlanks();
  void skipLine();
  void readRecord();
  CsvField readField();
  CsvField readQuoted();

  std::string_view text_;
  char separator_;
  std::size_t at_ = 0;
  std::size_t begin_ = 0;
  std::vector<CsvField> fields_;
};

}  // namespace circle_voronoi
