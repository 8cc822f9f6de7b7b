// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "at.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/editor.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/limits.h"
#include "dual.h"
#include "dual_keeper.h"
#include "face_discs.h"
#include "id_table.h"
#include "insert_cell.h"
#include "number_pool.h"
#include "predicates.h"
#include "proof.h"
#include "report_faces.h"
#include "rounded.h"

namespace circle_voronoi {

/// The data that an editor keeps about the circle in a slot, besides the circle itself. A hidden circle is in the list
/// of one visible circle that contains it.
struct Slot {
  CircleId id;              ///< kNone if the slot is free
  int hider = kNone;        ///< for a hidden circle, the slot in whose list it is
  int firstHidden = kNone;  ///< for a visible circle, the first slot in its list
  int next = kNone;
  int previous = kNone;

  friend bool operator==(const Slot&, const Slot&) = default;
};

/// The numbers of circles by size: those with a number from kSmallestInput up, and those without one that are not all
/// 0.
struct SizeCounts {
  int large = 0;
  int small = 0;

  void add(const Circle& circle, int times) {
    const double largest = largestNumber(circle);
    (largest >= kSmallestInput ? large : small) += largest > 0 ? times : 0;
  }
  /// Returns whether `compute` refuses such circles (limits.h).
  bool areTooSmall() const { return large == 0 && small > 0; }
};

/// The whole diagram of an editor, and a log to undo the changes since its last commit.
///
/// Circles are in slots, rounded (limits.h). Vertices are faces of the dual, including those at infinity. Free numbers
/// are reused, so that arrays have few gaps. Announce a change of a face or a slot before you make it.
class EditState final : public DualKeeper {
 public:
  EditState() : predicates(circles), discs(circles, dual, predicates) {}
  EditState(const EditState&) = delete;
  EditState& operator=(const EditState&) = delete;

  // For each slot.
  std::vector<Circle> circles;
  std::vector<Slot> slots;
  std::vector<char> hasNoCell;  ///< whether the circle is hidden or the slot is free
  std::vector<int> edgeOf;      ///< for a visible circle, a half-edge that starts from it, if there is one

  // For each face or half-edge.
  Dual dual;  ///< of the visible circles; a face that is not in use has no twins
  Predicates predicates;
  FaceDiscs discs;
  std::vector<HalfEdgeProof> proof;
  std::vector<int> edgeNumber;  ///< the same for both halves; kNone at infinity

  bool weights = false;  ///< whether radii are additive weights
  int threads = 1;       ///< EditorOptions::threads
  IdTable ids;
  CircleId nextId = 0;
  int circleCount = 0;
  int visibleCount = 0;
  int faceCount = 0;
  SizeCounts sizes;
  /// Reports the faces that change to an observer, if there is one.
  FaceReporter* reporter = nullptr;
  NumberPool faceNumbers;
  NumberPool slotNumbers;
  NumberPool edgeNumbers;

  bool isVisible(int slot) const { return slots[at(slot)].id != kNone && !hasNoCell[at(slot)]; }
  bool isInUse(int face) const { return dual.twin[at(3 * face)] != kNone; }
  /// Returns whether a face is a vertex of the diagram.
  bool isVertex(int face) const { return isInUse(face) && dual.isFinite(face); }
  /// Returns whether a half-edge represents an edge of the diagram. One of two twins does, and its origin is the left
  /// circle.
  bool isEdge(int h) const {
    return isInUse(h / 3) && h < dual.twin[at(h)] && dual.origin[at(h)] != kPointAtInfinity &&
           dual.target(h) != kPointAtInfinity;
  }
  /// Returns whether one circle hides another, that is, contains it. If two circles are identical, the lower id hides
  /// the other.
  bool hides(int slot, int other) {
    return predicates.contains(circles[at(slot)], circles[at(other)]) &&
           !(circles[at(slot)] == circles[at(other)] && slots[at(slot)].id > slots[at(other)].id);
  }
  CircleId idOf(int corner) const { return corner == kPointAtInfinity ? CircleId() : slots[at(corner)].id; }
  LiveDual live() { return {dual, discs, edgeOf, hasNoCell, *this}; }

  // --- changes ---

