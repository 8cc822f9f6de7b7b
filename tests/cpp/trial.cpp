// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial.h"

#include <algorithm>
#include <iterator>
#include <sstream>

#include "brute_force.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/editor.h"
#include "compare.h"
#include "oracle.h"

namespace circle_voronoi::test {
namespace {

/// A diagram by Method::automatic if it is certified, also when judged from outside; otherwise a problem.
Result<Diagram> certifiedDiagram(std::span<const Circle> circles) {
  auto diagram = compute(circles);
  if (!diagram) return diagram;
  const auto certificate = certify(diagram.value());
  if (!certificate) return certificate.error();
  if (!certificate.value().certified()) return Error{ErrorCode::notCertified, -1, certificate.value().message};
  return diagram;
}

}  // namespace

TrialResult tryAutomatic(std::span<const Circle> circles, bool isDegenerate) {
  const auto diagram = certifiedDiagram(circles);
  if (!diagram) return {diagram.error().message, "none"};
  const Diagram exact = oracle::exactDiagram(circles);
  const auto problem = isDegenerate ? problemInDegeneratePosition : problemInGeneralPosition;
  return {problem(diagram.value(), exact, circles), std::string(wayName(diagram.value().stats.way.value()))};
}

TrialResult tryCertified(std::span<const Circle> circles) {
  const auto diagram = certifiedDiagram(circles);
  if (!diagram) return {diagram.error().message, "none"};
  return {structureProblem(diagram.value(), circles.size()), std::string(wayName(diagram.value().stats.way.value()))};
}

TrialResult tryTiny(std::span<const Circle> circles, bool isDegenerate) {
  TrialResult result = isDegenerate ? tryCertified(circles) : tryAutomatic(circles, false);
  if (!result.problem.empty()) return result;
  const Diagram diagram = compute(circles).value();
  const auto editor = DiagramEditor::from(circles);
  if (!editor) return {"no editor: " + editor.error().message, result.way};
  const auto snapshot = editor.value().snapshot();
  if (!snapshot) return {"no snapshot: " + snapshot.error().message, result.way};
  if (snapshot.value().hidden != diagram.hidden) result.problem = "the snapshot of an editor hides other circles";
  if (diagram.hidden != hiddenByDefinition(circles)) result.problem = "hidden circles are not those by definition";
  return result;
}

std::vector<Circle> shrink(std::vector<Circle> circles, const std::function<bool(std::span<const Circle>)>& fails) {
  for (std::size_t part = circles.size() / 2; part > 0; part /= 2) {
    for (std::size_t first = 0; first < circles.size();) {
      std::vector<Circle> fewer = circles;
      const std::size_t last = std::min(first + part, fewer.size());
      fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(first),
                  fewer.begin() + static_cast<std::ptrdiff_t>(last));
      if (fails(fewer)) {
        circles = std::move(fewer);
      } else {
        first += part;
      }
    }
  }
  return circles;
}

void WayTable::add(const std::string& family, const TrialResult& result) {
  auto row = std::ranges::find(rows_, family, &Row::family);
  if (row == rows_.end()) row = rows_.insert(row, Row{.family = family});
  ++row->trials;
  if (!result.problem.empty()) ++row->problems;
  const auto* way = std::ranges::find(kWays, result.way);
  if (way != std::end(kWays)) ++row->ways[way - std::begin(kWays)];
}

std::string WayTable::text() const {
  std::ostringstream table;
  table << "| family | trials |";
  for (const auto way : kWays) table << ' ' << way << " |";
  table << " problems |\n|---|---|---|---|---|---|\n";
  for (const Row& row : rows_) {
    table << "| " << row.family << " | " << row.trials << " |";
    for (const int count : row.ways) table << ' ' << count << " |";
    table << ' ' << row.problems << " |\n";
  }
  return table.str();
}

int WayTable::trials() const {
  int sum = 0;
  for (const Row& row : rows_) sum += row.trials;
  return sum;
}

int WayTable::problems() const {
  int sum = 0;
  for (const Row& row : rows_) sum += row.problems;
  return sum;
}

}  // namespace circle_voronoi::test
