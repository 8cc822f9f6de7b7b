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

std::string lineAt(std::string_view text, std::size_t offset) {
  const std::string_view before = text.substr(0, offset);
  std::size_t line = 1;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const bool isInside = before[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if ((before[i] == '\n' || before[i] == '\r') && !isInside) ++line;
  }
  return std::to_string(line);
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

Error errorAt(std::string_view name, std::string_view text, std::size_t offset, const std::string& reason) {
  return {ErrorCode::badInput, -1, std::string(name) + ":" + lineAt(text, offset) + ": " + printable(reason)};
}

Error placed(Error error, std::span<const std::size_t> offsets, std::string_view name, std::string_view text) {
  const std::size_t offset = error.circle < 0 ? 0 : offsets[static_cast<std::size_t>(error.circle)];
  error.message = std::string(name) + ":" + lineAt(text, offset) + ": " + error.message;
  return error;
}

}  // namespace circle_voronoi
