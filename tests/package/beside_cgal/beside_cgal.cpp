// SPDX-License-Identifier: GPL-3.0-or-later
// Uses CGAL's own triangulations and the library's diagrams in one program. Each must work as it does alone.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>
#include <circle_voronoi/compute.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <iostream>
#include <set>
#include <vector>

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using circle_voronoi::Circle;
/// The coordinates of three circles that have a vertex.
using Triple = std::array<std::array<double, 2>, 3>;

std::vector<Circle> scatteredCircles(std::size_t count, double largestRadius) {
  std::uint64_t state = 1;
  const auto next = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 40);
  };
  std::vector<Circle> circles(count);
  for (Circle& c : circles) c = {next(), next(), next() * 0x1p-24 * largestRadius};
  return circles;
}

template <class Triangulation>
std::set<Triple> triplesOf(const Triangulation& triangulation) {
  std::set<Triple> triples;
  for (const auto face : triangulation.finite_face_handles()) {
    Triple triple;
    for (int i = 0; i < 3; ++i) {
      const auto& p = face->vertex(i)->point();
      triple[static_cast<std::size_t>(i)] = {p.x(), p.y()};
    }
    std::sort(triple.begin(), triple.end());
    triples.insert(triple);
  }
  return triples;
}

std::set<Triple> triplesOf(const std::vector<Circle>& circles, const circle_voronoi::Diagram& diagram) {
  std::set<Triple> triples;
  for (const auto& vertexCircles : diagram.vertexCircles) {
    Triple triple;
    for (std::size_t i = 0; i < 3; ++i) {
      const Circle& c = circles[static_cast<std::size_t>(vertexCircles[i])];
      triple[i] = {c.x, c.y};
    }
    std::sort(triple.begin(), triple.end());
    triples.insert(triple);
  }
  return triples;
}

int failures = 0;

void expect(bool holds, const char* what) {
  std::cout << (holds ? "right: " : "wrong: ") << what << '\n';
  if (!holds) ++failures;
}

}  // namespace

int main() {
  const std::vector<Circle> points = scatteredCircles(2000, 0);
  CGAL::Delaunay_triangulation_2<Kernel> delaunay;
  for (const Circle& c : points) delaunay.insert(Kernel::Point_2(c.x, c.y));
  expect(delaunay.is_valid() && triplesOf(delaunay) == triplesOf(points, circle_voronoi::compute(points).value()),
         "the diagram of points is the dual of CGAL's Delaunay triangulation");

  // On a grid every sign is zero or close to zero.
  std::vector<Circle> grid;
  for (int i = 0; i < 400; ++i) grid.push_back({0.1 * (i % 20), 0.1 * (i / 20), 0});
  CGAL::Delaunay_triangulation_2<Kernel> gridDelaunay;
  for (const Circle& c : grid) gridDelaunay.insert(Kernel::Point_2(c.x, c.y));
  const auto gridDiagram = circle_voronoi::compute(grid);
  expect(gridDelaunay.is_valid() && gridDiagram.ok() && gridDiagram.value().certificate.certified() &&
             gridDiagram.value().vertices.size() == gridDelaunay.number_of_faces(),
         "a grid has as many vertices as CGAL has triangles");

  const std::vector<Circle> circles = scatteredCircles(2000, 3e5);
  CGAL::Regular_triangulation_2<Kernel> regular;
  for (const Circle& c : circles) regular.insert({Kernel::Point_2(c.x, c.y), c.r * c.r});
  const auto power = circle_voronoi::compute(circles, {.metric = circle_voronoi::Metric::power});
  expect(regular.is_valid() && power.ok() && power.value().hidden.size() == regular.number_of_hidden_vertices() &&
             regular.number_of_hidden_vertices() > 0 && triplesOf(regular) == triplesOf(circles, power.value()),
         "the power diagram is the dual of CGAL's regular triangulation");

  const auto diagram = circle_voronoi::compute(circles);
  expect(diagram.ok() && diagram.value().certificate.certified(), "the diagram of circles is certified");
  return failures;
}
