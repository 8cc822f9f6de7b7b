// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "bit_cast.h"
#include "chord.h"
#include "circle_names.h"
#include "circle_voronoi/export.h"
#include "circle_voronoi/hull.h"
#include "circle_voronoi/periodic_diagram.h"
#include "circle_voronoi/queries.h"
#include "edge_points.h"
#include "infinity.h"
#include "periodic_options.h"
#include "prefetch.h"
#include "vectors.h"
#include "writer.h"
#include "xml_text.h"

namespace circle_voronoi {
namespace {

constexpr double kVertexPixels = 1.5;
constexpr double kPointPixels = 0.5;  ///< a smaller radius is hard to see
constexpr double kHeadPixels = 7;     ///< the length of an arrowhead

/// Only rules for properties that elements do not inherit from groups. In a page, the rules do not apply outside the
/// drawing.
constexpr std::string_view kStyle = R"(<style>
.circle-voronoi path, .circle-voronoi line, .circle-voronoi circle { vector-effect: non-scaling-stroke; }
.circle-voronoi .hidden { fill: #8c8c8c; stroke: #6e6e6e; stroke-dasharray: 3 2; }
.circle-voronoi .point { stroke-width: 3; stroke-linecap: round; stroke-dasharray: none; }
)";

/// Presentation attributes of each group. Any style sheet has precedence over them.
constexpr std::array<std::pair<std::string_view, std::string_view>, 7> kLooks = {{
    {"cells", R"(fill="#f6f4ee" stroke="none")"},
    {"edges", R"(fill="none" stroke="#1f4e79" stroke-width="1.5")"},
    {"dual", R"(stroke="#a59d8a" stroke-width="0.75")"},
    {"hull", R"(fill="none" stroke="#8a6d1d" stroke-width="1" stroke-dasharray="6 4")"},
    {"circles", R"(fill="#d9822b" fill-opacity="0.35" stroke="#a85a10" stroke-width="1")"},
    {"vertices", R"(fill="#1f4e79" stroke="none")"},
    {"lattice", R"(fill="none" stroke="#1f4e79" stroke-width="1" stroke-dasharray="6 4")"},
}};
/// Clipped cells have borders that are no edges.
constexpr std::string_view kLookOfCutCells = R"(fill="#f6f4ee" stroke="#1f4e79" stroke-width="1.5")";

/// Writes the class of a group, and how it looks.
void writeClass(Writer& out, std::string_view name, bool areCellsCut = false) {
  out << " class=\"" << name << "\"";
  const auto* const look = std::ranges::find(kLooks, name, [](const auto& entry) { return entry.first; });
  if (look == kLooks.end()) return;
  out << " " << (areCellsCut && name == "cells" ? kLookOfCutCells : look->second);
}

void writePoint(Writer& out, Point p) { out << p.x << " " << p.y; }

void writePoint(Writer& out, std::string_view command, Point p) {
  out << command;
  writePoint(out, p);
}

/// The points of an arc between its ends as SVG takes them: none for a line, else the control points and ends of cubic
/// Bezier curves.
std::vector<Point> innerPoints(const ExportFrame& frame, const EdgeCurve& curve) {
  std::vector<Point> points;
  if (isNearChord(curve, frame.tolerance)) return points;
  for (const CubicBezier& cubic : cubicBeziers(curve, frame.tolerance)) {
    if (!points.empty()) points.push_back(frame.round(cubic.start));
    points.push_back(frame.round(cubic.control1));
    points.push_back(frame.round(cubic.control2));
  }
  return points;
}

/// Continues a path to the end of an arc.
template <class Iterator>
void trace(Writer& out, Iterator inner, Iterator innerEnd, Point end) {
  constexpr std::array<std::string_view, 3> kBefore = {"C", " ", " "};
  std::size_t count = 0;
  for (; inner != innerEnd; ++inner) writePoint(out, kBefore[count++ % kBefore.size()], *inner);
  writePoint(out, count == 0 ? "L" : " ", end);
}

/// Returns the vertices and the edges inside the box, with points rounded by the frame.
EdgePoints drawnEdges(const ExportFrame& frame) {
  std::vector<Point> vertices;
  vertices.reserve(frame.diagram.vertices.size());
  for (const Vertex& vertex : frame.diagram.vertices) vertices.push_back(frame.round({vertex.x, vertex.y}));
  const auto follow = [&](const Edge&, const EdgeCurve& curve, EdgePoints& points) {
    std::ranges::copy(innerPoints(frame, curve), std::back_inserter(points.inner));
  };
  return {frame, std::move(vertices), follow};
}

/// Continues a path from the start of a side whose edge is inside the box.
void traceSide(Writer& out, const EdgePoints& edges, SideIndex side) {
  const Point end = edges.placeOf(edges.diagram.targetOf(side));
  edges.visitInner(side, [&](auto first, auto last) { trace(out, first, last, end); });
}

/// Continues a path from the start of a piece of a cell's outline. Points on edges are computed in the edge's own
/// direction.
void tracePiece(Writer& out, const ExportFrame& frame, const OutlinePiece& piece) {
  if (piece.isOnCircle()) {
    out << "A" << piece.r << " " << piece.r << " 0 0 1 ";
    return writePoint(out, frame.round(piece.curve.end));
  }
  std::vector<Point> points;
  if (piece.side != kNone) {
    points = innerPoints(frame, edgeDirection(frame.diagram, piece));
    if (piece.side % 2 == 1) std::ranges::reverse(points);
  }
  trace(out, points.begin(), points.end(), frame.round(piece.curve.end));
}

using CircleNames = std::vector<std::string>;

/// Ends the element of a circle or its cell, whose last attribute is open. Its name, if it has one, is its title.
void endElement(Writer& out, std::string_view element, const CircleNames& names, std::int32_t circle) {
  const auto i = static_cast<std::size_t>(circle);
  if (i >= names.size() || names[i].empty()) {
    out << "\"/>\n";
  } else {
    out << "\"><title>" << xmlText(names[i]) << "</title></" << element << ">\n";
  }
}

void writeCells(Writer& out, const EdgePoints& edges, std::int32_t count, const CircleNames& names) {
  const ExportFrame& frame = edges.frame;
  edges.visitCells([&](std::int32_t i) {
    if (i >= count) return;
    const auto begin = [&] { out << "<path data-circle=\"" << i << "\" d=\""; };
    if (edges.isWhole(i)) {
      const auto sides = frame.diagram.sides(i);
      begin();
      writePoint(out, "M", edges.placeOf(frame.diagram.originOf(sides.front())));
      for (const SideIndex side : sides) traceSide(out, edges, side);
      out << "Z";
      endElement(out, "path", names, i);
      return;
    }
    const Outline loops = frame.clipped.outline(i);
    if (loops.empty()) return;
    begin();
    for (const auto& loop : loops) {
      writePoint(out, "M", frame.round(loop.front().curve.start));
      for (const OutlinePiece& piece : loop) tracePiece(out, frame, piece);
      out << "Z";
    }
    endElement(out, "path", names, i);
  });
}

template <class IsDrawn>
void writeEdges(Writer& out, const EdgePoints& edges, IsDrawn isDrawn) {
  const ExportFrame& frame = edges.frame;
  for (std::int32_t e = 0; e < static_cast<std::int32_t>(frame.diagram.edges.size()); ++e) {
    if (!isDrawn(frame.diagram.edges[static_cast<std::size_t>(e)])) continue;
    const auto begin = [&] { out << "<path data-edge=\"" << e << "\" d=\""; };
    if (edges.hasInside(e)) {
      begin();
      writePoint(out, "M", edges.placeOf(frame.diagram.originOf(2 * e)));
      traceSide(out, edges, 2 * e);
      out << "\"/>\n";
      continue;
    }
    const auto parts = frame.clipped.edgeParts(e);
    if (parts.empty()) continue;
    begin();
    for (const EdgeCurve& part : parts) {
      writePoint(out, "M", frame.round(part.start));
      const auto points = innerPoints(frame, part);
      trace(out, points.begin(), points.end(), frame.round(part.end));
    }
    out << "\"/>\n";
  }
}

void writeDual(Writer& out, const ExportFrame& frame) {
  const auto& circles = frame.diagram.circles;
  const auto center = [&](std::int32_t i) {
    const Circle& c = circles[static_cast<std::size_t>(i)];
    return frame.round({c.x, c.y});
  };
  const Box& box = frame.box;
  const auto pairs = neighborPairs(frame.diagram);
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs.size() - k > kPrefetchAhead) {
      prefetch(circles, static_cast<std::size_t>(pairs[k + kPrefetchAhead][1]));
    }
    const Point p = center(pairs[k][0]);
    const Point q = center(pairs[k][1]);
    if (std::max(p.x, q.x) < box.minX || std::min(p.x, q.x) > box.maxX || std::max(p.y, q.y) < box.minY ||
        std::min(p.y, q.y) > box.maxY) {
      continue;
    }
    out << "<line x1=\"" << p.x << "\" y1=\"" << p.y << "\" x2=\"" << q.x << "\" y2=\"" << q.y << "\"/>\n";
  }
}

/// With all digits: where an arc is almost a whole circle, its ends are next to each other and say where its center is.
void writeHull(Writer& out, const ExportFrame& frame) {
  const auto& circles = frame.diagram.circles;
  const Hull shape = convexHull(frame.diagram);
  if (shape.arcs.empty()) return;
  if (shape.arcs.size() == 1) {
    const Circle& c = circles[static_cast<std::size_t>(shape.arcs[0].circle)];
    out << "<circle cx=\"" << c.x << "\" cy=\"" << c.y << "\" r=\"" << shape.arcs[0].r << "\"/>\n";
    return;
  }
  out << "<path d=\"";
  std::string_view command = "M";
  for (const HullArc& arc : shape.arcs) {
    writePoint(out, command, arc.start);
    out << "A" << arc.r << " " << arc.r << " 0 " << (arc.angle > std::numbers::pi ? "1" : "0") << " 1 ";
    writePoint(out, arc.end);
    command = "L";
  }
  out << "Z\"/>\n";
}

/// Circles of radius below `visible` are drawn as dots.
void writeCircles(Writer& out, const ExportFrame& frame, double visible, std::int32_t count, const CircleNames& names) {
  const Box& box = frame.box;
  const auto& circles = frame.diagram.circles;
  for (std::int32_t i = 0; i < count; ++i) {
    const Circle& circle = circles[static_cast<std::size_t>(i)];
    const auto& [x, y] = frame.round({circle.x, circle.y});
    const double r = frame.grid.round(std::max(circle.r, 0.0));
    if (x + r < box.minX || x - r > box.maxX || y + r < box.minY || y - r > box.maxY) continue;
    const bool isHidden = !frame.diagram.hasCell(i);
    const bool isPoint = circle.r < visible;
    out << (r == 0 ? "<path" : "<circle") << " data-circle=\"" << i << "\"";
    if (isPoint || isHidden) {
      out << " class=\"" << (isPoint ? "point" : "") << (isPoint && isHidden ? " " : "") << (isHidden ? "hidden" : "")
          << "\"";
    }
    if (r == 0) {  // SVG draws no circle of radius 0, but it draws a stroke of length 0
      out << " d=\"M" << x << " " << y << "h0";
    } else {
      out << " cx=\"" << x << "\" cy=\"" << y << "\" r=\"" << r;
    }
    endElement(out, r == 0 ? "path" : "circle", names, i);
  }
}

void writeVertices(Writer& out, const EdgePoints& edges, double radius) {
  const ExportFrame& frame = edges.frame;
  const auto& vertices = frame.diagram.vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    if (!frame.hasInside({vertices[v].x, vertices[v].y})) continue;
    if (!frame.isWithin(static_cast<std::int32_t>(v))) continue;
    const auto [x, y] = edges.places[v];
    out << "<circle data-vertex=\"" << static_cast<std::int64_t>(v) << "\" cx=\"" << x << "\" cy=\"" << y << "\" r=\""
        << radius << "\"/>\n";
  }
}

/// The two strokes of the head of an arrow, at most two fifths of its length.
void writeHead(Writer& out, const ExportFrame& frame, Point from, Point to, double unit) {
  const double dx = to.x - from.x;
  const double dy = to.y - from.y;
  const double size = std::sqrt(dx * dx + dy * dy);
  if (size == 0) return;
  const double part = std::min(kHeadPixels * unit / size, 0.4);
  const Point foot = {to.x - part * dx, to.y - part * dy};
  const Vector side = {-0.4 * part * dy, 0.4 * part * dx};
  writePoint(out, "M", frame.round({foot.x + side.x, foot.y + side.y}));
  writePoint(out, "L", frame.round(to));
  writePoint(out, "L", frame.round({foot.x - side.x, foot.y - side.y}));
}

void writeLayer(Writer& out, const ExportFrame& frame, const SvgLayer& layer, double unit) {
  for (const Circle& disc : layer.discs) {
    const Point center = frame.round({disc.x, disc.y});
    out << "<circle cx=\"" << center.x << "\" cy=\"" << center.y << "\" r=\"" << frame.grid.round(disc.r) << "\"/>\n";
  }
  for (const EdgeCurve& arc : layer.arcs) {
    const auto points = innerPoints(frame, arc);
    out << "<path d=\"";
    writePoint(out, "M", frame.round(arc.start));
    trace(out, points.begin(), points.end(), frame.round(arc.end));
    out << "\"/>\n";
  }
  for (const auto& [from, to] : layer.segments) {
    out << "<path d=\"";
    writePoint(out, "M", frame.round(from));
    writePoint(out, "L", frame.round(to));
    if (layer.areArrows) writeHead(out, frame, from, to, unit);
    out << "\"/>\n";
  }
  if (layer.points.empty()) return;
  out << "<path d=\"";
  for (const Point& point : layer.points) {
    writePoint(out, "M", frame.round(point));
    out << "h0";
  }
  out << "\"/>\n";
}

/// Within `guarded`.
Result<void> writeFigure(std::ostream& stream, const Diagram& diagram, const SvgFigure& figure) {
  if (!(figure.pixels > 0) || std::isinf(figure.pixels)) {
    return errorWith(ErrorCode::badOption, "The number of pixels must be finite and positive.");
  }
  return unguardedWritingIn(stream, diagram, figure.frame, [&](Writer& out, const ExportFrame& frame) {
    const EdgePoints edges = drawnEdges(frame);
    const double width = frame.box.maxX - frame.box.minX;
    const double height = frame.box.maxY - frame.box.minY;
    const double unit = std::max(width, height) / figure.pixels;  // the length of a pixel in the plane
    out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width / unit << "\" height=\"" << height / unit
        << "\" viewBox=\"" << frame.box.minX << " " << -frame.box.maxY << " " << width << " " << height
        << "\" class=\"circle-voronoi\" role=\"img\">\n"
        << "<title>Voronoi diagram of circles</title>\n<desc>" << static_cast<std::int64_t>(diagram.circles.size())
        << " circles, " << static_cast<std::int64_t>(diagram.hidden.size()) << " of them hidden; "
        << static_cast<std::int64_t>(diagram.vertices.size()) << " vertices, "
        << static_cast<std::int64_t>(diagram.edges.size()) << " edges</desc>\n"
        << kStyle << figure.style << "</style>\n<g transform=\"scale(1,-1)\">\n";
    const auto group = [&](std::string_view name, auto write) {
      out << "<g";
      writeClass(out, name, frame.clipped.maxDistance().has_value());
      out << ">\n";
      write();
      out << "</g>\n";
    };
    const auto ownGroup = [&](std::string_view name, auto write) {
      if (std::ranges::find(figure.groups, name) != figure.groups.end()) group(name, write);
    };
    const auto count = static_cast<std::int32_t>(diagram.circles.size());
    const CircleNames names = namesIn(frame.attributes);
    ownGroup("cells", [&] { writeCells(out, edges, count, names); });
    ownGroup("dual", [&] { writeDual(out, frame); });
    ownGroup("circles", [&] { writeCircles(out, frame, kPointPixels * unit, count, names); });
    ownGroup("edges", [&] { writeEdges(out, edges, [](const Edge&) { return true; }); });
    ownGroup("vertices", [&] { writeVertices(out, edges, frame.grid.round(kVertexPixels * unit)); });
    ownGroup("hull", [&] { writeHull(out, frame); });
    for (const SvgLayer& layer : figure.layers) group(layer.name, [&] { writeLayer(out, frame, layer, unit); });
    out << "</g>\n</svg>\n";
  });
}

constexpr double kPeriodicMargin = 0.15;
/// A drawing may repeat the given circles this often.
constexpr double kMostCopies = 1000;

/// The shifts of the copies of the given cells that a drawing shows.
std::vector<Vector> copiesIn(const PeriodicDiagram& periodic, const Box& view) {
  const auto& [a, b] = periodic.lattice;
  // The box around the drawing of the given circles.
  Box own = {kInfinite, kInfinite, -kInfinite, -kInfinite};
  const auto include = [&](double x, double y, double r) {
    own = {std::min(own.minX, x - r), std::min(own.minY, y - r), std::max(own.maxX, x + r), std::max(own.maxY, y + r)};
  };
  for (std::int32_t i = 0; i < periodic.circleCount; ++i) {
    const Circle& c = periodic.diagram.circles[static_cast<std::size_t>(i)];
    include(c.x, c.y, std::max(c.r, 0.0));
    for (const SideIndex side : periodic.diagram.sides(i)) {
      const Vertex& v = periodic.diagram.vertices[static_cast<std::size_t>(periodic.diagram.originOf(side))];
      include(v.x, v.y, std::max(c.r, 0.0));
    }
  }
  std::vector<Vector> copies;
  const double area = cross(a, b);
  Box places = {kInfinite, kInfinite, -kInfinite, -kInfinite};
  for (const double x : {view.minX - own.maxX, view.maxX - own.minX}) {
    for (const double y : {view.minY - own.maxY, view.maxY - own.minY}) {
      const Vector place = {cross({x, y}, b) / area, cross(a, {x, y}) / area};
      places = {std::min(places.minX, place.x), std::min(places.minY, place.y), std::max(places.maxX, place.x),
                std::max(places.maxY, place.y)};
    }
  }
  for (double k = std::ceil(places.minX); k <= places.maxX; ++k) {
    for (double l = std::ceil(places.minY); l <= places.maxY; ++l) {
      const Vector move = {k * a.x + l * b.x, k * a.y + l * b.y};
      if (own.maxX + move.x < view.minX || own.minX + move.x > view.maxX || own.maxY + move.y < view.minY ||
          own.minY + move.y > view.maxY) {
        continue;
      }
      if (static_cast<double>(copies.size()) == kMostCopies) {
        throw ThrownError{{ErrorCode::badOption, kNone, "The box is too narrow to be drawn."}};
      }
      copies.push_back(move);
    }
  }
  return copies;
}

/// Returns a name that differs from the names in drawings of other circles or with another box in the same page.
std::string idOf(const PeriodicDiagram& periodic) {
  std::uint64_t hash = 0xcbf29ce484222325U;  // FNV-1a, by numbers instead of bytes
  const auto add = [&](double value) {
    hash = (hash ^ bitCast<std::uint64_t>(value)) * 0x100000001b3U;
    hash ^= hash >> 32U;  // a product has what differs in its upper half alone
  };
  for (const Vector& side : {periodic.lattice.a, periodic.lattice.b}) {
    add(side.x);
    add(side.y);
  }
  for (const Circle& c : periodic.diagram.circles) {
    add(c.x);
    add(c.y);
    add(c.r);
  }
  return std::to_string(hash);
}

/// Draws the given circles once and repeats them wherever their images meet the drawing: inside the box, and dimmed
/// around it.
void drawPeriodic(Writer& out, const ExportFrame& frame, const PeriodicDiagram& periodic, const CircleNames& names) {
  const Box box = boxOf(periodic.lattice);
  const double margin = kPeriodicMargin * std::max(box.maxX - box.minX, box.maxY - box.minY);
  const Box view = {box.minX - margin, box.minY - margin, box.maxX + margin, box.maxY + margin};
  const std::vector<Vector> copies = periodic.circleCount > 0 ? copiesIn(periodic, view) : std::vector<Vector>();
  const double width = view.maxX - view.minX;
  const double height = view.maxY - view.minY;
  const SvgFigure usual;
  const double unit = std::max(width, height) / usual.pixels;
  const EdgePoints edges = drawnEdges(frame);
  const Vector a = periodic.lattice.a;
  const Vector b = periodic.lattice.b;
  const std::string id = idOf(periodic);
  const auto writeOutline = [&](auto writeLook) {
    out << "<path";
    writeLook();
    out << " d=\"M0 0";
    for (const Point corner : {Point{a.x, a.y}, Point{a.x + b.x, a.y + b.y}, Point{b.x, b.y}}) {
      writePoint(out, "L", frame.round(corner));
    }
    out << "Z\"/>\n";
  };
  const auto isDrawn = [&](const Edge& edge) {
    const auto isGiven = [&](CircleIndex i) { return i < periodic.circleCount; };
    if (isGiven(edge.left) && isGiven(edge.right)) return true;
    if (!isGiven(edge.left) && !isGiven(edge.right)) return false;
    // One of the two twins.
    const auto [given, image] =
        isGiven(edge.left) ? std::pair(edge.left, edge.right) : std::pair(edge.right, edge.left);
    const auto [other, shift] = periodic.imageFrom(given, image);
    return given != other ? given < other : shift > Shift{};
  };
  out << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << width / unit << "\" height=\"" << height / unit
      << "\" viewBox=\"" << view.minX << " " << -view.maxY << " " << width << " " << height
      << "\" class=\"circle-voronoi\" role=\"img\">\n"
      << "<title>Periodic Voronoi diagram of circles</title>\n<desc>" << std::int32_t{periodic.circleCount}
      << " circles in a box with opposite sides glued together</desc>\n"
      << kStyle << "</style>\n<defs>\n<clipPath id=\"box-" << id << "\">";
  writeOutline([] {});
  out << "</clipPath>\n<g id=\"given-" << id << "\">\n";
  const auto group = [&](std::string_view name, auto write) {
    out << "<g";
    writeClass(out, name);
    out << ">\n";
    write();
    out << "</g>\n";
  };
  group("cells", [&] { writeCells(out, edges, periodic.circleCount, names); });
  group("circles", [&] { writeCircles(out, frame, kPointPixels * unit, periodic.circleCount, names); });
  group("edges", [&] { writeEdges(out, edges, isDrawn); });
  out << "</g>\n<g id=\"copies-" << id << "\">\n";
  for (const Vector& move : copies) {
    out << "<use href=\"#given-" << id << "\" x=\"" << move.x << "\" y=\"" << move.y << "\"/>\n";
  }
  out << "</g>\n</defs>\n<g transform=\"scale(1,-1)\">\n<g class=\"images\" opacity=\"0.35\"><use href=\"#copies-" << id
      << "\"/></g>\n<g clip-path=\"url(#box-" << id << ")\"><use href=\"#copies-" << id << "\"/></g>\n";
  writeOutline([&] { writeClass(out, "lattice"); });
  out << "</g>\n</svg>\n";
}

}  // namespace

Result<void> writePeriodicSvg(std::ostream& stream, const PeriodicDiagram& periodic, const ExportOptions& options) {
  return guarded([&]() -> Result<void> {
    const auto own = periodicOptions(periodic, options);
    if (!own) return own.error();
    const CircleNames names = namesIn(options.attributes);
    return unguardedWritingIn(stream, periodic.diagram, own.value(), [&](Writer& out, const ExportFrame& frame) {
      drawPeriodic(out, frame, periodic, names);
    });
  });
}

Result<void> writeSvg(std::ostream& stream, const Diagram& diagram, const ExportOptions& options) {
  return guarded([&] {
    SvgFigure figure;
    figure.frame = options;
    return writeFigure(stream, diagram, figure);
  });
}

Result<void> writeSvgFigure(std::ostream& stream, const Diagram& diagram, const SvgFigure& figure) {
  return guarded([&] { return writeFigure(stream, diagram, figure); });
}

}  // namespace circle_voronoi
