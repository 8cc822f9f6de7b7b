// SPDX-License-Identifier: GPL-3.0-or-later
#include "sphere_oracle.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>
#include <cmath>
#include <cstdio>

#include "at.h"
#include "random.h"

namespace circle_voronoi::test {
namespace {

using Long = boost::multiprecision::number<boost::multiprecision::cpp_bin_float<50>, boost::multiprecision::et_off>;
using Vec = std::array<Long, 3>;

Long dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Long angle(const Vec& a, const Vec& b) {
  const Vec normal = cross(a, b);
  return atan2(sqrt(dot(normal, normal)), dot(a, b));
}

Vec unit(double longitude, double latitude) {
  static const Long kDegree = boost::math::constants::pi<Long>() / 180;
  const Long lon = Long(longitude) * kDegree;
  const Long lat = Long(latitude) * kDegree;
  return {cos(lat) * cos(lon), cos(lat) * sin(lon), sin(lat)};
}

struct LongCap {
  Vec center;
  Long r;
};

struct LongDisc {
  Vec center;
  Long r;
};

/// The disc that touches three caps, nearest to a given place, by Newton's method from there.
LongDisc disc(const std::array<LongCap, 3>& caps, const Vec& start, const Long& distance) {
  Vec q = start;
  Long s = distance;
  for (int step = 0; step < 12; ++step) {
    // The angle to each center is s + r. Its derivative is the direction away from the center.
    std::array<std::array<Long, 4>, 4> m;
    for (std::size_t k = 0; k < 3; ++k) {
      const Long cosine = dot(q, caps[k].center);
      const Long t = angle(q, caps[k].center);
      const Long sine = sin(t);
      if (sine == 0) return {q, s};
      for (std::size_t i = 0; i < 3; ++i) m[k][i] = -(caps[k].center[i] - cosine * q[i]) / sine;
      m[k][3] = -1;
    }
    for (std::size_t i = 0; i < 3; ++i) m[3][i] = q[i];
    m[3][3] = 0;
    std::array<Long, 4> b;
    for (std::size_t k = 0; k < 3; ++k) b[k] = s + caps[k].r - angle(q, caps[k].center);
    b[3] = 0;
    std::array<Long, 4> x;
    for (std::size_t c = 0; c < 4; ++c) {
      std::size_t pivot = c;
      for (std::size_t r = c + 1; r < 4; ++r) {
        if (abs(m[r][c]) > abs(m[pivot][c])) pivot = r;
      }
      std::swap(m[c], m[pivot]);
      std::swap(b[c], b[pivot]);
      if (m[c][c] == 0) return {q, s};
      for (std::size_t r = c + 1; r < 4; ++r) {
        const Long f = m[r][c] / m[c][c];
        for (std::size_t k = c; k < 4; ++k) m[r][k] -= f * m[c][k];
        b[r] -= f * b[c];
      }
    }
    for (std::size_t c = 4; c-- > 0;) {
      x[c] = b[c];
      for (std::size_t k = c + 1; k < 4; ++k) x[c] -= m[c][k] * x[k];
      x[c] /= m[c][c];
    }
    for (std::size_t i = 0; i < 3; ++i) q[i] += x[i];
    const Long size = sqrt(dot(q, q));
    for (Long& part : q) part /= size;
    s += x[3];
    if (abs(x[0]) + abs(x[1]) + abs(x[2]) + abs(x[3]) < 1e-40) break;
  }
  return {q, s};
}

/// Returns by how much a change of the radii of three caps may change the radius of the disc that touches them, as a
/// factor.
double magnification(const std::array<LongCap, 3>& caps, const LongDisc& exact) {
  const Long step = 1e-20;
  Long sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    std::array<LongCap, 3> changed = caps;
    changed[k].r += step;
    sum += abs(disc(changed, exact.center, exact.r).r - exact.r) / step;
  }
  return static_cast<double>(sum);
}

}  // namespace

double exactDistance(const SphereDiagram& diagram, CircleIndex cap, double longitude, double latitude) {
  const Cap& c = diagram.caps[at(cap)];
  return static_cast<double>(Long(diagram.radius) * angle(unit(c.longitude, c.latitude), unit(longitude, latitude)) -
                             Long(c.r));
}

