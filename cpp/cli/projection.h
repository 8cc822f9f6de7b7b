// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "circle_voronoi/attributes.h"
#include "circle_voronoi/circle.h"
#include "circle_voronoi/point.h"
#include "circle_voronoi/region.h"
#include "elementary.h"

namespace circle_voronoi::cli {

/// The names of the projections, in the order of Projection::Kind.
inline const std::vector<std::string> kProjections = {"local", "equal-area", "mercator"};

/// A map of the WGS 84 ellipsoid in meters, around a center.
///
/// - local: azimuthal equidistant. Distances and directions from the center are right.
/// - equal-area: Lambert's azimuthal projection. Areas are right everywhere.
/// - mercator: Mercator's projection, with the scale of the center's latitude. It keeps angles and the shape of small
///   circles, whose radii are scaled.
class Projection {
 public:
  enum class Kind { local, equalArea, mercator };

  /// Makes a projection around a place in degrees.
  Projection(Kind kind, double longitude, double latitude);

  /// Returns the projection around the middle of circles, whose centers are longitude and latitude in degrees. Throws
  /// CommandError, which names a circle that has no place on the map; errors call the input `name`.
  static Projection around(std::span<const Circle> circles, Kind kind, const std::string& name);

  /// Returns the projection that `record` has written; nothing if there is none.
  static std::optional<Projection> recordedIn(const CircleAttributes& attributes);
  /// Writes the projection into the members of the collection.
  void record(CircleAttributes& attributes) const;

  /// Removes what `record` has written.
  static void removeFrom(CircleAttributes& attributes);

  /// Returns the point of the plane for a longitude and a latitude in degrees.
  Point plane(Point degrees) const;
  /// Returns longitude and latitude in degrees, to the ninth place after the decimal point: a tenth of a millimeter. A
  /// longitude is at most 180 degrees from that of the center, so it may exceed 180.
  Point degrees(Point plane) const;
  /// Returns a circle with its center in degrees and its radius in meters as a circle of the plane.
  Circle plane(const Circle& circle) const;
  /// Returns a circle of the plane with its center in degrees and its radius in meters.
  Circle degrees(const Circle& circle) const;
  /// Returns a region with its points in degrees as a region of the plane. Long sides get more points. Throws
  /// CommandError.
  Region plane(const Region& region, const std::string& name, const RegionOptions& options) const;
  /// Returns the scale of lengths at a latitude: 1 at the center. Only that of Mercator's projection changes much.
  double scaleAt(double latitude) const;
  /// Returns the places of the poles that are on the map, where polygons in degrees have no meaning.
  std::vector<Point> poles() const;

 private:
  SineCosine auxiliaryOf(double latitude) const;
  double latitudeOf(SineCosine auxiliary) const;

  Kind kind_;
  double longitude_;   ///< of the center
  double latitude_;    ///< of the center
  SineCosine center_;  ///< of the auxiliary latitude of the center
  double radius_ = 0;  ///< of the auxiliary sphere, or the scale of Mercator's projection
  double stretch_ = 1;
};

}  // namespace circle_voronoi::cli
