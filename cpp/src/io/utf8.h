// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace circle_voronoi {

// Functions for text from outside. They stand in a header alone, so that the program can use them beside a shared
// library, which hides all but its public functions.

/// The end of a sentence about a text that is not UTF-8. Spreadsheets write Windows-1252.
inline constexpr const char* kNotUtf8 = "not UTF-8, perhaps Windows-1252; save it as UTF-8.";

/// Returns how many bytes the first character of a text has in UTF-8, or 0 if the text does not begin with one.
inline std::size_t sizeOfUtf8(std::string_view text) {
  const auto byte = [&](std::size_t i) -> unsigned {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0;
  };
  const unsigned first = byte(0);
  if (first < 0x80) return text.empty() ? 0 : 1;
  const std::size_t size = first >= 0xC2 && first < 0xE0   ? 2
                           : first >= 0xE0 && first < 0xF0 ? 3
                           : first >= 0xF0 && first < 0xF5 ? 4
                                                           : 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xC0) != 0x80) return 0;
  }
  // Neither longer than needed, nor a half of a pair of UTF-16, nor beyond the last character.
  const bool isBad = (first == 0xE0 && byte(1) < 0xA0) || (first == 0xED && byte(1) >= 0xA0) ||
                     (first == 0xF0 && byte(1) < 0x90) || (first == 0xF4 && byte(1) >= 0x90);
  return isBad ? 0 : size;
}

/// Returns a sentence as one line of printable UTF-8 of at most about 300 bytes, whatever it quotes from a file. A
/// question mark replaces each control character and each byte that is not UTF-8.
inline std::string printable(std::string_view sentence) {
  constexpr std::size_t kMostBytes = 300;
  std::string result;
  while (!sentence.empty()) {
    const std::size_t size = sizeOfUtf8(sentence);
    const std::string_view character = sentence.substr(0, size);
    const unsigned char first = static_cast<unsigned char>(sentence[0]);
    const bool isControl = first < ' ' || first == 0x7F || (first == 0xC2 && size == 2 && character[1] < '\xA0');
    const std::string_view shown = size == 0 || isControl ? "?" : character;
    if (result.size() + shown.size() > kMostBytes) return result + "...";
    result += shown;
    sentence.remove_prefix(size == 0 ? 1 : size);
  }
  return result;
}

/// Returns whether a text is UTF-16, with a byte-order mark or without one.
inline bool isUtf16(std::string_view text) {
  return text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE") || text.substr(0, 2).find('\0') != text.npos;
}

/// Returns a text without the byte-order mark of UTF-8 that it may begin with.
inline std::string_view withoutByteOrderMark(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  return text;
}

}  // namespace circle_voronoi
