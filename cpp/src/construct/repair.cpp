// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair.h"

#include <array>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

#include "at.h"
#include "circle_voronoi/index.h"
#include "sort_unique.h"
#include "wrong_faces.h"

namespace circle_voronoi {
namespace {

using Triple = Predicates::Triple;

/// A connected set of faces, and which those are.
struct Patch {
  std::vector<int> faces;
  std::unordered_set<int> members;
};

/// The faces within `reach` steps of the given ones, by connected patches.
std::vector<Patch> patchesAround(const Dual& dual, const std::vector<int>& wrong, int reach) {
  std::unordered_map<int, int> distances;
  std::vector<int> near = wrong;
  for (const int face : wrong) distances.emplace(face, 0);
  for (std::size_t i = 0; i < near.size(); ++i) {
    const int distance = distances.at(near[i]);
    if (distance == reach) continue;
    for (int h = 3 * near[i]; h < 3 * near[i] + 3; ++h) {
      const int neighbor = dual.twin[at(h)] / 3;
      if (distances.emplace(neighbor, distance + 1).second) near.push_back(neighbor);
    }
  }
  std::vector<Patch> patches;
  std::unordered_set<int> labelled;
  for (const int seed : near) {
    if (!labelled.insert(seed).second) continue;
    Patch patch{{seed}, {seed}};
    for (std::size_t i = 0; i < patch.faces.size(); ++i) {
      for (int h = 3 * patch.faces[i]; h < 3 * patch.faces[i] + 3; ++h) {
        const int neighbor = dual.twin[at(h)] / 3;
        if (!distances.contains(neighbor) || !labelled.insert(neighbor).second) continue;
        patch.faces.push_back(neighbor);
        patch.members.insert(neighbor);
      }
    }
    patches.push_back(std::move(patch));
  }
  return patches;
}

/// Replaces one patch; false if the local diagram does not fit its boundary.
bool replacePatch(std::span<const Circle> circles, Dual& dual, const Patch& patch, const LocalSolver& solve) {
  // The half-edges just outside the patch, and all circles at the patch and at the faces around it.
  std::vector<int> outside;
  std::vector<int> corners;
  for (const int face : patch.faces) {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      corners.push_back(dual.origin[at(h)]);
      const int t = dual.twin[at(h)];
      if (patch.members.contains(t / 3)) continue;
      outside.push_back(t);
      corners.push_back(dual.origin[at(Dual::previous(t))]);
    }
  }
  sortUnique(corners);
  std::erase(corners, kPointAtInfinity);

  std::vector<Circle> local;
  for (const int i : corners) local.push_back(circles[at(i)]);
  const auto solved = solve(local);
  if (!solved) return false;
  const auto globalOf = [&](int i) { return i == kPointAtInfinity ? kPointAtInfinity : corners[at(i)]; };

  // A triple of circles has one counter-clockwise disc, so its corners name a half-edge of the local dual.
  std::map<Triple, int> localHalfEdges;
  for (int h = 0; h < solved->halfEdgeCount(); ++h) {
    const auto [i, j, k] = cornersOf(*solved, h);
    localHalfEdges.emplace(Triple{globalOf(i), globalOf(j), globalOf(k)}, h);
  }
  std::vector<int> outsideOf(solved->origin.size(), kNone);  // the global half-edge that a local one stands for
  std::vector<int> inside;
  std::vector<int> placeOf(solved->origin.size() / 3, kNone);
  for (const int t : outside) {
    const auto found = localHalfEdges.find(cornersOf(dual, t));
    if (found == localHalfEdges.end()) return false;
    // A wrong dual may hold the same face twice.
    if (outsideOf[at(found->second)] != kNone) return false;
    outsideOf[at(found->second)] = t;
  }
  // Flood the inside from the boundary.
  const auto enter = [&](int face) {
    if (placeOf[at(face)] != kNone) return;
    placeOf[at(face)] = static_cast<int>(inside.size());
    inside.push_back(face);
  };
  for (int h = 0; h < solved->halfEdgeCount(); ++h) {
    if (outsideOf[at(h)] != kNone) enter(solved->twin[at(h)] / 3);
  }
  // Without a boundary the patch is the whole dual.
  if (outside.empty() && solved->faceCount() > 0) enter(0);
  for (std::size_t i = 0; i < inside.size() && inside.size() <= patch.faces.size(); ++i) {
    for (int h = 3 * inside[i]; h < 3 * inside[i] + 3; ++h) {
      if (outsideOf[at(solved->twin[at(h)])] == kNone) enter(solved->twin[at(h)] / 3);
    }
  }
  if (inside.size() != patch.faces.size()) return false;

  const auto halfEdgeAt = [&](int h) { return 3 * patch.faces[at(placeOf[at(h / 3)])] + h % 3; };
  for (const int face : inside) {
    for (int h = 3 * face; h < 3 * face + 3; ++h) {
      const int place = halfEdgeAt(h);
      const int t = solved->twin[at(h)];
      dual.origin[at(place)] = globalOf(solved->origin[at(h)]);
      dual.link(place, outsideOf[at(t)] != kNone ? outsideOf[at(t)] : halfEdgeAt(t));
    }
  }
  return true;
}

}  // namespace

std::int64_t repair(Dual& dual, FaceDiscs& discs, std::vector<int>& wrong, int reach, const LocalSolver& solve) {
  std::int64_t replaced = 0;
  std::vector<int> edges;
  for (const Patch& patch : patchesAround(dual, wrong, reach)) {
    if (replacePatch(discs.circles(), dual, patch, solve)) {
      ++replaced;
      for (const int face : patch.faces) discs.update(face);
    }
    for (const int face : patch.faces) edges.insert(edges.end(), {3 * face, 3 * face + 1, 3 * face + 2});
  }
  wrong = wrongFaces(discs, edges);
  return replaced;
}

}  // namespace circle_voronoi
