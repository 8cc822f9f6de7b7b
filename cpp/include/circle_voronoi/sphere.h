// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/clipped_diagram.h"
#include "circle_voronoi/diagram.h"
#include "circle_voronoi/error.h"
#include "circle_voronoi/index.h"
#include "circle_voronoi/queries.h"
#include "circle_voronoi/sides.h"

namespace circle_voronoi {

/// The Earth's mean radius in kilometers.
inline constexpr double kEarthRadius = 6371.0088;

/// A circle on a sphere: the points within the distance `r` of its center, along the ground. The center has a longitude
/// and a latitude in degrees. A cap with r = 0 is a point.
///
/// The distance from a place to a cap is signed, like that to a circle of the plane: the distance to the center minus
/// r.
struct Cap {
  double longitude = 0;
  double latitude = 0;
  double r = 0;

  friend bool operator==(const Cap&, const Cap&) = default;
};

struct SphereOptions {
  /// The radius of the sphere, positive and from 1e-20 to 1e20. Its unit is that of all lengths. The Earth is not quite
  /// a sphere: distances differ from those on the ellipsoid by up to 0.5 %.
  double radius = kEarthRadius;
  /// Whether the radii of the caps are additive weights, which may be negative.
  bool weights = false;
  /// The number of threads that may work at the same time; 0 means one for each hardware thread. The result has the
  /// same bits for any number.
  int threads = 1;
};

/// A Voronoi vertex on a sphere: a place that is equally far from its three caps, and nearer to no other cap.
struct SphereVertex {
  double longitude = 0;  ///< from -180 to before 180
  double latitude = 0;
  double distance = 0;  ///< from each of the three caps; negative where the three overlap

  friend bool operator==(const SphereVertex&, const SphereVertex&) = default;
};

/// The Voronoi diagram of caps on a sphere, by indices. A CircleIndex is the index of a cap here.
///
/// Vertices, edges and sides are those of a Diagram, without infinity: each vertex has three caps and three edges, and
/// counter-clockwise is as seen from outside the sphere. Where more than three caps touch one disc, several vertices
/// are joined by edges of length near zero. If two caps have a cell, one edge without vertices lies between them: its
/// ends are kNone. If one cap has a cell, the cell is the whole sphere.
///
/// For n visible caps there are 2 n - 4 vertices and 3 n - 6 edges, if n is at least 3.
struct CIRCLE_VORONOI_API SphereDiagram {
  /// The caps of the input, hidden ones included.
  std::vector<Cap> caps;
  /// The radius of the sphere.
  double radius = kEarthRadius;
  /// Whether the radii of the caps are additive weights.
  bool weights = false;

  std::vector<SphereVertex> vertices;
  /// For each vertex its three caps, counter-clockwise. Two vertices may share all three.
  std::vector<std::array<CircleIndex, 3>> vertexCaps;
  std::vector<Edge> edges;
  /// The caps without a cell, in increasing order, each with a visible cap that contains it. Among identical caps, the
  /// first stays visible.
  std::vector<HiddenCircle> hidden;
  Links links;
  /// The diagram is proven to be right for caps that differ from the given ones by at most this length, in place and
  /// radius.
  double rounding = 0;

  /// Returns whether a cap has a cell.
  [[nodiscard]] bool hasCell(CircleIndex cap) const;
  /// Returns the sides of a cell, counter-clockwise. The range is empty if there is no cell, or it is the whole sphere.
  [[nodiscard]] Sides sides(CircleIndex cap) const { return {links.nextSide, links.firstSide[at(cap)]}; }

  [[nodiscard]] static SideIndex twin(SideIndex side) { return side ^ 1; }
  [[nodiscard]] static EdgeIndex edgeOf(SideIndex side) { return side / 2; }
  /// Returns the cap whose cell has this side.
  [[nodiscard]] CircleIndex circleOf(SideIndex side) const {
    return side % 2 == 0 ? edgeAt(side).left : edgeAt(side).right;
  }
  /// Returns the cap on the other side of the edge.
  [[nodiscard]] CircleIndex neighborOf(SideIndex side) const { return circleOf(twin(side)); }
  /// Returns the vertex where a side begins, or kNone.
  [[nodiscard]] VertexIndex originOf(SideIndex side) const {
    return side % 2 == 0 ? edgeAt(side).start : edgeAt(side).end;
  }
  /// Returns the vertex where a side ends, or kNone.
  [[nodiscard]] VertexIndex targetOf(SideIndex side) const { return originOf(twin(side)); }

