// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "circle_voronoi/circle.h"
#include "circle_voronoi/index.h"
#include "dual.h"
#include "dual_keeper.h"
#include "face_discs.h"
#include "id_table.h"
#include "insert_cell.h"
#include "places.h"
#include "predicates.h"
#include "tell_faces.h"

namespace circle_voronoi {

/// What an editor knows of the circle in a slot besides the circle itself. Those that are hidden are in a list of one
/// visible circle that contains them.
struct Site {
  std::int32_t id = kNone;  ///< kNone: the slot is free
  int hider = kNone;        ///< of a hidden circle the slot in whose list it is
  int firstHidden = kNone;  ///< of a visible one the first of its list
  int next = kNone;
  int previous = kNone;

  friend bool operator==(const Site&, const Site&) = default;
};

/// What the proof of a diagram keeps of a half-edge.
struct HalfEdgeProof {
  bool isLower = false;  ///< whether its disc lies in the lower half, seen from its origin
  bool passes = false;   ///< whether the region of its origin passes the axis along its edge (edge_turns.h)
};

/// A certified diagram in the making: all of it, and how to take back what has changed since it was last kept.
///
/// Circles are in slots, times 1 / unit; vertices are faces of the dual, those at infinity among them. A number that
/// becomes free is used again, so that arrays have few gaps. Whoever changes a face or a site says so before.
class EditState final : public DualKeeper {
 public:
  EditState() : predicates(circles), discs(circles, dual, predicates) {}
  EditState(const EditState&) = delete;
  EditState& operator=(const EditState&) = delete;

  // Of each slot.
  std::vector<Circle> circles;
  std::vector<Site> sites;
  std::vector<char> isHidden;
  std::vector<int> edgeOf;  ///< of a visible circle a half-edge that starts from it, if there is one

  // Of each face, or half-edge.
  Dual dual;  ///< of the visible circles; a face that is not in use has no twins
  Predicates predicates;
  FaceDiscs discs;
  std::vector<HalfEdgeProof> proof;
  std::vector<int> edgeNumber;  ///< the same of both halves; kNone at infinity

  double unit = 1;        ///< a circle of the input = one of `circles` * unit
  bool hasScale = false;  ///< whether a number of the input was not 0 when the unit was chosen
  /// The input, where a unit rounds some of it; else empty.
  std::vector<Circle> inexact;
  IdTable ids;
  std::int32_t nextId = 0;
  int circleCount = 0;
  int visibleCount = 0;
  int faceCount = 0;
  /// Who tells of the faces that change, if somebody does.
  FaceTeller* teller = nullptr;
  Places facePlaces;
  Places sitePlaces;
  Places edgePlaces;

  bool isVisible(int slot) const { return sites[slot].id != kNone && !isHidden[slot]; }
  bool isInUse(int face) const { return dual.twin[3 * face] != kNone; }
  /// Whether a face is a vertex of the diagram.
  bool isVertex(int face) const { return isInUse(face) && dual.isFinite(face); }
  /// Whether a half-edge is the one of its two that makes them an edge of the diagram: the left circle is its origin.
  bool isEdge(int h) const {
    return isInUse(h / 3) && h < dual.twin[h] && dual.origin[h] != kInfinity && dual.target(h) != kInfinity;
  }
  Circle inputOf(int slot) const {
    const Circle& c = circles[slot];
    return inexact.empty() ? Circle{c.x * unit, c.y * unit, c.r * unit} : inexact[slot];
  }
  /// Whether one circle hides another: it contains it, and of identical ones it has the lower id.
  bool hides(int slot, int other) {
    return predicates.contains(circles[slot], circles[other]) &&
           !(circles[slot] == circles[other] && sites[slot].id > sites[other].id);
  }
  std::int32_t idOf(int corner) const { return corner == kInfinity ? kNone : sites[corner].id; }
  LiveDual live() { return {dual, discs, edgeOf, isHidden, *this}; }

  // --- changes ---

  int addFace() override;
  void removeFace(int face) override;
  void willChange(int face) override;
  void willHide(int slot) override { willChangeSite(slot); }
  void replaceEdge(int, int) override {}
  void dropEdge(int) override {}
  void willChangeSite(int slot);

  void link(int h, int t) {
    dual.twin[h] = t;
    dual.twin[t] = h;
  }
  void noteEdge(int h) {
    if (dual.origin[h] != kInfinity) edgeOf[dual.origin[h]] = h;
  }

  // A circle that is in no list, nor in the dual, counts as hidden.

  /// A slot for a circle with a new id.
  int addSite(const Circle& scaled);
  void removeSite(int slot);
  /// Puts a circle into the list of one that contains it, or takes it out.
  void attach(int slot, int hider);
  void detach(int slot);

  // --- taking back ---

  struct SavedFace {
    int face;
    int before;  ///< the place in the log where it was saved before, or kNone
    std::array<int, 3> origin;
    std::array<int, 3> twin;
    std::array<int, 3> edgeNumber;
    std::array<HalfEdgeProof, 3> proof;
    FaceDisc disc;
    bool isChanged = false;  ///< for the judge of the step: whether it has other corners, or another disc

    bool wasInUse() const { return twin[0] != kNone; }
    bool wasVertex() const {
      return wasInUse() && origin[0] != kInfinity && origin[1] != kInfinity && origin[2] != kInfinity;
    }
  };
  struct SavedSite {
    int slot;
    int before;
    Site site;
    Circle circle;
    char isHidden;

    bool wasVisible() const { return site.id != kNone && !isHidden; }
  };
  /// What has changed since the diagram was kept, in the state before: each face and each site once a step.
  std::vector<SavedFace> faceLog;
  std::vector<SavedSite> siteLog;

  /// A step begins: from now on all that changes is saved anew.
  struct Mark {
    std::size_t faces;
    std::size_t sites;
    Places::Mark facePlaces;
    Places::Mark sitePlaces;
    std::int32_t nextId;
    int circleCount;
    int visibleCount;
    int faceCount;
  };
  Mark beginStep();
  void takeBack(const Mark& mark) noexcept;
  const SavedFace* savedInStep(int face) const { return find(faceLog, savedFaceAt_[face], stepFaces_); }
  /// In the state that is kept; null if it has not changed.
  const SavedFace* firstSaved(int face) const {
    int at = savedFaceAt_[face];
    while (at != kNone && faceLog[at].before != kNone) at = faceLog[at].before;
    return find(faceLog, at, 0);
  }
  std::size_t stepFaces() const { return stepFaces_; }
  std::size_t stepSites() const { return stepSites_; }

  /// Of the faces that have changed in this step, all corners learn a half-edge again.
  void noteEdges();

  /// Makes all that has changed the state to come back to. `prepareToKeep` first: it takes what memory that needs.
  void prepareToKeep();
  void keep() noexcept;
  void takeAllBack() noexcept;

  /// Makes room for all faces and slots that the places count.
  void sizeToPlaces();

 private:
  void noteEdgesOf(int face) noexcept;

  template <class Saved>
  static const Saved* find(const std::vector<Saved>& log, int at, std::size_t from) {
    return at != kNone && static_cast<std::size_t>(at) >= from ? &log[static_cast<std::size_t>(at)] : nullptr;
  }

  std::vector<int> savedFaceAt_;  ///< of each face the last place in the log, or kNone
  std::vector<int> savedSiteAt_;
  std::size_t stepFaces_ = 0;
  std::size_t stepSites_ = 0;
  Mark kept_ = beginStep();
};

}  // namespace circle_voronoi
