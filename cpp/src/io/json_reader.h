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

/// Reads a JSON text (RFC 8259, UTF-8) from front to back. The caller asks for each value in turn:
///
///     reader.enterArray();
///     while (reader.nextItem()) sum += reader.number();
///     reader.finish();
///
/// The reader builds no tree and does not recurse. Its memory does not grow with the size of the text, and only by one
/// bit for each level of skipped values. Invalid JSON, or a value of another kind than requested, is a ReadError.
class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : text_(text) {}

  /// The offset of the next character.
  std::size_t offset() const { return at_; }

  /// A place in the text to which the reader can return.
  struct Place {
    std::size_t at;
    bool isFirst;
  };
  Place place() const { return {at_, isFirst_}; }
  void goTo(const Place& place) {
    at_ = place.at;
    isFirst_ = place.isFirst;
  }

  /// The kind of the next value.
  JsonKind kind() {
    skipSpace();
    if (isAtEnd()) failSyntax("a value");
    const char c = text_[at_];
    return c == '-' || isDigit(c) ? JsonKind::number : kindAfter(c);
  }

  void enterArray() { enter('['); }
  void enterObject() { enter('{'); }
  /// Moves to the next value of the current array. Returns false at its end, and leaves the array.
  bool nextItem() {
    if (!next(']')) return false;
    (void)kind();  // no comma comes before the end
    return true;
  }
  /// The next key of an object, valid until the next key or string is read.
  std::optional<std::string_view> nextKey();
  /// Reads the next key if it is `key` in the form that the library writes; otherwise reads nothing.
  bool nextKeyIs(std::string_view key);

  /// The nearest double; a minus sign before zero is kept.
  double number();
  /// Returns a number if it is whole and fits; otherwise nothing.
  template <class Integer>
  std::optional<Integer> whole();
  bool boolean() {
    if (kind() != JsonKind::boolean) failSyntax("true or false");
    const bool value = text_[at_] == 't';
    skipWord();
    return value;
  }
  /// Valid until the next key or string is read.
  std::string_view string() {
    if (kind() != JsonKind::string) failSyntax("a string");
    const std::size_t begin = ++at_;
    std::size_t at = begin;
    while (at != text_.size() && isPlain(text_[at])) ++at;
    at_ = at;
    if (!isAtEnd() && text_[at_] == '"') return text_.substr(begin, at_++ - begin);
    return decoded(begin);
  }
  /// Reads past a value of any kind and depth.
  void skip();

  /// Only white space may follow.
  void finish();
  /// Returns whether another text follows, as in JSON lines. Skips the record separators of RFC 8142.
  bool hasMore() {
    for (skipSpace(); !isAtEnd() && text_[at_] == '\x1E'; skipSpace()) ++at_;
    return !isAtEnd();
  }

  /// Throws ReadError with this reason, at the character last read.
  [[noreturn]] void fail(const std::string& reason) const { throw failure(reason); }
  /// Returns the ReadError that `fail` throws.
  ReadError failure(const std::string& reason) const { return {at_ == 0 ? 0 : at_ - 1, reason}; }

 private:
  static bool isSpace(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  static bool isDigit(char c) { return c >= '0' && c <= '9'; }
  /// A character of a string that stands for itself, of one byte.
  static bool isPlain(char c) {
    return static_cast<unsigned char>(c) >= 0x20 && static_cast<signed char>(c) >= 0 && c != '"' && c != '\\';
  }
  bool isAtEnd() const { return at_ == text_.size(); }
  void skipSpace() {
    while (!isAtEnd() && isSpace(text_[at_])) ++at_;
  }
  /// Whether there is another item before `end`; else reads past it.
  bool next(char end) {
    skipSpace();
    const bool isFirst = isFirst_;
    isFirst_ = false;
    if (!isAtEnd() && text_[at_] == end) {
      ++at_;
      return false;
    }
    if (isFirst) return true;
    if (isAtEnd() || text_[at_] != ',') failSyntax(std::string(", or ") + end);
    ++at_;
    return true;
  }
  void enter(char begin) {
    skipSpace();
    if (isAtEnd() || text_[at_] != begin) failSyntax(std::string(1, begin));
    ++at_;
    isFirst_ = true;
  }
  /// The kind of a value other than a number, by its first character.
  JsonKind kindAfter(char c) const;
  /// The rest of a string that began at `begin` and has an escape or a character of several bytes where it is read
  /// next.
  std::string_view decoded(std::size_t begin);
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
  bool isFirst_ = false;  ///< whether no item of the current array or object has been read
  std::string decoded_;   ///< a string with escapes
};

inline std::optional<std::string_view> JsonReader::nextKey() {
  if (!next('}')) return std::nullopt;
  skipSpace();
  if (isAtEnd() || text_[at_] != '"') failSyntax("a key in quotation marks");
  const std::string_view key = string();
  skipSpace();
  if (isAtEnd() || text_[at_] != ':') failSyntax("a colon after a key");
  ++at_;
  return key;
}

inline bool JsonReader::nextKeyIs(std::string_view key) {
  std::string_view rest = text_.substr(at_);
  if (!isFirst_) {
    if (!rest.starts_with(", ")) return false;
    rest.remove_prefix(2);
  }
  if (rest.size() < key.size() + 3 || rest[0] != '"' || rest.substr(1, key.size()) != key ||
      rest[key.size() + 1] != '"' || rest[key.size() + 2] != ':') {
    return false;
  }
  isFirst_ = false;
  at_ = text_.size() - rest.size() + key.size() + 3;
  return true;
}

template <class Integer>
std::optional<Integer> JsonReader::whole() {
  // Most have few digits and nothing else.
  if (kind() == JsonKind::number && text_[at_] != '-' && text_[at_] != '0') {
    std::size_t at = at_;
    Integer few = 0;
    for (; at - at_ < std::numeric_limits<Integer>::digits10 && at != text_.size() && isDigit(text_[at]); ++at) {
      few = 10 * few + (text_[at] - '0');
    }
    if (at != text_.size() && (text_[at] == ',' || text_[at] == ']' || text_[at] == '}')) {
      at_ = at;
      return few;
    }
  }
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
