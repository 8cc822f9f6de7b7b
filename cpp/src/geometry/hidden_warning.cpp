// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/hidden_warning.h"

#include "hidden_sentence.h"

namespace circle_voronoi {

std::string hiddenSentence(std::size_t hidden, std::size_t count, std::string_view unit) {
  if (4 * hidden <= count) return "";
  return std::to_string(hidden) + " of " + std::to_string(count) +
         " circles are hidden inside others and have no cell. Perhaps their radii have " + std::string(unit) +
         ", or are diameters or another column.";
}

std::string hiddenWarning(const Diagram& diagram) {
  if (diagram.metric != Metric::circles) return "";
  return hiddenSentence(diagram.hidden.size(), diagram.circles.size(),
                        "another unit than their coordinates, as meters and degrees do");
}

}  // namespace circle_voronoi
