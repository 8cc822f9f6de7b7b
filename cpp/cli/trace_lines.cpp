// SPDX-License-Identifier: GPL-3.0-or-later
#include "trace_lines.h"

#include <cmath>
#include <ostream>
#include <span>
#include <string_view>

#include "json_number.h"

namespace circle_voronoi::cli {
namespace {

/// Writes a member with the indices before the first kNone. Writes nothing if there are none.
template <class Index>
void writeIndices(std::ostream& out, std::string_view name, std::span<const Index> indices) {
  if (indices[0] == kNone) return;
  out << ", \"" << name << "\": [";
  for (std::size_t k = 0; k < indices.size() && indices[k] != kNone; ++k) {
    if (k > 0) out << ", ";
    writeNumber(out, std::int32_t{indices[k]});
  }
  out << ']';
}

bool hasDisc(const TraceEvent& event) {
  const TraceKind kind = event.kind;
  return kind != TraceKind::roundBegun && kind != TraceKind::centersJoined && kind != TraceKind::samplesJoined &&
         kind != TraceKind::pairFound && !std::isnan(event.disc.r);
}

}  // namespace

void writeTraceEvent(std::ostream& out, const TraceEvent& event) {
  out << "{\"kind\": \"" << traceKindName(event.kind) << '"';
  if (hasDisc(event)) {
    out << ", \"disc\": {\"x\": ";
    writeNumber(out, event.disc.x);
    out << ", \"y\": ";
    writeNumber(out, event.disc.y);
    out << ", \"r\": ";
    writeNumber(out, event.disc.r);
    out << '}';
  }
  writeIndices<CircleIndex>(out, "circles", event.circles);
  if (event.vertex != kNone) {
    out << ", \"vertex\": ";
    writeNumber(out, std::int32_t{event.vertex});
  }
  writeIndices<std::int32_t>(out, "numbers", event.numbers);
  out << "}\n";
}

}  // namespace circle_voronoi::cli
