// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
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

namespace circle_voronoi {

/// The id of a circle in an editor, from 0. A new circle gets the next id. An id is never reused for another circle: a
/// circle that was removed can be inserted again under its id (Edit).
using CircleId = CircleIndex;

/// The way in which an edit was done. The result is certified in each case.
enum class EditWay {
  local,  ///< by changes around the circles concerned
  patch,  ///< where flips did not suffice, by splicing in a diagram of the circles around
  whole,  ///< by computing the whole diagram
};

/// A side that ends at infinity, and the side that follows it around its cell (Links::nextSide).
struct HullSide {
  SideIndex side;
  SideIndex next;

  friend bool operator==(const HullSide&, const HullSide&) = default;
};

/// The effect of an edit, or of a batch of edits, on a diagram.
///
/// In an editor, circles have ids, and each vertex and edge has a number that it keeps until it disappears. Here and in
/// SnapshotNumbers, a CircleId is an id, VertexIndex and EdgeIndex are such numbers, and side 2 e or 2 e + 1 belongs to
/// the edge with number e. An edge that gets another end is another edge, and a vertex of a circle that moves is
/// another vertex. Numbers are reused, so they stay below the largest numbers of vertices and edges that ever existed
/// at a time, plus a few for the hull.
///
/// To follow the diagram, take away what disappears, then put what appears into its place. Unbounded edges and the hull
/// are included. Circles and vertices have the same bits as in `snapshot`.
struct Change {
  EditWay way = EditWay::local;

  std::vector<CircleId> inserted;  ///< in the order of the edits
  std::vector<CircleId> removed;
  std::vector<CircleId> replaced;
  std::vector<Circle> circles;   ///< the inserted circles, then the new values of the replaced ones
  std::vector<CircleId> hidden;  ///< circles that lost their cell, or were inserted without one
  /// A hider for each circle in `hidden`, and for each circle whose hider has changed. If several visible circles
  /// contain it, this is the one the editor keeps it with; a `snapshot` names the largest.
  std::vector<HiddenCircle> hiders;
  std::vector<CircleId> shown;  ///< circles that were hidden and have a cell again
  std::vector<CircleId> cells;  ///< circles whose cells have another outline, including new cells

  std::vector<VertexIndex> removedVertices;
  std::vector<VertexIndex> addedVertices;
  std::vector<Vertex> vertices;  ///< of the added vertices
  std::vector<std::array<CircleId, 3>>
      vertexCircles;  ///< of the added vertices: counter-clockwise, the lowest id first

  std::vector<EdgeIndex> removedEdges;
  std::vector<EdgeIndex> addedEdges;
  std::vector<Edge> edges;  ///< of the added edges

  std::vector<HullSide> hullSides;  ///< the sides to infinity whose next side has changed
};

/// Maps the indices of a snapshot to ids and numbers.
struct SnapshotNumbers {
  std::vector<CircleId> circles;      ///< the id of each circle
  std::vector<VertexIndex> vertices;  ///< the number of each vertex
  std::vector<EdgeIndex> edges;       ///< the number of each edge
  std::vector<CircleId> hiders;       ///< for each hidden circle the one the editor keeps it with (Change::hiders)
};

/// One edit of a batch.
struct Edit {
  enum class Kind { insert, remove, replace };
  Kind kind = Kind::insert;
  /// For remove and replace; for insert, the id of a circle that was removed before the batch, or kNone for a new id.
  CircleId id = {};
  Circle circle;  ///< for insert and replace
};

struct EditorOptions {
  bool weights = false;  ///< whether radii are additive weights, which may be negative (Options::weights)
  /// The ids of the circles, in increasing order. If there are none, circle i gets id i.
  std::span<const CircleId> ids = {};
  /// The number of ids given out: those below it that no circle has are the ids of removed circles. At least one more
  /// than the largest id; kNone stands for that.
  CircleId nextId = kNone;
  /// The number of threads that may work at the same time while the whole diagram is computed: when the editor is made,
  /// and in large edits. 0 means one for each hardware thread. The result has the same bits for any number.
  int threads = 1;
};

/// A certified Voronoi diagram whose circles can be inserted, removed, moved and resized.
///
/// An edit changes its surroundings and leaves the rest alone. It takes microseconds, however many circles there are,
/// unless a cell that changes has many sides. Among many centers nearly on one line an edit may take longer: patches of
/// their diagram are computed anew, or the whole.
/// The editor certifies the changed parts (the judge of a step, ARCHITECTURE.md). An edit that hides or shows a large
/// share of the circles computes the whole diagram. An edit that fails, for lack of memory or for any other reason,
/// changes nothing.
///
/// A circle inside another one is hidden. It gets a cell when the other one no longer contains it.
///
/// The diagram does not depend on the edits that led to it. It equals the result of `compute`, even where more than
/// three circles touch one disc. The circles may be any that `compute` takes, and their numbers are rounded as there:
/// at most 2^96 (7.9e28) in absolute value, to multiples of 2^-96 (1.3e-29). An edit that leaves circles that `compute`
/// refuses is an error, also a removal: numbers that are not all 0 may not all be below 2^-56 (1.4e-17).
///
/// Only one thread at a time may use an editor, except that several threads may call const functions.
class CIRCLE_VORONOI_API DiagramEditor {
 public:
  /// Makes an editor. Errors: see `compute`; badOption if the ids, the next id or the number of
  /// threads do not fit.
  static Result<DiagramEditor> from(std::span<const Circle> circles, const EditorOptions& options = {});

