// SPDX-License-Identifier: GPL-3.0-or-later
#include "experiments.h"
#include "mismatches.h"

namespace circle_voronoi::results {

Json correctness(const Parameters& parameters) {
  const auto found = test::countMismatches(parameters.seed, parameters.trials);
  Json rows = Json::array();
  for (std::size_t i = 0; i < found.size(); ++i) {
    const FamilyInfo& family = families()[i];
    Json row = {{"family", family.name},
                {"description", family.description},
                {"isDisjoint", family.isDisjoint},
                {"isDegenerate", family.isDegenerate},
                {"misjudged", found[i].firstMisjudged},
                {"wrong", Json::object()},
                {"passed", Json::object()}};
    for (std::size_t way = 0; way < test::kComparedWays; ++way) {
      const test::ComparedWay& compared = test::comparedWays()[way];
      if (compared.method == Method::touchingDisc && test::isBeyondTouchingDisc(family.family)) continue;
      row["wrong"][compared.name] = found[i].wrong[way];
      row["passed"][compared.name] = found[i].passed[way];
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace circle_voronoi::results
