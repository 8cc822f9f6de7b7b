// SPDX-License-Identifier: GPL-3.0-or-later
#include "wkb.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "bit_cast.h"
#include "digits.h"
#include "text.h"

namespace circle_voronoi {
namespace {

/// The types of geometries (OGC 06-103r4, section 8.2), by their codes from 1.
constexpr auto kWkbTypes = std::to_array<std::string_view>(
    {"POINT", "LINESTRING", "POLYGON", "MULTIPOINT", "MULTILINESTRING", "MULTIPOLYGON", "GEOMETRYCOLLECTION"});
constexpr std::uint32_t kPoint = 1, kLineString = 2, kPolygon = 3, kCollection = 7;
/// The flags of PostGIS. The standard adds 1000 for Z, 2000 for M and 3000 for both.
constexpr std::uint32_t kHasZ = 0x80000000U, kHasM = 0x40000000U, kHasSrid = 0x20000000U;
constexpr std::size_t kDigitsOfByte = 2;
/// Byte order and type.
constexpr std::size_t kLeastDigits = 5 * kDigitsOfByte;

/// Returns the value of a hexadecimal digit, or -1.
int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  return -1;
}

/// Reads the bytes from front to back and writes the text.
class WkbTranslator {
 public:
  explicit WkbTranslator(std::string_view hex) : hex_(hex) {}

  std::string translate() {
    addGeometry(true, 0);
    if (at_ != hex_.size()) fail("expected nothing after the geometry.");
    return std::move(text_);
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw ReadError{at_, reason}; }

  std::uint64_t byte() {
    if (hex_.size() - at_ < kDigitsOfByte) fail("the geometry (WKB) ends too early.");
    const int value = 16 * hexDigit(hex_[at_]) + hexDigit(hex_[at_ + 1]);
    at_ += kDigitsOfByte;
    return static_cast<std::uint64_t>(value);
  }

  std::uint64_t bytes(int count, bool isLittle) {
    std::uint64_t value = 0;
    for (int k = 0; k < count; ++k) value = isLittle ? value | byte() << (8 * k) : value << 8U | byte();
    return value;
  }

  std::uint32_t integer(bool isLittle) { return static_cast<std::uint32_t>(bytes(4, isLittle)); }
  double number(bool isLittle) { return bitCast<double>(bytes(8, isLittle)); }

  /// The byte order and the number of coordinates of a geometry.
  struct Form {
    bool isLittle;
    bool hasZ;
    bool hasM;
  };

  void addNumber(double value) {
    if (!std::isfinite(value)) fail("a coordinate is not a finite number.");
    std::array<char, kMostDigits> digits{};
    text_.append(digits.data(), writeDigits(digits.data(), value));
  }

  template <class AddItem>
  void addList(std::uint32_t count, AddItem addItem) {
    if (count == 0) text_ += " EMPTY";
    for (std::uint32_t k = 0; k < count; ++k) {
      text_ += k == 0 ? "(" : ",";
      addItem();
    }
    if (count > 0) text_ += ")";
  }

  /// Adds the position of a point, which is EMPTY if its coordinates are NaN.
  void addPoint(const Form& form) {
    const std::size_t begin = at_;
    const double x = number(form.isLittle);
    const double y = number(form.isLittle);
    at_ = begin;
    if (!std::isnan(x) || !std::isnan(y)) return addList(1, [&] { addPosition(form); });
    for (int k = 0; k < 2 + form.hasZ + form.hasM; ++k) (void)number(form.isLittle);
    text_ += " EMPTY";
  }

  void addPosition(const Form& form) {
    addNumber(number(form.isLittle));
    for (int k = 1; k < 2 + form.hasZ + form.hasM; ++k) {
      text_ += " ";
      addNumber(number(form.isLittle));
    }
  }

  void addPositions(const Form& form) {
    addList(integer(form.isLittle), [&] { addPosition(form); });
  }

  /// Adds a geometry. `hasType`: whether its text begins with its type, which parts of a MULTIPOINT and the like lack.
  void addGeometry(bool hasType, int depth) {
    if (depth == kMostNested) {
      fail("collections are nested more than " + std::to_string(kMostNested) + " deep.");
    }
    const std::size_t begin = at_;
    const bool isLittle = byte() != 0;
    const std::uint32_t code = integer(isLittle);
    const std::uint32_t plain = code & ~(kHasZ | kHasM | kHasSrid);
    const std::uint32_t type = plain % 1000;
    const std::uint32_t dimensions = plain / 1000;
    if (type < 1 || type > kWkbTypes.size() || dimensions > 3) {
      at_ = begin;
      fail("there is no geometry (WKB) of the type " + std::to_string(plain) + ".");
    }
    const Form form = {isLittle, (code & kHasZ) != 0 || dimensions % 2 == 1, (code & kHasM) != 0 || dimensions >= 2};
    if ((code & kHasSrid) != 0) {
      const std::uint32_t srid = integer(isLittle);
      if (depth == 0) text_ += "SRID=" + std::to_string(srid) + ";";
    }
    if (hasType) {
      text_ += kWkbTypes[type - 1];
      if (form.hasZ || form.hasM) text_ += std::string(" ") + (form.hasZ ? "Z" : "") + (form.hasM ? "M" : "");
    }
    if (type == kPoint) return addPoint(form);
    if (type == kLineString) return addPositions(form);
    addList(integer(isLittle), [&] {
      if (type == kPolygon) return addPositions(form);
      addGeometry(type == kCollection, depth + 1);
    });
  }

  std::string_view hex_;
  std::size_t at_ = 0;
  std::string text_;
};

}  // namespace

bool isHexWkb(std::string_view text) {
  if (text.size() < kLeastDigits || !(text.starts_with("00") || text.starts_with("01"))) return false;
  return std::ranges::all_of(text, [](char c) { return hexDigit(c) >= 0; });
}

std::string wktOfHexWkb(std::string_view hex) { return WkbTranslator(hex).translate(); }

}  // namespace circle_voronoi
