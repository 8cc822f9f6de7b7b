// SPDX-License-Identifier: GPL-3.0-or-later
// Whichever allocation fails, every function of the library gives its result or an error: nothing is thrown, and under
// the address sanitizer nothing leaks.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <limits>
#include <new>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/box.h"
#include "circle_voronoi/certify.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/fit_areas.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi_families/families.h"
#include "guarded.h"

namespace {

constexpr long kNever = std::numeric_limits<long>::max();

long allocationsLeft = kNever;
bool failsOnce = false;
bool hasFailed = false;

void* allocate(std::size_t size) {
  if (allocationsLeft != kNever && allocationsLeft-- <= 0) {
    hasFailed = true;
    allocationsLeft = failsOnce ? kNever : 0;
    throw std::bad_alloc();
  }
  if (void* memory = std::malloc(size == 0 ? 1 : size)) return memory;
  throw std::bad_alloc();
}

}  // namespace

void* operator new(std::size_t size) { return allocate(size); }
void* operator new[](std::size_t size) { return allocate(size); }
// Sorting asks for memory that may be missing. Sanitizers would take it from elsewhere than it is given back to.
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  try {
    return allocate(size);
  } catch (const std::bad_alloc&) {
    return nullptr;
  }
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete[](void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }

// Where memory runs out, containers of CGAL lose the block that they were about to note.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() { return "leak:Compact_container\n"; }

namespace circle_voronoi {
namespace {

/// Calls `function` until no allocation fails. In each call one more allocation succeeds before one, or all, fail.
/// Passes each value that is returned in place of an error to `check`.
template <class Function, class Check>
void failEachAllocation(Function function, Check check) {
  for (const bool once : {true, false}) {
    int errors = 0;
    for (long count = 0;; ++count) {
      failsOnce = once;
      hasFailed = false;
      allocationsLeft = count;
      auto result = function();
      allocationsLeft = kNever;
      if (result.ok()) {
        check(result.value());
      } else {
        ++errors;
        ASSERT_EQ(result.error().code, ErrorCode::tooManyCircles) << "allocation " << count;
        ASSERT_TRUE(hasFailed);
      }
      if (!hasFailed) break;
    }
    EXPECT_GT(errors, 0);
  }
}

// More than one patch of every structure, hidden circles, ties.
std::vector<Circle> someCircles() {
  std::vector<Circle> circles = generate(Family::hidden, 20, 1);
  const std::vector<Circle> grid = generate(Family::grid, 16, 1);
  circles.insert(circles.end(), grid.begin(), grid.end());
  return circles;
}

void checkComputed(const Options& options) {
  const auto circles = someCircles();
  const Diagram expected = compute(circles, options).value();
  failEachAllocation([&] { return compute(circles, options); },
                     [&](const Diagram& diagram) {
                       ASSERT_EQ(diagram.edges, expected.edges);
                       ASSERT_EQ(diagram.hull, expected.hull);
                       ASSERT_EQ(diagram.certificate.flaw, expected.certificate.flaw);
                     });
}

TEST(Allocation, MayFailInCompute) { checkComputed({}); }

TEST(Allocation, MayFailInFlips) {
  Options options;
  options.method = Method::flip;
  checkComputed(options);
}

TEST(Allocation, MayFailInTheTouchingDiscMethod) {
  for (const Candidates candidates : {Candidates::dynamic, Candidates::uniform, Candidates::allPairs}) {
    Options options;
    options.method = Method::touchingDisc;
    options.candidates = candidates;
    options.samples = candidates == Candidates::allPairs ? -1 : 2;
    options.resample = true;
    checkComputed(options);
  }
}

TEST(Allocation, MayFailWherePolygonsAreMerged) {
  const std::vector<Region::Ring> rings = {{{0, 0}, {4, 0}, {4, 4}, {0, 4}}, {{2, 1}, {6, 2}, {5, 7}}};
  const std::vector<std::vector<Region::Ring>> polygons = {{rings[0]}, {rings[1]}};
  failEachAllocation([&] { return Region::fromPolygons(polygons, {.dissolve = true}); },
                     [](const Region& region) { ASSERT_EQ(region.ringCount(), 1U); });
}

TEST(Allocation, MayFailInAFit) {
  const std::vector<Circle> sites = {{1, 1, 0}, {3, 2, 0}};
  const std::vector<double> areas = {9, 7};
  const Region region = Region::from(Box{0, 0, 4, 4}).value();
  AreaFitOptions options;
  options.tolerance = 0.1;
  failEachAllocation([&] { return fitAreas(sites, areas, region, options); },
                     [](const AreaFit& fit) { ASSERT_LE(fit.error, 0.1); });
}

TEST(Allocation, MayFailInCertify) {
  const auto circles = someCircles();
  const Diagram diagram = compute(circles).value();
  failEachAllocation([&] { return certify(diagram); },
                     [](const Certificate& certificate) { ASSERT_TRUE(certificate.certified()); });
  Diagram wrong = diagram;
  wrong.edges.pop_back();
  failEachAllocation([&] { return certify(wrong); },
                     [](const Certificate& certificate) { ASSERT_FALSE(certificate.certified()); });
}

/// Memory never runs out while this lives.
class Enough {
 public:
  Enough() { allocationsLeft = kNever; }
  ~Enough() { allocationsLeft = left_; }
  Enough(const Enough&) = delete;
  Enough& operator=(const Enough&) = delete;

