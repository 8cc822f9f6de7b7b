// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/editor.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "at.h"
#include "build_state.h"
#include "certify_circles.h"
#include "change_record.h"
#include "guarded.h"
#include "snapshot.h"
#include "sort_unique.h"
#include "step.h"
#include "validate.h"

namespace circle_voronoi {
namespace {

Error unknownCircle(CircleId id, std::size_t edit) {
  return {ErrorCode::unknownCircle, id, "There is no circle with id " + std::to_string(id) + ".",
          static_cast<std::int64_t>(edit)};
}

Error notFormer(CircleId id, std::size_t edit) {
  return {ErrorCode::unknownCircle, id, "There is no removed circle with id " + std::to_string(id) + ".",
          static_cast<std::int64_t>(edit)};
}

/// Returns the ids of the circles that an editor starts with, or an error.
Result<std::vector<CircleId>> startIds(std::size_t count, const EditorOptions& options) {
  const auto& [weights, given, nextId, threads] = options;
  const auto error = [](const std::string& message) { return Error{ErrorCode::badOption, kNone, message}; };
  std::vector<CircleId> ids(given.begin(), given.end());
  if (ids.empty()) {
    for (std::size_t i = 0; i < count; ++i) ids.push_back(static_cast<std::int32_t>(i));
  }
  if (ids.size() != count) {
    return error("ids must be as many as there are circles: " + std::to_string(count) + ", not " +
                 std::to_string(ids.size()) + ".");
  }
  CircleId least = 0;
  for (const CircleId id : ids) {
    if (id < least || id == std::numeric_limits<std::int32_t>::max()) {
      return error("ids must be whole numbers from 0 to 2147483646 in increasing order; " + std::to_string(id) +
                   " is not.");
    }
    least = id + 1;
  }
  if (nextId != kNone && nextId < least) {
    return error("nextId must be above all ids: at least " + std::to_string(least) + ", not " + std::to_string(nextId) +
                 ".");
  }
  return ids;
}

/// A batch of more than kFewEdits edits plus 1 / kManyShare of the circles computes the whole diagram.
constexpr std::size_t kFewEdits = 32;
constexpr std::size_t kManyShare = 25;

}  // namespace

class DiagramEditor::Editor {
 public:
  explicit Editor(std::unique_ptr<EditState> state) { take(std::move(state)); }

  const EditState& state() const { return *state_; }
  const Locator& locator() const { return locator_; }

  /// Returns the slot of a circle, or kNone. A circle that was removed in the same batch has none.
  int slotOf(CircleId id) const {
    const int slot = state_->ids.slotOf(id);
    return slot != kNone && state_->slots[at(slot)].id == id ? slot : kNone;
  }

  /// Sets the observer, and records all faces for it. While an observer is called, this waits until the call returns.
  void observe(const Observer& observer) {
    if (isTelling_) {
      nextObserver_ = observer;
      return;
    }
    stopTelling();
    observer_ = observer;
    if (observer_) beginTelling();
  }

  void stopTelling() noexcept {
    state_->reporter = nullptr;
    reporter_.reset();
    observer_ = nullptr;
    events_.clear();
  }

  /// Passes the recorded events to the observer. If a call sets another observer, that one gets all faces in place of
  /// the rest, also if the call throws.
  void handOut() {
    if (isTelling_) return;
    std::exception_ptr thrown;
    do {
      isTelling_ = true;
      try {
        tellRecorded();
      } catch (...) {
        thrown = std::current_exception();
      }
      isTelling_ = false;
    } while (takeNextObserver());
    if (thrown) std::rethrow_exception(thrown);
  }

  /// Applies edits, then tells the observer. If the observer throws, the exception reaches the caller, but the edits
  /// are done.
  Result<Change> edited(std::span<const Edit> edits, CircleId hint) {
    if (isTelling_) return errorWith(ErrorCode::badInput, "An observer must not edit the editor that calls it.");
    auto change = guarded([&] { return apply(edits, hint); });
    if (!change) events_.clear();  // refused edits were never done
    handOut();
    return change;
  }

  /// Applies edits. Throws only if memory runs out, and then nothing has changed.
  Result<Change> apply(std::span<const Edit> edits, CircleId hint) {
    if (auto error = refusalOf(edits)) return *std::move(error);
    try {
      auto change = areFew(edits) ? applyLocally(edits, hint) : std::nullopt;
      if (!change) {
        rollBackAll();
        return applyWhole(edits);
      }
      if (!*change) {
        rollBackAll();
        return *std::move(change);
      }
      state_->prepareToCommit();
      state_->commit();
      note(change->value());
      return *std::move(change);
    } catch (...) {
      state_->rollBackAll();
      stopTelling();
      throw;
    }
  }

