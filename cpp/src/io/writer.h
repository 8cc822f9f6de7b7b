// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstdint>
#include <exception>
#include <ostream>
#include <string_view>
#include <vector>

#include "circle_voronoi/error.h"
#include "digits.h"
#include "guarded.h"

namespace circle_voronoi {

/// Collects text and passes it to a stream in large pieces.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out), text_(kPiece) {}
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  Writer& operator<<(std::string_view text) {
    if (text.size() > text_.size() - size_) flush();
    if (text.size() > text_.size()) {
      pass(text);
    } else {
      size_ += text.copy(text_.data() + size_, text.size());
    }
    return *this;
  }

  Writer& operator<<(std::int64_t value) { return integer(value); }
  Writer& operator<<(std::int32_t value) { return integer(value); }
  /// Writes the shortest digits that read back to the same bits.
  Writer& operator<<(double value) {
    return append([value](char* to) { return writeDigits(to, value); });
  }

  /// Passes the rest to the stream. Errors: notWritten. Without this call the rest is lost, because a destructor could
  /// not report a full disk.
  Result<void> finish() {
    flush();
    if (!out_) return errorWith(ErrorCode::notWritten, "The stream did not accept all of the text.");
    return {};
  }

 private:
  static constexpr std::size_t kPiece = 1 << 17;

  template <class Integer>
  Writer& integer(Integer value) {
    return append([value](char* to) { return std::to_chars(to, to + kMostDigits, value).ptr; });
  }

  template <class Write>
  Writer& append(Write write) {
    if (text_.size() - size_ < kMostDigits) flush();
    char* begin = text_.data() + size_;
    size_ += static_cast<std::size_t>(write(begin) - begin);
    return *this;
  }

  void flush() {
    pass({text_.data(), size_});
    size_ = 0;
  }

  /// The stream is the caller's, and so are its exceptions.
  void pass(std::string_view text) {
    try {
      out_.write(text.data(), static_cast<std::streamsize>(text.size()));
    } catch (...) {
      throw CallbackThrew{std::current_exception()};
    }
  }

  std::ostream& out_;
  std::vector<char> text_;
  std::size_t size_ = 0;
};

/// Writes items with a separator between them, each by `write(item)`.
template <class Items, class Write>
void writeJoined(Writer& out, const Items& items, std::string_view separator, Write write) {
  std::string_view before;
  for (const auto& item : items) {
    out << before;
    write(item);
    before = separator;
  }
}
template <class Items>
void writeJoined(Writer& out, const Items& items, std::string_view separator) {
  writeJoined(out, items, separator, [&out](const auto& item) { out << item; });
}

/// Writes to a stream what `body` writes to a Writer. Call it within exactly one `guarded`: exceptions of the stream
/// would not pass through a second one.
template <class Body>
Result<void> unguardedWriting(std::ostream& stream, Body body) {
  Writer out(stream);
  body(out);
  return out.finish();
}

/// Writes to a stream what `body` writes to a Writer.
template <class Body>
Result<void> writing(std::ostream& stream, Body body) {
  return guarded([&] { return unguardedWriting(stream, body); });
}

}  // namespace circle_voronoi
