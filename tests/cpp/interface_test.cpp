// SPDX-License-Identifier: GPL-3.0-or-later
// Properties that programs with the library rely on: results, errors, and indices as keys.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>
#include <sstream>
#include <streambuf>
#include <string>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "circle_voronoi/box.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/finder.h"
#include "circle_voronoi/io.h"
#include "circle_voronoi/method.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/tile.h"
#include "circle_voronoi_families/families.h"

namespace circle_voronoi {
namespace {

const std::vector<Circle> kCircles = {{0, 0, 1}, {6, 0, 1}, {0, 8, 1}, {0, 0, 0.5}};

TEST(Result, GivesTheValueItselfWhereTheResultIsATemporary) {
  static_assert(std::is_same_v<decltype(std::declval<Result<std::string>>().value()), std::string>);
  static_assert(std::is_same_v<decltype(*std::declval<Result<std::string>>()), std::string>);
  const auto& edges = compute(kCircles).value().edges;
  EXPECT_EQ(edges.size(), 3U);
  Result<std::unique_ptr<int>> owner = std::make_unique<int>(7);
  const std::unique_ptr<int> taken = *std::move(owner);
  EXPECT_EQ(*taken, 7);
}

TEST(Result, GivesAccessLikeAPointer) {
  auto diagram = compute(kCircles);
  ASSERT_TRUE(diagram);
  EXPECT_EQ(diagram->circles, kCircles);
  EXPECT_EQ(&*diagram, &diagram.value());
  diagram->circles.clear();
  EXPECT_TRUE(std::as_const(diagram)->circles.empty());
}

TEST(Result, HasAFallbackWhereThereIsAnError) {
  const Result<int> value = 3;
  const Result<int> error = Error{ErrorCode::badOption, kNone, "No."};
  EXPECT_EQ(value.value_or(5), 3);
  EXPECT_EQ(error.value_or(5), 5);
  EXPECT_EQ(Result<int>(error).value_or(6), 6);
}

TEST(Result, ThrowsWhereItIsMisused) {
  const Result<int> value = 3;
  const Result<int> error = Error{ErrorCode::badOption, kNone, "No."};
  EXPECT_THROW((void)error.value(), std::bad_variant_access);
  EXPECT_THROW((void)*error, std::bad_variant_access);
  EXPECT_THROW((void)error.operator->(), std::bad_variant_access);
  EXPECT_THROW((void)value.error(), std::bad_variant_access);
  EXPECT_THROW((void)Result<void>().error(), std::bad_variant_access);
}

TEST(Index, IsAKeyOfHashTables) {
  std::unordered_set<CircleIndex> circles;
  const auto diagram = compute(kCircles);
  for (const auto& triple : diagram->vertexCircles) circles.insert(triple.begin(), triple.end());
  EXPECT_EQ(circles, (std::unordered_set<CircleIndex>{0, 1, 2}));
  std::unordered_map<EdgeIndex, int> counts;
  ++counts[EdgeIndex(4)];
  ++counts[EdgeIndex(4)];
  EXPECT_EQ(counts.at(4), 2);
}

TEST(Method, NamesAreThoseOfTheValues) {
  EXPECT_EQ(methodName(Method::automatic), "auto");
  EXPECT_EQ(candidatesName(Candidates::allPairs), "all-pairs");
  EXPECT_EQ(wayName(Way::touchingDisc), "touching-disc");
  const auto expectAll = [](auto name, auto fromName, auto last) {
    int i = 0;
    for (; !name(static_cast<decltype(last)>(i)).empty(); ++i) {
      EXPECT_EQ(fromName(name(static_cast<decltype(last)>(i))), static_cast<decltype(last)>(i));
    }
    EXPECT_EQ(i, static_cast<int>(last) + 1);
    EXPECT_EQ(fromName("other"), std::nullopt);
  };
  expectAll(methodName, methodFromName, Method::flip);
  expectAll(candidatesName, candidatesFromName, Candidates::allPairs);
  expectAll(wayName, wayFromName, Way::edit);
}

TEST(Options, SamplesOfNoneAreThoseOfTheCandidates) {
  const auto circles = generate(Family::uniform, 20, 1);
  const auto samplesOf = [&](Candidates candidates, std::optional<int> samples) {
    Options options;
    options.method = Method::touchingDisc;
    options.candidates = candidates;
    options.samples = samples;
    return compute(circles, options)->stats.counts.samples;
  };
  EXPECT_EQ(samplesOf(Candidates::uniform, {}), samplesOf(Candidates::uniform, kDefaultUniformSamples));
  EXPECT_EQ(samplesOf(Candidates::dynamic, {}), samplesOf(Candidates::dynamic, kDefaultDynamicSamples));
  Options options;
  options.method = Method::touchingDisc;
  options.samples = -1;
  EXPECT_EQ(compute(circles, options).error().code, ErrorCode::badOption);
}

TEST(Region, IsMadeOfABoxOnlyIfItIsOne) {
  static_assert(!std::is_constructible_v<Region, Box>);
  EXPECT_EQ(Region::from(Box{0, 0, 2, 1})->area(), 2);
  EXPECT_EQ(Region::from(Box{-0x1p100, -0x1p100, 0x1p100, 0x1p100})->area(), 0x1p202);
  for (const Box& box : {Box{0, 0, 0, 1}, Box{0, 1, 1, 0}, Box{0, 0, NAN, 1}, Box{0, 0, 1, INFINITY}}) {
    EXPECT_EQ(Region::from(box).error().code, ErrorCode::badOption);
  }
}

TEST(Finder, CanBeMoved) {
  const Diagram diagram = compute(kCircles).value();
  Finder finder(diagram);
  std::vector<Finder> finders;
  finders.push_back(std::move(finder));
  EXPECT_EQ(finders[0].find({7, 0}), 1);
}

/// A stream that fails after a number of characters.
class Full : public std::streambuf {
 public:
  explicit Full(std::streamsize room) : room_(room) {}

