// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/compute.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <limits>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi_families/families.h"
#include "compare.h"
#include "diagrams.h"
#include "oracle.h"

namespace circle_voronoi {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

Diagram diagramOf(const std::vector<Circle>& circles, Method method) {
  Options options;
  options.method = method;
  const Diagram diagram = test::diagramOf(circles, options);
  EXPECT_EQ(test::structureProblem(diagram, circles.size()), "");
  EXPECT_TRUE(diagram.certificate.certified()) << diagram.certificate.message;
  return diagram;
}

/// Properties of every method.
class Compute : public testing::TestWithParam<Method> {
 protected:
  Diagram diagramOf(const std::vector<Circle>& circles) const { return circle_voronoi::diagramOf(circles, GetParam()); }
};

std::string nameOfMethodTest(const testing::TestParamInfo<Method>& method) {
  constexpr const char* kNames[] = {"automatic", "touchingDisc", "flip"};
  return kNames[static_cast<int>(method.param)];
}

INSTANTIATE_TEST_SUITE_P(Methods, Compute, testing::Values(Method::automatic, Method::touchingDisc, Method::flip),
                         nameOfMethodTest);

TEST_P(Compute, NoCircleHasAnEmptyDiagram) {
  const Diagram diagram = diagramOf({});
  EXPECT_TRUE(diagram.vertices.empty() && diagram.edges.empty() && diagram.hull.empty());
}

TEST_P(Compute, OneCircleIsTheHullAndHasNoEdge) {
  const Diagram diagram = diagramOf({{1, 2, 3}});
  EXPECT_TRUE(diagram.vertices.empty() && diagram.edges.empty());
  EXPECT_EQ(diagram.hull, std::vector<CircleIndex>{0});
}

TEST_P(Compute, TwoCirclesShareOneUnboundedEdge) {
  const Diagram diagram = diagramOf({{0, 0, 1}, {5, 0, 2}});
  EXPECT_TRUE(diagram.vertices.empty());
  ASSERT_EQ(diagram.edges.size(), 1U);
  EXPECT_EQ(diagram.edges[0].start, kNone);
  EXPECT_EQ(diagram.edges[0].end, kNone);
  EXPECT_EQ(diagram.hull.size(), 2U);
}

TEST_P(Compute, ThreeCirclesShareOneVertex) {
  const Diagram diagram = diagramOf({{0, 0, 1}, {6, 0, 1}, {0, 8, 1}});
  ASSERT_EQ(diagram.vertices.size(), 1U);
  EXPECT_DOUBLE_EQ(diagram.vertices[0].x, 3);
  EXPECT_DOUBLE_EQ(diagram.vertices[0].y, 4);
  EXPECT_DOUBLE_EQ(diagram.vertices[0].r, 4);
  EXPECT_EQ(diagram.vertexCircles[0], (std::array<CircleIndex, 3>{0, 1, 2}));
  EXPECT_EQ(diagram.edges.size(), 3U);
}

TEST_P(Compute, ASmallCircleBetweenTwoLargeOnesHasACellWithTwoEdges) {
  const Diagram diagram = diagramOf({{-5, 0, 4}, {5, 0, 4}, {0, 0, 0.1}});
  EXPECT_EQ(diagram.vertices.size(), 2U);
  EXPECT_EQ(diagram.edges.size(), 4U) << "two for the small circle, and two that the large ones share";
}

TEST_P(Compute, CollinearCentersHaveParallelEdgesAndAHullThereAndBack) {
  const Diagram diagram = diagramOf({{0, 0, 1}, {3, 3, 1}, {6, 6, 1}, {9, 9, 1}});
  EXPECT_TRUE(diagram.vertices.empty());
  EXPECT_EQ(diagram.edges.size(), 3U);
  EXPECT_EQ(diagram.hull.size(), 6U) << "there and back";
}

TEST_P(Compute, OfIdenticalCirclesTheFirstStaysVisible) {
  const Diagram diagram = diagramOf({{0, 0, 1}, {0, 0, 1}, {4, 0, 1}, {0, 0, 1}});
  EXPECT_EQ(diagram.hidden, (std::vector<HiddenCircle>{{1, 0}, {3, 0}}));
}

TEST_P(Compute, ContainedAndInternallyTangentCirclesAreHidden) {
  const Diagram diagram = diagramOf({{0, 0, 1}, {0, 0, 4}, {3, 0, 1}, {1, 0, 0}, {9, 0, 1}});
  EXPECT_EQ(diagram.hidden, (std::vector<HiddenCircle>{{0, 1}, {2, 1}, {3, 1}}));
}

TEST_P(Compute, ACircleThatReachesOutOfAnotherIsVisible) {
  EXPECT_TRUE(diagramOf({{0, 0, 4}, {3, 0, 1.0000001}}).hidden.empty());
}

TEST_P(Compute, APointOnACircleIsHidden) {
  EXPECT_EQ(diagramOf({{0, 0, 5}, {3, 4, 0}}).hidden, (std::vector<HiddenCircle>{{1, 0}}));
}

TEST_P(Compute, MutuallyIntersectingCirclesHaveAVertexInside) {
  const Diagram diagram = diagramOf({{-1, 0, 2}, {1, 0, 2}, {0, 1.5, 2}});
  ASSERT_EQ(diagram.vertices.size(), 1U);
  EXPECT_LT(diagram.vertices[0].r, 0);
}

TEST_P(Compute, NegativeZeroIsZero) {
  EXPECT_EQ(diagramOf({{0, 0, 1}, {-0.0, -0.0, 1}, {3, 0, 1}}).hidden, (std::vector<HiddenCircle>{{1, 0}}));
}

TEST_P(Compute, TheLargestAndSmallestNumbersGiveTheSameVertex) {
  for (const double scale : {0x1p-54, 1e-9, 9e27}) {
    const Diagram diagram = diagramOf({{0, 0, scale}, {6 * scale, 0, scale}, {0, 8 * scale, scale}});
    ASSERT_EQ(diagram.vertices.size(), 1U) << scale;
    EXPECT_NEAR(diagram.vertices[0].x / scale, 3, 1e-15);
  }
}

struct BadCircle {
  Circle circle;
  ErrorCode code;
};

TEST_P(Compute, NamesTheFirstBadCircle) {
  const BadCircle kBadCircles[] = {
      {{kNan, 0, 1}, ErrorCode::nonFinite},          {{0, -kInfinite, 1}, ErrorCode::nonFinite},
      {{0, 0, kInfinite}, ErrorCode::nonFinite},     {{0, 0, -1e-300}, ErrorCode::negativeRadius},
      {{8e28, 0, 1}, ErrorCode::coordinateTooLarge}, {{0, -8e28, 1}, ErrorCode::coordinateTooLarge},
      {{0, 0, 8e28}, ErrorCode::coordinateTooLarge}};
  for (const auto& [circle, code] : kBadCircles) {
    const std::vector<Circle> circles = {{0, 0, 1}, {5, 0, 1}, circle, {kNan, kNan, kNan}};
    Options options;
    options.method = GetParam();
    const auto diagram = compute(circles, options);
    ASSERT_FALSE(diagram) << errorCodeName(code);
    EXPECT_EQ(diagram.error().code, code) << errorCodeName(code);
    EXPECT_EQ(diagram.error().circle, 2);
    EXPECT_NE(diagram.error().message.find("Circle 2 "), std::string::npos) << diagram.error().message;
  }
}

TEST(ComputeOptions, SamplesAreChecked) {
  struct Case {
    Candidates candidates;
    int samples;
    bool isGood;
  };
  const Case kCases[] = {{Candidates::dynamic, 0, true},   {Candidates::dynamic, kMaxSamples, true},
                         {Candidates::dynamic, -2, false}, {Candidates::dynamic, kMaxSamples + 1, false},
                         {Candidates::uniform, 0, false},  {Candidates::uniform, 1, true},
                         {Candidates::uniform, -1, false}};
  for (const auto& [candidates, samples, isGood] : kCases) {
    Options options;
    options.method = Method::touchingDisc;
    options.candidates = candidates;
    options.samples = samples;
    const auto diagram = compute(std::array{Circle{0, 0, 1}, Circle{5, 0, 1}}, options);
    EXPECT_EQ(diagram.ok(), isGood) << samples;
    if (!diagram) {
      EXPECT_EQ(diagram.error().code, ErrorCode::badOption);
    }
  }
}

TEST(ComputeOptions, AllPairsOfTooManyCirclesAreRefused) {
  Options options;
  options.method = Method::touchingDisc;
  options.candidates = Candidates::allPairs;
  std::vector<Circle> circles(kMaxAllPairsCircles + 1);
  const auto diagram = compute(circles, options);
  ASSERT_FALSE(diagram);
  EXPECT_EQ(diagram.error().code, ErrorCode::tooManyCircles);
  // The largest number of circles is accepted, so the computation begins.
  circles.pop_back();
  struct Begun {};
  options.progress = [](Stage, double) { throw Begun{}; };
  EXPECT_THROW(compute(circles, options), Begun);
}

std::vector<std::pair<std::string, double>> progressOf(const std::vector<Circle>& circles, Method method) {
  std::vector<std::pair<std::string, double>> told;
  Options options;
  options.method = method;
  options.progress = [&](Stage stage, double done) { told.emplace_back(stageName(stage), done); };
  EXPECT_TRUE(compute(circles, options));
  return told;
}

// Refused before anything is allocated: 32-bit indices would not do, and before memory ran out nobody could stop it.
TEST(ComputeOptions, SamplesBeyond32BitsAreRefused) {
  const auto circles = generate(Family::uniform, 60'000, 1);
  Options options;
  options.method = Method::touchingDisc;
  options.samples = kMaxSamples;
  const auto dynamic = compute(circles, options);
  ASSERT_FALSE(dynamic.ok());
  EXPECT_EQ(dynamic.error().code, ErrorCode::tooManyCircles);
  EXPECT_NE(dynamic.error().message.find("samples; at most 357913941 are possible"), std::string::npos)
      << dynamic.error().message;
  options.candidates = Candidates::uniform;
  const auto uniform = compute(generate(Family::uniform, 358'000, 1), options);
  ASSERT_FALSE(uniform.ok());
  EXPECT_EQ(uniform.error().code, ErrorCode::tooManyCircles);
}

// Insertion finds the hidden circles of this family and leaves its dual. The other methods still begin with a
// triangulation of the centers. Their results may be wrong, but their number of edges satisfies Euler's formula.
TEST(ComputeOptions, OtherMethodsTriangulateTheCentersAfterInsertionFoundTheHiddenCircles) {
  const auto circles = generate(Family::barelyOut, 3000, 1);
  for (const Method method : {Method::touchingDisc, Method::flip}) {
    Options options;
    options.method = method;
    EXPECT_NE(compute(circles, options).value().certificate.flaw, Flaw::eulerCount);
  }
}

TEST(ComputeOptions, ExceptionsOfCallbacksPassThrough) {
  struct Stop {
    int call;
  };
  const auto circles = generate(Family::mixed, 300, 1);
  for (const Method method : {Method::automatic, Method::touchingDisc, Method::flip}) {
    int calls = 0;
    int stopAt = std::numeric_limits<int>::max();
    Options options;
    options.method = method;
    options.progress = [&](Stage, double) {
      if (calls++ == stopAt) throw Stop{stopAt};
    };
    ASSERT_TRUE(compute(circles, options).ok());
    const int all = calls;
    ASSERT_GT(all, 2);
    for (stopAt = 0; stopAt < all; ++stopAt) {
      calls = 0;
      try {
        (void)compute(circles, options);
        ADD_FAILURE() << "call " << stopAt;
      } catch (const Stop& stop) {
        EXPECT_EQ(stop.call, stopAt);
      }
      EXPECT_EQ(calls, stopAt + 1) << "called again";
    }
  }
  Options options;
  options.method = Method::touchingDisc;
  int events = 0;
  options.observer = [&](const TraceEvent&) {
    if (++events == 100) throw std::bad_alloc();
  };
  // Not taken for an allocation of ours.
  EXPECT_THROW(compute(circles, options), std::bad_alloc);
  EXPECT_EQ(events, 100);
}

TEST(Compute, VerticesBeginWithTheirFirstCircle) {
  const Diagram diagram = compute(generate(Family::uniform, 100, 1)).value();
  for (const auto& triple : diagram.vertexCircles) EXPECT_EQ(triple[0], *std::ranges::min_element(triple));
}

// However many samples there are, a computation can be stopped while they are paired.
TEST(ComputeOptions, ProgressGrowsInLongStages) {
  struct Case {
    Candidates candidates;
    int samples;
    Stage stage;
    double mostStep;  ///< of the stage, between two calls
    std::size_t count = 2000;
  };
  for (const auto& [candidates, samples, stage, mostStep, count] :
       {Case{Candidates::dynamic, 100, Stage::sample, 1}, Case{Candidates::uniform, 100, Stage::sample, 1},
        Case{Candidates::dynamic, 50, Stage::pair, 0.1}, Case{Candidates::dynamic, 0, Stage::touch, 1, 10'000}}) {
    SCOPED_TRACE(std::string(stageName(stage)) + ", " + std::string(candidatesName(candidates)));
    Options options;
    options.method = Method::touchingDisc;
    options.candidates = candidates;
    options.samples = samples;
    std::vector<double> told;
    struct Enough {};
    options.progress = [&, last = stage](Stage now, double done) {
      if (now == last) told.push_back(done);
      if (now != last && !told.empty()) throw Enough{};
    };
    EXPECT_THROW(compute(generate(Family::uniform, count, 1), options), Enough);
    ASSERT_GT(told.size(), 1U);
    EXPECT_EQ(told.front(), 0);
    EXPECT_TRUE(std::ranges::is_sorted(told));
    EXPECT_LE(told.back(), 1);
    told.push_back(1);
    for (std::size_t i = 1; i < told.size(); ++i) EXPECT_LE(told[i] - told[i - 1], mostStep) << i;
  }
}

TEST(ComputeOptions, ProgressTellsEachStageAsItBegins) {
  using Told = std::vector<std::pair<std::string, double>>;
  const std::vector<Circle> circles = {{0, 0, 1}, {5, 0, 1}, {0, 5, 2}};
  EXPECT_EQ(progressOf(circles, Method::automatic),
            (Told{{"order", 0}, {"triangulate", 0}, {"flip", 0}, {"certify", 0}, {"assemble", 0}}));
  EXPECT_EQ(progressOf(circles, Method::touchingDisc), (Told{{"order", 0},
                                                             {"triangulate", 0},
                                                             {"sample", 0},
                                                             {"pair", 0},
                                                             {"touch", 0},
                                                             {"certify", 0},
                                                             {"assemble", 0}}));
}

// Insertion finds the hidden circles of this family, and its result is judged: each has its own stage.
TEST(ComputeOptions, ProgressNamesWhatAnInsertionDoes) {
  using Told = std::vector<std::pair<std::string, double>>;
  const auto circles = generate(Family::barelyOut, 3000, 1);
  EXPECT_EQ(progressOf(circles, Method::automatic),
            (Told{{"order", 0}, {"triangulate", 0}, {"flip", 0}, {"certify", 0}, {"triangulate", 0}, {"assemble", 0}}));
  const Seconds seconds = compute(circles).value().stats.seconds;
  EXPECT_GT(seconds.flip, 0);
  EXPECT_GT(seconds.certify, 0);
}

}  // namespace
}  // namespace circle_voronoi
