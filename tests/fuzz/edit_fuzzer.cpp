// SPDX-License-Identifier: GPL-3.0-or-later
// A libFuzzer target over DiagramEditor. The first half of the bytes are circles (fuzz_input.h), the second half is
// a script of insertions, removals and replacements. For all inputs,
// - the editor neither crashes nor hangs; it refuses an edit only for a fault of the circle;
// - after every few edits the diagram is certified from outside, and that of `compute`;
// - an edit that is refused changes nothing.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <utility>
#include <vector>

#include "circle_voronoi/compute.h"
#include "circle_voronoi/editor.h"
#include "fuzz_input.h"

namespace circle_voronoi::fuzz {
namespace {

using Script = std::vector<circle_voronoi::Edit>;

constexpr std::size_t kMostEdits = 60;

void require(bool holds, const std::string& what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what.c_str());
  std::abort();
}

auto contentOf(const Diagram& diagram) {
  auto vertices = diagram.vertexCircles;
  std::sort(vertices.begin(), vertices.end());
  return std::pair(std::move(vertices), std::pair(diagram.hidden, diagram.hull));
}

void check(const DiagramEditor& editor) {
  const auto snapshot = editor.snapshot();
  require(snapshot.ok(), "no snapshot");
  const auto computed = compute(editor.circles());
  // Removals may leave small circles alone.
  if (!computed && computed.error().code == ErrorCode::coordinateTooSmall) return;
  const auto certificate = editor.certificate();
  require(certificate.ok() && certificate.value().certified(), "the snapshot is not certified");
  require(computed.ok() && contentOf(computed.value()) == contentOf(snapshot.value()), "compute makes another diagram");
}

/// The next edit that bytes stand for. Each fourth insertion is under an id that may be of a removed circle.
circle_voronoi::Edit editOf(std::uint8_t byte, const DiagramEditor& editor, const Circle& circle) {
  using Kind = circle_voronoi::Edit::Kind;
  const std::vector<CircleId> ids = editor.ids();
  const CircleId id = ids.empty() ? CircleId() : ids[byte / 4 % ids.size()];
  switch (byte % 4) {
    case 0:
      return {Kind::remove, id, {}};
    case 1:
      return {Kind::replace, id, circle};
    case 2:
      if (byte % 8 == 2) return {Kind::insert, byte / 8, circle};
      [[fallthrough]];
    default:
      return {Kind::insert, kNone, circle};
  }
}

void run(std::span<const std::uint8_t> bytes) {
  const std::vector<Circle> circles = decode(bytes.first(bytes.size() / 2)).circles;
  if (circles.empty()) return;
  auto made = DiagramEditor::from({});
  require(made.ok(), "no editor of no circles");
  DiagramEditor editor = std::move(made).value();
  Script batch;
  std::size_t count = 0;
  for (const std::uint8_t byte : bytes.subspan(bytes.size() / 2)) {
    if (++count > kMostEdits) break;
    batch.push_back(editOf(byte, editor, circles[count % circles.size()]));
    // Some edits in batches, which may remove a circle twice.
    if (byte >= 224 && batch.size() < 4) continue;
    const std::vector<Circle> before = editor.circles();
    const auto change = editor.apply(batch);
    if (!change.ok()) {
      const ErrorCode code = change.error().code;
      require(code == ErrorCode::nonFinite || code == ErrorCode::negativeRadius ||
                  code == ErrorCode::coordinateTooLarge || code == ErrorCode::coordinateTooSmall ||
                  code == ErrorCode::unknownCircle,
              "refused: " + change.error().message);
      require(editor.circles() == before, "a refused edit has changed something");
    }
    batch.clear();
    if (count % 4 == 0) check(editor);
  }
  check(editor);
}

}  // namespace
}  // namespace circle_voronoi::fuzz

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  circle_voronoi::fuzz::run({data, size});
  return 0;
}
