// SPDX-License-Identifier: GPL-3.0-or-later
// Answers questions about circles of files with the library's geometry. tests/wasm/geometry.test.mjs asks web/lib
// the same ones. Each line of the input is a request, of words separated by tabs:
//
//     FILE circles|weights|centers|power MINX MINY MAXX MAXY MAX_DISTANCE
//
// Each line of the output is a question and the numbers that answer it, which read back to the same bits. An empty line
// ends the answers to a request.
#include <array>
#include <charconv>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/cells.h"
#include "circle_voronoi/clearest_path.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/hidden_warning.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/merged.h"
#include "circle_voronoi/queries.h"

namespace circle_voronoi {
namespace {

/// Query points along each side of the box.
constexpr int kPlaces = 7;
/// The parameter at which a piece of an unbounded edge begins, or the inverse of that at which it ends.
constexpr double kNearParameter = 0.1;

/// One line of output, written by the destructor: a question, then its numbers.
class Answer {
 public:
  explicit Answer(const std::string& question) : text_(question + ':') {}
  Answer(const Answer&) = delete;
  ~Answer() { std::cout << text_ << '\n'; }

  Answer& operator<<(double value) {
    std::array<char, 32> digits{};
    text_ += ' ';
    text_.append(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
    return *this;
  }
  Answer& operator<<(Point p) { return *this << p.x << p.y; }
  Answer& operator<<(Vector v) { return *this << v.x << v.y; }

  template <class Indices>
  Answer& list(const Indices& indices) {
    for (const auto i : indices) *this << static_cast<double>(static_cast<std::int32_t>(i));
    return *this;
  }

 private:
  std::string text_;
};

template <class... Parts>
std::string question(const char* name, Parts... parts) {
  std::string text = name;
  ((text += ' ', text += std::to_string(parts)), ...);
  return text;
}

class Questions {
 public:
  Questions(const Diagram& diagram, const Box& box, double maxDistance)
      : diagram_(diagram), box_(box), maxDistance_(maxDistance) {
    tolerance_ = 1e-4 * std::max(box.maxX - box.minX, box.maxY - box.minY);
    for (int j = 0; j < kPlaces; ++j) {
      for (int i = 0; i < kPlaces; ++i) places_.push_back(placeAt(i, j));
    }
  }

  void askAll() const {
    askBoxes();
    for (EdgeIndex e = 0; e < static_cast<std::int32_t>(diagram_.edges.size()); ++e) askEdge(e);
    for (CircleIndex i = 0; i < static_cast<std::int32_t>(diagram_.circles.size()); ++i) askCell(i);
    askPlaces();
    askHull();
    askMerged();
    if (diagram_.metric == Metric::circles) askQueries();
  }

 private:
  Point placeAt(int i, int j) const {
    return {box_.minX + (i / (kPlaces - 1.0)) * (box_.maxX - box_.minX),
            box_.minY + (j / (kPlaces - 1.0)) * (box_.maxY - box_.minY)};
  }

  void askBoxes() const {
    const Box box = exportBox(diagram_.circles);
    Answer("exportBox") << box.minX << box.minY << box.maxX << box.maxY;
    const Box grown = exportBox(diagram_, maxDistance_);
    Answer("exportBox of a distance") << grown.minX << grown.minY << grown.maxX << grown.maxY;
    const std::string warning = hiddenWarning(diagram_);
    Answer("hiddenWarning").list(std::vector<CircleIndex>(warning.begin(), warning.end()));
  }

  void askEdge(EdgeIndex e) const {
    const EdgeCurve curve = edgeCurve(diagram_, e);
    const Bisector& b = curve.bisector;
    Answer(question("bisector", e)) << b.left << b.right << b.a << b.b << b.origin << b.along << b.across << b.apex;
    {
      Answer answer(question("edgeCurve", e));
      answer << curve.from << curve.to;
      if (!curve.startsAtInfinity()) answer << curve.start;
      if (!curve.endsAtInfinity()) answer << curve.end;
    }
    for (const double s : {0.3, 1.0, 5.0}) {
      const Point p = pointAt(b, s);
      Answer(question("pointAt", e)) << p << parameterAt(b, p);
    }
    // A bounded piece of the edge, between parameters.
    EdgeCurve piece = curve;
    if (curve.startsAtInfinity()) {
      piece.from = std::min(kNearParameter, curve.to / 2);
      piece.start = pointAt(b, piece.from);
    }
    if (curve.endsAtInfinity()) {
      piece.to = std::max(1 / kNearParameter, 2 * piece.from);
      piece.end = pointAt(b, piece.to);
    }
    askPiece(question("piece", e), piece);
  }

  void askPiece(const std::string& name, const EdgeCurve& piece) const {
    Answer(name + " ends") << piece.from << piece.to << piece.start << piece.end;
    Answer(name + " arcLength") << arcLength(piece);
    const RationalBezier rational = rationalBezier(piece);
    Answer(name + " rationalBezier") << rational.start << rational.control << rational.end << rational.weight
                                     << pointAt(rational, 0.3);
    {
      Answer cubics(name + " cubicBeziers");
      for (const auto& [start, control1, control2, end] : cubicBeziers(piece, tolerance_)) {
        cubics << start << control1 << control2 << end;
      }
    }
    Answer points(name + " polyline");
    for (const Point& p : polyline(piece, tolerance_)) points << p;
  }

