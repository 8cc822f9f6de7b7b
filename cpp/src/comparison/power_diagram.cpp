// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_2.h>

#include <algorithm>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <cstdint>
#include <map>
#include <tuple>
#include <utility>
#include <vector>

#include "circle_voronoi/comparison.h"
#include "guarded.h"
#include "spatial_order.h"
#include "topology.h"
#include "validate.h"
#include "vectors.h"

namespace circle_voronoi {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Triangulation = CGAL::Regular_triangulation_2<Kernel>;
using VertexHandle = Triangulation::Vertex_handle;

/// A vertex of the triangulation has no room for an index; of equal circles the first stands for all.
class Indices {
 public:
  explicit Indices(std::span<const Circle> circles) {
    for (std::size_t i = 0; i < circles.size(); ++i) {
      const Circle& c = circles[i];
      indices_.emplace(Key{c.x, c.y, c.r * c.r}, static_cast<std::int32_t>(i));
    }
  }
  std::int32_t of(VertexHandle vertex) const {
    const auto& p = vertex->point();
    return indices_.at(Key{p.x(), p.y(), p.weight()});
  }

 private:
  using Key = std::tuple<double, double, double>;
  std::map<Key, std::int32_t> indices_;
};

using Integer = boost::multiprecision::cpp_int;
using Number = boost::multiprecision::cpp_rational;

/// mantissa * 2^exponent, with one to four as the mantissa or zero: a number that may be beyond the doubles.
struct Scaled {
  double mantissa = 0;
  int exponent = 0;

  double value() const { return std::ldexp(mantissa, exponent); }
};

/// Rounds a number to the nearest one of 53 bits.
Scaled rounded(const Number& number) {
  if (number.is_zero()) return {};
  constexpr int kBits = 62;
  Integer above = abs(numerator(number));
  Integer below = denominator(number);
  const int exponent = static_cast<int>(msb(above)) - static_cast<int>(msb(below)) - kBits;
  (exponent > 0 ? below : above) <<= std::abs(exponent);
  Integer quotient, rest;
  divide_qr(above, below, quotient, rest);
  // A sticky bit: it says that a remainder follows, and it is too small to disturb the rounding of the other bits.
  const auto bits = static_cast<std::uint64_t>(quotient) | (rest.is_zero() ? 0U : 1U);
  const auto size = static_cast<double>(bits);
  return {std::ldexp(number.sign() < 0 ? -size : size, 1 - kBits), exponent + kBits - 1};
}

/// Returns the square root of the absolute value, with the sign of the number.
Scaled squareRoot(Scaled number) {
  if (number.exponent % 2 != 0) number = {2 * number.mantissa, number.exponent - 1};
  return {std::copysign(std::sqrt(std::abs(number.mantissa)), number.mantissa), number.exponent / 2};
}

/// Returns the point of equal power to three circles. Every number is rounded once.
Vertex exactRadicalCenter(const Circle& a, const Circle& b, const Circle& c) {
  const auto half = [&](const Circle& d, const Number& x, const Number& y) -> Number {
    return (x * x + y * y + Number(a.r * a.r) - Number(d.r * d.r)) / 2;
  };
  const Number ux = Number(b.x) - Number(a.x);
  const Number uy = Number(b.y) - Number(a.y);
  const Number vx = Number(c.x) - Number(a.x);
  const Number vy = Number(c.y) - Number(a.y);
  const Number ku = half(b, ux, uy);
  const Number kv = half(c, vx, vy);
  const Number determinant = ux * vy - uy * vx;
  const Number x = (ku * vy - kv * uy) / determinant;
  const Number y = (kv * ux - ku * vx) / determinant;
  const Number power = x * x + y * y - Number(a.r * a.r);
  return {rounded(x + Number(a.x)).value(), rounded(y + Number(a.y)).value(), squareRoot(rounded(power)).value()};
}

/// Returns the point of equal power to three circles. Computes relative to the first circle for accuracy.
///
/// The determinant is a multiple of 2^-192 (limits.h), and ku and kv are below 2^195. So the center is below 2^487, and
/// its square does not overflow.
Vertex radicalCenter(const Circle& a, const Circle& b, const Circle& c) {
  const Vector u = between(a, b);
  const Vector v = between(a, c);
  const double ku = (dot(u, u) + (a.r - b.r) * (a.r + b.r)) / 2;
  const double kv = (dot(v, v) + (a.r - c.r) * (a.r + c.r)) / 2;
  const double determinant = cross(u, v);
  const Vector center = {(ku * v.y - kv * u.y) / determinant, (kv * u.x - ku * v.x) / determinant};
  const double d = length(center);
  const double power = (d - a.r) * (d + a.r);
  // If cancellation leaves a smaller share, as for nearly collinear or nearly equal centers, the rest may be rounding
  // error.
  constexpr double kCertain = 0x1p-30;
  const auto sizeOf = [](const Vector& w) { return std::abs(w.x) + std::abs(w.y); };
  const double terms =
      (dot(u, u) + a.r * a.r + b.r * b.r) * sizeOf(v) + (dot(v, v) + a.r * a.r + c.r * c.r) * sizeOf(u);
  const double products = std::abs(u.x * v.y) + std::abs(u.y * v.x);
  if (!(std::abs(determinant) > kCertain * products) || !(std::abs(determinant) * sizeOf(center) > kCertain * terms)) {
    return exactRadicalCenter(a, b, c);
  }
  return {a.x + center.x, a.y + center.y, std::copysign(std::sqrt(std::abs(power)), power)};
}

/// Adds the diagram of centers on a line: parallel edges, and a hull that goes there and back.
void addChain(const std::vector<CircleIndex>& chain, Diagram& diagram) {
  for (std::size_t i = 1; i < chain.size(); ++i) diagram.edges.push_back({chain[i - 1], chain[i], kNone, kNone});
  diagram.hull = chain;
  for (std::size_t i = chain.size() - 1; i-- > 1;) diagram.hull.push_back(chain[i]);
}

void addTriangles(const Triangulation& triangulation, const Indices& indices, std::span<const Circle> circles,
                  Diagram& diagram) {
  std::map<Triangulation::Face_handle, std::int32_t> vertexOf;
  for (const auto face : triangulation.finite_face_handles()) {
    vertexOf[face] = static_cast<std::int32_t>(diagram.vertices.size());
    const auto& triple = diagram.vertexCircles.emplace_back(std::array<CircleIndex, 3>{
        indices.of(face->vertex(0)), indices.of(face->vertex(1)), indices.of(face->vertex(2))});
    const auto circleAt = [&](std::size_t k) { return circles[static_cast<std::size_t>(triple[k])]; };
    diagram.vertices.push_back(radicalCenter(circleAt(0), circleAt(1), circleAt(2)));
  }
  // Each edge is added from its first face in this order. CGAL's own list of edges depends on addresses in memory.
  for (const auto face : triangulation.finite_face_handles()) {
    const std::int32_t vertex = vertexOf.at(face);
    for (int i = 0; i < 3; ++i) {
      const auto neighbor = face->neighbor(i);
      const std::int32_t beyond = triangulation.is_infinite(neighbor) ? kNone : vertexOf.at(neighbor);
      if (beyond != kNone && beyond < vertex) continue;
      // The face lies left of the edge from its corner ccw(i) to cw(i); the Voronoi edge leaves it with the latter on
      // its left.
      diagram.edges.push_back({indices.of(face->vertex(Triangulation::cw(i))),
                               indices.of(face->vertex(Triangulation::ccw(i))), vertex, beyond});
    }
  }
  // Counter-clockwise around infinity is clockwise around the hull.
  const auto first = triangulation.incident_vertices(triangulation.infinite_vertex());
  auto corner = first;
  do {
    diagram.hull.push_back(indices.of(corner));
  } while (--corner != first);
}

Diagram powerDiagramOf(std::span<const Circle> circles) {
  Triangulation triangulation;
  std::vector<Point> centers;
  centers.reserve(circles.size());
  for (const Circle& c : circles) centers.push_back({c.x, c.y});
  // In an order of our own: CGAL's differs between standard libraries, and with it the numbers of vertices.
  Triangulation::Face_handle hint;
  for (const int i : spatialOrder(centers)) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    hint = triangulation.insert({Kernel::Point_2(c.x, c.y), c.r * c.r}, hint)->face();
  }
  const Indices indices(circles);

