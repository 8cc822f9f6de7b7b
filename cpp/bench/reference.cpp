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

#include <chrono>
#include <vector>

namespace circle_voronoi::reference {
namespace {

template <class Graph>
typename Graph::Site_2 siteOf(const Circle& c) {
  return {typename Graph::Point_2(c.x, c.y), c.r};
}

template <class Graph>
std::vector<typename Graph::Site_2> sitesOf(std::span<const Circle> circles) {
  std::vector<typename Graph::Site_2> sites;
  sites.reserve(circles.size());
  for (const Circle& c : circles) sites.push_back(siteOf<Graph>(c));
  return sites;
}

template <class Graph>
std::size_t build(std::span<const Circle> circles) {
  const auto sites = sitesOf<Graph>(circles);
  Graph graph;
  graph.insert(sites.begin(), sites.end());
  return graph.number_of_vertices();
}

using Hierarchy =
    CGAL::Apollonius_graph_hierarchy_2<CGAL::Apollonius_graph_filtered_traits_2<CGAL::Simple_cartesian<double>>>;

}  // namespace

std::size_t delaunay(std::span<const Circle> circles) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> points;
  points.reserve(circles.size());
  for (const Circle& c : circles) points.emplace_back(c.x, c.y);
  return CGAL::Delaunay_triangulation_2<Kernel>(points.begin(), points.end()).number_of_vertices();
}

std::size_t apolloniusHierarchy(std::span<const Circle> circles) { return build<Hierarchy>(circles); }

void apolloniusEdits(std::span<const Circle> circles, std::span<const Circle> inserted, std::vector<double>& inserts,
                     std::vector<double>& removals) {
  using Clock = std::chrono::steady_clock;
  const auto timed = [](std::vector<double>& seconds, const auto& edit) {
    const auto start = Clock::now();
    edit();
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count());
  };
  const auto sites = sitesOf<Hierarchy>(circles);
  Hierarchy graph;
  graph.insert(sites.begin(), sites.end());
  for (const Circle& c : inserted) {
    const std::size_t before = graph.number_of_vertices();
    Hierarchy::Vertex_handle handle;
    timed(inserts, [&] { handle = graph.insert(siteOf<Hierarchy>(c)); });
    if (graph.number_of_vertices() == before + 1) timed(removals, [&] { graph.remove(handle); });
  }
}

std::size_t apolloniusExact(std::span<const Circle> circles) {
  using Traits = CGAL::Apollonius_graph_traits_2<CGAL::Simple_cartesian<CGAL::Gmpq>, CGAL::Field_tag>;
  return build<CGAL::Apollonius_graph_2<Traits>>(circles);
}

}  // namespace circle_voronoi::reference
