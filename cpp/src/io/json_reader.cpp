// SPDX-License-Identifier: GPL-3.0-or-later
#include "json_reader.h"

#include <vector>

#include "read_double.h"
#include "utf8.h"

namespace circle_voronoi {
namespace {

void appendUtf8(std::string& text, char32_t c) {
  const auto append = [&](char32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
  const auto tail = [&](int shift) { append(0x80 | ((c >> shift) & 0x3F)); };
  if (c < 0x80) {
    append(c);
  } else if (c < 0x800) {
    append(0xC0 | (c >> 6));
    tail(0);
  } else if (c < 0x10000) {
    append(0xE0 | (c >> 12));
    tail(6);
    tail(0);
  } else {
    append(0xF0 | (c >> 18));
    tail(12);
    tail(6);
    tail(0);
  }
}

}  // namespace

std::string_view nameOf(JsonKind kind) {
  switch (kind) {
    case JsonKind::null:
      return "null";
    case JsonKind::boolean:
      return "a boolean";
    case JsonKind::number:
      return "a number";
    case JsonKind::string:
      return "a string";
    case JsonKind::array:
      return "an array";
    case JsonKind::object:
      return "an object";
  }
  return "";
}

void JsonReader::failSyntax(const std::string& expected) const {
  std::string found = "the end of the text";
  if (!isAtEnd()) {
    const std::size_t size = std::max<std::size_t>(sizeOfUtf8(text_.substr(at_)), 1);
    found = "\"" + std::string(text_.substr(at_, size)) + "\"";
  }
  throw ReadError{at_, "bad JSON: expected " + expected + ", not " + found + "."};
}

JsonKind JsonReader::kindAfter(char c) const {
  switch (c) {
    case '"':
      return JsonKind::string;
    case '[':
      return JsonKind::array;
    case '{':
      return JsonKind::object;
    case 't':
    case 'f':
      return JsonKind::boolean;
    case 'n':
      return JsonKind::null;
    default:
      failSyntax("a value");
  }
}

std::string_view JsonReader::numeral() {
  if (kind() != JsonKind::number) failSyntax("a number");
  const char* const begin = text_.data() + at_;
  const char* const end = text_.data() + text_.size();
  const char* at = begin;
  const auto skipDigits = [&] {
    const char* const first = at;
    while (at != end && isDigit(*at)) ++at;
    if (at != first) return;
    at_ += static_cast<std::size_t>(at - begin);
    failSyntax("a digit");
  };
  if (*at == '-') ++at;
  if (at != end && *at == '0') {
    ++at;
  } else {
    skipDigits();
  }
  if (at != end && *at == '.') {
    ++at;
    skipDigits();
  }
  if (at != end && (*at == 'e' || *at == 'E')) {
    ++at;
    if (at != end && (*at == '+' || *at == '-')) ++at;
    skipDigits();
  }
  const auto size = static_cast<std::size_t>(at - begin);
  at_ += size;
  return {begin, size};
}

double JsonReader::valueOf(std::string_view numeral) const {
  double value = 0;
  const auto code = readDouble(numeral.data(), numeral.data() + numeral.size(), value).ec;
  if (code != std::errc()) fail("a number is beyond the range of a double: " + std::string(numeral) + ".");
  return value;
}

double JsonReader::number() { return valueOf(numeral()); }

std::string_view JsonReader::decoded(std::size_t begin) {
  decoded_.assign(text_, begin, at_ - begin);
  while (!isAtEnd() && text_[at_] != '"') {
    if (text_[at_] == '\\') {
      decodeEscape();
    } else {
      const std::size_t from = at_;
      skipCharacter();
      decoded_.append(text_, from, at_ - from);
    }
  }
  if (isAtEnd()) failSyntax("the end of a string");
  ++at_;
  return decoded_;
}

void JsonReader::skipCharacter() {
  const char c = text_[at_];
  if (isPlain(c)) {
    ++at_;
    return;
  }
  if (static_cast<unsigned char>(c) < 0x20) throw ReadError{at_, "bad JSON: a string has a control character."};
  const std::size_t size = sizeOfUtf8(text_.substr(at_));
  if (size == 0) throw ReadError{at_, std::string("bad JSON: a string is ") + kNotUtf8};
  at_ += size;
}

char32_t JsonReader::hexDigits() {
  unsigned value = 0;
  const std::string_view digits = text_.substr(at_, 4);
  const auto [stop, code] = std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
  if (digits.size() < 4 || code != std::errc() || stop != digits.data() + 4) {
    throw ReadError{at_, "bad JSON: a string has a bad escape."};
  }
  at_ += 4;
  return value;
}

void JsonReader::decodeEscape() {
  constexpr std::string_view kEscapes = "\"\\/bfnrtu";
  constexpr std::string_view kMeanings = "\"\\/\b\f\n\r\t";
  const std::size_t which = kEscapes.find(text_.substr(at_ + 1, 1));
  if (at_ + 1 == text_.size() || which == std::string_view::npos) {
    throw ReadError{at_, "bad JSON: a string has a bad escape."};
  }
  at_ += 2;
  if (which < kMeanings.size()) {
    decoded_ += kMeanings[which];
    return;
  }
  char32_t c = hexDigits();
  const bool isHigh = c >= 0xD800 && c < 0xDC00;
  if (isHigh && text_.substr(at_, 2) == "\\u") {
    at_ += 2;
    const char32_t low = hexDigits();
    if (low >= 0xDC00 && low < 0xE000) return appendUtf8(decoded_, 0x10000 + ((c - 0xD800) << 10) + (low - 0xDC00));
  }
  if (c >= 0xD800 && c < 0xE000) throw ReadError{at_ - 1, "bad JSON: a string has half of a pair of UTF-16."};
  appendUtf8(decoded_, c);
}

void JsonReader::skipWord() {
  for (const std::string_view word : {"null", "true", "false"}) {
    if (text_.substr(at_, word.size()) == word) {
      at_ += word.size();
      return;
    }
  }
  failSyntax("a value");
}

void JsonReader::skip() {
  std::vector<bool> isObject;  // of each array or object that is open
  do {
    if (!isObject.empty()) {
      const bool isMore = isObject.back() ? nextKey().has_value() : nextItem();
      if (!isMore) {
        isObject.pop_back();
        continue;
      }
    }
    switch (kind()) {
      case JsonKind::array:
        enterArray();
        isObject.push_back(false);
        break;
      case JsonKind::object:
        enterObject();
        isObject.push_back(true);
        break;
      case JsonKind::string:
        (void)string();
        break;
      case JsonKind::number:
        (void)numeral();
        break;
      default:
        skipWord();
    }
  } while (!isObject.empty());
}

void JsonReader::finish() {
  skipSpace();
  if (!isAtEnd()) failSyntax("the end of the text");
}

}  // namespace circle_voronoi