 private:
  /// Passes the recorded events to the observer until a call sets another one.
  void tellRecorded() {
    const std::vector<TraceEvent> events = std::exchange(events_, {});
    for (const TraceEvent& event : events) {
      observer_(event);
      if (nextObserver_) return;
    }
  }

  /// Sets the observer that a call of the last one has set. Returns whether there is one.
  bool takeNextObserver() {
    if (!nextObserver_) return false;
    stopTelling();
    observer_ = *std::exchange(nextObserver_, std::nullopt);
    reportAnew();
    return true;
  }

  void rollBackAll() {
    state_->rollBackAll();
    if (!reporter_) return;
    reporter_->setShrinking(kPointAtInfinity);
    reporter_->reportChanges();
    events_.clear();  // the edit was never done
  }

  void beginTelling() {
    reporter_.emplace(state_->dual, state_->circles, sink_);
    state_->reporter = &*reporter_;
    reporter_->reportRound(round_++);
    reporter_->reportChanges();
  }

  /// Tells all faces after an edit is done. The edit stays valid if memory runs out, but then the telling ends.
  void reportAnew() noexcept {
    if (!observer_) return;
    try {
      beginTelling();
    } catch (...) {
      stopTelling();
    }
  }

  /// Tells of an edit that computes the whole diagram.
  void reportEdit(const Edit& edit, CircleId id, const Circle& circle) {
    if (!observer_) return;
    const TraceKind kind = edit.kind == Edit::Kind::insert   ? TraceKind::circleInserted
                           : edit.kind == Edit::Kind::remove ? TraceKind::circleRemoved
                                                             : TraceKind::circleReplaced;
    events_.push_back({kind, {circle.x, circle.y, circle.r}, {id, kNone, kNone}, kNone});
  }

  /// Tells the changes of an edit that were not told yet.
  void reportRest() {
    if (!reporter_) return;
    for (const auto& saved : state_->faceLog) reporter_->addPending(saved.face);
    reporter_->reportPending();
  }

  void take(std::unique_ptr<EditState> state) {
    auto stepper = std::make_unique<Stepper>(*state, locator_);
    Locator filled;
    filled.fill(*state);
    state_ = std::move(state);
    stepper_ = std::move(stepper);
    locator_ = std::move(filled);
  }

  bool areFew(std::span<const Edit> edits) const {
    return edits.size() <= kFewEdits + static_cast<std::size_t>(state_->circleCount) / kManyShare;
  }

  /// Returns the first error in an edit that does not depend on the other edits.
  std::optional<Error> refusalOf(std::span<const Edit> edits) const {
    std::int32_t idsLeft = std::numeric_limits<std::int32_t>::max() - state_->nextId;
    for (std::size_t i = 0; i < edits.size(); ++i) {
      const Edit& edit = edits[i];
      if (edit.kind == Edit::Kind::remove) continue;
      const bool isNew = edit.kind == Edit::Kind::insert && edit.id == kNone;
      if (isNew && idsLeft-- == 0) {
        return Error{ErrorCode::tooManyCircles, kNone, "There is no id left for the new circle.",
                     static_cast<std::int64_t>(i)};
      }
      const auto error = errorOf(edit.circle, state_->weights);
      if (!error) continue;
      const std::string who = isNew ? "The new circle" : "Circle " + std::to_string(edit.id);
      return Error{error->code, isNew ? CircleId() : edit.id, who + " " + error->what, static_cast<std::int64_t>(i)};
    }
    // Numbers that are rounded to zero are too small, too, unless there are larger ones.
    if (state_->sizes.large > 0) return std::nullopt;
    double largest = 0;
    for (const Edit& edit : edits) {
      if (edit.kind != Edit::Kind::remove) largest = std::max(largest, largestNumber(edit.circle));
    }
    return tooSmallError(largest, "The circles");
  }

  /// Returns the error of `compute` for the circles that are left, if they are too small without one that is gone.
  std::optional<Error> refusalOfRest() const {
    if (!state_->sizes.areTooSmall()) return std::nullopt;
    double largest = 0;
    for (std::size_t slot = 0; slot < state_->slots.size(); ++slot) {
      if (state_->slots[slot].id != kNone) largest = std::max(largest, largestNumber(state_->circles[slot]));
    }
    return tooSmallError(largest, "The circles that are left");
  }

