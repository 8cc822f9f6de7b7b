// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>

#include "in_circle.h"

namespace circle_voronoi {
namespace {

using Epick = CGAL::Exact_predicates_inexact_constructions_kernel;

/// CGAL's kernel with our exact tests in place of its two: on grids, whose ties no filter decides, CGAL's are several
/// times slower natively and much slower in WebAssembly, where its interval arithmetic cannot set the rounding mode.
struct Kernel : Epick {
  struct Orientation_2 {
    using result_type = CGAL::Orientation;
    result_type operator()(const Epick::Point_2& a, const Epick::Point_2& b, const Epick::Point_2& c) const {
      return static_cast<result_type>(orientation(pointOf(a), pointOf(b), pointOf(c)));
    }
  };
  struct Side_of_oriented_circle_2 {
    using result_type = CGAL::Oriented_side;
    result_type operator()(const Epick::Point_2& a, const Epick::Point_2& b, const Epick::Point_2& c,
                           const Epick::Point_2& d) const {
      return static_cast<result_type>(inCircle(pointOf(a), pointOf(b), pointOf(c), pointOf(d)));
    }
  };
  Orientation_2 orientation_2_object() const { return {}; }
  Side_of_oriented_circle_2 side_of_oriented_circle_2_object() const { return {}; }

