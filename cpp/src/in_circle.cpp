// SPDX-License-Identifier: GPL-3.0-or-later
#include "in_circle.h"

#include <boost/multiprecision/cpp_int.hpp>
#include <initializer_list>

#include "integers.h"

namespace circle_voronoi {
namespace {

template <class Integer>
int inCircleOf(const CommonUnit& unit, const Circle& a, const Circle& b, const Circle& c, const Circle& d) {
  const Integer x = unit.in<Integer>(d.x);
  const Integer y = unit.in<Integer>(d.y);
  const Integer ax = unit.in<Integer>(a.x) - x, ay = unit.in<Integer>(a.y) - y;
  const Integer bx = unit.in<Integer>(b.x) - x, by = unit.in<Integer>(b.y) - y;
  const Integer cx = unit.in<Integer>(c.x) - x, cy = unit.in<Integer>(c.y) - y;
  const Integer determinant = (ax * ax + ay * ay) * (bx * cy - by * cx) + (bx * bx + by * by) * (cx * ay - cy * ax) +
                              (cx * cx + cy * cy) * (ax * by - ay * bx);
  return determinant > 0 ? 1 : determinant < 0 ? -1 : 0;
}

}  // namespace

int inCircle(const Circle& a, const Circle& b, const Circle& c, const Circle& d) {
  namespace multiprecision = boost::multiprecision;
  using Wide = multiprecision::number<
      multiprecision::cpp_int_backend<512, 512, multiprecision::signed_magnitude, multiprecision::unchecked, void>>;
  CommonUnit unit;
  for (const Circle* circle : {&a, &b, &c, &d}) {
    unit.include(circle->x);
    unit.include(circle->y);
  }
  // Differences have one bit more, and the sum of twelve products of four of them has at most 4 (bits + 1) + 4.
  const int bits = 4 * (unit.bits() + 1) + 4;
  __extension__ using Short = __int128;
  if (bits < 127) return inCircleOf<Short>(unit, a, b, c, d);
  if (bits < 512) return inCircleOf<Wide>(unit, a, b, c, d);
  return inCircleOf<multiprecision::cpp_int>(unit, a, b, c, d);
}

}  // namespace circle_voronoi
