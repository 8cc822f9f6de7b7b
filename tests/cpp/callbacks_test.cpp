// SPDX-License-Identifier: GPL-3.0-or-later
// Callbacks that call the library, replace themselves or throw. In the preset `sanitize`, sanitizers watch the memory.
#include <gtest/gtest.h>

#include <numeric>
#include <sstream>
#include <stdexcept>
#include <utility>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/compute_periodic.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/fit_areas.h"
#include "circle_voronoi/region.h"
#include "circle_voronoi_families/families.h"
#include "edit_script.h"
#include "trace_replay.h"

namespace circle_voronoi {
namespace {

using Circles = std::vector<Circle>;

const Circles& someCircles() {
  static const Circles circles = generate(Family::uniform, 40, 1);
  return circles;
}

DiagramEditor someEditor() { return DiagramEditor::from(someCircles()).value(); }

void observe(DiagramEditor& editor, Observer observer) { EXPECT_TRUE(editor.observe(std::move(observer)).ok()); }

void expectEditorIsRight(const DiagramEditor& editor) {
  EXPECT_EQ(test::differenceToTheBit(editor.snapshot().value(), compute(editor.circles()).value()), "");
}

/// Calls the library from a callback. The data of a callback die with it, so a callback that is destroyed while it
/// runs reads freed memory here.
struct Caller {
  std::vector<int> data = std::vector<int>(100, 1);

