// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// Text that names an option: `before`, the words that name it, and `after`.
struct OptionAdvice {
  std::string before = {};
  std::string words = {};
  std::string after = {};
  std::string option = {};  ///< the name of the option in C++; empty: there is no advice
};

/// Appends advice to the message of an error.
inline void append(Error& error, const OptionAdvice& advice) {
  if (advice.option.empty()) return;
  error.option = {advice.option, error.message.size() + advice.before.size(), advice.words.size()};
  error.message += advice.before + advice.words + advice.after;
}

/// Returns an error whose message begins with a prefix.
inline Error withPrefix(Error error, std::string_view prefix) {
  error.message.insert(0, prefix);
  error.option.offset += prefix.size();
  return error;
}

}  // namespace circle_voronoi
