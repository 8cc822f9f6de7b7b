// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <numbers>

#include "circle_voronoi/export.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi/queries.h"
#include "export_frame.h"
#include "writer.h"

namespace circle_voronoi {
namespace {

constexpr double kPixels = 1000;  ///< the longer side of the drawing
constexpr double kVertexPixels = 1.5;
constexpr double kPointPixels = 0.5;  ///< a smaller radius is hard to see

constexpr std::string_view kStyle = R"(<style>
path, line, circle { vector-effect: non-scaling-stroke; }
.cells { fill: #f6f4ee; stroke: none; }
.edges { fill: none; stroke: #1f4e79; stroke-width: 1.5; }
.dual { stroke: #a59d8a; stroke-width: 0.75; }
.hull { fill: none; stroke: #8a6d1d; stroke-width: 1; stroke-dasharray: 6 4; }
.circles { fill: #d9822b; fill-opacity: 0.35; stroke: #a85a10; stroke-width: 1; }
.circles .hidden { fill: #8c8c8c; stroke: #6e6e6e; stroke-dasharray: 3 2; }
.circles .point { stroke-width: 3; stroke-linecap: round; stroke-dasharray: none; }
.vertices { fill: #1f4e79; stroke: none; }
</style>
)";

void writePoint(Writer& out, Point p) { out << p.x << " " << p.y; }

void moveTo(Writer& out, Point p) {
  out << "M";
  writePoint(out, p);
}

/// Draws on from the start of the curve, or, against it, from its end.
void traceCurve(Writer& out, const EdgeCurve& curve, double tolerance, bool isAgainst) {
  const auto lineTo = [&](Point p) {
    out << "L";
    writePoint(out, p);
  };
  if (curve.isStraight()) return lineTo(isAgainst ? curve.start : curve.end);
  auto cubics = cubicBeziers(curve, tolerance);
  if (isAgainst) {
    std::ranges::reverse(cubics);
    for (CubicBezier& cubic : cubics) {
      std::swap(cubic.start, cubic.end);
      std::swap(cubic.control1, cubic.control2);
    }
  }
  for (const CubicBezier& cubic : cubics) {
    out << "C";
    writePoint(out, cubic.control1);
    out << " ";
    writePoint(out, cubic.control2);
    out << " ";
    writePoint(out, cubic.end);
  }
}

void writeCells(Writer& out, const ExportFrame& frame) {
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(frame.cells.circles().size()); ++i) {
    const Outline loops = outline(frame.cells, i, frame.box);
    if (loops.empty()) continue;
    out << "<path data-circle=\"" << i << "\" d=\"";
    for (const auto& loop : loops) {
      moveTo(out, loop.front().curve.start);
      for (const OutlinePiece& piece : loop) {
        traceCurve(out, edgeDirection(frame.cells, piece), frame.tolerance, isAgainstEdge(piece));
      }
      out << "Z";
    }
    out << "\"/>\n";
  }
}

void writeEdges(Writer& out, const ExportFrame& frame) {
  const Diagram& diagram = frame.cells.diagram();
  for (std::int32_t e = 0; e < static_cast<std::int32_t>(diagram.edges.size()); ++e) {
    const auto pieces = clip(edgeCurve(frame.cells.circles(), diagram, e), frame.box);
    if (pieces.empty()) continue;
    out << "<path data-edge=\"" << e << "\" d=\"";
    for (const EdgeCurve& piece : pieces) {
      moveTo(out, piece.start);
      traceCurve(out, piece, frame.tolerance, false);
    }
    out << "\"/>\n";
  }
}

void writeDual(Writer& out, const ExportFrame& frame) {
  const auto circles = frame.cells.circles();
  for (const auto& [i, j] : neighborPairs(frame.cells.diagram())) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    const Circle& d = circles[static_cast<std::size_t>(j)];
    out << "<line x1=\"" << c.x << "\" y1=\"" << c.y << "\" x2=\"" << d.x << "\" y2=\"" << d.y << "\"/>\n";
  }
}

void writeHull(Writer& out, const ExportFrame& frame) {
  const auto circles = frame.cells.circles();
  const Hull shape = hull(circles, frame.cells.diagram());
  if (shape.arcs.empty()) return;
  if (shape.arcs.size() == 1) {
    const Circle& c = circles[static_cast<std::size_t>(shape.arcs[0].circle)];
    out << "<circle cx=\"" << c.x << "\" cy=\"" << c.y << "\" r=\"" << c.r << "\"/>\n";
    return;
  }
  out << "<path d=\"";
  std::string_view command = "M";
  for (const HullArc& arc : shape.arcs) {
    const double r = circles[static_cast<std::size_t>(arc.circle)].r;
    out << command;
    writePoint(out, arc.start);
    out << "A" << r << " " << r << " 0 " << (arc.angle > std::numbers::pi ? "1" : "0") << " 1 ";
    writePoint(out, arc.end);
    command = "L";
  }
  out << "Z\"/>\n";
}

/// Circles of radius below `visible` are drawn as dots.
void writeCircles(Writer& out, const ExportFrame& frame, double visible) {
  const auto circles = frame.cells.circles();
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(circles.size()); ++i) {
    const auto& [x, y, r] = circles[static_cast<std::size_t>(i)];
    const bool isHidden = !frame.cells.exists(i);
    const bool isPoint = r < visible;
    out << (r == 0 ? "<path" : "<circle") << " data-circle=\"" << i << "\"";
    if (isPoint || isHidden) {
      out << " class=\"" << (isPoint ? "point" : "") << (isPoint && isHidden ? " " : "") << (isHidden ? "hidden" : "")
          << "\"";
    }
    if (r == 0) {  // SVG draws no circle then, but a stroke of length 0
      out << " d=\"M" << x << " " << y << "h0\"/>\n";
    } else {
      out << " cx=\"" << x << "\" cy=\"" << y << "\" r=\"" << r << "\"/>\n";
    }
  }
}

void writeVertices(Writer& out, const ExportFrame& frame, double radius) {
  const ConvexPolygon region = frame.box;
  const auto& vertices = frame.cells.diagram().vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!region.contains({vertices[v].x, vertices[v].y})) continue;
    out << "<circle data-vertex=\"" << static_cast<std::int64_t>(v) << "\" cx=\"" << vertices[v].x << "\" cy=\""
        << vertices[v].y << "\" r=\"" << radius << "\"/>\n";
  }
}

}  // namespace

void writeSvg(std::ostream& stream, std::span<const Circle> circles, const Diagram& diagram,
              const ExportOptions& options) {
  Writer out(stream);
  const ExportFrame frame(circles, diagram, options);
  const double width = frame.box.maxX - frame.box.minX;
  const double height = frame.box.maxY - frame.box.minY;
  const double unit = std::max(width, height) / kPixels;  // what a pixel stands for
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width / unit << "\" height=\"" << height / unit
      << "\" viewBox=\"" << frame.box.minX << " " << -frame.box.maxY << " " << width << " " << height << "\">\n"
      << "<title>Voronoi diagram of circles</title>\n<desc>" << static_cast<std::int64_t>(circles.size())
      << " circles, " << static_cast<std::int64_t>(diagram.hidden.size()) << " of them hidden; "
      << static_cast<std::int64_t>(diagram.vertices.size()) << " vertices, "
      << static_cast<std::int64_t>(diagram.edges.size()) << " edges</desc>\n"
      << kStyle << "<g transform=\"scale(1,-1)\">\n";
  const auto group = [&](std::string_view name, auto write) {
    out << "<g id=\"" << name << "\" class=\"" << name << "\">\n";
    write();
    out << "</g>\n";
  };
  group("cells", [&] { writeCells(out, frame); });
  group("dual", [&] { writeDual(out, frame); });
  group("circles", [&] { writeCircles(out, frame, kPointPixels * unit); });
  group("edges", [&] { writeEdges(out, frame); });
  group("vertices", [&] { writeVertices(out, frame, kVertexPixels * unit); });
  group("hull", [&] { writeHull(out, frame); });
  out << "</g>\n</svg>\n";
}

}  // namespace circle_voronoi
