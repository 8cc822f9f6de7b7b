// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "circle_voronoi/none.h"

namespace circle_voronoi {
namespace {

using Triple = Predicates::Triple;

Triple cornersOf(const Dual& dual, int h) { return {dual.origin[h], dual.target(h), dual.origin[Dual::previous(h)]}; }

/// The faces that the repair starts from.
std::vector<int> wrongFaces(const Dual& dual, Predicates& predicates) {
  std::vector<FaceDisc> discs;
  discs.reserve(dual.faceCount());
  for (int face = 0; face < dual.faceCount(); ++face) discs.push_back(predicates.disc(cornersOf(dual, 3 * face)));
  std::vector<int> wrong;
  for (int face = 0; face < dual.faceCount(); ++face) {
    if (!discs[face].exists) wrong.push_back(face);
  }
  for (int h = 0; h < dual.halfEdgeCount(); ++h) {
    const int t = dual.twin[h];
    if (h > t || !discs[h / 3].exists || !discs[t / 3].exists) continue;
    const auto [a, b, c] = cornersOf(dual, h);
    const int d = dual.origin[Dual::previous(t)];
    const bool isWrong = a == kInfinity   ? predicates.tangentSide(d, c, b) < 0
                         : b == kInfinity ? predicates.tangentSide(c, d, a) < 0
                                          : predicates.edgeOrder(a, b, c, d, discs[h / 3], discs[t / 3]) < 0;
    if (isWrong) wrong.insert(wrong.end(), {h / 3, t / 3});
  }
  return wrong;
}

/// Labels the faces within `reach` steps of the given ones by connected patches; kNone elsewhere.
std::vector<std::vector<int>> patchesAround(const Dual& dual, const std::vector<int>& wrong, int reach,
                                            std::vector<int>& patchOf) {
  std::vector<int> distance(dual.faceCount(), -1);
  std::vector<int> queue;
  for (const int face : wrong) {
    if (distance[face] == 0) continue;
    distance[face] = 0;
    queue.push_back(face);
  }
  for (std::size_t i = 0; i < queue.size(); ++i) {
    const int face = queue[i];
    if (distance[face] == reach) continue;
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const int neighbor = dual.twin[h] / 3;
      if (distance[neighbor] >= 0) continue;
      distance[neighbor] = distance[face] + 1;
      queue.push_back(neighbor);
    }
  }
  patchOf.assign(dual.faceCount(), -1);
  std::vector<std::vector<int>> patches;
  for (const int seed : queue) {
    if (patchOf[seed] >= 0) continue;
    const int label = static_cast<int>(patches.size());
    std::vector<int> patch = {seed};
    patchOf[seed] = label;
    for (std::size_t i = 0; i < patch.size(); ++i) {
      for (int h = 3 * patch[i]; h < 3 * patch[i] + 3; ++h) {
        const int neighbor = dual.twin[h] / 3;
        if (distance[neighbor] < 0 || patchOf[neighbor] >= 0) continue;
        patchOf[neighbor] = label;
        patch.push_back(neighbor);
      }
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

/// Replaces one patch; false if the local diagram does not fit its boundary.
bool replacePatch(std::span<const Circle> circles, Dual& dual, const std::vector<int>& patch,
                  const std::vector<int>& patchOf, const LocalSolver& solve) {
  const int label = patchOf[patch.front()];
  // The half-edges just outside the patch, and all circles at the patch and at the faces around it.
  std::vector<int> outside;
  std::vector<int> corners;
  for (const int face : patch) {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      corners.push_back(dual.origin[h]);
      const int t = dual.twin[h];
      if (patchOf[t / 3] == label) continue;
      outside.push_back(t);
      corners.push_back(dual.origin[Dual::previous(t)]);
    }
  }
  std::sort(corners.begin(), corners.end());
  corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
  std::erase(corners, kInfinity);

  std::vector<Circle> local;
  for (const int i : corners) local.push_back(circles[i]);
  const auto solved = solve(local);
  if (!solved) return false;
  const auto globalOf = [&](int i) { return i == kInfinity ? kInfinity : corners[i]; };

  // A triple of circles has one counter-clockwise disc, so its corners name a half-edge of the local dual.
  std::map<Triple, int> localHalfEdges;
  for (int h = 0; h < solved->halfEdgeCount(); ++h) {
    const auto [i, j, k] = cornersOf(*solved, h);
    localHalfEdges.emplace(Triple{globalOf(i), globalOf(j), globalOf(k)}, h);
  }
  std::vector<int> outsideOf(solved->halfEdgeCount(), kNone);  // the global half-edge that a local one stands for
  std::vector<int> inside;
  std::vector<int> placeOf(solved->faceCount(), kNone);
  for (const int t : outside) {
    const auto found = localHalfEdges.find(cornersOf(dual, t));
    if (found == localHalfEdges.end()) return false;
    // A wrong dual may hold the same face twice.
    if (outsideOf[found->second] != kNone) return false;
    outsideOf[found->second] = t;
  }
  // Flood the inside from the boundary.
  const auto enter = [&](int face) {
    if (placeOf[face] != kNone) return;
    placeOf[face] = static_cast<int>(inside.size());
    inside.push_back(face);
  };
  for (int h = 0; h < solved->halfEdgeCount(); ++h) {
    if (outsideOf[h] != kNone) enter(solved->twin[h] / 3);
  }
  // Without a boundary the patch is the whole dual.
  if (outside.empty() && solved->faceCount() > 0) enter(0);
  for (std::size_t i = 0; i < inside.size() && inside.size() <= patch.size(); ++i) {
    for (int h = 3 * inside[i]; h < 3 * inside[i] + 3; ++h) {
      if (outsideOf[solved->twin[h]] == kNone) enter(solved->twin[h] / 3);
    }
  }
  if (inside.size() != patch.size()) return false;

  const auto halfEdgeAt = [&](int h) { return 3 * patch[placeOf[h / 3]] + h % 3; };
  for (const int face : inside) {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const int at = halfEdgeAt(h);
      const int t = solved->twin[h];
      dual.origin[at] = globalOf(solved->origin[h]);
      dual.twin[at] = outsideOf[t] != kNone ? outsideOf[t] : halfEdgeAt(t);
      dual.twin[dual.twin[at]] = at;
    }
  }
  return true;
}

}  // namespace

std::int64_t repair(std::span<const Circle> circles, Dual& dual, Predicates& predicates, int reach,
                    const LocalSolver& solve) {
  std::vector<int> patchOf;
  const auto patches = patchesAround(dual, wrongFaces(dual, predicates), reach, patchOf);
  std::int64_t replaced = 0;
  for (const auto& patch : patches) {
    if (replacePatch(circles, dual, patch, patchOf, solve)) ++replaced;
  }
  return replaced;
}

}  // namespace circle_voronoi
