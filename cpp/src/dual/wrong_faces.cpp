// SPDX-License-Identifier: GPL-3.0-or-later
#include "wrong_faces.h"

#include "at.h"
#include "sort_unique.h"

namespace circle_voronoi {
namespace {

void addWrong(const FaceDiscs& discs, int h, std::vector<int>& wrong) {
  const Flaw flaw = discs.flawOf(h);
  if (flaw == Flaw::none) return;
  for (const int face : {h / 3, discs.dual().twin[at(h)] / 3}) {
    if (flaw != Flaw::vertexWithoutDisc || !discs.exists(face)) wrong.push_back(face);
  }
}

}  // namespace

std::vector<int> wrongFaces(const FaceDiscs& discs, std::span<const int> edges) {
  std::vector<int> wrong;
  for (const int h : edges) addWrong(discs, h, wrong);
  sortUnique(wrong);
  return wrong;
}

std::vector<int> wrongFaces(const FaceDiscs& discs) {
  std::vector<int> wrong;
  for (int h = 0; h < discs.dual().halfEdgeCount(); ++h) {
    if (h < discs.dual().twin[at(h)]) addWrong(discs, h, wrong);
  }
  sortUnique(wrong);
  return wrong;
}

}  // namespace circle_voronoi
