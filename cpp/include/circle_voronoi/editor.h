// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/certificate.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/point.h"
#include "circle_voronoi/trace.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// What a circle is called while it is there, from 0. A new circle gets the next number, which is never given again.
using CircleId = std::int32_t;

/// How an edit was done. Each is certified.
enum class EditWay {
  local,  ///< by flips around the circles concerned
  patch,  ///< where flips led astray, by a diagram of the circles around, spliced in
  whole,  ///< by computing everything
};

/// What an edge is in a Change: an arc of the bisector of two circles, between two vertices by number, kNone where it
/// is unbounded (Edge).
struct EditedEdge {
  CircleId left = kNone;
  CircleId right = kNone;
  std::int32_t start = kNone;
  std::int32_t end = kNone;

  friend bool operator==(const EditedEdge&, const EditedEdge&) = default;
};

/// A hidden circle, and a visible one that contains it: of several the one that it is kept with, where `snapshot` names
/// the largest.
struct EditedHider {
  CircleId circle = kNone;
  CircleId by = kNone;

  friend bool operator==(const EditedHider&, const EditedHider&) = default;
};

/// A side that goes to infinity, and the next one around its cell, which comes from there (Diagram::nextSide). Side 2 e
/// is that of the left circle of the edge with number e, 2 e + 1 that of the right one.
struct EditedSide {
  std::int32_t side = kNone;
  std::int32_t next = kNone;

  friend bool operator==(const EditedSide&, const EditedSide&) = default;
};

/// What an edit, or a batch, did to a diagram.
///
/// While an editor lives, each vertex and each edge has a number, which stays its own until it goes, and may then be
/// that of another: an edge with another end is another edge, and so is a vertex whose circle has moved. Numbers stay
/// below the most vertices and edges that there ever were at a time, and a few for the hull. Who takes away what goes,
/// then puts what comes into its place, has the diagram as it is now, unbounded edges and the hull included. Its
/// circles and vertices equal those of `snapshot` to the bit, at any scale.
struct Change {
  EditWay way = EditWay::local;

  std::vector<CircleId> inserted;  ///< in the order of the edits
  std::vector<CircleId> removed;
  std::vector<CircleId> replaced;
  std::vector<Circle> circles;      ///< those inserted, then those replaced, as they are now
  std::vector<CircleId> hidden;     ///< circles that no longer have a cell, or came without one
  std::vector<EditedHider> hiders;  ///< of each of those, and of each that another circle hides than before
  std::vector<CircleId> shown;      ///< circles that were hidden and have a cell again
  std::vector<CircleId> cells;      ///< circles whose cells have another outline, new ones included

  std::vector<std::int32_t> removedVertices;
  std::vector<std::int32_t> addedVertices;
  std::vector<Vertex> vertices;                        ///< of those added
  std::vector<std::array<CircleId, 3>> vertexCircles;  ///< of those added: counter-clockwise, the least first

  std::vector<std::int32_t> removedEdges;
  std::vector<std::int32_t> addedEdges;
  std::vector<EditedEdge> edges;  ///< of those added

  std::vector<EditedSide> hullSides;  ///< of sides to infinity that another follows than before
};

/// What the indices of a snapshot stand for.
struct SnapshotNumbers {
  std::vector<CircleId> circles;       ///< of each circle its id
  std::vector<std::int32_t> vertices;  ///< of each vertex its number
  std::vector<std::int32_t> edges;     ///< of each edge its number
  std::vector<CircleId> hiders;        ///< of each hidden circle the one that it is kept with (EditedHider)
};

/// One edit of a batch.
struct Edit {
  enum class Kind { insert, remove, replace };
  Kind kind = Kind::insert;
  CircleId id = kNone;  ///< of remove and replace
  Circle circle;        ///< of insert and replace
};

/// A certified Voronoi diagram whose circles come, go, move and grow.
///
/// An edit changes what is around it and leaves the rest: microseconds, however many circles there are. It is certified
/// by what it changes before it is believed (judge of a step, ARCHITECTURE.md). An edit that hides or shows a large
/// share of the circles computes everything. An edit that is refused, or for which there is no memory, changes nothing.
/// A circle inside another is hidden, and has a cell again when that goes.
///
/// The diagram does not depend on the edits that led to it: it is that of `compute`, where more than three circles
/// touch one disc as well. Circles may be anything that `compute` takes.
///
/// An editor is for one thread at a time; const functions of one may be called from several.
class DiagramEditor {
 public:
  /// Circle i gets id i. Errors are those of `compute`.
  static Result<DiagramEditor> from(std::span<const Circle> circles);

  DiagramEditor(DiagramEditor&&) noexcept;
  DiagramEditor& operator=(DiagramEditor&&) noexcept;
  ~DiagramEditor();

  // Errors: unknownCircle, and those of `compute`; `circle` is the index of the edit, -1 if it is none of one edit.
  // `hint`: a circle nearby, if one is known; what was edited last is one anyway.

  /// The new id is `inserted[0]`.
  Result<Change> insert(const Circle& circle, CircleId hint = kNone);
  Result<Change> remove(CircleId id);
  /// Moves or resizes a circle, or both.
  Result<Change> replace(CircleId id, const Circle& circle);
  /// All or none of the edits, one after the other. A circle that comes and goes in it is in no list.
  Result<Change> apply(std::span<const Edit> edits);

  /// Has `observer` told all faces now, as a round, and from then on what each edit does, once it is done (trace.h);
  /// an empty one ends that, as does an edit for which there is no memory. Circles are named by ids. Where everything
  /// is computed, a round begins with all faces. Whatever the observer throws passes through; the edit is done then. An
  /// error if there is no memory.
  std::optional<Error> observe(const Observer& observer);

  /// The circle of smallest signed distance, one of them up to rounding where several are; kNone if there is none.
  CircleId nearest(Point p, CircleId hint = kNone) const;

  /// How many circles there are, hidden ones included.
  std::size_t size() const;
  /// A circle as it was given; nothing if there is none with this id.
  std::optional<Circle> circle(CircleId id) const;
  /// Whether a circle has no cell. Precondition: there is one with this id.
  bool isHidden(CircleId id) const;
  /// The ids of all circles, in increasing order.
  std::vector<CircleId> ids() const;
  /// The circles, in the order of `ids`.
  std::vector<Circle> circles() const;

  /// What makes the diagram of nothing: all vertices and edges with their numbers. Linear time.
  Result<Change> all() const;
  /// The diagram of `circles()`, as `compute` makes it but for the order of vertices and edges: linear time.
  Result<Diagram> snapshot() const;
  /// What the indices of `snapshot()` stand for, so that changes can be applied to its arrays. Linear time.
  Result<SnapshotNumbers> numbers() const;
  /// All judged once more: linear time. It is certified, as each edit was.
  Result<Certificate> certificate() const;

 private:
  class Editor;
  explicit DiagramEditor(std::unique_ptr<Editor> editor);
  std::unique_ptr<Editor> editor_;
};

}  // namespace circle_voronoi
