// SPDX-License-Identifier: GPL-3.0-or-later
#include "csv_table.h"

#include <algorithm>

#include "column_names.h"
#include "text.h"

namespace circle_voronoi {

char separatorIn(std::string_view line) {
  // Most lines end here.
  if (!isSameName(line.substr(line.starts_with('"') ? 1 : 0, 4), "sep=")) return '\0';
  line = line.substr(0, line.find_first_of("\r\n"));
  const std::size_t end = line.find_last_not_of(' ');
  line = line.substr(0, end == line.npos ? 0 : end + 1);
  if (line.size() == 7 && line.front() == '"' && line.back() == '"') line = line.substr(1, 5);
  const bool isOne = line.size() == 5 && isSameName(line.substr(0, 4), "sep=");
  return isOne ? line[4] : '\0';
}

bool CsvTable::next() {
  while (!isAtEnd()) {
    begin_ = at_;
    skipBlanks();
    const bool isComment = !isAtEnd() && (text_[at_] == '#' || separatorIn(text_.substr(at_)) != 0);
    if (isComment) {
      skipLine();
    } else {
      readRecord();
    }
    if (at_ - begin_ > kLongestRecord) {
      throw ReadError{begin_, "a line is too long, or a quotation mark is not closed."};
    }
    if (!endLine()) {
      at_ = begin_;
      return false;
    }
    if (isComment) continue;
    if (std::ranges::any_of(fields_, [](const CsvField& field) { return !field.text.empty(); })) return true;
  }
  return false;
}

/// The white space around fields, but for separators.
void CsvTable::skipBlanks() {
  while (!isAtEnd() && (text_[at_] == ' ' || (text_[at_] == '\t' && separator_ != '\t'))) ++at_;
}

void CsvTable::skipLine() {
  while (!isAtLineEnd()) ++at_;
}

/// Reads past the end of a line. Returns false if the text does not show whether the line ends there.
bool CsvTable::endLine() {
  if (isAtEnd()) {
    if (isWhole_ && open_) throw ReadError{*open_, "a quotation mark is not closed."};
    return isWhole_;
  }
  // A CR at the end may be half of a line end.
  if (!isWhole_ && text_[at_] == '\r' && at_ + 1 == text_.size()) return false;
  ++at_;
  return true;
}

void CsvTable::readRecord() {
  fields_.clear();
  open_.reset();
  for (skipBlanks(); !isAtLineEnd(); skipBlanks()) {
    fields_.push_back(readField());
    if (isAtLineEnd()) return;
    if (separator_ != ' ') ++at_;
  }
  // A separator at the end is followed by an empty field, like one before another separator.
  if (separator_ != ' ') fields_.emplace_back();
}

CsvField CsvTable::readField() {
  if (text_[at_] == '"') return readQuoted();
  const std::size_t from = at_;
  std::size_t to = at_;
  for (; !isAtLineEnd() && !isSeparator(); ++at_) {
    if (text_[at_] == '\t' && separator_ == ' ') break;
    if (text_[at_] != ' ' && text_[at_] != '\t') to = at_ + 1;
  }
  return {text_.substr(from, to - from), false};
}

CsvField CsvTable::readQuoted() {
  std::size_t close = text_.find('"', at_ + 1);
  while (close != std::string_view::npos && text_.substr(close + 1, 1) == "\"") close = text_.find('"', close + 2);
  if (close == std::string_view::npos) {
    open_ = at_;
    at_ = text_.size();
    return {};
  }
  std::string_view inside = text_.substr(at_ + 1, close - at_ - 1);
  inside.remove_prefix(std::min(inside.find_first_not_of(" \t"), inside.size()));
  inside = inside.substr(0, inside.find_last_not_of(" \t") + 1);
  at_ = close + 1;
  skipBlanks();
  const bool isOver = isAtLineEnd() || isSeparator() || (separator_ == ' ' && at_ > close + 1);
  if (!isOver) throw ReadError{close, "a field goes on after its closing quotation mark."};
  return {inside, true};
}

}  // namespace circle_voronoi
