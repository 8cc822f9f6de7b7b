// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <charconv>
#include <cstdint>
#include <ostream>
#include <string_view>
#include <vector>

#include "digits.h"

namespace circle_voronoi {

/// Collects text and hands it to the stream in large pieces.
class Writer {
 public:
  explicit Writer(std::ostream& out) : out_(out), text_(kPiece) {}
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  ~Writer() { flush(); }

  Writer& operator<<(std::string_view text) {
    if (text.size() > text_.size() - size_) flush();
    if (text.size() > text_.size()) {
      out_.write(text.data(), static_cast<std::streamsize>(text.size()));
    } else {
      size_ += text.copy(text_.data() + size_, text.size());
    }
    return *this;
  }

  Writer& operator<<(std::int64_t value) { return integer(value); }
  Writer& operator<<(std::int32_t value) { return integer(value); }
  /// The shortest digits that read back to the same bits.
  Writer& operator<<(double value) {
    return append([value](char* to) { return writeDigits(to, value); });
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
    out_.write(text_.data(), static_cast<std::streamsize>(size_));
    size_ = 0;
  }

  std::ostream& out_;
  std::vector<char> text_;
  std::size_t size_ = 0;
};

}  // namespace circle_voronoi