 private:
  static std::size_t at(std::int32_t index) { return static_cast<std::size_t>(index); }
  const Edge& edgeAt(SideIndex side) const { return edges[at(edgeOf(side))]; }
};

/// Computes the Voronoi diagram of caps on a sphere.
///
/// The caps may be disjoint, intersecting, tangent, nested, equal, points, or larger than half of the sphere, in any
/// position. There may be none. Longitudes are any numbers; latitudes are within 90 degrees. Radii are less than half
/// of the circumference.
///
/// Adding a number to all radii does not change the diagram. So one cap N becomes a point, and stereographic
/// projection from N turns the others into circles of the plane with signed radii. A disc that touches three caps and
/// overlaps none becomes such a disc of the plane, because it does not contain N. A disc that touches N becomes a
/// half-plane. So the dual on the sphere is the dual of the circles in the plane, whose point at infinity is N.
/// `compute` finds it and proves it, and `checkSphere` looks at it on the sphere again.
///
/// The projected circles are rounded, so the proof is about caps near the given ones (SphereDiagram::rounding). They
/// are a few nanometers away on the Earth, and more only if each cap almost hides another or is almost hidden by it: N
/// is a cap for which the rounding is small. Vertices are computed from the given caps. They touch their caps to the
/// rounding of degrees and to a share of the size of caps and disc: 1e-14, or 6 rounding / radius if that is more.
///
/// The same input gives the same bits on every platform. Takes about n log n steps for n caps.
///
/// Errors: nonFinite, negativeRadius (without `weights`), coordinateTooLarge if a latitude is beyond 90 degrees or a
/// radius is not below half of the circumference (these three name the first such cap), badOption, tooManyCircles,
/// notCertified, badArithmetic, internal.
CIRCLE_VORONOI_API Result<SphereDiagram> computeSphere(std::span<const Cap> caps, const SphereOptions& options = {});

/// Judges whether a diagram is the Voronoi diagram of its caps on the sphere, whatever program made it: each vertex
/// touches its three caps, counter-clockwise; no cap across an edge reaches into its disc; each hidden cap lies in a
/// visible one; and the sides of each cell go around its center once, in order of bearing. All this holds up to twice
/// the `rounding` of the diagram, and at least 1e-14 of the sphere's radius: where sides are in the wrong order, the
/// fourth cap must touch the disc of a vertex to this length. Linear time.
///
/// Errors: badInput if the parts of the diagram do not fit together; notCertified if the diagram is not right, with a
/// cap.
CIRCLE_VORONOI_API Result<void> checkSphere(const SphereDiagram& diagram);

/// Returns the caps across the sides of a cell, in the order of the sides. A cap recurs if the two cells share several
/// edges.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<CircleIndex> neighbors(const SphereDiagram& diagram, CircleIndex cap);

/// Returns the distance of a place from a cap: along the ground to its center, minus its radius.
[[nodiscard]] CIRCLE_VORONOI_API double distanceFrom(const SphereDiagram& diagram, CircleIndex cap, double longitude,
                                                     double latitude);

/// Returns the area of a cell, or of its part within `maxDistance` of its cap. The areas of all cells sum to that of
/// the sphere. A hidden cap has the area 0.
[[nodiscard]] CIRCLE_VORONOI_API double area(const SphereDiagram& diagram, CircleIndex cap,
                                             std::optional<double> maxDistance = {});
/// Returns the areas of all cells.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<double> areas(const SphereDiagram& diagram,
                                                           std::optional<double> maxDistance = {});

/// Returns the length of the border of a cell, or of its part within `maxDistance` of its cap.
[[nodiscard]] CIRCLE_VORONOI_API double perimeter(const SphereDiagram& diagram, CircleIndex cap,
                                                  std::optional<double> maxDistance = {});
