// SPDX-License-Identifier: GPL-3.0-or-later
#include "text.h"

#include <algorithm>

#include "utf8.h"

namespace circle_voronoi {
namespace {

/// The number of line ends between two places in the text.
std::size_t lineEndsBetween(std::string_view text, std::size_t from, std::size_t offset) {
  std::size_t count = 0;
  for (std::size_t i = from; i < std::min(offset, text.size()); ++i) {
    const bool isInside = text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n';
    if ((text[i] == '\n' || text[i] == '\r') && !isInside) ++count;
  }
  return count;
}

std::size_t lineEndsBefore(std::string_view text, std::size_t offset) { return lineEndsBetween(text, 0, offset); }

/// `name:line: `
std::string placeOf(std::string_view name, std::string_view text, std::size_t offset, std::size_t linesBefore) {
  return std::string(name) + ":" + std::to_string(linesBefore + lineEndsBefore(text, offset) + 1) + ": ";
}

}  // namespace

Result<std::string_view> contentOf(std::string_view text, std::string_view name) {
  if (isUtf16(text)) return errorAt(name, text, 0, "the text is UTF-16; save it as UTF-8.");
  text = withoutByteOrderMark(text);
  if (text.find_first_not_of(kBlank) == text.npos) return errorAt(name, text, 0, "the text is empty.");
  return text;
}

Error errorAt(std::string_view name, std::string_view text, std::size_t offset, const std::string& reason,
              std::size_t linesBefore) {
  return {ErrorCode::badInput, -1, placeOf(name, text, offset, linesBefore) + printable(reason)};
}

Error errorAt(std::string_view name, std::string_view text, const ReadError& failure, std::size_t linesBefore) {
  Error error = errorAt(name, text, failure.offset, failure.reason, linesBefore);
  error.code = failure.code;
  error.circle = failure.circle;
  append(error, failure.advice);
  return error;
}

std::vector<std::size_t> linesAt(std::string_view text, std::span<const std::size_t> offsets) {
  std::vector<std::size_t> lines;
  std::size_t line = 1;
  std::size_t counted = 0;
  for (const std::size_t offset : offsets) {
    line += lineEndsBetween(text, counted, offset);
    counted = offset;
    lines.push_back(line);
  }
  return lines;
}

std::vector<Error> errorsAt(std::string_view name, std::string_view text, std::span<const ReadError> failures) {
  std::vector<std::size_t> offsets;
  for (const ReadError& failure : failures) offsets.push_back(failure.offset);
  const std::vector<std::size_t> lines = linesAt(text, offsets);
  std::vector<Error> errors;
  for (std::size_t k = 0; k < failures.size(); ++k) {
    ReadError failure = failures[k];
    failure.offset = 0;
    errors.push_back(errorAt(name, "", failure, lines[k] - 1));
  }
  return errors;
}

Error errorAtCircle(Error error, std::span<const std::size_t> offsets, std::string_view name, std::string_view text,
                    std::size_t linesBefore) {
  const std::size_t offset = error.circle < 0 ? 0 : offsets[static_cast<std::size_t>(error.circle)];
  error.message = placeOf(name, text, offset, linesBefore) + error.message;
  return error;
}

std::size_t lineEnds(std::string_view text) { return lineEndsBefore(text, text.size()); }

}  // namespace circle_voronoi
