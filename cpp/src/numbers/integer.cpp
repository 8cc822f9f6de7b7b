// SPDX-License-Identifier: GPL-3.0-or-later
#include "integer.h"

#include <cstdlib>
#include <utility>

namespace circle_voronoi::limbs {
namespace {

int signedAs(int count, bool isNegative) { return isNegative ? -count : count; }

/// Returns -1 if a is smaller than b, 0 if they are equal, 1 if a is larger.
int compare(const Limb* a, int aCount, const Limb* b, int bCount) {
  if (aCount != bCount) return aCount < bCount ? -1 : 1;
  for (int i = aCount - 1; i >= 0; --i) {
    if (a[i] != b[i]) return a[i] < b[i] ? -1 : 1;
  }
  return 0;
}

/// Writes a + b to `out`. Returns its number of limbs.
/// Precondition: aCount >= bCount.
int sumOf(const Limb* a, int aCount, const Limb* b, int bCount, Limb* out) {
  Limb carry = 0;
  for (int i = 0; i < aCount; ++i) {
    const Wide total = static_cast<Wide>(a[i]) + (i < bCount ? b[i] : 0) + carry;
    out[i] = static_cast<Limb>(total);
    carry = static_cast<Limb>(total >> kBits);
  }
  out[aCount] = carry;
  return aCount + (carry != 0 ? 1 : 0);
}

/// Writes a - b to `out`. Returns its number of limbs.
/// Precondition: a > b.
int differenceOf(const Limb* a, int aCount, const Limb* b, int bCount, Limb* out) {
  Limb borrow = 0;
  for (int i = 0; i < aCount; ++i) {
    const Wide rest = static_cast<Wide>(a[i]) - (i < bCount ? b[i] : 0) - borrow;
    out[i] = static_cast<Limb>(rest);
    borrow = static_cast<Limb>(rest >> kBits) & 1;
  }
  int count = aCount;
  while (out[count - 1] == 0) --count;
  return count;
}

}  // namespace

int sum(const Limb* a, int aSize, const Limb* b, int bSize, Limb* out) {
  int aCount = std::abs(aSize);
  int bCount = std::abs(bSize);
  const int order = compare(a, aCount, b, bCount);
  if (order < 0) {
    std::swap(a, b);
    std::swap(aSize, bSize);
    std::swap(aCount, bCount);
  }
  if ((aSize < 0) == (bSize < 0)) return signedAs(sumOf(a, aCount, b, bCount, out), aSize < 0);
  if (order == 0) return 0;
  return signedAs(differenceOf(a, aCount, b, bCount, out), aSize < 0);
}

int product(const Limb* a, int aSize, const Limb* b, int bSize, Limb* out) {
  const int aCount = std::abs(aSize);
  const int bCount = std::abs(bSize);
  if (aCount == 0 || bCount == 0) return 0;
  for (int j = 0; j < bCount; ++j) out[j] = 0;
  for (int i = 0; i < aCount; ++i) {
    Limb carry = 0;
    for (int j = 0; j < bCount; ++j) {
      const Wide total = static_cast<Wide>(a[i]) * b[j] + out[i + j] + carry;
      out[i + j] = static_cast<Limb>(total);
      carry = static_cast<Limb>(total >> kBits);
    }
    out[i + bCount] = carry;
  }
  const int count = aCount + bCount;
  return signedAs(out[count - 1] == 0 ? count - 1 : count, (aSize < 0) != (bSize < 0));
}

int assign(std::int64_t value, int shift, Limb* out) {
  if (value == 0) return 0;
  const auto magnitude = value < 0 ? -static_cast<Limb>(value) : static_cast<Limb>(value);
  const int zeros = shift / kBits;
  const int bits = shift % kBits;
  for (int i = 0; i < zeros; ++i) out[i] = 0;
  out[zeros] = magnitude << bits;
  const Limb carried = bits == 0 ? 0 : magnitude >> (kBits - bits);
  if (carried != 0) out[zeros + 1] = carried;
  return signedAs(zeros + (carried != 0 ? 2 : 1), value < 0);
}

LeadingBits leading(const Limb* a, int size) {
  const int count = std::abs(size);
  if (count == 0) return {};
  const int zeros = std::countl_zero(a[count - 1]);
  Limb top = a[count - 1] << zeros;
  if (zeros > 0 && count > 1) top |= a[count - 2] >> (kBits - zeros);
  const auto value = static_cast<double>(top);
  return {size < 0 ? -value : value, kBits * (count - 1) - zeros};
}

}  // namespace circle_voronoi::limbs
