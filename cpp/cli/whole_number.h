// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cstdint>
#include <string>
#include <system_error>

namespace circle_voronoi::cli {

/// Checks the value of an option: a whole number from 0 to `most` in decimal digits. Removes leading zeros, because
/// CLI11 would read the number as octal.
inline CLI::Validator wholeNumber(std::uint64_t most) {
  const auto read = [most](std::string& text) -> std::string {
    std::uint64_t value = 0;
    const char* end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(text.data(), end, value);
    if (code != std::errc() || stop != end || value > most) {
      return "expected a whole number from 0 to " + std::to_string(most) + ".";
    }
    text = std::to_string(value);
    return "";
  };
  return {read, ""};
}

}  // namespace circle_voronoi::cli
