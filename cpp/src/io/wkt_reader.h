// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>
#include <system_error>

#include "read_double.h"
#include "text.h"

namespace circle_voronoi {

/// Reads well-known text (WKT), or that of PostGIS (EWKT), from front to back. The caller asks for each part in turn.
/// Throws ReadError.
class WktReader {
 public:
  explicit WktReader(std::string_view text) : text_(text) {}

  /// The beginning of a geometry.
  struct Head {
    std::string type;  ///< in capitals, without Z and M
    bool hasHeight = false;
    bool isEmpty = false;
  };

  /// Reads `SRID=4326;`, if it comes next. Returns the number of the reference system in its digits; empty if there is
  /// none.
  std::string srid() {
    const std::size_t begin = at_;
    if (nextWord() != "SRID" || !accepts('=')) {
      at_ = begin;
      return "";
    }
    skipSpace();
    const std::size_t end = std::min(text_.find_first_not_of("0123456789", at_), text_.size());
    std::string digits(text_.substr(at_, end - at_));
    at_ = end;
    if (digits.empty()) fail("expected a number after SRID.");
    if (!accepts(';')) fail("expected ; after SRID.");
    return digits;
  }

  Head head() {
    Head head = {.type = nextWord()};
    std::string dimensions;
    // PostGIS writes POINTZ, others POINT Z.
    for (const std::string_view ending : {"ZM", "Z", "M"}) {
      if (!head.type.ends_with(ending)) continue;
      dimensions = ending;
      head.type.resize(head.type.size() - ending.size());
      break;
    }
    std::string next = nextWord();
    if (dimensions.empty() && (next == "Z" || next == "M" || next == "ZM")) {
      dimensions = next;
      next = nextWord();
    }
    head.hasHeight = dimensions != "M";
    head.isEmpty = next == "EMPTY";
    if (!next.empty() && !head.isEmpty) fail("expected an opening parenthesis.");
    return head;
  }

  /// Reads a list in parentheses, or EMPTY: `readItem()` reads each item.
  template <class ReadItem>
  void readList(ReadItem readItem) {
    if (isEmptyNext()) return;
    if (!accepts('(')) fail("expected an opening parenthesis.");
    do {
      readItem();
    } while (accepts(','));
    if (!accepts(')')) fail("expected a comma or a closing parenthesis.");
  }

  /// Reads EMPTY, if it comes next.
  bool isEmptyNext() {
    const std::size_t begin = at_;
    if (nextWord() == "EMPTY") return true;
    at_ = begin;
    return false;
  }

  double number() {
    skipSpace();
    if (at_ < text_.size() && text_[at_] == '+') ++at_;
    double value = 0;
    const char* begin = text_.data() + at_;
    const auto [end, code] = readDouble(begin, text_.data() + text_.size(), value);
    if (code != std::errc()) fail("expected a number.");
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  /// Returns whether a position in a list goes on.
  bool hasNumber() {
    skipSpace();
    return at_ < text_.size() && text_[at_] != ',' && text_[at_] != ')';
  }

  bool isNext(char c) {
    skipSpace();
    return at_ < text_.size() && text_[at_] == c;
  }

  bool accepts(char c) {
    if (!isNext(c)) return false;
    ++at_;
    return true;
  }

  /// Nothing may follow but a semicolon.
  void finish() {
    (void)accepts(';');
    skipSpace();
    if (at_ != text_.size()) fail("expected nothing after the geometry.");
  }

  /// The offset of the next character.
  std::size_t offset() const { return at_; }

  [[noreturn]] void fail(const std::string& reason) const { throw ReadError{at_, reason}; }

 private:
  /// The letters that come next, in capitals.
  std::string nextWord() {
    skipSpace();
    std::string word;
    for (; at_ < text_.size(); ++at_) {
      const char c = text_[at_];
      const char upper = c >= 'a' && c <= 'z' ? static_cast<char>(c - ('a' - 'A')) : c;
      if (upper < 'A' || upper > 'Z') break;
      word += upper;
    }
    return word;
  }

  void skipSpace() { at_ = std::min(text_.find_first_not_of(" \t\n\v\f\r", at_), text_.size()); }

  std::string_view text_;
  std::size_t at_ = 0;
};

}  // namespace circle_voronoi