  Diagram diagram;
  std::vector<VertexHandle> visible(triangulation.finite_vertex_handles().begin(),
                                    triangulation.finite_vertex_handles().end());
  std::vector<bool> isVisible(circles.size(), false);
  for (const VertexHandle vertex : visible) isVisible[static_cast<std::size_t>(indices.of(vertex))] = true;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    if (!isVisible[i]) diagram.hidden.push_back({static_cast<std::int32_t>(i), kNone});
  }
  if (triangulation.dimension() == 2) {
    addTriangles(triangulation, indices, circles, diagram);
  } else if (!visible.empty()) {
    std::sort(visible.begin(), visible.end(), [](VertexHandle a, VertexHandle b) {
      return std::pair(a->point().x(), a->point().y()) < std::pair(b->point().x(), b->point().y());
    });
    std::vector<CircleIndex> chain;
    for (const VertexHandle vertex : visible) chain.push_back(indices.of(vertex));
    addChain(chain, diagram);
  }
  if (!diagram.hull.empty()) rotateHull(diagram.hull);
  return diagram;
}

}  // namespace

Result<Diagram> powerDiagram(std::span<const Circle> circles) {
  return guarded([&]() -> Result<Diagram> {
    auto rounded = validate(circles);
    if (!rounded) return rounded.error();
    Diagram diagram = powerDiagramOf(rounded.value());
    diagram.circles = std::move(rounded).value();
    diagram.metric = Metric::power;
    linkSides(diagram);
    return diagram;
  });
}

}  // namespace circle_voronoi
