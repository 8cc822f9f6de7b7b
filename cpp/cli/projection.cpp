// SPDX-License-Identifier: GPL-3.0-or-later
#include "projection.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "command_error.h"
#include "number_text.h"
#include "read_double.h"

namespace circle_voronoi::cli {
namespace {

// WGS 84.
constexpr double kEquator = 6378137;
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kSquare = kFlattening * (2 - kFlattening);  ///< the square of the eccentricity
const double kEccentricity = std::sqrt(kSquare);

/// The largest distance from the center of an azimuthal map, and the largest latitude of Mercator's, in degrees.
constexpr double kFarthest = 60;
constexpr double kNorthernmost = 85;
/// The largest part of a degree between points of a side of a region.
constexpr double kLongestSide = 0.05;
constexpr double kMostPoints = 1e6;
constexpr std::string_view kRecord = "\"projection\":{\"type\":\"";

double normalCurvature(double sine) { return kEquator / std::sqrt(1 - kSquare * sine * sine); }

/// The hyperbolic sine of a number up to 0.01.
double smallSinh(double x) { return x * (1 + x * x / 6 * (1 + x * x / 20)); }

/// The conformal latitude (Snyder 1987, 3-1; C. F. F. Karney 2011, equations 7 to 9).
SineCosine conformalOf(SineCosine latitude) {
  const double s = smallSinh(kEccentricity * smallArtanh(kEccentricity * latitude.sine));
  const double sine = latitude.sine * std::sqrt(1 + s * s) - s;
  const double length = std::sqrt(sine * sine + latitude.cosine * latitude.cosine);
  return {sine / length, latitude.cosine / length};
}

/// The tangent of a latitude whose conformal latitude has a tangent, by Newton's method (Karney, equations 19 to 21).
double tangentOfConformal(double conformal) {
  double tangent = conformal / (1 - kSquare);
  for (int step = 0; step < 6; ++step) {
    const double secant = std::sqrt(1 + tangent * tangent);
    const double s = smallSinh(kEccentricity * smallArtanh(kEccentricity * tangent / secant));
    const double reached = tangent * std::sqrt(1 + s * s) - s * secant;
    tangent += (conformal - reached) / std::sqrt(1 + reached * reached) * (1 + (1 - kSquare) * tangent * tangent) /
               ((1 - kSquare) * secant);
  }
  return tangent;
}

/// Snyder's q (3-12), which is proportional to the area south of a latitude.
double areaOf(double sine) {
  return (1 - kSquare) * (sine / (1 - kSquare * sine * sine) + smallArtanh(kEccentricity * sine) / kEccentricity);
}

/// The cosine of a latitude within 60 m of a pole.
constexpr double kAtPole = 1e-5;

double cosineOf(double sine) { return std::sqrt(std::max((1 - sine) * (1 + sine), 0.0)); }

/// Mercator's ordinate of a latitude above the equator, whose conformal latitude is given.
double ordinateOf(SineCosine conformal) {
  const double size = logarithm((1 + std::abs(conformal.sine)) / conformal.cosine);
  return conformal.sine < 0 ? -size : size;
}

double wrapped(double degrees) { return degrees - 360 * std::floor((degrees + 180) / 360); }

double rounded(double degrees) { return std::floor(degrees * 1e9 + 0.5) / 1e9; }

}  // namespace

Projection::Projection(Kind kind, double longitude, double latitude)
    : kind_(kind), longitude_(longitude), latitude_(latitude), center_(auxiliaryOf(latitude)) {
  const SineCosine geodetic = sineCosine(latitude * kDegree);
  const double normal = normalCurvature(geodetic.sine);
  switch (kind) {
    case Kind::local:
      radius_ = normal * geodetic.cosine / center_.cosine;
      break;
    case Kind::equalArea:
      radius_ = kEquator * std::sqrt(areaOf(1) / 2);
      // Around a pole, the map is the same in all directions, and both cosines are hardly known.
      stretch_ = geodetic.cosine < kAtPole ? 1 : normal * geodetic.cosine / (radius_ * center_.cosine);
      break;
    case Kind::mercator:
      radius_ = normal * geodetic.cosine;
      break;
  }
}

SineCosine Projection::auxiliaryOf(double latitude) const {
  const SineCosine geodetic = sineCosine(latitude * kDegree);
  if (kind_ != Kind::equalArea) return conformalOf(geodetic);
  const double sine = std::clamp(areaOf(geodetic.sine) / areaOf(1), -1.0, 1.0);
  return {sine, cosineOf(sine)};
}

double Projection::latitudeOf(SineCosine auxiliary) const {
  if (kind_ != Kind::equalArea) {
    if (!(auxiliary.cosine > 0)) return auxiliary.sine < 0 ? -90 : 90;
    return angleOf(tangentOfConformal(auxiliary.sine / auxiliary.cosine), 1) / kDegree;
  }
  const double area = auxiliary.sine * areaOf(1);
  double sine = auxiliary.sine;
  for (int step = 0; step < 6; ++step) {
    const double slope = 1 - kSquare * sine * sine;
    sine = std::clamp(sine + (area - areaOf(sine)) * slope * slope / (2 * (1 - kSquare)), -1.0, 1.0);
  }
  return angleOf(sine, cosineOf(sine)) / kDegree;
}

Point Projection::plane(Point degrees) const {
  const double turn = wrapped(degrees.x - longitude_) * kDegree;
  const SineCosine latitude = auxiliaryOf(degrees.y);
  if (kind_ == Kind::mercator) return {radius_ * turn, radius_ * (ordinateOf(latitude) - ordinateOf(center_))};
  const SineCosine meridian = sineCosine(turn);
  const double across = latitude.cosine * meridian.sine;
  const double along = center_.cosine * latitude.sine - center_.sine * latitude.cosine * meridian.cosine;
  const double cosine = center_.sine * latitude.sine + center_.cosine * latitude.cosine * meridian.cosine;
  if (kind_ == Kind::equalArea) {
    const double factor = radius_ * std::sqrt(2 / (1 + cosine));
    return {factor * stretch_ * across, factor / stretch_ * along};
  }
  const double sine = std::sqrt(across * across + along * along);
  const double factor = sine > 0 ? radius_ * (angleOf(sine, cosine) / sine) : radius_;
  return {factor * across, factor * along};
}

Point Projection::degrees(Point plane) const {
  const double x = plane.x / radius_ / stretch_;
  const double y = plane.y / radius_ * stretch_;
  if (kind_ == Kind::mercator) {
    const double up = exponential(y + ordinateOf(center_));
    const double tangent = tangentOfConformal((up - 1 / up) / 2);
    return {rounded(longitude_ + x / kDegree), rounded(angleOf(tangent, 1) / kDegree)};
  }
  const double distance = std::sqrt(x * x + y * y);
  SineCosine arc = sineCosine(std::min(distance, kPi));
  if (kind_ == Kind::equalArea) {
    const double half = std::min(distance / 2, 1.0);
    arc = {2 * half * cosineOf(half), 1 - 2 * half * half};
  }
  const double factor = distance > 0 ? arc.sine / distance : 1;
  const double east = factor * x;
  const double north = arc.cosine * center_.cosine - factor * y * center_.sine;
  const double sine = std::clamp(arc.cosine * center_.sine + factor * y * center_.cosine, -1.0, 1.0);
  const double cosine = std::sqrt(east * east + north * north);
  return {rounded(longitude_ + angleOf(east, north) / kDegree), rounded(latitudeOf({sine, cosine}))};
}

Circle Projection::plane(const Circle& circle) const {
  const Point center = plane(Point{circle.x, circle.y});
  return {center.x, center.y, circle.r * scaleAt(circle.y)};
}

double Projection::scaleAt(double latitude) const {
  if (kind_ != Kind::mercator) return 1;
  const SineCosine angle = sineCosine(latitude * kDegree);
  return radius_ / (normalCurvature(angle.sine) * angle.cosine);
}

std::vector<Point> Projection::poles() const {
  if (kind_ == Kind::mercator) return {};
  return {plane(Point{longitude_, 90}), plane(Point{longitude_, -90})};
}

Projection Projection::around(std::span<const Circle> circles, Kind kind, const std::string& name) {
  const auto fail = [&](std::size_t i, const std::string& problem) {
    throw CommandError{kBadInput, name + ": circle " + std::to_string(i) + " " + problem};
  };
  double x = 0;
  double y = 0;
  double z = 0;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const Circle& c = circles[i];
    if (!(std::abs(c.x) <= 360 && std::abs(c.y) <= 90)) {
      fail(i,
           "is at (" + numberText(c.x) + ", " + numberText(c.y) + "), which is no longitude and latitude in degrees.");
    }
    if (kind == Kind::mercator && std::abs(c.y) > kNorthernmost)
      fail(i, "is too near a pole for --project mercator; use --sphere.");
    const SineCosine meridian = sineCosine(wrapped(c.x) * kDegree);
    const SineCosine latitude = sineCosine(c.y * kDegree);
    x += latitude.cosine * meridian.cosine;
    y += latitude.cosine * meridian.sine;
    z += latitude.sine;
  }
  const auto toMicrodegrees = [](double angle) { return std::floor(angle / kDegree * 1e6 + 0.5) / 1e6; };
  const Projection projection(kind, toMicrodegrees(angleOf(y, x)),
                              toMicrodegrees(angleOf(z, std::sqrt(x * x + y * y))));
  if (kind == Kind::mercator) return projection;
  const SineCosine center = sineCosine(projection.latitude_ * kDegree);
  const double least = sineCosine(kFarthest * kDegree).cosine;
  for (std::size_t i = 0; i < circles.size(); ++i) {
    const SineCosine latitude = sineCosine(circles[i].y * kDegree);
    const double turn = sineCosine(wrapped(circles[i].x - projection.longitude_) * kDegree).cosine;
    if (center.sine * latitude.sine + center.cosine * latitude.cosine * turn >= least) continue;
    fail(i,
         "is more than 60 degrees from the middle of the circles, too far for one map; use --sphere, or --project "
         "mercator.");
  }
  return projection;
}

