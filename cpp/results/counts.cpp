// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi_families/families.h"
#include "experiments.h"
#include "method.h"

namespace circle_voronoi::results {

Json countDiscs(const Parameters& parameters) {
  Json rows = Json::array();
  for (const std::size_t n : parameters.sizes) {
    for (std::uint64_t seed = parameters.seed; seed < parameters.seed + parameters.trials; ++seed) {
      const auto circles = generate(Family::uniform, n, seed);
      const Diagram diagram = diagramOf(circles, touchingDisc(Candidates::dynamic, 1));
      const Counts& counts = diagram.stats.counts;
      const Seconds& seconds = diagram.stats.seconds;
      rows.push_back({{"n", n},
                      {"seed", seed},
                      {"samples", counts.samples},
                      {"antipodalDiscs", counts.antipodalDiscs},
                      {"threeTouchDiscs", counts.threeTouchDiscs},
                      {"certified", diagram.certificate.certified()},
                      {"seconds",
                       {{"centers", seconds.order + seconds.triangulate},
                        {"sample", seconds.sample},
                        {"pair", seconds.pair},
                        {"touch", seconds.touch},
                        {"certify", seconds.certify},
                        {"total", seconds.total}}}});
    }
  }
  return rows;
}

}  // namespace circle_voronoi::results
