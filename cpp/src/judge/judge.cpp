// SPDX-License-Identifier: GPL-3.0-or-later
#include "judge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <tuple>
#include <utility>
#include <vector>

#include "at.h"
#include "branchless.h"
#include "certificate_message.h"
#include "portable.h"
#include "prefetch.h"

namespace circle_voronoi {
namespace {

class Judge {
 public:
  Judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates, Proof proof, Threads threads)
      : circles_(circles),
        dual_(dual),
        predicates_(predicates),
        threads_(threads),
        circleCount_(static_cast<int>(circles.size())),
        hasDiscs_(!proof.discs.empty()),
        proof_(std::move(proof)) {}

  Verdict run() && {
    if (Verdict verdict = checkAdjacency(); !verdict.isRight()) return verdict;
    if (circleCount_ < 2) return {};
    if (Verdict verdict = checkFaces(); !verdict.isRight()) return verdict;
    Verdict verdict = checkWindings();
    if (verdict.isRight()) {
      verdict.ties = std::move(ties_);
      proof_.orders = {};
      verdict.proof = std::move(proof_);
    }
    return verdict;
  }

 private:
  /// The findings on some of the faces.
  struct Findings {
    Verdict verdict;
    std::size_t check = std::numeric_limits<std::size_t>::max();  ///< at which the verdict was found: four a face
    std::vector<int> ties;
    std::vector<int> across;  ///< half-edges of the range's faces whose twins are in an earlier range
  };
  using FaceProver = Prover<std::vector<FaceDisc>>;

  static constexpr std::size_t kFacesAtATime = 128;

  Verdict checkAdjacency() const {
    const int faceCount = circleCount_ < 2 ? 0 : 2 * circleCount_ - 2;
    if (dual_.faceCount() != faceCount) return {Flaw::eulerCount};
    const std::size_t found =
        threads_.firstWhere(dual_.origin.size(), [&](std::size_t h) { return !dual_.fits(static_cast<int>(h)); });
    if (found == dual_.origin.size()) return {};
    const auto h = static_cast<int>(found);
    return {dual_.origin[at(h)] == dual_.target(h) ? Flaw::badIndex : Flaw::adjacency, kNone, h / 3, h};
  }

  /// The disc of each face, and each edge once both its faces have one: in the order of the faces, so that the verdict
  /// is about the first that is wrong. A few faces at a time stay in the cache.
  Verdict checkFaces() {
    proof_.halfEdges.resize(dual_.origin.size());
    proof_.discs.resize(dual_.origin.size() / 3);
    const std::size_t faceCount = proof_.discs.size();
    std::vector<Findings> findings(threads_.rangesOf(faceCount));
    predicates_.forRanges(
        threads_, faceCount, [&](std::size_t begin, std::size_t end, std::size_t range, Predicates& own) {
          FaceProver prover = proverBy(own);
          Findings& found = findings[range];
          for (std::size_t from = begin; from < end && found.verdict.isRight(); from += kFacesAtATime) {
            const std::size_t to = std::min(from + kFacesAtATime, end);
            checkSome(static_cast<int>(from), static_cast<int>(to), static_cast<int>(3 * begin), own, prover, found);
          }
        });
    // The first flaw, and then the edges between ranges before it.
    const auto first = std::min_element(findings.begin(), findings.end(),
                                        [](const Findings& a, const Findings& b) { return a.check < b.check; });
    Findings all;
    all.verdict = first->verdict;
    all.check = first->check;
    FaceProver prover = proverBy(predicates_);
    for (const Findings& part : findings) {
      for (const int t : part.across) checkEdge(t, prover, all);
      all.ties.insert(all.ties.end(), part.ties.begin(), part.ties.end());
    }
    ties_ = std::move(all.ties);
    // In the order of the faces beyond them.
    if (findings.size() > 1) {
      std::sort(ties_.begin(), ties_.end(), [&](int g, int h) { return dual_.twin[at(g)] < dual_.twin[at(h)]; });
    }
    return all.verdict;
  }

  FaceProver proverBy(Predicates& predicates) { return {dual_, circles_, predicates, proof_.discs, proof_.halfEdges}; }

  /// Checks a range of faces, and the edges whose second face is in the range.
  void checkSome(int first, int last, int firstHalfEdge, Predicates& predicates, FaceProver& prover, Findings& found) {
    std::array<int, 3 * kFacesAtATime> halves;
    std::size_t count = select(3 * first, 3 * last, halves, [&](int h) { return dual_.twin[at(h)] > h; });
    // Each edge is looked at before the first of its faces gets its disc.
    int hidden = kPointAtInfinity;
    for (std::size_t k = 0; k < count && !isFinite(hidden); ++k) {
      if (!hasDiscs_) prefetchCircles(static_cast<std::size_t>(halves[k] / 3) + kPrefetchAhead);
      hidden = hiddenBeside(halves[k], predicates);
      if (isFinite(hidden)) last = halves[k] / 3;
    }
    if (isFinite(hidden)) note(4 * static_cast<std::size_t>(last), {Flaw::cellNotClosed, hidden}, found);
    for (int face = first; face < last; ++face) {
      if (!proof_.discs[at(face)].exists) proof_.discs[at(face)] = predicates.disc(cornersOf(dual_, 3 * face));
      if (prover.proveFace(face)) continue;
      note(4 * static_cast<std::size_t>(face), {Flaw::vertexWithoutDisc, kNone, face}, found);
      last = face;
    }
    count = select(3 * first, 3 * last, halves, [&](int t) { return dual_.twin[at(t)] < t; });
    for (std::size_t k = 0; k < count; ++k) {
      const int t = halves[k];
      if (dual_.twin[at(t)] < firstHalfEdge) {
        found.across.push_back(t);
      } else {
        checkEdge(t, prover, found);
      }
    }
  }

