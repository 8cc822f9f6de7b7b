// SPDX-License-Identifier: GPL-3.0-or-later
#include "edit_script.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <ranges>
#include <set>
#include <sstream>
#include <tuple>

#include "circle_voronoi/compute.h"
#include "compare.h"
#include "oracle.h"
#include "predicates.h"
#include "random.h"
#include "topology.h"

namespace circle_voronoi::test {
namespace {

using NumberedCircles = std::array<std::int32_t, 3>;
constexpr NumberedCircles kUnbounded = {kNone, kNone, kNone};

/// The contents of a diagram, without numbers of vertices and edges.
struct Content {
  std::vector<std::tuple<NumberedCircles, double, double, double>> vertices;
  std::vector<std::tuple<std::int32_t, std::int32_t, NumberedCircles, NumberedCircles>> edges;
  std::vector<std::int32_t> hidden;

  void addEdge(std::int32_t left, std::int32_t right, NumberedCircles start, NumberedCircles end) {
    if (std::tuple(right, end) < std::tuple(left, start)) {
      std::swap(left, right);
      std::swap(start, end);
    }
    edges.emplace_back(left, right, start, end);
  }
  void sort() {
    std::ranges::sort(vertices);
    std::ranges::sort(edges);
    std::ranges::sort(hidden);
  }
};

Content contentOf(const Diagram& diagram) {
  Content content;
  const auto tripleOf = [&](std::int32_t vertex) {
    if (vertex == kNone) return kUnbounded;
    const auto& [i, j, k] = diagram.vertexCircles[static_cast<std::size_t>(vertex)];
    return NumberedCircles{i, j, k};
  };
  for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
    const auto& [x, y, radius] = diagram.vertices[v];
    content.vertices.emplace_back(tripleOf(static_cast<std::int32_t>(v)), x, y, radius);
  }
  for (const Edge& e : diagram.edges) content.addEdge(e.left, e.right, tripleOf(e.start), tripleOf(e.end));
  for (const HiddenCircle& h : diagram.hidden) content.hidden.push_back(h.circle);
  content.sort();
  return content;
}

std::string differenceOf(const Content& actual, const Content& expected) {
  if (actual.vertices.size() != expected.vertices.size()) return "another number of vertices";
  if (actual.vertices != expected.vertices) return "other vertices";
  if (actual.edges != expected.edges) return "other edges";
  if (actual.hidden != expected.hidden) return "other hidden circles";
  return {};
}

/// Circles that come, go and change.
class Script {
 public:
  Script(const FamilyInfo& family, std::size_t count, std::uint64_t seed)
      : random_(seed), count_(count), supply_(generate(family.family, 2 * count + 1, seed)) {}

  std::vector<Circle> start() const { return {supply_.begin(), supply_.begin() + static_cast<std::ptrdiff_t>(count_)}; }

  /// Removed circles come back under their ids, about as often as new ones come.
  Edit next(const DiagramEditor& editor) {
    Edit edit = any(editor);
    if (edit.kind == Edit::Kind::insert && !removed_.empty() && random_.below(2) == 0) {
      const auto id = removed_.begin() + static_cast<std::ptrdiff_t>(random_.below(removed_.size()));
      edit.id = *id;
      removed_.erase(id);
    }
    return edit;
  }

  void note(const Change& change) { removed_.insert(removed_.end(), change.removed.begin(), change.removed.end()); }

  std::size_t below(std::size_t count) { return random_.below(count); }

 private:
  Edit any(const DiagramEditor& editor) {
    const std::vector<CircleId> ids = editor.ids();
    if (ids.empty()) return {Edit::Kind::insert, kNone, any()};
    const CircleId id = ids[random_.below(ids.size())];
    const Circle old = *editor.circle(id);
    const Circle other = *editor.circle(ids[random_.below(ids.size())]);
    switch (random_.below(12)) {
      case 0:
      case 1:
        return {Edit::Kind::insert, kNone, any()};
      case 2:
      case 3:
      case 4:
        return {Edit::Kind::remove, id, {}};
      case 5:
        return {Edit::Kind::insert, kNone, between(old, other)};
      case 6:
        return {Edit::Kind::replace, id, any()};
      case 7:  // as large as to reach another
        return {Edit::Kind::replace, id, {old.x, old.y, std::hypot(other.x - old.x, other.y - old.y)}};
      case 8:
        return {Edit::Kind::replace, id, {old.x, old.y, old.r * random_.unit()}};
      case 9:  // a copy of another circle, or a smaller circle inside it
        return {Edit::Kind::replace, id, {other.x, other.y, random_.below(2) == 0 ? other.r : other.r / 2}};
      case 10:
        return {Edit::Kind::replace, id, between(old, between(old, between(old, other)))};
      default: {
        const double step = random_.logUniform(-6, 0) * std::hypot(other.x - old.x, other.y - old.y);
        const Vector u = random_.direction();
        return {Edit::Kind::replace, id, {old.x + step * u.x, old.y + step * u.y, old.r}};
      }
    }
  }