/// Returns the lengths of the borders of all cells.
[[nodiscard]] CIRCLE_VORONOI_API std::vector<double> perimeters(const SphereDiagram& diagram,
                                                                std::optional<double> maxDistance = {});

/// The default tolerance of polygons as a part of the sphere's radius: 64 m on the Earth.
inline constexpr double kSphereTolerance = 1e-5;

struct SpherePolygonOptions {
  /// The largest distance between the polygons and the true borders, along the ground. Finite and positive. By default
  /// kSphereTolerance of the sphere's radius.
  std::optional<double> tolerance = {};
  /// Cells are cut at this distance from their caps.
  std::optional<double> maxDistance = {};
};

/// Returns polygons of all cells for RFC 7946 (GeoJSON): points are longitudes (x) and latitudes (y) in degrees, and
/// sides are straight in degrees. Cells are cut at the antimeridian; points on it have the longitude 180 or -180. A
/// cell that contains a pole has a polygon with a side along it, from -180 to 180. The whole sphere is the rectangle of
/// all degrees.
///
/// Row i has the polygons of cap i, none if it has no cell. Neighbors share their points to the bit, except on the
/// antimeridian and at the poles. Polygons are valid as the OGC and GEOS define it: borders of cells that are narrower
/// than the tolerance are followed more closely. Where rounding alone makes a ring cross itself, it is divided there.
///
/// Errors: badOption if the tolerance is not finite and positive, or the distance is not finite.
CIRCLE_VORONOI_API Result<ClippedPolygons> cellPolygons(const SphereDiagram& diagram,
                                                        const SpherePolygonOptions& options = {});
/// Returns polygons of some cells: row k has those of caps[k].
CIRCLE_VORONOI_API Result<ClippedPolygons> cellPolygons(const SphereDiagram& diagram, std::span<const CircleIndex> caps,
                                                        const SpherePolygonOptions& options = {});

/// Finds the nearest cap of any place on the sphere. It walks through the cells: from any cell to the neighbor that is
/// nearest to the place, until none is nearer. The cells are star-shaped around their centers, so the walk cannot stop
/// too early. It starts at the first of a few caps near the place.
class CIRCLE_VORONOI_API SphereFinder {
 public:
  /// Takes linear time. The diagram must outlive the finder.
  explicit SphereFinder(const SphereDiagram& diagram);
  explicit SphereFinder(const SphereDiagram&& diagram) = delete;
  SphereFinder(SphereFinder&&) noexcept;
  SphereFinder& operator=(SphereFinder&&) noexcept;
  ~SphereFinder();

  /// Returns the cap at the smallest distance from a place. If several are equally near up to rounding, returns one of
  /// them. Returns kNone if there are no caps. Precondition: the numbers are finite, and the latitude is within 90
  /// degrees.
  [[nodiscard]] CircleIndex find(double longitude, double latitude) const;

 private:
  class Walker;
  std::unique_ptr<const Walker> walker_;
};

/// A place and the caps that are nearest to it, up to three. The remaining entries are kNone.
struct FarthestPlace {
  SphereVertex place;
  std::array<CircleIndex, 3> caps;
};

/// Returns the place that is farthest from all caps: the center of the largest disc that overlaps no cap. Its distance
/// is negative if the caps cover the sphere. It is a vertex, or the far point of an edge, or the antipode of a single
/// cap. Returns nothing if there are no caps. Linear time.
[[nodiscard]] CIRCLE_VORONOI_API std::optional<FarthestPlace> farthestPlace(const SphereDiagram& diagram);

/// Returns the two visible caps with the smallest gap. Returns nothing if fewer than two caps are visible. Linear time.
[[nodiscard]] CIRCLE_VORONOI_API std::optional<ClosestPair> closestPair(const SphereDiagram& diagram);

/// Returns a sentence for the user if more than a quarter of the caps are hidden, because radii in another unit than
/// the radius of the sphere hide most caps; otherwise an empty text.
[[nodiscard]] CIRCLE_VORONOI_API std::string hiddenWarning(const SphereDiagram& diagram);

}  // namespace circle_voronoi
