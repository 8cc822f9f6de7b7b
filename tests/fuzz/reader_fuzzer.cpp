// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target over the readers of files: any bytes are a text (read_anything.h).
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "read_anything.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  if (const auto problem = circle_voronoi::fuzz::readAnything(text)) {
    std::fprintf(stderr, "%s\n", problem->c_str());
    std::abort();
  }
  return 0;
}