 private:
  long left_ = allocationsLeft;
};

bool areSame(const Change& a, const Change& b) {
  return a.addedVertices == b.addedVertices && a.vertices == b.vertices && a.vertexCircles == b.vertexCircles &&
         a.addedEdges == b.addedEdges && a.edges == b.edges && a.inserted == b.inserted && a.hidden == b.hidden;
}

/// The circles of all vertices and the hidden ones: which diagram it is, whatever the numbers.
auto contentOf(const DiagramEditor& editor) {
  const Change all = editor.all().value();
  std::multiset<std::array<CircleId, 3>> vertices(all.vertexCircles.begin(), all.vertexCircles.end());
  return std::pair(vertices, all.hidden);
}

TEST(Allocation, MayFailInEdits) {
  const auto circles = someCircles();
  failEachAllocation([&] { return DiagramEditor::from(circles); },
                     [&](const DiagramEditor& editor) { ASSERT_EQ(editor.size(), circles.size()); });
  // Insert, remove, insert and remove a circle that hides others, move near and far; in the end edit so many circles
  // that the whole diagram is computed.
  const Circle hider = {circles[20].x, circles[20].y, 2};
  const auto moved = [&](CircleId id, double step) {
    const Circle& c = circles[static_cast<std::size_t>(id)];
    return Edit{Edit::Kind::replace, id, {c.x + step, c.y, c.r}};
  };
  const std::vector<std::vector<Edit>> scripts = {
      {{Edit::Kind::insert, kNone, {1.51, 1.52, 0.01}}},
      {{Edit::Kind::remove, 25, {}}},
      {{Edit::Kind::insert, kNone, hider}, moved(21, 0.1)},
      {{Edit::Kind::remove, 37, {}}},
      {moved(26, 1e-3), {Edit::Kind::insert, 25, circles[25]}, moved(27, -2)},
      std::vector<Edit>(50, {Edit::Kind::insert, kNone, {0.25, 0.75, 0.1}})};
  const auto editorAfter = [&](std::size_t count) {
    DiagramEditor editor = std::move(DiagramEditor::from(circles)).value();
    for (std::size_t i = 0; i < count; ++i) EXPECT_TRUE(editor.apply(scripts[i]).ok());
    return editor;
  };
  for (std::size_t i = 0; i < scripts.size(); ++i) {
    const Change before = editorAfter(i).all().value();
    const auto after = contentOf(editorAfter(i + 1));
    DiagramEditor editor = editorAfter(i);
    failEachAllocation(
        [&] {
          {
            const Enough enough;
            editor = editorAfter(i);
          }
          auto change = editor.apply(scripts[i]);
          const Enough enough;
          if (!change.ok()) {
            // The failed edit changed nothing, and the script can go on.
            EXPECT_TRUE(areSame(editor.all().value(), before)) << "script " << i;
            EXPECT_TRUE(editor.apply(scripts[i]).ok());
          }
          EXPECT_EQ(contentOf(editor), after) << "script " << i;
          return change;
        },
        [&](const Change&) { EXPECT_TRUE(editor.certificate().value().certified()); });
  }
}

TEST(Allocation, MayFailInComparisons) {
  const auto circles = someCircles();
  for (const Metric metric : {Metric::circles, Metric::centers, Metric::power}) {
    const Diagram expected = compute(circles, {.metric = metric}).value();
    failEachAllocation(
        [&] { return compute(circles, {.metric = metric}); },
        [&](const Diagram& diagram) { ASSERT_TRUE(diagram.edges == expected.edges) << static_cast<int>(metric); });
  }
}

/// Calls `failEachAllocation` with a function that gives the error `code` while memory lasts.
template <class Function>
void failEachAllocationBefore(ErrorCode code, Function function) {
  failEachAllocation(
      [&]() -> Result<ErrorCode> {
        const auto result = function();
        const ErrorCode found = result.ok() ? ErrorCode::internal : result.error().code;
        if (found == code) return found;
        return Error{found, -1, {}};
      },
      [](ErrorCode) {});
}

TEST(Allocation, MayFailInReadersOfCircles) {
  const auto circles = someCircles();
  for (const auto write : {writeCirclesCsv, writeCirclesJson, writeCirclesGeoJson}) {
    std::ostringstream text;
    ASSERT_TRUE(write(text, circles, {}));
    const std::string written = text.str();
    failEachAllocation([&] { return readCircles(written, "file"); },
                       [&](const std::vector<Circle>& read) { ASSERT_TRUE(read == circles); });
  }
  for (const char* text : {"", "a table without columns, but with words", "x,y,r\n1,2,\"", "[[1,2,3],[4,5]]",
                           R"({"type":"FeatureCollection","features":[{"type":"Feature"}]})"}) {
    failEachAllocationBefore(ErrorCode::badInput, [&] { return readCircles(text, "a name that is not short"); });
  }
  failEachAllocationBefore(ErrorCode::negativeRadius,
                           [&] { return readCircles("1,2,3\n1,2,-3", "a name that is not short"); });
}

TEST(Allocation, MayFailInTheReaderOfDiagrams) {
  const auto circles = someCircles();
  const Diagram diagram = compute(circles).value();
  std::ostringstream text;
  EXPECT_TRUE(writeJson(text, diagram));
  const std::string written = text.str();
  failEachAllocation([&] { return readDiagram(written, "file"); },
                     [&](const Diagram& read) { ASSERT_TRUE(read.edges == diagram.edges); });
  for (const char* bad : {"", R"({"format":"another format that is unknown here"})", R"({"circles":[{"x":1}]})"}) {
    failEachAllocationBefore(ErrorCode::badInput, [&] { return readDiagram(bad, "a name that is not short"); });
  }
}

TEST(Allocation, MayFailBeforeARefusal) {
  failEachAllocationBefore(ErrorCode::badOption, [] {
    return guarded([]() -> Result<int> {
      throw ThrownError{{ErrorCode::badOption, -1, "A message that is not short."}};
    });
  });
}

TEST(Allocation, MayFailInBoxes) {
  failEachAllocation([&] { return Region::from(Box{}); },
                     [](const Region& region) { ASSERT_EQ(region.sideCount(), 4U); });
  failEachAllocationBefore(ErrorCode::badOption, [&] { return Region::from(Box{1, 1, 0, 0}); });
}

}  // namespace
}  // namespace circle_voronoi
