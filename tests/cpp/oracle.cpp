// SPDX-License-Identifier: GPL-3.0-or-later
#include "oracle.h"

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Apollonius_graph_hierarchy_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Regular_triangulation_2.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <map>
#include <tuple>

namespace circle_voronoi::oracle {
namespace {

using Filter = CGAL::Simple_cartesian<double>;
using Exact = CGAL::Simple_cartesian<CGAL::Gmpq>;
using Traits = CGAL::Apollonius_graph_filtered_traits_2<Filter, CGAL::Field_with_sqrt_tag, Exact,
                                                        CGAL::Integral_domain_without_division_tag>;
using Graph = CGAL::Apollonius_graph_hierarchy_2<Traits>;

/// A site has no room for an index.
class Indices {
 public:
  explicit Indices(std::span<const Circle> circles) {
    // Among identical circles, the first stays visible.
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const Circle& c = circles[i];
      indices_.emplace(Key{c.x, c.y, c.r}, static_cast<int>(i));
    }
  }

  int of(Graph::Vertex_handle vertex) const {
    const Graph::Site_2& site = vertex->site();
    return indices_.at(Key{site.point().x(), site.point().y(), site.weight()});
  }

 private:
  using Key = std::tuple<double, double, double>;
  std::map<Key, int> indices_;
};

}  // namespace

Diagram exactDiagram(std::span<const Circle> circles) {
  const Indices indices(circles);
  Graph graph;
  for (const Circle& c : circles) graph.insert(Graph::Site_2(Graph::Point_2(c.x, c.y), c.r));

  Diagram diagram;
  std::vector<int> visible;
  std::vector<bool> isVisible(circles.size(), false);
  for (auto v = graph.finite_vertices_begin(); v != graph.finite_vertices_end(); ++v) {
    visible.push_back(indices.of(v));
    isVisible[visible.back()] = true;
  }
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (!isVisible[i]) diagram.hidden.push_back({static_cast<int>(i), kNone});
  }
  if (visible.size() == 2) diagram.edges.push_back({visible[0], visible[1], kNone, kNone});
  if (visible.size() <= 2) return diagram;

  std::map<Graph::Face_handle, int> vertexOf;
  for (auto face = graph.all_faces_begin(); face != graph.all_faces_end(); ++face) {
    vertexOf[face] = graph.is_infinite(face) ? kNone : static_cast<int>(diagram.vertexCircles.size());
    if (graph.is_infinite(face)) continue;
    diagram.vertexCircles.push_back(
        {indices.of(face->vertex(0)), indices.of(face->vertex(1)), indices.of(face->vertex(2))});
  }
  for (const auto& [face, vertex] : vertexOf) {
    for (int i = 0; i < 3; ++i) {
      const Graph::Face_handle neighbor = face->neighbor(i);
      const auto a = face->vertex((i + 1) % 3);
      const auto b = face->vertex((i + 2) % 3);
      if (neighbor < face || graph.is_infinite(a) || graph.is_infinite(b)) continue;
      // The face lies left of a -> b; the Voronoi edge leaves it with b on its left.
      diagram.edges.push_back({indices.of(b), indices.of(a), vertex, vertexOf.at(neighbor)});
    }
  }
  return diagram;
}

std::vector<std::array<int, 3>> delaunayFaces(std::span<const Point> points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel>;
  std::map<Kernel::Point_2, int> indices;
  std::vector<Kernel::Point_2> sites;
  for (const Point& p : points) {
    sites.emplace_back(p.x, p.y);
    indices.emplace(sites.back(), static_cast<int>(sites.size()) - 1);
  }
  const Triangulation triangulation(sites.begin(), sites.end());
  const auto indexOf = [&](Triangulation::Vertex_handle vertex) {
    return triangulation.is_infinite(vertex) ? kNone : indices.at(vertex->point());
  };
  std::vector<std::array<int, 3>> faces;
  if (triangulation.dimension() == 2) {
    for (const auto face : triangulation.all_face_handles()) {
      faces.push_back({indexOf(face->vertex(0)), indexOf(face->vertex(1)), indexOf(face->vertex(2))});
    }
  } else if (triangulation.dimension() == 1) {
    for (auto edge = triangulation.finite_edges_begin(); edge != triangulation.finite_edges_end(); ++edge) {
      const int a = indexOf(edge->first->vertex(0));
      const int b = indexOf(edge->first->vertex(1));
      faces.insert(faces.end(), {{a, b, kNone}, {b, a, kNone}});
    }
  }
  for (auto& face : faces) std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
  std::sort(faces.begin(), faces.end());
  return faces;
}

std::vector<std::array<int, 3>> regularFaces(std::span<const Circle> circles, bool weights) {
  using Kernel = CGAL::Simple_cartesian<CGAL::Gmpq>;
  using Triangulation = CGAL::Regular_triangulation_2<Kernel>;
  const auto weightOf = [&](const Circle& c) {
    const CGAL::Gmpq r(c.r);
    return weights ? r : CGAL::Gmpq(r * r);
  };
  std::map<std::pair<double, double>, int> indices;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const auto index = static_cast<int>(i);
    const auto [place, isNew] = indices.emplace(std::pair(circles[i].x, circles[i].y), index);
    if (!isNew && weightOf(circles[i]) > weightOf(circles[static_cast<std::size_t>(place->second)])) {
      place->second = index;
    }
  }
  Triangulation triangulation;
  std::map<Triangulation::Vertex_handle, int> indexOf;
  for (const auto& [place, index] : indices) {
    const Circle& c = circles[static_cast<std::size_t>(index)];
    const auto vertex = triangulation.insert({Kernel::Point_2(c.x, c.y), weightOf(c)});
    if (vertex != nullptr) indexOf[vertex] = index;
  }
  std::vector<std::array<int, 3>> faces;
  if (triangulation.dimension() < 2) return faces;
  for (const auto face : triangulation.finite_face_handles()) {
    faces.push_back({indexOf.at(face->vertex(0)), indexOf.at(face->vertex(1)), indexOf.at(face->vertex(2))});
  }
  return faces;
}

}  // namespace circle_voronoi::oracle
