// SPDX-License-Identifier: GPL-3.0-or-later
#include "csv_table.h"

#include <algorithm>

#include "text.h"

namespace circle_voronoi {

bool CsvTable::next() {
  while (!isAtEnd()) {
    begin_ = at_;
    skipBlanks();
    if (!isAtEnd() && text_[at_] == '#') {
      skipLine();
      continue;
    }
    readRecord();
    if (!isAtEnd()) ++at_;  // the line end
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
  if (!isAtEnd()) ++at_;
}

void CsvTable::readRecord() {
  fields_.clear();
  for (skipBlanks(); !isAtLineEnd(); skipBlanks()) {
    fields_.push_back(readField());
    if (isAtLineEnd()) return;
    if (separator_ != ' ') ++at_;
  }
  // What follows the last separator is an empty field, as where one precedes another.
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
  if (close == std::string_view::npos) throw ReadFailure{at_, "a quotation mark is not closed."};
  std::string_view inside = text_.substr(at_ + 1, close - at_ - 1);
  inside.remove_prefix(std::min(inside.find_first_not_of(" \t"), inside.size()));
  inside = inside.substr(0, inside.find_last_not_of(" \t") + 1);
  at_ = close + 1;
  skipBlanks();
  const bool isOver = isAtLineEnd() || isSeparator() || (separator_ == ' ' && at_ > close + 1);
  if (!isOver) throw ReadFailure{close, "a field goes on after its closing quotation mark."};
  return {inside, true};
}

}  // namespace circle_voronoi
