// SPDX-License-Identifier: GPL-3.0-or-later
#include "flip.h"

#include <vector>

namespace circle_voronoi {
namespace {

class Flipper {
 public:
  Flipper(std::span<const Circle> circles, Dual& dual, Predicates& predicates)
      : circles_(circles), dual_(dual), predicates_(predicates) {
    discs_.reserve(dual.faceCount());
    for (int face = 0; face < dual.faceCount(); ++face) discs_.push_back(discOf(face));
  }

  std::int64_t run() {
    // Far more flips than any input seen needs: going on means going round in circles.
    const std::int64_t limit = 1000 + 10 * static_cast<std::int64_t>(dual_.faceCount());
    std::int64_t flips = 0;
    for (int first = 0; first < dual_.halfEdgeCount(); ++first) {
      if (first > dual_.twin[first]) continue;
      stack_.push_back(first);
      while (!stack_.empty()) {
        const int h = stack_.back();
        stack_.pop_back();
        if (!isWrong(h)) continue;
        if (flips == limit) return flips;
        flipEdge(h);
        ++flips;
      }
    }
    return flips;
  }

 private:
  FaceDisc discOf(int face) {
    return predicates_.disc({dual_.origin[3 * face], dual_.origin[3 * face + 1], dual_.origin[3 * face + 2]});
  }

  bool isWrong(int h) {
    const int t = dual_.twin[h];
    const int a = dual_.origin[h];
    const int b = dual_.origin[t];
    const int c = dual_.origin[Dual::previous(h)];
    const int d = dual_.origin[Dual::previous(t)];
    if (c == d) return false;  // the flipped edge would be a loop
    // The hull goes d, a, c (or d, b, c): the middle circle must not lie behind the tangent line of the other two.
    if (b == kInfinity) return predicates_.tangentSide(c, d, a) < 0 && predicates_.disc({a, d, c}).exists;
    if (a == kInfinity) return predicates_.tangentSide(d, c, b) < 0 && predicates_.disc({b, c, d}).exists;
    const FaceDisc& f = discs_[h / 3];
    const FaceDisc& g = discs_[t / 3];
    if (!f.exists || !g.exists) {
      return (!f.exists && isTopOf(a, b, c) && predicates_.tangentSide(b, a, c) >= 0) ||
             (!g.exists && isTopOf(b, a, d) && predicates_.tangentSide(a, b, d) >= 0);
    }
    return predicates_.edgeOrder(a, b, c, d, f, g) < 0;
  }

  /// The length of the common tangents of two circles, squared.
  double tangentLength(int i, int j) const {
    const Circle& a = circles_[i];
    const Circle& b = circles_[j];
    const Vector v = between(a, b);
    return dot(v, v) - (a.r - b.r) * (a.r - b.r);
  }

  /// Where a disc is lost its circles come to lie along one tangent line: c, in the middle, crosses that of a and b.
  bool isTopOf(int a, int b, int c) const {
    const double ab = tangentLength(a, b);
    return ab >= tangentLength(b, c) && ab >= tangentLength(c, a);
  }

  /// Faces (a, b, c) and (b, a, d) become (a, d, c) and (b, c, d).
  void flipEdge(int h) {
    const int t = dual_.twin[h];
    const int bc = Dual::next(h);
    const int ad = Dual::next(t);
    const int ca = Dual::previous(h);
    const int db = Dual::previous(t);
    const int beyondAd = dual_.twin[ad];
    const int beyondBc = dual_.twin[bc];
    link(h, beyondAd);
    link(t, beyondBc);
    dual_.origin[bc] = dual_.origin[db];
    dual_.origin[ad] = dual_.origin[ca];
    link(bc, ad);
    discs_[h / 3] = discOf(h / 3);
    discs_[t / 3] = discOf(t / 3);
    if (!discs_[h / 3].exists || !discs_[t / 3].exists) stack_.push_back(bc);
    for (const int outer : {h, ca, t, db}) stack_.push_back(outer);
  }

  void link(int h, int t) {
    dual_.twin[h] = t;
    dual_.twin[t] = h;
  }

  std::span<const Circle> circles_;
  Dual& dual_;
  Predicates& predicates_;
  std::vector<FaceDisc> discs_;
  std::vector<int> stack_;
};

}  // namespace

std::int64_t flip(std::span<const Circle> circles, Dual& dual, Predicates& predicates) {
  return Flipper(circles, dual, predicates).run();
}

}  // namespace circle_voronoi