  DiagramEditor(DiagramEditor&&) noexcept;
  DiagramEditor& operator=(DiagramEditor&&) noexcept;
  ~DiagramEditor();

  // Errors of the edits below: unknownCircle, and the errors of `compute`; tooManyCircles also if no id is left.
  // `Error::circle` is the id of the circle to blame, or kNone if the circle is new or no single circle is to blame.
  // `Error::edit` is the index of the edit to blame, or kNone if no single edit is to blame.

  /// Inserts a circle. Its id is `inserted[0]`. `hint` is a circle nearby, if you know one. By default the search
  /// starts at the circle that was edited last.
  Result<Change> insert(const Circle& circle, CircleId hint = kNone);
  Result<Change> remove(CircleId id);
  /// Moves or resizes a circle, or both.
  Result<Change> replace(CircleId id, const Circle& circle);
  /// Makes all of the edits, one after the other, or none. The change does not mention a circle that one edit inserts
  /// and a later one removes.
  Result<Change> apply(std::span<const Edit> edits);

  /// Sets an observer. It is first called for all faces, as a round, and then for each edit once that is done
  /// (trace.h). If an edit computes the whole diagram, a round with all faces begins. An empty observer ends this. An
  /// edit that runs out of memory does so, too. Errors: tooManyCircles if memory runs out.
  ///
  /// While the observer is called, the diagram is that after the edit. The observer may call const functions, and
  /// `observe`: once the call returns, the new observer replaces it and is called for all faces. An edit is the error
  /// badInput then. The observer must not move or destroy the editor. An exception of the observer passes through. The
  /// edit is then done, and the observer misses the rest of its events.
  Result<void> observe(const Observer& observer);

  /// Returns the circle with the smallest signed distance from p. If several are equally near up to rounding, returns
  /// one of them. Returns kNone if there are no circles or p is not finite. `hint` is a circle nearby, if you know one.
  [[nodiscard]] CircleId nearest(Point p, CircleId hint = kNone) const;

  /// Returns the number of circles, hidden ones included.
  [[nodiscard]] std::size_t size() const;
  /// Returns the circle with an id, with its original numbers; nothing if the id is unknown.
  [[nodiscard]] std::optional<Circle> circle(CircleId id) const;
  /// Returns whether a circle has no cell. Precondition: there is a circle with this id.
  [[nodiscard]] bool isHidden(CircleId id) const;
  /// Returns the ids of all circles, in increasing order.
  [[nodiscard]] std::vector<CircleId> ids() const;
  /// Returns the circles, in the order of `ids`.
  [[nodiscard]] std::vector<Circle> circles() const;

  /// Returns the change from an empty diagram to this one: all vertices and edges with their numbers. Linear time.
  Result<Change> all() const;
  /// Returns the diagram of `circles()`, as `compute` makes it except for the order of vertices and edges. Linear time.
  Result<Diagram> snapshot() const;
  /// Returns what the indices of `snapshot()` stand for, so that changes can be applied to its arrays. Linear time.
  Result<SnapshotNumbers> numbers() const;
  /// Judges the whole diagram once more. Like each edit, it is certified. Linear time.
  Result<Certificate> certificate() const;

 private:
  class Editor;
  explicit DiagramEditor(std::unique_ptr<Editor> editor);
  std::unique_ptr<Editor> editor_;
};

}  // namespace circle_voronoi
