// SPDX-License-Identifier: GPL-3.0-or-later
// The editor as a part of the module of bindings.cpp. Its only caller is web/lib/wasm/module-editor.ts. JavaScript
// holds the address of an editor, which lives until `deleteEditor`. A change is one array of bytes, because an object
// of arrays would take longer than the edit.
#include <emscripten/bind.h>
#include <emscripten/val.h>

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "circle_voronoi/editor.h"
#include "trace_arrays.h"
#include "values.h"

namespace {

using namespace circle_voronoi;
using emscripten::val;

struct Session {
  DiagramEditor editor;
  std::vector<std::uint8_t> reply;  ///< kept to reuse its memory
};

Session& sessionOf(std::uintptr_t address) { return *reinterpret_cast<Session*>(address); }

template <class Item>
void append(std::vector<std::uint8_t>& bytes, const std::vector<Item>& items) {
  const auto* data = reinterpret_cast<const std::uint8_t*>(items.data());
  bytes.insert(bytes.end(), data, data + items.size() * sizeof(Item));
}

/// Encodes a change: the way and the length of each list as 32-bit numbers, padded to an even count; then the lists of
/// doubles; then the other lists. Returns a view that is valid until the next edit or until memory grows.
val changeValue(std::vector<std::uint8_t>& reply, const Change& change) {
  reply.clear();
  std::vector<std::int32_t> head = {static_cast<std::int32_t>(change.way)};
  const auto eachList = [&](auto visit) {
    visit(change.circles);
    visit(change.vertices);
    visit(change.inserted);
    visit(change.removed);
    visit(change.replaced);
    visit(change.hidden);
    visit(change.hiders);
    visit(change.shown);
    visit(change.cells);
    visit(change.removedVertices);
    visit(change.addedVertices);
    visit(change.vertexCircles);
    visit(change.removedEdges);
    visit(change.addedEdges);
    visit(change.edges);
    visit(change.hullSides);
  };
  eachList([&](const auto& list) { head.push_back(static_cast<std::int32_t>(list.size())); });
  head.resize(18);
  append(reply, head);
  eachList([&](const auto& list) { append(reply, list); });
  return val(emscripten::typed_memory_view(reply.size(), reply.data()));
}

val replyTo(Session& session, const Result<Change>& change) {
  return change.ok() ? changeValue(session.reply, change.value()) : errorValue(change.error());
}

val createEditor(const val& coordinates, bool weights, const val& ids, std::int32_t nextId) {
  return valueOf([&] {
    const auto given = itemsFrom<std::int32_t, CircleId>(ids);
    auto editor = DiagramEditor::from(itemsFrom<double, Circle>(coordinates),
                                      {.weights = weights, .ids = given, .nextId = nextId});
    if (!editor.ok()) return errorValue(editor.error());
    val result = val::object();
    result.set("editor", reinterpret_cast<std::uintptr_t>(new Session{std::move(editor).value(), {}}));
    return result;
  });
}

void deleteEditor(std::uintptr_t address) { delete &sessionOf(address); }

/// One edit (Edit) and a hint for a new circle.
val editValue(std::uintptr_t address, int kind, std::int32_t id, double x, double y, double r, std::int32_t hint) {
  return valueOf([&] {
    Session& session = sessionOf(address);
    const Edit edit = {static_cast<Edit::Kind>(kind), id, {x, y, r}};
    return replyTo(session, edit.kind == Edit::Kind::insert ? session.editor.insert(edit.circle, hint)
                                                            : session.editor.apply({&edit, 1}));
  });
}

/// For each edit its kind, id, x, y, r.
std::vector<Edit> editsFrom(const val& numbers) {
  std::vector<Edit> edits;
  for (const auto& [kind, id, x, y, r] : itemsFrom<double, std::array<double, 5>>(numbers)) {
    edits.push_back({static_cast<Edit::Kind>(static_cast<int>(kind)), static_cast<std::int32_t>(id), {x, y, r}});
  }
  return edits;
}

val applyValue(std::uintptr_t address, const val& numbers) {
  return valueOf([&] {
    Session& session = sessionOf(address);
    return replyTo(session, session.editor.apply(editsFrom(numbers)));
  });
}

/// The events of the edits, one edit after the other.
val traceEditsValue(std::uintptr_t address, const val& numbers) {
  return valueOf([&] {
    DiagramEditor& editor = sessionOf(address).editor;
    TraceArrays events;
    if (const auto observed = editor.observe(events.observer()); !observed) return errorValue(observed.error());
    const Result<Change> change = editor.apply(editsFrom(numbers));
    (void)editor.observe({});  // this call cannot fail
    return change.ok() ? events.value() : errorValue(change.error());
  });
}

std::int32_t nearestId(std::uintptr_t address, double x, double y, std::int32_t hint) {
  return sessionOf(address).editor.nearest({x, y}, hint);
}

double sizeOf(std::uintptr_t address) { return static_cast<double>(sessionOf(address).editor.size()); }

/// Returns x, y, r and whether the circle is hidden; undefined if the id is unknown.
val circleValue(std::uintptr_t address, std::int32_t id) {
  const DiagramEditor& editor = sessionOf(address).editor;
  const auto circle = editor.circle(id);
  if (!circle) return val::undefined();
  return float64Array(std::vector<double>{circle->x, circle->y, circle->r, editor.isHidden(id) ? 1.0 : 0.0});
}

val idsValue(std::uintptr_t address) {
  return valueOf([&] { return int32Array(sessionOf(address).editor.ids()); });
}

val snapshotValue(std::uintptr_t address) {
  return valueOf([&] {
    const DiagramEditor& editor = sessionOf(address).editor;
    const Result<Diagram> diagram = editor.snapshot();
    if (!diagram.ok()) return errorValue(diagram.error());
    const Result<SnapshotNumbers> numbers = editor.numbers();
    if (!numbers.ok()) return errorValue(numbers.error());
    val result = diagramValue(diagram.value());
    result.set("circles", float64Array(diagram.value().circles));
    val names = val::object();
    names.set("circles", int32Array(numbers.value().circles));
    names.set("vertices", int32Array(numbers.value().vertices));
    names.set("edges", int32Array(numbers.value().edges));
    names.set("hiders", int32Array(numbers.value().hiders));
    result.set("numbers", names);
    return result;
  });
}

val certificateOfEditor(std::uintptr_t address) {
  return valueOf([&] {
    const Result<Certificate> certificate = sessionOf(address).editor.certificate();
    return certificate.ok() ? certificateValue(certificate.value()) : errorValue(certificate.error());
  });
}

}  // namespace

EMSCRIPTEN_BINDINGS(circle_voronoi_editor) {
  emscripten::function("createEditor", &createEditor);
  emscripten::function("deleteEditor", &deleteEditor);
  emscripten::function("editCircle", &editValue);
  emscripten::function("applyEdits", &applyValue);
  emscripten::function("traceEdits", &traceEditsValue);
  emscripten::function("nearestCircle", &nearestId);
  emscripten::function("editorSize", &sizeOf);
  emscripten::function("circleOfEditor", &circleValue);
  emscripten::function("idsOfEditor", &idsValue);
  emscripten::function("snapshotOfEditor", &snapshotValue);
  emscripten::function("certificateOfEditor", &certificateOfEditor);
}