 protected:
  std::streamsize xsputn(const char*, std::streamsize size) override {
    const std::streamsize taken = std::min(size, room_);
    room_ -= taken;
    return taken;
  }
  int_type overflow(int_type) override { return traits_type::eof(); }

 private:
  std::streamsize room_;
};

/// Each writer, of one diagram.
std::vector<std::function<Result<void>(std::ostream&)>> writers(const Diagram& diagram) {
  using Export = Result<void> (*)(std::ostream&, const Diagram&, const ExportOptions&);
  std::vector<std::function<Result<void>(std::ostream&)>> all;
  for (const Export write :
       {Export{writeSvg}, Export{writeGeoJson}, Export{writeGeoJsonLines}, Export{writeWkt}, Export{writeObj}}) {
    all.emplace_back([&, write](std::ostream& out) { return write(out, diagram, {}); });
  }
  for (const auto write : {writeJson, writeDiagramCsv}) {
    all.emplace_back([&, write](std::ostream& out) { return write(out, diagram, {}); });
  }
  for (const auto write : {writeCirclesCsv, writeCirclesJson, writeCirclesGeoJson}) {
    all.emplace_back([&, write](std::ostream& out) { return write(out, diagram.circles, {}); });
  }
  all.emplace_back([&](std::ostream& out) { return writeStatsJson(out, diagram); });
  all.emplace_back([&](std::ostream& out) { return writePartsCsv(out, diagram, {}); });
  all.emplace_back([&](std::ostream& out) {
    const std::vector<std::uint8_t> chosen(diagram.circles.size(), 1);
    const std::vector<std::int64_t> ids = {0, 1, 2, 3};
    return writeTile(out, {diagram.circles, ids, chosen}, chosen);
  });
  return all;
}

TEST(Writers, SayThatTheStreamIsFull) {
  const Diagram diagram = compute(kCircles).value();
  for (const auto& write : writers(diagram)) {
    std::ostringstream whole;
    ASSERT_TRUE(write(whole));
    for (const std::streamsize room : {std::streamsize{0}, static_cast<std::streamsize>(whole.str().size()) - 1}) {
      Full full(room);
      std::ostream out(&full);
      const auto written = write(out);
      ASSERT_FALSE(written);
      EXPECT_EQ(written.error().code, ErrorCode::notWritten);
    }
  }
}

TEST(Writers, LetTheExceptionsOfTheStreamThrough) {
  const Diagram diagram = compute(kCircles).value();
  for (const auto& write : writers(diagram)) {
    Full full(1);
    std::ostream out(&full);
    out.exceptions(std::ios::badbit);
    EXPECT_THROW((void)write(out), std::ios_base::failure);
  }
}

/// The code of the error that a writer gives, which has written nothing.
template <class Write>
ErrorCode refusalOf(Write write) {
  std::ostringstream out;
  const Result<void> written = write(out);
  EXPECT_EQ(out.str(), "");
  return written ? ErrorCode::internal : written.error().code;
}

TEST(Writers, RefuseOptionsOutOfRange) {
  const Diagram diagram = compute(kCircles).value();
  const auto refusal = [&](const ExportOptions& options) {
    return refusalOf([&](std::ostream& out) { return writeWkt(out, diagram, options); });
  };
  for (const Box& box : {Box{1, 0, 1, 2}, Box{0, 2, 1, 0}, Box{NAN, 0, 1, 1}, Box{0, 0, 1.3e30, 1}}) {
    EXPECT_EQ(refusal({.bounds = box}), ErrorCode::badOption);
  }
  for (const double tolerance : {0.0, -1.0, double{NAN}, double{INFINITY}}) {
    EXPECT_EQ(refusal({.tolerance = tolerance}), ErrorCode::badOption);
  }
  for (const double distance : {double{NAN}, double{-INFINITY}, 1.3e30}) {
    EXPECT_EQ(refusal({.maxDistance = distance}), ErrorCode::badOption);
  }
  EXPECT_EQ(refusal({.digits = -1}), ErrorCode::badOption);
  const Region region = Region::from(Box{0, 0, 1, 1}).value();
  EXPECT_EQ(refusal({.bounds = Box{0, 0, 1, 1}, .region = &region}), ErrorCode::badOption);
  for (const auto write : {writeJson, writeDiagramCsv}) {
    EXPECT_EQ(refusalOf([&](std::ostream& out) { return write(out, diagram, -1); }), ErrorCode::badOption);
  }
  const PeriodicDiagram periodic = computePeriodic(kCircles, {{9, 0}, {0, 9}}).value();
  EXPECT_EQ(refusalOf([&](std::ostream& out) { return writePeriodicJson(out, periodic, -1); }), ErrorCode::badOption);
  EXPECT_EQ(refusalOf([&](std::ostream& out) { return writeContactsCsv(out, periodic, -1); }), ErrorCode::badOption);
  for (const auto write : {writePeriodicSvg, writePeriodicGeoJson, writePeriodicGeoJsonLines}) {
    for (const ExportOptions& options :
         {ExportOptions{.bounds = Box{0, 0, 1, 1}}, ExportOptions{.region = &region}, ExportOptions{.maxDistance = 1},
          ExportOptions{.tolerance = 0}, ExportOptions{.digits = -1}}) {
      EXPECT_EQ(refusalOf([&](std::ostream& out) { return write(out, periodic, options); }), ErrorCode::badOption);
    }
  }
  for (const double pixels : {0.0, -1.0, double{NAN}, double{INFINITY}}) {
    SvgFigure figure;
    figure.pixels = pixels;
    EXPECT_EQ(refusalOf([&](std::ostream& out) { return writeSvgFigure(out, diagram, figure); }), ErrorCode::badOption);
  }
}

TEST(Writers, RefuseDiagramsAndListsThatDoNotFitTogether) {
  Diagram diagram = compute(kCircles).value();
  const std::vector<std::uint8_t> few(2, 1);
  const std::vector<std::int64_t> many = {0, 1, 2, 3, 4};
  for (const Selection& selection : {Selection{{}, few}, Selection{many, {}}}) {
    EXPECT_EQ(refusalOf([&](std::ostream& out) { return writePartsCsv(out, diagram, selection); }),
              ErrorCode::badInput);
    EXPECT_EQ(refusalOf([&](std::ostream& out) { return writePartsGeoJsonLines(out, diagram, selection); }),
              ErrorCode::badInput);
  }
  const std::vector<std::uint8_t> all(kCircles.size(), 1);
  const std::vector<std::int64_t> ids(many.begin(), many.end() - 1);
  const auto refusalOfTile = [](const Tile& tile, const std::vector<std::uint8_t>& chosen) {
    return refusalOf([&](std::ostream& out) { return writeTile(out, tile, chosen); });
  };
  EXPECT_EQ(refusalOfTile({kCircles, {}, all}, all), ErrorCode::badInput);
  EXPECT_EQ(refusalOfTile({kCircles, ids, {}}, all), ErrorCode::badInput);
  EXPECT_EQ(refusalOfTile({kCircles, ids, all}, few), ErrorCode::badInput);
  const std::vector<Circle> invalid = {{NAN, 0, 1}};
  EXPECT_EQ(refusalOf([&](std::ostream& out) { return writeCirclesCsv(out, invalid); }), ErrorCode::nonFinite);
  diagram.certificate.flaw = Flaw::cellNotClosed;
  EXPECT_EQ(refusalOf([&](std::ostream& out) { return writeSvg(out, diagram); }), ErrorCode::notCertified);
  EXPECT_EQ(refusalOf([&](std::ostream& out) { return writeGeoJsonLines(out, diagram); }), ErrorCode::notCertified);
  diagram.vertexCircles.pop_back();
  for (const auto write : {writeJson, writeDiagramCsv}) {
    EXPECT_EQ(refusalOf([&](std::ostream& out) { return write(out, diagram, {}); }), ErrorCode::badInput);
  }
}

}  // namespace
}  // namespace circle_voronoi
