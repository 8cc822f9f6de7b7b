// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "circle_voronoi_families/families.h"
#include "experiments.h"
#include "method.h"

namespace circle_voronoi::results {

Json sampleTable(const Parameters&) {
  Json rows = Json::array();
  for (const std::size_t n : {std::size_t{49}, std::size_t{199}}) {
    const auto circles = generate(Family::ring, n, 1);
    std::vector<int> counts(n, 0);
    for (const int circle : dynamicSamples(circles, 3).circles) ++counts[circle];
    int total = 0;
    for (const int count : counts) total += count;
    rows.push_back({{"n", n},
                    {"onLargest", counts[0]},
                    {"fewestOnOthers", *std::min_element(counts.begin() + 1, counts.end())},
                    {"mostOnOthers", *std::max_element(counts.begin() + 1, counts.end())},
                    {"average", static_cast<double>(total) / static_cast<double>(n)}});
  }
  return rows;
}

}  // namespace circle_voronoi::results
