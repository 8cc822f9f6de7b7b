// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/io.h"
#include "json_reader.h"
#include "text.h"

namespace circle_voronoi {

bool holdsDiagram(std::string_view text) try {
  const auto content = contentOf(text, "");
  if (!content) return false;
  JsonReader reader(content.value());
  reader.enterObject();
  while (const auto key = reader.nextKey()) {
    if (*key == "format") return true;
    if (*key == "type" || *key == "features") return false;
    reader.skip();
  }
  return false;
} catch (const ReadError&) {
  return false;
}

}  // namespace circle_voronoi
