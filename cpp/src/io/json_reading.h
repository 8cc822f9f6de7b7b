// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace circle_voronoi {

using Json = nlohmann::json;

/// Tells how far the parser has read, so that an error can name its line.
class JsonPosition {
 public:
  explicit JsonPosition(std::string_view text) : text_(text) {}

  void advance() { ++read_; }

  /// How many characters are read.
  std::size_t read() const { return read_; }

  /// The line of the last character read.
  int line() {
    const std::size_t last = read_ == 0 ? 0 : std::min(read_ - 1, text_.size());
    line_ +=
        static_cast<int>(std::count(text_.begin() + counted_, text_.begin() + static_cast<std::ptrdiff_t>(last), '\n'));
    counted_ = static_cast<std::ptrdiff_t>(last);
    return line_;
  }

 private:
  std::string_view text_;
  std::size_t read_ = 0;
  std::ptrdiff_t counted_ = 0;
  int line_ = 1;
};

/// An input iterator over text that keeps a JsonPosition up to date.
class JsonIterator {
 public:
  using iterator_category = std::input_iterator_tag;
  using value_type = char;
  using difference_type = std::ptrdiff_t;
  using pointer = const char*;
  using reference = const char&;

  JsonIterator(const char* at, JsonPosition& position) : at_(at), position_(&position) {}

  reference operator*() const { return *at_; }
  JsonIterator& operator++() {
    ++at_;
    position_->advance();
    return *this;
  }
  friend bool operator==(const JsonIterator& i, const JsonIterator& j) { return i.at_ == j.at_; }
  friend bool operator!=(const JsonIterator& i, const JsonIterator& j) { return i.at_ != j.at_; }

 private:
  const char* at_;
  JsonPosition* position_;
};

/// The value under a key; null if there is none.
inline Json at(const Json& value, std::string_view key) {
  return value.is_object() ? value.value(std::string(key), Json()) : Json();
}

/// An integer with a minus sign, as the parser gives it: one that is zero is -0.
inline double negative(Json::number_integer_t value) { return value == 0 ? -0.0 : static_cast<double>(value); }

/// A number to the bit. Precondition: value.is_number().
inline double numberOf(const Json& value) {
  const bool isNegative = value.is_number_integer() && !value.is_number_unsigned();
  return isNegative ? negative(value.get<Json::number_integer_t>()) : value.get<double>();
}

/// Hands the events of `text` to `handler` until it returns false or the text ends.
inline void parseJson(std::string_view text, JsonPosition& position, Json::json_sax_t& handler) {
  Json::sax_parse(JsonIterator(text.data(), position), JsonIterator(text.data() + text.size(), position), &handler);
}

/// What the parser objects to, without its own tag and position.
inline std::string reasonOf(const Json::exception& exception) {
  const std::string_view what = exception.what();
  const std::size_t reason = what.find(": ");
  return "bad JSON: " + std::string(reason == std::string_view::npos ? what : what.substr(reason + 2)) + ".";
}

}  // namespace circle_voronoi