Region Projection::plane(const Region& region, const std::string& name, const RegionOptions& options) const {
  std::vector<Point> points;
  std::vector<std::int32_t> ringOffsets = {0};
  const auto offsets = region.ringOffsets();
  for (std::size_t ring = 0; ring + 1 < offsets.size(); ++ring) {
    const auto begin = static_cast<std::size_t>(offsets[ring]);
    const auto end = static_cast<std::size_t>(offsets[ring + 1]);
    for (std::size_t k = begin; k < end; ++k) {
      const Point from = region.points()[k];
      const Point to = region.points()[k + 1 == end ? begin : k + 1];
      if (!(std::abs(from.x) <= 360 && std::abs(from.y) <= (kind_ == Kind::mercator ? kNorthernmost : 90))) {
        throw CommandError{kBadInput, name + ": (" + numberText(from.x) + ", " + numberText(from.y) +
                                          ") has no place on the map of --project, which takes degrees."};
      }
      // A side that two regions share gets the same points in both, whatever its direction.
      const bool isForth = std::pair(from.x, from.y) < std::pair(to.x, to.y);
      const Point a = isForth ? from : to;
      const Point b = isForth ? to : from;
      const double parts = std::max(1.0, std::ceil(std::max(std::abs(b.x - a.x), std::abs(b.y - a.y)) / kLongestSide));
      if (static_cast<double>(points.size()) + parts > kMostPoints) {
        throw CommandError{kBadInput, name + ": the sides of the region are too long for --project."};
      }
      for (double part = 0; part < parts; ++part) {
        const double share = (isForth ? part : parts - part) / parts;
        points.push_back(plane(Point{a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)}));
      }
    }
    ringOffsets.push_back(static_cast<std::int32_t>(points.size()));
  }
  auto projected = Region::fromArrays(points, ringOffsets, region.polygonOffsets(), options);
  if (!projected) throw CommandError{kBadInput, name + ": " + projected.error().message};
  return *std::move(projected);
}