  Circle any() { return supply_[random_.below(supply_.size())]; }
  static Circle between(const Circle& a, const Circle& b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2, (a.r + b.r) / 2};
  }

  Random random_;
  std::size_t count_;
  std::vector<Circle> supply_;  ///< never empty
  std::vector<CircleId> removed_;
};

std::string wholeProblem(const DiagramEditor& editor, const Mirror& mirror, bool isLast, const FamilyInfo& family) {
  const auto snapshot = editor.snapshot();
  if (!snapshot) return "no snapshot: " + snapshot.error().message;
  const std::vector<Circle> circles = editor.circles();
  const auto computed = compute(circles);
  // Removals may leave small circles alone.
  if (!computed && computed.error().code == ErrorCode::coordinateTooSmall) {
    return mirror.difference(snapshot.value(), editor.ids());
  }
  if (!computed) return "compute: " + computed.error().message;
  const auto certificate = editor.certificate();
  if (!certificate) return certificate.error().message;
  if (!certificate.value().certified()) return "not certified: " + certificate.value().message;
  if (auto problem = differenceToTheBit(snapshot.value(), computed.value()); !problem.empty()) return problem;
  if (auto problem = mirror.difference(snapshot.value(), editor.ids()); !problem.empty()) return "mirror: " + problem;
  if (!isLast) return {};
  const Diagram exact = oracle::exactDiagram(circles);
  const auto problem = family.isDegenerate ? problemInDegeneratePosition : problemInGeneralPosition;
  return problem(snapshot.value(), exact, circles);
}

}  // namespace

std::string Mirror::apply(const Change& change) {
  for (const CircleId id : change.removed) {
    if (circles_.erase(id) == 0) return "removes a circle that is not there";
    hidden_.erase(id);
  }
  if (change.circles.size() != change.inserted.size() + change.replaced.size()) return "another number of circles";
  auto circle = change.circles.begin();
  for (const CircleId id : change.inserted) {
    if (!circles_.emplace(id, *circle++).second) return "inserts a circle that is there";
  }
  for (const CircleId id : change.replaced) {
    if (!circles_.contains(id)) return "replaces a circle that is not there";
    circles_[id] = *circle++;
  }
  const auto byCircle = [](const HiddenCircle& hider) { return hider.circle; };
  for (const CircleId id : change.hidden) {
    if (!circles_.contains(id) || hidden_.contains(id)) return "hides a circle that is hidden";
    if (std::ranges::count(change.hiders, id, byCircle) != 1) return "hides a circle by none, or by two";
  }
  for (const CircleId id : change.shown) {
    if (hidden_.erase(id) == 0) return "shows a circle that is not hidden";
  }
  for (const auto& [id, by] : change.hiders) {
    const auto found = hidden_.find(id);
    if (found == hidden_.end() && std::ranges::count(change.hidden, id) == 0) return "hides a circle that is visible";
    if (found != hidden_.end() && found->second == by) return "hides a circle by the same";
    hidden_[id] = by;
  }
  for (const std::int32_t vertex : change.removedVertices) {
    if (vertices_.erase(vertex) == 0) return "removes a vertex that is not there";
  }
  for (const std::int32_t edge : change.removedEdges) {
    if (edges_.erase(edge) == 0) return "removes an edge that is not there";
    hullSides_.erase(2 * edge);
    hullSides_.erase(2 * edge + 1);
  }
  for (std::size_t i = 0; i < change.addedVertices.size(); ++i) {
    if (!vertices_.try_emplace(change.addedVertices[i], Corner{change.vertexCircles[i], change.vertices[i]}).second) {
      return "adds a vertex that is there";
    }
  }
  const std::set<CircleId> cells(change.cells.begin(), change.cells.end());
  if (cells.size() != change.cells.size()) return "names a cell twice";
  for (std::size_t i = 0; i < change.addedEdges.size(); ++i) {
    const Edge& edge = change.edges[i];
    if (!edges_.try_emplace(change.addedEdges[i], edge).second) return "adds an edge that is there";
    if (!cells.contains(edge.left) || !cells.contains(edge.right)) return "leaves out a cell";
  }
  for (const auto& [side, next] : change.hullSides) hullSides_[side] = next;
  return {};
}