 private:
  static Point pointOf(const Epick::Point_2& p) { return {p.x(), p.y()}; }
};

using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/// A fixed mixing of an index (splitmix64), in place of a random number.
std::uint64_t mix(std::uint64_t i) {
  i += 0x9e3779b97f4a7c15u;
  i = (i ^ (i >> 30)) * 0xbf58476d1ce4e5b9u;
  i = (i ^ (i >> 27)) * 0x94d049bb133111ebu;
  return i ^ (i >> 31);
}

/// The order of insertion: random rounds, each in the order given; three points in four go to the last round, three in
/// four of the rest to the one before, and so on (N. Amenta, S. Choi, G. Rote, "Incremental constructions con BRIO",
/// 2003).
std::vector<int> insertionOrder(std::size_t count) {
  constexpr int kRounds = 16;
  const auto roundOf = [](std::size_t i) { return kRounds - 1 - std::min(kRounds - 1, std::countr_zero(mix(i)) / 2); };
  std::array<std::size_t, kRounds + 1> first{};
  for (std::size_t i = 0; i < count; ++i) ++first[roundOf(i) + 1];
  for (int round = 1; round <= kRounds; ++round) first[round] += first[round - 1];
  std::vector<int> order(count);
  for (std::size_t i = 0; i < count; ++i) order[first[roundOf(i)]++] = static_cast<int>(i);
  return order;
}

/// Inserts all points; vertex info is the point's index. Returns each point's representative.
std::vector<int> insertAll(Triangulation& triangulation, std::span<const Point> points) {
  std::vector<int> representative(points.size());
  Triangulation::Face_handle hint;
  for (const int i : insertionOrder(points.size())) {
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert({points[i].x, points[i].y}, hint);
    if (triangulation.number_of_vertices() > before) vertex->info() = i;
    representative[i] = vertex->info();
    hint = vertex->face();
  }
  return representative;
}

Dual dualOf(Triangulation& triangulation, std::size_t pointCount) {
  triangulation.infinite_vertex()->info() = kInfinity;
  // Number the faces by their smallest corner, so that the faces around a circle are near in memory.
  std::vector<int> first(pointCount + 2, 0);
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face) {
    const int smallest = std::min({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
    face->info() = smallest + 1;
    ++first[smallest + 2];
  }
  for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
  const auto count = static_cast<std::size_t>(first.back());
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face) {
    face->info() = first[face->info()]++;
  }
  Dual dual;
  dual.origin.resize(3 * count);
  dual.twin.resize(3 * count);
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face) {
    for (int i = 0; i < 3; ++i) {
      // The half-edge from vertex i to vertex ccw(i) lies opposite vertex cw(i).
      const auto neighbor = face->neighbor(Triangulation::cw(i));
      const int h = 3 * face->info() + i;
      dual.origin[h] = face->vertex(i)->info();
      dual.twin[h] = 3 * neighbor->info() + Triangulation::ccw(neighbor->index(face));
    }
  }
  return dual;
}

bool areCollinear(std::span<const Point> points) {
  const auto differs = [&](const Point& p) { return p.x != points[0].x || p.y != points[0].y; };
  const auto other = std::find_if(points.begin(), points.end(), differs);
  return std::all_of(other, points.end(), [&](const Point& p) { return orientation(points[0], *other, p) == 0; });
}

/// Collinear points: every face has the corner at infinity, one on each side of each edge of the chain.
Dual dualOfChain(const std::vector<int>& chain) {
  const int edgeCount = static_cast<int>(chain.size()) - 1;
  Dual dual;
  dual.origin.reserve(6 * static_cast<std::size_t>(edgeCount));
  dual.twin.reserve(6 * static_cast<std::size_t>(edgeCount));
  // Edge i has the half-edges 6 i + 0, 1, 2 (p_i, p_i+1, infinity) and 6 i + 3, 4, 5 (p_i+1, p_i, infinity).
  for (int i = 0; i < edgeCount; ++i) {
    dual.origin.insert(dual.origin.end(), {chain[i], chain[i + 1], kInfinity, chain[i + 1], chain[i], kInfinity});
    const int after = i + 1 < edgeCount ? 6 * (i + 1) + 2 : 6 * i + 5;
    const int before = i > 0 ? 6 * (i - 1) + 5 : 2;
    const int left = i > 0 ? 6 * (i - 1) + 1 : 4;
    const int right = i + 1 < edgeCount ? 6 * (i + 1) + 4 : 6 * i + 1;
    dual.twin.insert(dual.twin.end(), {6 * i + 3, after, left, 6 * i, before, right});
  }
  return dual;
}

/// The distinct points in order along their line; notes each point's representative.
std::vector<int> chainOf(std::span<const Point> points, std::vector<int>& representative) {
  std::vector<int> order(points.size());
  std::iota(order.begin(), order.end(), 0);
  const auto position = [&](int i) { return std::pair(points[i].x, points[i].y); };
  std::sort(order.begin(), order.end(),
            [&](int i, int j) { return std::pair(position(i), i) < std::pair(position(j), j); });
  representative.resize(points.size());
  std::vector<int> chain;
  for (const int i : order) {
    if (chain.empty() || position(chain.back()) != position(i)) chain.push_back(i);
    representative[i] = chain.back();
  }
  return chain;
}

}  // namespace

Delaunay delaunay(std::span<const Point> points) {
  Delaunay result;
  if (areCollinear(points)) {
    const std::vector<int> chain = chainOf(points, result.representative);
    if (chain.size() > 1) result.dual = dualOfChain(chain);
    return result;
  }
  Triangulation triangulation;
  result.representative = insertAll(triangulation, points);
  result.dual = dualOf(triangulation, points.size());
  return result;
}

DelaunayEdges delaunayEdges(std::span<const Point> points) {
  DelaunayEdges result;
  if (areCollinear(points)) {
    const std::vector<int> chain = chainOf(points, result.representative);
    for (std::size_t i = 1; i < chain.size(); ++i) result.edges.push_back({chain[i - 1], chain[i]});
    return result;
  }
  Triangulation triangulation;
  result.representative = insertAll(triangulation, points);
  result.edges.reserve(3 * triangulation.number_of_vertices());
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge) {
    const auto& [face, i] = *edge;
    result.edges.push_back({face->vertex(Triangulation::ccw(i))->info(), face->vertex(Triangulation::cw(i))->info()});
  }
  return result;
}

}  // namespace circle_voronoi
