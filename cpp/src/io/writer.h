// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <cstdint>
#include <ostream>
#include <string>
#include <string_view>

namespace circle_voronoi {

/// Collects text and hands it to the stream in large pieces.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out) { text_.reserve(2 * kPiece); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { flush(); }

  Writer& operator<<(std::string_view text) {
    text_ += text;
    if (text_.size() >= kPiece) flush();
    return *this;
  }

  Writer& operator<<(std::int64_t value) { return number(value); }
  Writer& operator<<(std::int32_t value) { return number(value); }
  /// The shortest digits that read back to the same bits.
  Writer& operator<<(double value) { return number(value); }

 private:
  static constexpr std::size_t kPiece = 1 << 16;

  template <class Number>
  Writer& number(Number value) {
    std::array<char, 32> digits{};
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    return *this << std::string_view(digits.data(), static_cast<std::size_t>(end - digits.data()));
  }

  void flush() {
    out_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    text_.clear();
  }

  std::ostream& out_;
  std::string text_;
};

}  // namespace circle_voronoi
