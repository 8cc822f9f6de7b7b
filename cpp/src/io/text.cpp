// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.h"

#include <algorithm>

namespace circle_voronoi {
namespace {

/// The reason as one line of printable text, whatever it quotes from a file.
std::string printable(std::string reason) {
  constexpr std::size_t kMostCharacters = 300;
  const auto isControl = [](char c) { return static_cast<unsigned char>(c) < ' ' || c == '\x7f'; };
  std::replace_if(reason.begin(), reason.end(), isControl, '?');
  if (reason.size() > kMostCharacters) reason = reason.substr(0, kMostCharacters) + "...";
  return reason;
}

/// How many lines end before a place in the text.
std::size_t lineEndsBefore(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  std::size_t count = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool isInside = before[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if ((before[i] == '\n' || before[i] == '\r') && !isInside) ++count;
  }
  return count;
}

/// `name:line: `
std::string placeOf(std::string_view name, std::string_view text, std::size_t offset, std::size_t linesBefore) {
  return std::string(name) + ":" + std::to_string(linesBefore + lineEndsBefore(text, offset) + 1) + ": ";
}

bool isUtf16(std::string_view text) {
  return text.starts_with("\xFE\xFF") || text.starts_with("\xFF\xFE") || text.substr(0, 2).find('\0') != text.npos;
}

}  // namespace

Result<std::string_view> contentOf(std::string_view text, std::string_view name) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (isUtf16(text)) return errorAt(name, text, 0, "the text is UTF-16; it has to be UTF-8.");
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  if (text.find_first_not_of(" \t\r\n") == text.npos) return errorAt(name, text, 0, "the text is empty.");
  return text;
}

Error errorAt(std::string_view name, std::string_view text, std::size_t offset, const std::string& reason,
              std::size_t linesBefore) {
  return {ErrorCode::badInput, -1, placeOf(name, text, offset, linesBefore) + printable(reason)};
}

Error placed(Error error, std::span<const std::size_t> offsets, std::string_view name, std::string_view text,
             std::size_t linesBefore) {
  const std::size_t offset = error.circle < 0 ? 0 : offsets[static_cast<std::size_t>(error.circle)];
  error.message = placeOf(name, text, offset, linesBefore) + error.message;
  return error;
}

std::size_t lineEnds(std::string_view text) { return lineEndsBefore(text, text.size()); }

}  // namespace circle_voronoi
