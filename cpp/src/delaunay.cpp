// SPDX-License-Identifier: GPL-3.0-or-later
#include "delaunay.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>

#include "insertion_order.h"

namespace circle_voronoi {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
using FaceBase = CGAL::Triangulation_face_base_with_info_2<int, Kernel>;
using Triangulation =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>>;

/// Inserts all points; vertex info is the point's index. Returns each point's representative.
std::vector<int> insertAll(Triangulation& triangulation, std::span<const Point> points) {
  std::vector<int> representative(points.size());
  Triangulation::Face_handle hint;
  for (const int i : insertionOrder(points)) {
    const std::size_t before = triangulation.number_of_vertices();
    const auto vertex = triangulation.insert({points[i].x, points[i].y}, hint);
    if (triangulation.number_of_vertices() > before) vertex->info() = i;
    representative[i] = vertex->info();
    hint = vertex->face();
  }
  return representative;
}

Dual dualOf(Triangulation& triangulation) {
  int count = 0;
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face)
    face->info() = count++;
  triangulation.infinite_vertex()->info() = kInfinity;
  Dual dual;
  dual.origin.reserve(3 * static_cast<std::size_t>(count));
  dual.twin.reserve(3 * static_cast<std::size_t>(count));
  for (auto face = triangulation.all_faces_begin(); face != triangulation.all_faces_end(); ++face) {
    for (int i = 0; i < 3; ++i) {
      // The half-edge from vertex i to vertex ccw(i) lies opposite vertex cw(i).
      const auto neighbor = face->neighbor(Triangulation::cw(i));
      dual.origin.push_back(face->vertex(i)->info());
      dual.twin.push_back(3 * neighbor->info() + Triangulation::ccw(neighbor->index(face)));
    }
  }
  return dual;
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

/// The distinct points in order along their line.
std::vector<int> chainOf(const Triangulation& triangulation) {
  std::vector<Triangulation::Vertex_handle> vertices;
  for (const auto& vertex : triangulation.finite_vertex_handles()) vertices.push_back(vertex);
  std::sort(vertices.begin(), vertices.end(), [](auto a, auto b) { return a->point() < b->point(); });
  std::vector<int> chain;
  for (const auto& vertex : vertices) chain.push_back(vertex->info());
  return chain;
}

}  // namespace

Delaunay delaunay(std::span<const Point> points) {
  Triangulation triangulation;
  Delaunay result;
  result.representative = insertAll(triangulation, points);
  if (triangulation.dimension() == 2) result.dual = dualOf(triangulation);
  if (triangulation.dimension() == 1) result.dual = dualOfChain(chainOf(triangulation));
  return result;
}

DelaunayEdges delaunayEdges(std::span<const Point> points) {
  Triangulation triangulation;
  DelaunayEdges result;
  result.representative = insertAll(triangulation, points);
  result.edges.reserve(3 * triangulation.number_of_vertices());
  for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge) {
    const auto& [face, i] = *edge;
    result.edges.push_back({face->vertex(Triangulation::ccw(i))->info(), face->vertex(Triangulation::cw(i))->info()});
  }
  return result;
}

}  // namespace circle_voronoi