Circle Projection::degrees(const Circle& circle) const {
  const Point center = degrees(Point{circle.x, circle.y});
  return {center.x, center.y, circle.r / scaleAt(center.y)};
}

void Projection::removeFrom(CircleAttributes& attributes) {
  std::string& text = attributes.collection;
  std::size_t begin = text.find(kRecord);
  if (begin == std::string::npos) return;
  std::size_t end = text.find('}', begin) + 1;
  if (end < text.size() && text[end] == ',') {
    ++end;
  } else if (begin > 0) {
    --begin;
  }
  text.erase(begin, end - begin);
}

void Projection::record(CircleAttributes& attributes) const {
  removeFrom(attributes);
  if (!attributes.collection.empty()) attributes.collection += ",";
  attributes.collection += std::string(kRecord) + kProjections[static_cast<std::size_t>(kind_)] +
                           "\",\"longitude\":" + numberText(longitude_) + ",\"latitude\":" + numberText(latitude_) +
                           ",\"unit\":\"meter\"}";
}

std::optional<Projection> Projection::recordedIn(const CircleAttributes& attributes) {
  const std::string& text = attributes.collection;
  std::size_t at = text.find(kRecord);
  if (at == std::string::npos) return std::nullopt;
  at += kRecord.size();
  const std::size_t end = text.find('"', at);
  const auto kind = std::ranges::find(kProjections, text.substr(at, end - at));
  const auto numberAfter = [&](std::string_view key) -> std::optional<double> {
    const std::size_t found = text.find(key, end);
    if (found == std::string::npos) return std::nullopt;
    double value = 0;
    const char* first = text.data() + found + key.size();
    const auto code = readDouble(first, text.data() + text.size(), value).ec;
    return code == std::errc() ? std::optional(value) : std::nullopt;
  };
  const auto longitude = numberAfter(",\"longitude\":");
  const auto latitude = numberAfter(",\"latitude\":");
  if (kind == kProjections.end() || !longitude || !latitude ||
      !(std::abs(*longitude) <= 180 && std::abs(*latitude) < 90)) {
    return std::nullopt;
  }
  return Projection(static_cast<Kind>(kind - kProjections.begin()), *longitude, *latitude);
}

}  // namespace circle_voronoi::cli