  void call() const {
    EXPECT_EQ(compute(someCircles()).value().circles, someCircles());
    DiagramEditor other = someEditor();
    EXPECT_TRUE(other.remove(3).ok());
    EXPECT_EQ(std::accumulate(data.begin(), data.end(), 0), 100);
  }
};

TEST(Callbacks, OfComputeMayCallTheLibrary) {
  const Diagram expected = compute(someCircles()).value();
  for (const Method method : {Method::automatic, Method::touchingDisc}) {
    int calls = 0;
    Options options;
    options.method = method;
    options.progress = [&calls, caller = Caller()](Stage, double) {
      if (++calls % 50 == 1) caller.call();
    };
    options.observer = [&calls, caller = Caller()](const TraceEvent&) {
      if (++calls % 50 == 1) caller.call();
    };
    EXPECT_EQ(compute(someCircles(), options).value().vertices.size(), expected.vertices.size());
    EXPECT_TRUE(computePeriodic(someCircles(), {{2000, 0}, {0, 2000}}, options).ok());
    EXPECT_GT(calls, 50);
  }
}

TEST(Callbacks, OfAFitMayCallTheLibrary) {
  const Circles sites = {{0.2, 0.2, 0}, {0.7, 0.3, 0}, {0.4, 0.8, 0}};
  const std::vector<double> areas(3, 1.0 / 3);
  const Region square = Region::from(Box{0, 0, 1, 1}).value();
  AreaFitOptions options;
  int calls = 0;
  options.onStep = [&calls, caller = Caller()](const AreaFitStep&) {
    ++calls;
    caller.call();
  };
  EXPECT_TRUE(fitAreas(sites, areas, square, options).ok());
  EXPECT_GT(calls, 1);
}

TEST(Callbacks, OfAWriterMayCallTheLibrary) {
  const Diagram diagram = compute(someCircles()).value();
  std::ostringstream plain;
  EXPECT_TRUE(writeGeoJson(plain, diagram).ok());
  ExportOptions options;
  int calls = 0;
  options.place = [&calls, caller = Caller()](Point p) {
    if (++calls % 500 == 1) caller.call();
    return p;
  };
  std::ostringstream out;
  EXPECT_TRUE(writeGeoJson(out, diagram, options).ok());
  EXPECT_GT(calls, 500);
  EXPECT_FALSE(out.str().empty());
}

TEST(Callbacks, AnObserverMayEndTheObservation) {
  for (const int last : {1, 2, 7, 100}) {
    DiagramEditor editor = someEditor();
    int calls = 0;
    observe(editor, [&, last, caller = Caller()](const TraceEvent&) {
      if (++calls != last) return;
      EXPECT_TRUE(editor.observe({}).ok());
      caller.call();
    });
    for (CircleId id = 0; id < 20; ++id) EXPECT_TRUE(editor.remove(id).ok());
    EXPECT_EQ(calls, last);
    expectEditorIsRight(editor);
  }
}

TEST(Callbacks, AnObserverMaySetAnotherOne) {
  for (const int last : {1, 2, 7, 100}) {
    DiagramEditor editor = someEditor();
    test::Replay replay;
    int calls = 0;
    int callsOfNext = 0;
    const Observer next = [&, caller = Caller()](const TraceEvent& event) {
      if (++callsOfNext == 1) {
        EXPECT_EQ(event.kind, TraceKind::roundBegun);
        caller.call();
      }
      replay.see(event);
    };
    observe(editor, [&, last, caller = Caller()](const TraceEvent&) {
      if (++calls != last) return;
      // The last of several counts.
      EXPECT_TRUE(editor.observe({}).ok());
      EXPECT_TRUE(editor.observe(next).ok());
      EXPECT_EQ(callsOfNext, 0);
      caller.call();
    });
    for (CircleId id = 0; id < 20; ++id) EXPECT_TRUE(editor.remove(id).ok());
    EXPECT_EQ(calls, last);
    replay.expectDiagram(editor.snapshot().value(), editor.ids());
  }
}

TEST(Callbacks, AnObserverThatThrowsIsReplacedAsItAsked) {
  DiagramEditor editor = someEditor();
  int callsOfNext = 0;
  EXPECT_THROW((void)editor.observe([&, caller = Caller()](const TraceEvent&) {
    EXPECT_TRUE(editor.observe([&](const TraceEvent&) { ++callsOfNext; }).ok());
    caller.call();
    throw std::runtime_error("mine");
  }),
               std::runtime_error);
  const int faces = callsOfNext;
  EXPECT_GT(faces, 40);
  EXPECT_TRUE(editor.remove(1).ok());
  EXPECT_GT(callsOfNext, faces);
}

TEST(Callbacks, AnObserverMustNotEditItsEditor) {
  DiagramEditor editor = someEditor();
  int refused = 0;
  const auto refuse = [&](const Result<Change>& change) {
    ASSERT_FALSE(change.ok());
    EXPECT_EQ(change.error().code, ErrorCode::badInput);
    EXPECT_EQ(change.error().message, "An observer must not edit the editor that calls it.");
    ++refused;
  };
  observe(editor, [&](const TraceEvent& event) {
    if (event.kind == TraceKind::faceMade || event.kind == TraceKind::faceRemoved) return;
    refuse(editor.insert({0, 0, 1}));
    refuse(editor.remove(2));
    refuse(editor.replace(2, {0, 0, 1}));
    refuse(editor.apply(std::vector<Edit>{{Edit::Kind::remove, 2, {}}}));
    // It sees the diagram after the edit.
    expectEditorIsRight(editor);
    EXPECT_EQ(editor.circle(1).has_value(), event.kind == TraceKind::roundBegun);
    EXPECT_NE(editor.nearest({0, 0}), kNone);
  });
  EXPECT_TRUE(editor.remove(1).ok());
  EXPECT_GE(refused, 8);
  EXPECT_EQ(editor.size(), 39U);
  expectEditorIsRight(editor);
}

TEST(Callbacks, AnObserverThatThrowsIsToldTheNextEdit) {
  DiagramEditor editor = someEditor();
  int calls = 0;
  observe(editor, [&](const TraceEvent& event) {
    ++calls;
    if (event.kind == TraceKind::circleRemoved) throw std::runtime_error("mine");
  });
  EXPECT_THROW((void)editor.remove(1), std::runtime_error);
  EXPECT_EQ(editor.size(), 39U);
  calls = 0;
  EXPECT_TRUE(editor.insert({0, 0, 1}).ok());
  EXPECT_GT(calls, 0);
  expectEditorIsRight(editor);
}

}  // namespace
}  // namespace circle_voronoi