  /// Returns nothing if the whole diagram must be computed again.
  std::optional<Result<Change>> applyLocally(std::span<const Edit> edits, CircleId hint) {
    EditWay way = EditWay::local;
    for (std::size_t i = 0; i < edits.size(); ++i) {
      const Edit& edit = edits[i];
      int slot = kNone;
      if (edit.kind != Edit::Kind::insert) {
        slot = slotOf(edit.id);
        if (slot == kNone) return unknownCircle(edit.id, i);
      } else if (edit.id != kNone && !state_->isFormer(edit.id)) {
        return notFormer(edit.id, i);
      }
      std::optional<EditWay> done;
      if (edit.kind == Edit::Kind::remove) {
        done = stepper_->remove(slot);
      } else {
        const Circle circle = normalized(edit.circle);
        done = edit.kind == Edit::Kind::insert ? stepper_->insert(circle, edit.id, slotOf(hint))
                                               : stepper_->replace(slot, circle);
      }
      if (!done) return std::nullopt;
      reportRest();
      way = std::max(way, *done);
    }
    if (auto error = refusalOfRest()) return *std::move(error);
    return recorder_.record(*state_, way);
  }

  Result<Change> applyWhole(std::span<const Edit> edits) {
    enum class Presence { awaited, present, removed };
    struct Entry {
      CircleId id;
      Circle circle;
      Presence presence;
    };
    std::vector<Entry> entries;
    CircleId nextId = state_->nextId;
    std::vector<int> restored;
    for (const Edit& edit : edits) {
      if (edit.kind == Edit::Kind::insert && state_->isFormer(edit.id)) restored.push_back(edit.id);
    }
    sortUnique(restored);
    auto next = restored.begin();
    const auto awaitBelow = [&](CircleId id) {
      for (; next != restored.end() && *next < id; ++next) entries.push_back({*next, {}, Presence::awaited});
    };
    state_->ids.forEach([&](CircleId id, int slot) {
      awaitBelow(id);
      entries.push_back({id, state_->circles[at(slot)], Presence::present});
    });
    awaitBelow(nextId);
    const auto isBefore = [](const Entry& a, const Entry& b) { return a.id < b.id; };
    for (std::size_t i = 0; i < edits.size(); ++i) {
      const Edit& edit = edits[i];
      const bool isInsertion = edit.kind == Edit::Kind::insert;
      const Circle circle = normalized(edit.circle);
      if (isInsertion && edit.id == kNone) {
        entries.push_back({nextId, circle, Presence::present});
        reportEdit(edit, nextId, circle);
        ++nextId;
        continue;
      }
      const auto found = std::lower_bound(entries.begin(), entries.end(), Entry{edit.id, {}, {}}, isBefore);
      const Presence needed = isInsertion ? Presence::awaited : Presence::present;
      if (found == entries.end() || found->id != edit.id || found->presence != needed) {
        return isInsertion ? notFormer(edit.id, i) : unknownCircle(edit.id, i);
      }
      const bool isRemoval = edit.kind == Edit::Kind::remove;
      reportEdit(edit, edit.id, isRemoval ? found->circle : circle);
      found->presence = isRemoval ? Presence::removed : Presence::present;
      if (!isRemoval) found->circle = circle;
    }
    std::vector<CircleId> ids;
    std::vector<Circle> circles;
    for (const Entry& entry : entries) {
      if (entry.presence != Presence::present) continue;
      ids.push_back(entry.id);
      circles.push_back(entry.circle);
    }
    auto state = buildState(circles, ids, nextId, {.weights = state_->weights, .threads = state_->threads});
    if (!state) return state.error();
    auto change = recorder_.recordWhole(*state_, **state);
    if (change) {
      take(std::move(state).value());
      reportAnew();
    }
    return change;
  }

  /// Tells the locator where circles are now. If memory runs out, empties the locator instead.
  void note(const Change& change) noexcept {
    try {
      for (const auto* list : {&change.replaced, &change.inserted, &change.shown}) {
        for (const CircleId id : *list) {
          if (const int slot = slotOf(id); state_->isVisible(slot)) locator_.note(*state_, slot);
        }
      }
      if (change.inserted.empty() && change.replaced.empty() && !change.cells.empty()) {
        locator_.note(*state_, slotOf(change.cells.front()));
      }
    } catch (const std::bad_alloc&) {
      locator_ = {};
    }
  }