  void askCell(CircleIndex i) const {
    {
      Answer answer(question("cell", i));
      answer << diagram_.hasCell(i);
      for (const SideIndex side : diagram_.sides(i)) answer << side;
      answer.list(neighbors(diagram_, i));
    }
    for (const SideIndex side : diagram_.sides(i)) {
      const EdgeCurve curve = sideCurve(diagram_, side);
      Answer(question("side", side)) << diagram_.circleOf(side) << diagram_.neighborOf(side) << diagram_.originOf(side)
                                     << diagram_.targetOf(side) << curve.from << curve.to << curve.bisector.a
                                     << curve.bisector.across;
    }
    askOutline(question("outline", i), outline(diagram_, i));
    Answer(question("whole cell", i)) << cellArea(diagram_, i) << cellPerimeter(diagram_, i);
  }

  static void askOutline(const std::string& name, const Outline& parts) {
    for (const auto& loop : parts) {
      Answer answer(name + " loop");
      for (const auto& [curve, side, neighbor, radius, regionSide] : loop) {
        answer << curve.from << curve.to << curve.start << curve.end << side << neighbor << radius;
      }
    }
    Answer(name + " area") << area(parts);
    Answer(name + " centroid") << centroid(parts);
    Answer(name + " perimeter") << perimeter(parts);
  }

  void askPlaces() const {
    if (diagram_.circles.empty()) return;
    const Finder finder(diagram_);
    Answer("findAll").list(finder.findAll(places_));
    for (std::size_t k = 0; k < places_.size(); ++k) {
      const Point& p = places_[k];
      const CircleIndex found = finder.find(p);
      const CircleIndex hint = static_cast<std::int32_t>(k % diagram_.circles.size());
      Answer answer(question("place", k));
      answer << found << finder.find(p, hint) << distanceFrom(diagram_, found, p) << contains(diagram_, found, p)
             << contains(diagram_, hint, p) << distanceDifference(diagram_, hint, found, p);
      for (const CircleIndex other : neighbors(diagram_, found))
        answer << distanceDifference(diagram_, found, other, p);
    }
  }

  void askHull() const {
    const Hull around = convexHull(diagram_);
    for (const HullArc& arc : around.arcs) {
      Answer(question("hull arc", arc.circle)) << arc.r << arc.start << arc.end;
    }
    Answer measures("hull measures");
    measures << around.length << around.area;
    for (const HullArc& arc : around.arcs) measures << arc.angle;
  }

  void askMerged() const {
    for (const std::optional<double> nearZero : {std::optional<double>{}, {0.0}, {tolerance_}, {1000 * tolerance_}}) {
      const MergedDiagram merged = mergeVertices(diagram_, nearZero);
      Answer answer("mergeVertices");
      for (const auto& [x, y, radius] : merged.vertices) answer << x << y << radius;
      answer.list(merged.firstCircle).list(merged.circles).list(merged.mergedVertex);
      for (const auto& [left, right, start, end] : merged.edges) answer << left << right << start << end;
    }
  }

  void askQueries() const {
    if (const auto pair = closestPair(diagram_)) Answer("closestPair") << pair->first << pair->second << pair->gap;
    askDisc("largestEmptyDiscCenteredInHull", largestEmptyDiscCenteredInHull(diagram_));
    if (diagram_.circles.empty()) return;
    for (std::size_t k = 0; k < places_.size(); k += 3) {
      const ClearestPath path =
          clearestPath(diagram_, places_[k], places_[places_.size() - 1 - (5 * k) % places_.size()]);
      Answer answer(question("clearestPath", k));
      answer << path.clearance;
      if (path.entry) answer << *path.entry;
      if (path.exit) answer << *path.exit;
      answer.list(path.edges);
    }
  }

  static void askDisc(const char* name, const std::optional<EmptyDisc>& found) {
    Answer answer(name);
    if (!found) return;
    answer << found->disc.x << found->disc.y << found->disc.r;
    for (const CircleIndex circle : found->circles) {
      if (circle != kNone) answer << circle;
    }
  }

  const Diagram& diagram_;
  Box box_;
  double maxDistance_;
  double tolerance_;
  std::vector<Point> places_;
};

Result<Diagram> diagramOf(const std::vector<Circle>& circles, std::string_view metric) {
  if (metric == "weights") return compute(circles, {.weights = true});
  if (metric == "power-weights") return compute(circles, {.metric = Metric::power, .weights = true});
  if (const auto known = metricFromName(metric)) return compute(circles, {.metric = *known});
  return Error{ErrorCode::badOption, -1, "There is no such metric."};
}

/// Answers one request. Returns false if the request is invalid.
bool answer(const std::vector<std::string>& words) {
  constexpr std::size_t kWords = 7;
  if (words.size() != kWords) return false;
  std::ifstream file(words[0]);
  const std::string text(std::istreambuf_iterator<char>(file), {});
  const bool weights = words[1].ends_with("weights");
  const auto circles = readCircles(text, words[0], {.weights = weights});
  if (!circles) return false;
  const auto diagram = diagramOf(circles.value(), words[1]);
  if (!diagram) return false;
  const auto number = [&](std::size_t k) { return std::strtod(words[k].c_str(), nullptr); };
  Questions(diagram.value(), {number(2), number(3), number(4), number(5)}, number(6)).askAll();
  return true;
}

int answerAll() {
  std::ios::sync_with_stdio(false);
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream request(line);
    std::vector<std::string> words;
    for (std::string word; std::getline(request, word, '\t');) words.push_back(word);
    if (!answer(words)) return 2;
    std::cout << '\n' << std::flush;
  }
  return 0;
}

}  // namespace
}  // namespace circle_voronoi

int main() { return circle_voronoi::answerAll(); }
