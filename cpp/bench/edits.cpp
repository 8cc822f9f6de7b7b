// SPDX-License-Identifier: GPL-3.0-or-later
#include "edits.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <numeric>
#include <span>

#include "child.h"
#include "circle_voronoi/compute.h"
#include "circle_voronoi/editor.h"
#include "random.h"
#include "reference.h"

namespace circle_voronoi::bench {
namespace {

using Clock = std::chrono::steady_clock;
using Circles = std::vector<Circle>;

constexpr std::size_t kEdits = 10'000;
/// CGAL makes fewer edits, because they take longer.
constexpr std::size_t kReferenceEdits = 300;

double secondsSince(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

template <class T>
T valueOf(Result<T> result) {
  if (!result.ok()) {
    std::cerr << result.error().message << '\n';
    std::exit(1);
  }
  return std::move(result).value();
}

/// Percentiles of the times of single edits, in microseconds.
struct Times {
  double median = 0;
  double most = 0;  ///< the 99.9th percentile
};

Times timesOf(std::vector<double> seconds) {
  std::ranges::sort(seconds);
  const auto at = [&](double part) {
    return 1e6 * seconds[static_cast<std::size_t>(part * static_cast<double>(seconds.size() - 1))];
  };
  return {at(0.5), at(0.999)};
}

template <class Do>
Times timed(std::size_t count, Do edit) {
  std::vector<double> seconds;
  seconds.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto start = Clock::now();
    edit(i);
    seconds.push_back(secondsSince(start));
  }
  return timesOf(std::move(seconds));
}

void shuffle(auto& list, Random& random) {
  for (std::size_t i = list.size(); i > 1; --i) std::swap(list[i - 1], list[random.below(i)]);
}

/// A boustrophedon order: rows of squares in alternating directions, so that each circle is near the one before.
Circles inRows(Circles circles) {
  double low = circles[0].y;
  double high = low;
  for (const Circle& c : circles) {
    low = std::min(low, c.y);
    high = std::max(high, c.y);
  }
  const double rows = std::sqrt(static_cast<double>(circles.size()));
  const auto rowOf = [&](const Circle& c) {
    return static_cast<int>((c.y - low) / std::max(high - low, 1e-300) * rows);
  };
  std::ranges::stable_sort(circles, [&](const Circle& a, const Circle& b) {
    if (rowOf(a) != rowOf(b)) return rowOf(a) < rowOf(b);
    return rowOf(a) % 2 == 0 ? a.x < b.x : a.x > b.x;
  });
  return circles;
}

struct SingleEdits {
  Times moves;
  Times inserts;
  Times removals;
};

/// Moves of some circles by a hundredth of the distance to a nearby circle, insertions of other circles, and removals
/// of the inserted circles.
SingleEdits singleEdits(const EditInput& input, bool isNear) {
  DiagramEditor editor = valueOf(DiagramEditor::from(input.circles));
  Random random(1);
  Circles supply = input.supply;
  supply.resize(std::min(supply.size(), kEdits));
  std::vector<CircleId> moved(input.circles.size());
  std::iota(moved.begin(), moved.end(), 0);
  shuffle(moved, random);
  moved.resize(std::min(moved.size(), kEdits));
  if (isNear) {
    supply = inRows(std::move(supply));
    Circles places;
    for (const CircleId id : moved) places.push_back(input.circles[static_cast<std::size_t>(id)]);
    const Circles ordered = inRows(places);
    // Editors also find circles by position.
    for (std::size_t i = 0; i < ordered.size(); ++i) moved[i] = editor.nearest({ordered[i].x, ordered[i].y});
  }
  const double spacing = [&] {
    double low = input.circles[0].x;
    double high = low;
    for (const Circle& c : input.circles) {
      low = std::min(low, c.x);
      high = std::max(high, c.x);
    }
    return (high - low) / std::sqrt(static_cast<double>(input.circles.size()));
  }();
  SingleEdits result;
  result.moves = timed(moved.size(), [&](std::size_t i) {
    Circle c = *editor.circle(moved[i]);
    c.x += 0.01 * spacing;
    valueOf(editor.replace(moved[i], c));
  });
  std::vector<CircleId> inserted;
  result.inserts =
      timed(supply.size(), [&](std::size_t i) { inserted.push_back(valueOf(editor.insert(supply[i])).inserted[0]); });
  if (!isNear) shuffle(inserted, random);
  result.removals = timed(inserted.size(), [&](std::size_t i) { valueOf(editor.remove(inserted[i])); });
  return result;
}

void printTimes(const EditInput& input, const char* who, const char* what, Times times) {
  std::printf("%-14s %8zu  %-8s %-28s %10.2f %10.1f\n", input.family.c_str(), input.circles.size(), who, what,
              times.median, times.most);
  std::fflush(stdout);
}

void printSeconds(const EditInput& input, const std::string& what, double seconds, double reference,
                  const char* comparison) {
  std::printf("%-14s %8zu  %-37s %8.3f s, %.2f times %s\n", input.family.c_str(), input.circles.size(), what.c_str(),
              seconds, seconds / reference, comparison);
  std::fflush(stdout);
}

void printSingleEdits(const EditInput& input, unsigned limit) {
  for (const bool isNear : {true, false}) {
    const auto child = runInChild<SingleEdits>(limit, [&] { return singleEdits(input, isNear); });
    if (!child.value) continue;
    printTimes(input, "ours", isNear ? "insert, near the last" : "insert, anywhere", child.value->inserts);
    printTimes(input, "ours", isNear ? "remove, near the last" : "remove, anywhere", child.value->removals);
    printTimes(input, "ours", isNear ? "small move, near the last" : "small move, anywhere", child.value->moves);
  }
  const auto child = runInChild<SingleEdits>(limit, [&] {
    std::vector<double> inserts;
    std::vector<double> removals;
    const std::size_t count = std::min(kReferenceEdits, input.supply.size());
    reference::apolloniusEdits(input.circles, std::span(input.supply).first(count), inserts, removals);
    return SingleEdits{{}, timesOf(inserts), timesOf(removals)};
  });
  if (!child.value) return;
  printTimes(input, "CGAL", "insert, anywhere", child.value->inserts);
  printTimes(input, "CGAL", "remove, anywhere", child.value->removals);
}

struct Seconds {
  double ours = 0;
  double compute = 0;
};

/// The fastest of three turns each, so that other programs on the machine matter less.
template <class Ours>
Seconds inTurns(std::span<const Circle> circles, Ours ours) {
  Seconds least = {1e300, 1e300};
  for (int turn = 0; turn < 3; ++turn) {
    auto start = Clock::now();
    valueOf(compute(circles));
    least.compute = std::min(least.compute, secondsSince(start));
    least.ours = std::min(least.ours, ours());
  }
  return least;
}

void printFromNothing(const EditInput& input, unsigned limit) {
  const auto child = runInChild<Seconds>(limit, [&] {
    Random random(1);
    Circles circles = input.circles;
    shuffle(circles, random);
    return inTurns(circles, [&] {
      const auto start = Clock::now();
      DiagramEditor editor = valueOf(DiagramEditor::from({}));
      for (const Circle& c : circles) valueOf(editor.insert(c));
      return secondsSince(start);
    });
  });
  if (child.value) printSeconds(input, "all inserted one by one", child.value->ours, child.value->compute, "compute");
}

void printBatches(const EditInput& input, unsigned limit) {
  for (std::size_t count = 10; count <= input.circles.size(); count *= 10) {
    struct Batch {
      Seconds batch;
      double singles = 1e300;
    };
    const auto child = runInChild<Batch>(limit, [&] {
      Random random(1);
      std::vector<Edit> edits;
      for (std::size_t i = 0; i < count; ++i) {
        const auto id = static_cast<CircleId>(static_cast<int>(random.below(input.circles.size())));
        const Circle& to = input.supply[i % input.supply.size()];
        edits.push_back({Edit::Kind::replace, id, to});
      }
      Batch result;
      result.batch = inTurns(input.circles, [&] {
        DiagramEditor editor = valueOf(DiagramEditor::from(input.circles));
        const auto start = Clock::now();
        valueOf(editor.apply(edits));
        return secondsSince(start);
      });
      DiagramEditor editor = valueOf(DiagramEditor::from(input.circles));
      const auto start = Clock::now();
      for (const Edit& edit : edits) valueOf(editor.apply({&edit, 1}));
      result.singles = secondsSince(start);
      return result;
    });
    if (!child.value) continue;
    const std::string what = "a batch of " + std::to_string(count) + " jumps";
    printSeconds(input, what, child.value->batch.ours, child.value->batch.compute, "compute");
    printSeconds(input, what, child.value->batch.ours, child.value->singles, "single edits");
  }
}

/// An edit that changes much of a diagram at once, or its scale.
struct WorstEdit {
  const char* what;
  Circles circles;
  Edit edit;
};

/// The edits of scripts/bench-edits.mjs.
std::vector<WorstEdit> worstEdits(const Circles& circles) {
  Point low = {circles[0].x, circles[0].y};
  Point high = low;
  for (const Circle& c : circles) {
    low = {std::min(low.x, c.x), std::min(low.y, c.y)};
    high = {std::max(high.x, c.x), std::max(high.y, c.y)};
  }
  const double side = std::max(high.x - low.x, high.y - low.y);
  const Point middle = {(low.x + high.x) / 2, (low.y + high.y) / 2};
  const auto disc = [&](double radius) { return Circle{middle.x, middle.y, radius * side}; };
  const auto with = [](Circles list, const Circle& circle) {
    list.push_back(circle);
    return list;
  };
  const Circle ofAll = disc(1);
  const Circle ofASixth = disc(0.23);
  const Circle moved = {ofASixth.x + ofASixth.r / 50, ofASixth.y, ofASixth.r};
  // A fifth of the circles become points around one circle, and the others move aside.
  Circles around = circles;
  for (std::size_t i = 0; i < around.size(); ++i) {
    const auto angle = static_cast<double>(i);
    if (i % 5 == 0) {
      around[i] = {middle.x + side * std::cos(angle), middle.y + side * std::sin(angle), 0};
    } else {
      around[i].x += 3 * side;
    }
  }
  const auto last = static_cast<CircleId>(static_cast<int>(circles.size()));
  const auto inserted = [](const Circle& circle) { return Edit{Edit::Kind::insert, kNone, circle}; };
  const auto replaced = [&](const Circle& circle) { return Edit{Edit::Kind::replace, last, circle}; };
  const Edit removed = {Edit::Kind::remove, last, {}};
  return {{"insert a point at 1e28", circles, inserted({1e28, 0, 0})},
          {"insert one that hides all", circles, inserted(ofAll)},
          {"shrink one that hides all", with(circles, ofAll), replaced(disc(1e-6))},
          {"insert one that hides a sixth", circles, inserted(ofASixth)},
          {"nudge one that hides a sixth", with(circles, ofASixth), replaced(moved)},
          {"remove one that hides a sixth", with(circles, ofASixth), removed},
          {"remove a neighbor of a fifth", with(around, disc(0.5)), removed}};
}

/// The time of `compute` is the longer of its times before and after the edit.
void printWorstEdits(const EditInput& input, unsigned limit) {
  for (const WorstEdit& worst : worstEdits(input.circles)) {
    const auto child = runInChild<Seconds>(limit, [&] {
      Circles after;
      const Seconds before = inTurns(worst.circles, [&] {
        DiagramEditor editor = valueOf(DiagramEditor::from(worst.circles));
        const auto start = Clock::now();
        valueOf(editor.apply({&worst.edit, 1}));
        const double seconds = secondsSince(start);
        after = editor.circles();
        return seconds;
      });
      const Seconds computed = inTurns(after, [] { return 0.0; });
      return Seconds{before.ours, std::max(before.compute, computed.compute)};
    });
    if (child.value) printSeconds(input, worst.what, child.value->ours, child.value->compute, "compute");
  }
}

void printMemory(const EditInput& input, unsigned limit) {
  const auto nothing = runInChild<bool>(limit, [] { return true; });
  const auto computing = runInChild<bool>(limit, [&] { return !valueOf(compute(input.circles)).edges.empty(); });
  const auto editing = runInChild<bool>(limit, [&] {
    DiagramEditor editor = valueOf(DiagramEditor::from(input.circles));
    for (std::size_t i = 0; i < 1000 && i < input.supply.size(); ++i) valueOf(editor.insert(input.supply[i]));
    return true;
  });
  const double ours = editing.megabytes - nothing.megabytes;
  std::printf("%-14s %8zu  %-37s %8.0f MB, %.2f times compute\n", input.family.c_str(), input.circles.size(),
              "an editor, at its peak", ours, ours / (computing.megabytes - nothing.megabytes));
}

}  // namespace

void printEdits(const EditInput& input, unsigned limitSeconds) {
  printSingleEdits(input, limitSeconds);
  printFromNothing(input, limitSeconds);
  printBatches(input, limitSeconds);
  printWorstEdits(input, limitSeconds);
  printMemory(input, limitSeconds);
}

}  // namespace circle_voronoi::bench
