// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the values of enumerations, as errors, files and JavaScript have them.
#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

#include "circle_voronoi/certificate.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/method.h"
#include "circle_voronoi/progress.h"
#include "circle_voronoi/stats.h"
#include "circle_voronoi/trace.h"

namespace circle_voronoi {
namespace {

/// The names of an enumeration, in its order, up to the last of its values.
template <auto kLast>
using Names = std::array<std::string_view, static_cast<std::size_t>(kLast) + 1>;

constexpr auto kMethods = std::to_array<std::string_view>({"auto", "touching-disc", "flip"});
constexpr auto kCandidates = std::to_array<std::string_view>({"dynamic", "uniform", "all-pairs"});
constexpr auto kWays = std::to_array<std::string_view>({"flip", "repair", "insert", "touching-disc", "edit"});
constexpr auto kErrorCodes = std::to_array<std::string_view>(
    {"nonFinite", "negativeRadius", "coordinateTooLarge", "coordinateTooSmall", "tooManyCircles", "badOption",
     "notCertified", "notConverged", "unknownCircle", "badInput", "badArithmetic", "notWritten", "internal"});
static_assert(std::is_same_v<decltype(kErrorCodes), const Names<ErrorCode::internal>>);
constexpr auto kFlaws = std::to_array<std::string_view>(
    {"none", "notJudged", "badIndex", "hiddenWithoutHider", "adjacency", "eulerCount", "vertexWithoutDisc",
     "vertexMisplaced", "edgeOutOfOrder", "cellNotClosed", "hullNotClosed"});
static_assert(std::is_same_v<decltype(kFlaws), const Names<Flaw::hullNotClosed>>);
constexpr auto kTraceKinds = std::to_array<std::string_view>({"roundBegun",
                                                              "centersJoined",
                                                              "sampleTaken",
                                                              "samplesJoined",
                                                              "pairFound",
                                                              "antipodalDiscAccepted",
                                                              "antipodalDiscUsed",
                                                              "antipodalDiscNotEmpty",
                                                              "threeTouchDiscFormed",
                                                              "threeTouchDiscStale",
                                                              "branchDisc",
                                                              "directedEdgePlaced",
                                                              "directedEdgeDeleted",
                                                              "segmentFinished",
                                                              "faceMade",
                                                              "faceRemoved",
                                                              "discNotEmpty",
                                                              "discMissing",
                                                              "tangentNotClear",
                                                              "hullNotConvex",
                                                              "circleInserted",
                                                              "circleRemoved",
                                                              "circleReplaced",
                                                              "circleShrunk"});
static_assert(std::is_same_v<decltype(kTraceKinds), const Names<TraceKind::circleShrunk>>);
static_assert(kSecondsMembers.size() == static_cast<std::size_t>(Stage::assemble) + 2, "each stage has a time");

template <class Value, std::size_t count>
std::string_view nameIn(const std::array<std::string_view, count>& names, Value value) {
  const auto i = static_cast<std::size_t>(value);
  return i < count ? names[i] : std::string_view();
}

template <class Value, std::size_t count>
std::optional<Value> valueIn(const std::array<std::string_view, count>& names, std::string_view name) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) return std::nullopt;
  return static_cast<Value>(found - names.begin());
}

}  // namespace

std::string_view methodName(Method method) { return nameIn(kMethods, method); }
std::string_view candidatesName(Candidates candidates) { return nameIn(kCandidates, candidates); }
std::string_view wayName(Way way) { return nameIn(kWays, way); }
std::string_view errorCodeName(ErrorCode code) { return nameIn(kErrorCodes, code); }
std::string_view flawName(Flaw flaw) { return nameIn(kFlaws, flaw); }
std::string_view traceKindName(TraceKind kind) { return nameIn(kTraceKinds, kind); }
std::string_view stageName(Stage stage) { return kSecondsMembers[static_cast<std::size_t>(stage)].name; }

std::optional<Method> methodFromName(std::string_view name) { return valueIn<Method>(kMethods, name); }
std::optional<Candidates> candidatesFromName(std::string_view name) { return valueIn<Candidates>(kCandidates, name); }
std::optional<Way> wayFromName(std::string_view name) { return valueIn<Way>(kWays, name); }

}  // namespace circle_voronoi
