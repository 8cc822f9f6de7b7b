// SPDX-License-Identifier: GPL-3.0-or-later
#include "apollonius.h"

#include <CGAL/Apollonius_graph_2.h>
#include <CGAL/Apollonius_graph_traits_2.h>
#include <CGAL/MP_Float.h>
#include <CGAL/Simple_cartesian.h>

#include <array>
#include <map>

namespace circle_voronoi {
namespace {

// Exact arithmetic throughout. CGAL's filtered traits would be faster here, but they compile every predicate three
// times, which doubles the size of the WebAssembly module, and the last resort need not be fast.
using Kernel = CGAL::Simple_cartesian<CGAL::MP_Float>;
using Traits = CGAL::Apollonius_graph_traits_2<Kernel, CGAL::Integral_domain_without_division_tag>;
using Graph = CGAL::Apollonius_graph_2<Traits>;

}  // namespace

Dual apolloniusGraph(std::span<const Circle> circles) {
  Graph graph;
  std::map<std::array<double, 3>, int> indexOf;
  Graph::Vertex_handle near;
  for (int i = 0; i < static_cast<int>(circles.size()); ++i) {
    const Circle& c = circles[i];
    const Graph::Site_2 site(Kernel::Point_2(c.x, c.y), c.r);
    near = near == Graph::Vertex_handle() ? graph.insert(site) : graph.insert(site, near);
    indexOf[{c.x, c.y, c.r}] = i;
  }
  Dual dual;
  if (graph.dimension() < 2) return dual;
  const auto cornerOf = [&](Graph::Vertex_handle vertex) {
    if (graph.is_infinite(vertex)) return kPointAtInfinity;
    const auto& site = vertex->site();
    return indexOf.at(
        {CGAL::to_double(site.point().x()), CGAL::to_double(site.point().y()), CGAL::to_double(site.weight())});
  };
  std::map<Graph::Face_handle, int> faceOf;
  for (auto face = graph.all_faces_begin(); face != graph.all_faces_end(); ++face) {
    const int index = static_cast<int>(faceOf.size());
    faceOf[face] = index;
  }
  for (auto face = graph.all_faces_begin(); face != graph.all_faces_end(); ++face) {
    for (int i = 0; i < 3; ++i) {
      const int opposite = CGAL::Triangulation_cw_ccw_2::cw(i);
      dual.origin.push_back(cornerOf(face->vertex(i)));
      // Two faces may share several edges: the mirror index tells them apart.
      dual.twin.push_back(3 * faceOf.at(face->neighbor(opposite)) +
                          CGAL::Triangulation_cw_ccw_2::ccw(graph.data_structure().mirror_index(face, opposite)));
    }
  }
  return dual;
}

}  // namespace circle_voronoi
