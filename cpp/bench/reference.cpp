// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference.h"

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_filtered_traits_2.h>
#include <CGAL/Apollonius_graph_hierarchy_2.h>
#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Gmpq.h>
#include <CGAL/Simple_cartesian.h>

#include <vector>

namespace circle_voronoi::reference {
namespace {

template <class Graph>
std::size_t build(std::span<const Circle> circles) {
  std::vector<typename Graph::Site_2> sites;
  sites.reserve(circles.size());
  for (const Circle& c : circles) sites.emplace_back(typename Graph::Point_2(c.x, c.y), c.r);
  Graph graph;
  graph.insert(sites.begin(), sites.end());
  return graph.number_of_vertices();
}

}  // namespace

std::size_t delaunay(std::span<const Circle> circles) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> points;
  points.reserve(circles.size());
  for (const Circle& c : circles) points.emplace_back(c.x, c.y);
  return CGAL::Delaunay_triangulation_2<Kernel>(points.begin(), points.end()).number_of_vertices();
}

std::size_t apolloniusHierarchy(std::span<const Circle> circles) {
  using Traits = CGAL::Apollonius_graph_filtered_traits_2<CGAL::Simple_cartesian<double>>;
  return build<CGAL::Apollonius_graph_hierarchy_2<Traits>>(circles);
}

std::size_t apolloniusExact(std::span<const Circle> circles) {
  using Traits = CGAL::Apollonius_graph_traits_2<CGAL::Simple_cartesian<CGAL::Gmpq>, CGAL::Field_tag>;
  return build<CGAL::Apollonius_graph_2<Traits>>(circles);
}

}  // namespace circle_voronoi::reference
