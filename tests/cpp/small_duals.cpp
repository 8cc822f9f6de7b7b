// SPDX-License-Identifier: GPL-3.0-or-later
#include "small_duals.h"

#include <variant>

#include "apollonius.h"
#include "found_sites.h"
#include "judge.h"
#include "order.h"
#include "pair.h"
#include "touch.h"
#include "validate.h"

namespace circle_voronoi::test {

std::vector<Circle> visibleCircles(Family family, std::size_t count, std::uint64_t seed) {
  return test::foundSites(order(validate(generate(family, count, seed)).value())).sites.circles;
}

bool isRight(std::span<const Circle> circles, const Dual& dual) {
  Predicates predicates(circles);
  return judge(circles, dual, predicates).isRight();
}

std::optional<Dual> solve(std::span<const Circle> circles) {
  const int n = static_cast<int>(circles.size());
  const auto touched = dualOf(touch(circles, pairAll(n), {}).topology, n);
  if (const auto* dual = std::get_if<Dual>(&touched); dual != nullptr && isRight(circles, *dual)) return *dual;
  Dual dual = apolloniusGraph(circles);
  if (!isRight(circles, dual)) return std::nullopt;
  return dual;
}

}  // namespace circle_voronoi::test