  static void note(std::size_t check, const Verdict& verdict, Findings& found) {
    found.check = check;
    found.verdict = verdict;
  }

  /// A diagram from outside has its circles in any order. Inlined, as a compiler may take a function that only does
  /// this for idle.
  CIRCLE_VORONOI_ALWAYS_INLINE void prefetchCircles(std::size_t face) const {
    if (face >= proof_.discs.size()) return;
    for (const int i : cornersOf(dual_, static_cast<int>(3 * face))) {
      if (isFinite(i)) prefetch(circles_, at(i));
    }
  }

  /// Returns the circle of an edge that the other one hides, or kPointAtInfinity.
  int hiddenBeside(int h, Predicates& predicates) const {
    const int a = dual_.origin[at(h)];
    const int b = dual_.target(h);
    return isFinite(a) && isFinite(b) ? predicates.hiddenOf(a, b) : kPointAtInfinity;
  }

  /// Proves an edge, given by its second half. Edges after the first wrong one are not examined.
  void checkEdge(int t, FaceProver& prover, Findings& found) {
    const std::size_t check = 4 * static_cast<std::size_t>(t / 3) + 1 + static_cast<std::size_t>(t % 3);
    if (check > found.check) return;
    const int h = dual_.twin[at(t)];
    const int order = prover.proveEdge(h, proof_.orders.empty() ? kUnknownOrder : proof_.orders[at(h)]);
    if (order < 0) {
      note(check, {Flaw::edgeOutOfOrder, kNone, h / 3, h}, found);
      return;
    }
    if (order == 0) found.ties.push_back(h);
  }

  /// One full turn of every region, and of the hull.
  Verdict checkWindings() const {
    // Nothing passes around infinity, whose number precedes the circles' numbers. Branches would be mispredicted.
    static_assert(kPointAtInfinity == -1);
    std::vector<int> windings(static_cast<std::size_t>(circleCount_) + 1);
    int hullTurns = 0;
    for (int h = 0; h < dual_.halfEdgeCount(); ++h) {
      const int passes = proof_.halfEdges[at(h)].passes ? 1 : 0;
      windings[at(dual_.origin[at(h)] + 1)] += passes;
      hullTurns += isFinite(dual_.target(h)) ? 0 : passes;
    }
    for (int circle = 0; circle < circleCount_; ++circle) {
      if (windings[at(circle + 1)] != 1) return {Flaw::cellNotClosed, circle};
    }
    return {hullTurns == 1 ? Flaw::none : Flaw::hullNotClosed};
  }

  std::span<const Circle> circles_;
  const Dual& dual_;
  Predicates& predicates_;
  Threads threads_;
  int circleCount_;
  bool hasDiscs_;  ///< whether most discs were given
  Proof proof_;
  std::vector<int> ties_;
};

#ifdef CIRCLE_VORONOI_CHECK_PROOFS
/// Ends a program whose judge comes to another verdict, or another proof, if it rests on nothing.
void checkAgainst(const Verdict& verdict, const Verdict& own) {
  const auto place = [](const Verdict& v) { return std::tuple(v.flaw, v.circle, v.face, v.halfEdge); };
  const bool isSame = place(verdict) == place(own) && verdict.ties == own.ties &&
                      verdict.proof.discs == own.proof.discs && verdict.proof.halfEdges == own.proof.halfEdges;
  if (!isSame) std::abort();
}
#endif

}  // namespace

Verdict judge(std::span<const Circle> circles, const Dual& dual, Predicates& predicates, Proof proof, Threads threads) {
  Verdict verdict = Judge(circles, dual, predicates, std::move(proof), threads).run();
#ifdef CIRCLE_VORONOI_CHECK_PROOFS
  Predicates own(circles);
  checkAgainst(verdict, Judge(circles, dual, own, {}, threads).run());
#endif
  return verdict;
}

std::optional<CircleIndex> markHidden(std::span<const HiddenCircle> hidden, std::span<std::uint8_t> isHidden) {
  const auto isIndex = [&](int i) { return i >= 0 && static_cast<std::size_t>(i) < isHidden.size(); };
  for (const auto& [circle, by] : hidden) {
    if (!isIndex(circle) || !isIndex(by) || isHidden[at(circle)] != 0) return circle;
    isHidden[at(circle)] = 1;
  }
  return std::nullopt;
}

Verdict judgeHidden(std::span<const Circle> circles, std::span<const HiddenCircle> hidden) {
  std::vector<std::uint8_t> isHidden(circles.size());
  if (const auto wrong = markHidden(hidden, isHidden)) return {Flaw::badIndex, *wrong};
  Predicates predicates(circles);
  for (const auto& [circle, by] : hidden) {
    if (isHidden[at(by)] != 0 || !predicates.contains(circles[at(by)], circles[at(circle)])) {
      return {Flaw::hiddenWithoutHider, circle};
    }
  }
  return {};
}

std::optional<Error> refusalOfHidden(std::span<const Circle> circles, std::span<const HiddenCircle> hidden) {
  const Verdict verdict = judgeHidden(circles, hidden);
  if (verdict.isRight()) return std::nullopt;
  const Certificate certificate = {verdict.flaw, verdict.circle, kNone, kNone, {}};
  return Error{ErrorCode::notCertified, verdict.circle,
               "No construction led to a certified diagram: " + messageOf(certificate, {})};
}

}  // namespace circle_voronoi