  std::unique_ptr<EditState> state_;
  Locator locator_;
  std::unique_ptr<Stepper> stepper_;
  ChangeRecorder recorder_;
  Observer observer_;
  std::optional<Observer> nextObserver_;  ///< set while `observer_` is called
  bool isTelling_ = false;                ///< whether `observer_` is being called
  std::vector<TraceEvent> events_;        ///< to be told once the edit is done
  /// Collects events, by ids.
  const Observer sink_ = [this](TraceEvent event) {
    for (CircleIndex& circle : event.circles) circle = state_->idOf(circle);
    events_.push_back(event);
  };
  std::optional<FaceReporter> reporter_;
  int round_ = 0;
};

DiagramEditor::DiagramEditor(std::unique_ptr<Editor> editor) : editor_(std::move(editor)) {}
DiagramEditor::DiagramEditor(DiagramEditor&&) noexcept = default;
DiagramEditor& DiagramEditor::operator=(DiagramEditor&&) noexcept = default;
DiagramEditor::~DiagramEditor() = default;

Result<DiagramEditor> DiagramEditor::from(std::span<const Circle> circles, const EditorOptions& options) {
  return guarded([&]() -> Result<DiagramEditor> {
    const auto ids = startIds(circles.size(), options);
    if (!ids) return ids.error();
    if (auto error = Threads::refusalOf(options.threads)) return *std::move(error);
    auto state = buildState(circles, *ids, options.nextId, options);
    if (!state) return state.error();
    return DiagramEditor(std::make_unique<Editor>(std::move(state).value()));
  });
}

Result<Change> DiagramEditor::insert(const Circle& circle, CircleId hint) {
  const Edit edit{Edit::Kind::insert, kNone, circle};
  return editor_->edited({&edit, 1}, hint);
}

Result<Change> DiagramEditor::remove(CircleId id) {
  const Edit edit{Edit::Kind::remove, id, {}};
  return editor_->edited({&edit, 1}, kNone);
}

Result<Change> DiagramEditor::replace(CircleId id, const Circle& circle) {
  const Edit edit{Edit::Kind::replace, id, circle};
  return editor_->edited({&edit, 1}, kNone);
}

Result<Change> DiagramEditor::apply(std::span<const Edit> edits) { return editor_->edited(edits, kNone); }

Result<void> DiagramEditor::observe(const Observer& observer) {
  auto done = guarded([&]() -> Result<void> {
    editor_->observe(observer);
    return {};
  });
  if (done) editor_->handOut();
  return done;
}

CircleId DiagramEditor::nearest(Point p, CircleId hint) const {
  const EditState& state = editor_->state();
  if (!std::isfinite(p.x) || !std::isfinite(p.y)) return kNone;
  // From farther off, all circles are equally near up to rounding. The point is moved so that no product overflows.
  const double shrink = std::max(std::abs(p.x), std::abs(p.y)) < 0x1p400 ? 1 : 0x1p-600;
  return state.idOf(editor_->locator().locate(state, {shrink * p.x, shrink * p.y}, editor_->slotOf(hint)).slot);
}

std::size_t DiagramEditor::size() const { return static_cast<std::size_t>(editor_->state().circleCount); }

std::optional<Circle> DiagramEditor::circle(CircleId id) const {
  const int slot = editor_->slotOf(id);
  if (slot == kNone) return std::nullopt;
  return editor_->state().circles[at(slot)];
}

bool DiagramEditor::isHidden(CircleId id) const { return !editor_->state().isVisible(editor_->slotOf(id)); }

std::vector<CircleId> DiagramEditor::ids() const {
  std::vector<CircleId> ids;
  ids.reserve(size());
  editor_->state().ids.forEach([&](CircleId id, int) { ids.push_back(id); });
  return ids;
}

std::vector<Circle> DiagramEditor::circles() const {
  std::vector<Circle> circles;
  circles.reserve(size());
  editor_->state().ids.forEach([&](CircleId, int slot) { circles.push_back(editor_->state().circles[at(slot)]); });
  return circles;
}

Result<Change> DiagramEditor::all() const {
  return guarded([&] { return ChangeRecorder().recordWhole(EditState(), editor_->state()); });
}

Result<Diagram> DiagramEditor::snapshot() const {
  return guarded([&] { return snapshotOf(editor_->state()); });
}

Result<SnapshotNumbers> DiagramEditor::numbers() const {
  return guarded([&]() -> Result<SnapshotNumbers> { return numbersOf(editor_->state()); });
}

Result<Certificate> DiagramEditor::certificate() const {
  return guarded([&]() -> Result<Certificate> {
    const auto diagram = snapshotOf(editor_->state());
    if (!diagram) return diagram.error();
    return certifyCircles(diagram.value());
  });
}

}  // namespace circle_voronoi