SphereErrors errorsOf(const SphereDiagram& diagram) {
  SphereErrors errors;
  const Long radius = diagram.radius;
  std::vector<LongCap> caps;
  for (const Cap& c : diagram.caps) caps.push_back({unit(c.longitude, c.latitude), Long(c.r) / radius});
  const double allowed = 2 * diagram.rounding / diagram.radius;
  for (std::size_t v = 0; v < diagram.vertices.size(); ++v) {
    const SphereVertex& vertex = diagram.vertices[v];
    const Vec place = unit(vertex.longitude, vertex.latitude);
    const Long distance = Long(vertex.distance) / radius;
    const auto& triple = diagram.vertexCaps[v];
    const std::array<LongCap, 3> three = {caps[at(triple[0])], caps[at(triple[1])], caps[at(triple[2])]};
    const LongDisc exact = disc(three, place, distance);
    // The length from a cap's center to the vertex, the largest.
    double size = 0;
    for (const CircleIndex i : triple) {
      size = std::max(size, static_cast<double>(angle(place, caps[at(i)].center)));
    }
    for (const CircleIndex i : triple) {
      const auto miss = static_cast<double>(abs(angle(place, caps[at(i)].center) - caps[at(i)].r - distance));
      // Degrees are rounded, those near 180 to half of 5e-16.
      errors.touch = std::max(errors.touch, (miss - 5e-16) / size);
    }
    double wrong = static_cast<double>(abs(exact.r - distance)) / size;
    if (wrong > 1e-12) wrong /= std::max(1.0, magnification(three, exact));
    if (wrong > errors.distance) {
      errors.distance = wrong;
      errors.message = "vertex " + std::to_string(v) + ": " + std::to_string(triple[0]) + " " +
                       std::to_string(triple[1]) + " " + std::to_string(triple[2]);
    }
    // A double decides where nothing is near.
    for (std::size_t i = 0; i < diagram.caps.size(); ++i) {
      const double rough = distanceFrom(diagram, static_cast<std::int32_t>(i), vertex.longitude, vertex.latitude);
      if (rough > vertex.distance + 1e-12 * diagram.radius) continue;
      const auto reach = static_cast<double>(exact.r + caps[i].r - angle(exact.center, caps[i].center));
      errors.reach = std::max(errors.reach, reach - allowed);
    }
  }
  return errors;
}

CapInput randomCaps(std::uint64_t seed) {
  Random random(seed);
  CapInput input;
  const std::array<std::size_t, 4> most = {4, 8, 20, 40};
  const std::size_t count = 1 + random.below(most[random.below(4)]);
  // The sine of half of the angle from a center that caps have at most.
  const std::array<double, 6> spreads = {1, 1, 0.3, 1e-3, 1e-6, 1e-10};
  const double spread = spreads[random.below(6)];
  const std::size_t kind = random.below(6);
  const std::size_t position = random.below(5);
  input.options.radius = random.below(3) == 0 ? 1 : kEarthRadius;
  input.options.weights = random.below(8) == 0;
  const double middleLongitude = random.uniform(-180, 180);
  const double middleLatitude = position == 0   ? 90
                                : position == 1 ? -90
                                                : std::asin(random.uniform(-1, 1)) * 57.2957795;
  constexpr double kPi = 3.14159265358979323846;
  for (std::size_t i = 0; i < count; ++i) {
    Cap cap;
    if (spread == 1 && kind == 5) {
      cap.longitude = 30 * static_cast<double>(random.below(12)) - 180;
      cap.latitude = 30 * static_cast<double>(random.below(7)) - 90;
    } else if (spread == 1) {
      cap.longitude = random.uniform(-180, 180);
      cap.latitude = std::asin(random.uniform(-1, 1)) * (180 / kPi);
    } else {
      const double size = spread * 180 / kPi;
      const double up = size * random.uniform(-1, 1);
      cap.latitude = middleLatitude + up > 90 || middleLatitude + up < -90 ? middleLatitude - up : middleLatitude + up;
      const double share = std::max(std::cos(cap.latitude * kPi / 180), 1e-9);
      cap.longitude = middleLongitude + std::clamp(size * random.uniform(-1, 1) / share, -180.0, 180.0);
    }
    double r = 0;
    switch (kind) {
      case 1:
        r = 0.1 * spread * random.unit();
        break;
      case 2:
        r = spread * random.unit() * random.unit();
        break;
      case 3:
        r = std::min(spread * kPi, kPi) * random.unit();
        break;
      case 4:
        r = random.below(2) == 0 ? 0.2 * spread : 0.1 * spread;
        break;
      default:
        break;
    }
    cap.r = input.options.radius * r;
    if (input.options.weights && random.below(2) == 0) cap.r = -cap.r;
    const std::size_t special = random.below(20);
    if (!input.caps.empty() && special < 3) {
      const Cap& other = input.caps[random.below(input.caps.size())];
      if (special == 0) cap = other;
      if (special == 1) cap = {other.longitude + 180, -other.latitude, cap.r};
      if (special == 2) cap = {other.longitude, other.latitude, cap.r};
    }
    input.caps.push_back(cap);
  }
  input.name = "seed " + std::to_string(seed);
  return input;
}

std::string describe(const std::vector<Cap>& caps) {
  std::string text = "std::vector<Cap> caps = {";
  for (const Cap& c : caps) {
    std::array<char, 128> line{};
    std::snprintf(line.data(), line.size(), "{%a, %a, %a}, ", c.longitude, c.latitude, c.r);
    text += line.data();
  }
  return text + "};";
}

}  // namespace circle_voronoi::test