std::string Mirror::difference(const Diagram& snapshot, const std::vector<CircleId>& ids) const {
  if (!std::ranges::equal(ids, std::views::keys(circles_))) return "other circles";
  if (!std::ranges::equal(snapshot.circles, std::views::values(circles_))) return "circles in other places";
  const auto rank = [&](CircleId id) {
    return static_cast<std::int32_t>(std::ranges::lower_bound(ids, id) - ids.begin());
  };
  const std::vector<Circle>& rounded = snapshot.circles;
  const auto roundedOf = [&](CircleId id) { return rounded[static_cast<std::size_t>(rank(id))]; };
  for (const auto& [id, by] : hidden_) {
    if (!circles_.contains(by) || hidden_.contains(by)) return "hidden by a circle that is not visible";
    if (!Predicates({}).contains(roundedOf(by), roundedOf(id))) return "hidden by a circle that does not contain it";
  }
  Content content;
  const auto tripleOf = [&](std::int32_t vertex) {
    const auto found = vertices_.find(vertex);
    if (found == vertices_.end()) return kUnbounded;
    const auto& [i, j, k] = found->second.circles;
    return NumberedCircles{rank(i), rank(j), rank(k)};
  };
  for (const auto& [number, corner] : vertices_) {
    content.vertices.emplace_back(tripleOf(number), corner.vertex.x, corner.vertex.y, corner.vertex.r);
  }
  for (const auto& [number, edge] : edges_) {
    content.addEdge(rank(edge.left), rank(edge.right), tripleOf(edge.start), tripleOf(edge.end));
  }
  for (const CircleId id : std::views::keys(hidden_)) content.hidden.push_back(rank(id));
  content.sort();
  if (auto problem = differenceOf(content, contentOf(snapshot)); !problem.empty()) return problem;
  return hullDifference(snapshot, ids);
}

/// The sides to infinity go around the hull once.
std::string Mirror::hullDifference(const Diagram& snapshot, const std::vector<CircleId>& ids) const {
  // A diagram without edges, or with one cell, has a hull without sides.
  std::vector<CircleIndex> hull;
  if (!hullSides_.empty()) {
    std::int32_t side = hullSides_.begin()->first;
    do {
      const auto found = hullSides_.find(side);
      if (found == hullSides_.end() || hull.size() > hullSides_.size()) return "a hull that does not close";
      const auto edge = edges_.find(side / 2);
      if (edge == edges_.end()) return "a hull with an edge that is not there";
      const CircleId circle = side % 2 == 0 ? edge->second.left : edge->second.right;
      hull.push_back(static_cast<std::int32_t>(std::ranges::lower_bound(ids, circle) - ids.begin()));
      side = found->second ^ 1;
    } while (side != hullSides_.begin()->first);
    if (hull.size() != hullSides_.size()) return "a hull in parts";
    rotateHull(hull);
  } else if (snapshot.hull.size() == 1) {
    return {};
  }
  return hull == snapshot.hull ? "" : "another hull";
}

std::string differenceToTheBit(const Diagram& actual, const Diagram& expected) {
  if (auto problem = differenceOf(contentOf(actual), contentOf(expected)); !problem.empty()) return problem;
  if (actual.hidden != expected.hidden) return "other hiders";
  if (actual.hull != expected.hull) return "another hull";
  return {};
}

ScriptResult runScript(const FamilyInfo& family, std::size_t count, int edits, std::uint64_t seed) {
  Script script(family, count, seed);
  auto made = DiagramEditor::from(script.start());
  if (!made) return {made.error().message};
  DiagramEditor editor = std::move(made).value();
  Mirror mirror;
  mirror.apply(editor.all().value());
  ScriptResult result;
  for (int i = 0; i < edits; ++i) {
    Edit edit = script.next(editor);
    const auto where = [&] { return " at edit " + std::to_string(i); };
    const auto change = editor.apply({&edit, 1});
    if (!change) {
      // A circle beyond the limit, or a small one where all are.
      if (change.error().code == ErrorCode::coordinateTooLarge) continue;
      if (change.error().code == ErrorCode::coordinateTooSmall) continue;
      result.problem = change.error().message + where();
      return result;
    }
    ++result.edits;
    ++result.ways[static_cast<int>(change.value().way)];
    script.note(change.value());
    result.problem = mirror.apply(change.value());
    const bool isLast = i + 1 == edits;
    if (result.problem.empty() && (isLast || i % 10 == 9))
      result.problem = wholeProblem(editor, mirror, isLast, family);
    if (!result.problem.empty()) {
      result.problem += where();
      return result;
    }
  }
  return result;
}

void EditTable::add(const std::string& family, const ScriptResult& result) {
  auto row = std::ranges::find(rows_, family, &Row::family);
  if (row == rows_.end()) row = rows_.insert(row, Row{family, {}, 0, 0});
  ++row->scripts;
  row->problems += !result.problem.empty();
  row->sum.edits += result.edits;
  for (std::size_t way = 0; way < std::size(result.ways); ++way) row->sum.ways[way] += result.ways[way];
}

std::string EditTable::text() const {
  std::ostringstream table;
  table << "| family | scripts | edits | local | patch | whole | problems |\n|---|---|---|---|---|---|---|\n";
  for (const Row& row : rows_) {
    table << "| " << row.family << " | " << row.scripts << " | " << row.sum.edits << " |";
    for (const int count : row.sum.ways) table << ' ' << count << " |";
    table << ' ' << row.problems << " |\n";
  }
  return table.str();
}

int EditTable::edits() const {
  int sum = 0;
  for (const Row& row : rows_) sum += row.sum.edits;
  return sum;
}

int EditTable::problems() const {
  int sum = 0;
  for (const Row& row : rows_) sum += row.problems;
  return sum;
}

}  // namespace circle_voronoi::test
