// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <charconv>
#include <cstddef>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>

#include "text.h"

namespace circle_voronoi {

enum class JsonKind { null, boolean, number, string, array, object };

/// With its article: "a number".
std::string_view nameOf(JsonKind kind);

/// Reads a JSON text (RFC 8259, UTF-8) from front to back. Its caller says what it wants next:
///
///     reader.enterArray();
///     while (reader.nextItem()) sum += reader.number();
///     reader.finish();
///
/// Nothing is built and nothing calls itself, so that neither size nor depth of the text costs memory but one bit a
/// level of what is skipped. What is not JSON, or not of the kind asked for, is a ReadFailure.
class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_(text) {}

  /// The character that is read next.
  std::size_t offset() const { return at_; }

  /// What the value is that comes next.
  JsonKind kind();

  void enterArray() { enter('['); }
  void enterObject() { enter('{'); }
  /// Goes on to the next value of the array last entered; false at its end, which leaves it.
  bool nextItem();
  /// The same for an object: the key of the next value, valid until the next key or string is read.
  std::optional<std::string_view> nextKey();

  /// The nearest double; a minus sign before zero is kept.
  double number();
  /// A number that is whole and fits; nothing if it is not.
  template <class Integer>
  std::optional<Integer> whole();
  /// Valid until the next key or string is read.
  std::string_view string();
  /// Reads past a value of any kind and depth.
  void skip();

  /// Nothing but white space may follow.
  void finish();

  /// Ends with a reason of the caller's, at the character last read.
  [[noreturn]] void fail(const std::string& reason) const;

 private:
  static bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  bool isAtEnd() const { return at_ == text_.size(); }
  void skipSpace() {
    while (!isAtEnd() && isSpace(text_[at_])) ++at_;
  }
  bool next(char end);
  void enter(char begin);
  void skipWord();
  /// The text of a number.
  std::string_view numeral();
  double valueOf(std::string_view numeral) const;
  void decodeEscape();
  char32_t hexDigits();
  void skipCharacter();
  [[noreturn]] void failSyntax(const std::string& expected) const;

  std::string_view text_;
  std::size_t at_ = 0;
  bool isFirst_ = false;  ///< no item of the array or object last entered is read yet
  std::string decoded_;   ///< a string with escapes
};

template <class Integer>
std::optional<Integer> JsonReader::whole() {
  const std::string_view digits = numeral();
  Integer integer = 0;
  const char* end = digits.data() + digits.size();
  const auto [stop, code] = std::from_chars(digits.data(), end, integer);
  if (code == std::errc() && stop == end) return integer;
  const double value = valueOf(digits);
  constexpr double kLimit = std::min(0x1p53, static_cast<double>(std::numeric_limits<Integer>::max()));
  if (!(value >= -kLimit && value <= kLimit)) return std::nullopt;
  integer = static_cast<Integer>(value);
  return static_cast<double>(integer) == value ? std::optional(integer) : std::nullopt;
}

}  // namespace circle_voronoi
