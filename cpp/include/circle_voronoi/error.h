// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "circle_voronoi/abi.h"

namespace CIRCLE_VORONOI_API circle_voronoi {

/// What can be wrong. Hidden, duplicate and tangent circles are results, not errors.
/// The names are the same in TypeScript (`errorCodeName`, `web/lib/base/errors.ts`).
enum class ErrorCode {
  nonFinite,           ///< a coordinate or a radius is NaN or infinite
  negativeRadius,      ///< a radius is below zero, and radii are no weights
  coordinateTooLarge,  ///< a coordinate or a radius exceeds kCoordinateLimit, or a vertex the doubles
  tooManyCircles,      ///< the input, or the candidates asked for, do not fit in memory or in 32-bit indices
  badOption,           ///< an option is out of its range
  notCertified,        ///< no construction led to a certified diagram
  unknownCircle,       ///< an editor has no circle with this id
  badInput,            ///< text that cannot be read as circles
  badArithmetic,       ///< the program rounds otherwise than to nearest, or takes tiny numbers for zero
  internal,            ///< the program itself failed; please report it with the input
};

/// The name of a code, as in the enumeration.
std::string_view errorCodeName(ErrorCode code);

/// One sentence about what is wrong, and the index of the circle concerned (-1: none). The message is empty if there
/// was no memory left for it.
struct Error {
  ErrorCode code = ErrorCode::badInput;
  std::int64_t circle = -1;
  std::string message;
};

/// A value or an error. A function that returns it throws nothing, on bad input or when memory runs out, and never
/// aborts. What a callback of the caller throws passes through it unchanged.
template <class T>
class Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  explicit operator bool() const { return ok(); }
  bool ok() const { return std::holds_alternative<T>(state_); }

  /// Precondition: ok().
  const T& value() const& { return std::get<T>(state_); }
  T& value() & { return std::get<T>(state_); }
  T&& value() && { return std::get<T>(std::move(state_)); }

  /// Precondition: !ok().
  const Error& error() const { return std::get<Error>(state_); }

 private:
  std::variant<T, Error> state_;
};

}  // namespace circle_voronoi