  int addFace() override;
  void removeFace(int face) override;
  void willChange(int face) override;
  void willHide(int slot) override { willChangeSlot(slot); }
  void replaceEdge(int, int) override {}
  void dropEdge(int) override {}
  void willChangeSlot(int slot);

  void noteEdge(int h) {
    if (dual.origin[at(h)] != kPointAtInfinity) edgeOf[at(dual.origin[at(h)])] = h;
  }

  // A circle that is neither in a list nor in the dual counts as hidden.

  /// Returns whether an id belongs to a circle that was removed before the last commit.
  bool isFormer(CircleId id) const { return id >= 0 && id < nextId && ids.slotOf(id) == kNone; }
  /// Adds a circle with a former id, or with a new one for kNone. Returns its slot.
  int addSlot(const Circle& circle, CircleId id);
  void removeSlot(int slot);
  /// Changes the circle in a slot.
  void setCircle(int slot, const Circle& circle);
  /// Puts a circle into the list of a visible circle that contains it.
  void attach(int slot, int hider);
  /// Takes a hidden circle out of its list.
  void detach(int slot);

  // --- taking back ---

  struct SavedFace {
    int face;
    int before;  ///< the place in the log where the face was saved before, or kNone
    std::array<int, 3> origin;
    std::array<int, 3> twin;
    std::array<int, 3> edgeNumber;
    std::array<HalfEdgeProof, 3> proof;
    FaceDisc disc;
    bool isChanged = false;  ///< whether its corners or its disc have changed; set by judge and recorder

    bool wasInUse() const { return twin[0] != kNone; }
    bool wasVertex() const {
      return wasInUse() && origin[0] != kPointAtInfinity && origin[1] != kPointAtInfinity &&
             origin[2] != kPointAtInfinity;
    }
  };
  struct SavedSlot {
    int slot;
    int before;
    Slot data;
    Circle circle;
    char hasNoCell;

    bool wasVisible() const { return data.id != kNone && !hasNoCell; }
  };
  /// The former state of the parts that have changed since the last commit. Each step saves a face or slot at most
  /// once.
  std::vector<SavedFace> faceLog;
  std::vector<SavedSlot> slotLog;

  /// A state within the log that `rollBack` can return to.
  struct Mark {
    std::size_t faces;
    std::size_t slots;
    NumberPool::Mark faceNumbers;
    NumberPool::Mark slotNumbers;
    CircleId nextId;
    int circleCount;
    int visibleCount;
    int faceCount;
    SizeCounts sizes;
  };
  /// Begins a step: from now on, faces and slots are saved again before they change.
  Mark beginStep();
  void rollBack(const Mark& mark) noexcept;
  const SavedFace* savedInStep(int face) const { return find(faceLog, savedFaceAt_[at(face)], stepFaces_); }
  /// Returns a face in the committed state; null if it has not changed.
  const SavedFace* firstSaved(int face) const {
    int entry = savedFaceAt_[at(face)];
    while (entry != kNone && faceLog[at(entry)].before != kNone) entry = faceLog[at(entry)].before;
    return find(faceLog, entry, 0);
  }
  std::size_t stepFaces() const { return stepFaces_; }
  std::size_t stepSlots() const { return stepSlots_; }

  /// Sets `edgeOf` for all corners of the faces that have changed in this step.
  void noteEdges();

  /// Allocates the memory that `commit` needs.
  void prepareToCommit();
  /// Makes the current state the target of `rollBackAll`. Call `prepareToCommit` first.
  void commit() noexcept;
  void rollBackAll() noexcept;

  /// Resizes the arrays to hold all faces and slots that have numbers.
  void sizeToNumbers();

 private:
  void noteEdgesOf(int face) noexcept;

  template <class Saved>
  static const Saved* find(const std::vector<Saved>& log, int entry, std::size_t from) {
    return entry != kNone && at(entry) >= from ? &log[at(entry)] : nullptr;
  }

  std::vector<int> savedFaceAt_;  ///< for each face its last place in the log, or kNone
  std::vector<int> savedSlotAt_;
  std::size_t stepFaces_ = 0;
  std::size_t stepSlots_ = 0;
  Mark committed_ = beginStep();
};

}  // namespace circle_voronoi
