// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "circle_voronoi/abi.h"
#include "circle_voronoi/index.h"

namespace circle_voronoi {

/// The kind of an error. Hidden, duplicate and tangent circles are results, not errors.
/// The names are the same in TypeScript (`errorCodeName`, `web/lib/base/errors.ts`).
enum class ErrorCode {
  nonFinite,           ///< a coordinate or a radius is NaN or infinite
  negativeRadius,      ///< a radius is negative, and the radii are not weights
  coordinateTooLarge,  ///< a number exceeds kCoordinateLimit in absolute value (limits.h)
  coordinateTooSmall,  ///< the largest number of the input is not 0 and below kSmallestInput (limits.h)
  tooManyCircles,      ///< the input, or the requested candidates, do not fit in memory or in 32-bit indices
  badOption,           ///< an option is out of range
  notCertified,        ///< no construction led to a certified diagram
  notConverged,        ///< an iteration did not reach its tolerance
  unknownCircle,       ///< an editor has no circle with this id
  badInput,            ///< the text cannot be read as circles, or the parts of an argument do not fit together
  badArithmetic,       ///< the program does not round to nearest, or flushes tiny numbers to zero
  notWritten,          ///< a stream did not accept all of the text
  internal,            ///< the library itself failed; please report it with the input
};

/// Returns the name of a code, as in the enumeration. Past the last code the name is empty.
[[nodiscard]] CIRCLE_VORONOI_API std::string_view errorCodeName(ErrorCode code);

/// The option that the message of an error names. Programs whose options have other names write theirs in its place,
/// and need not search a message that may quote the user's text.
struct NamedOption {
  std::string name = {};   ///< the option in C++, such as `radius`; empty if the message names none
  std::size_t offset = 0;  ///< the offset in the message of the words that name the option
  std::size_t size = 0;    ///< the number of bytes of these words
};

/// An error with its kind, place and message. The message is one sentence; it is empty if no memory was left for it.
struct Error {
  ErrorCode code = ErrorCode::badInput;
  std::int64_t circle = kNone;  ///< the index of the circle, or its id in an editor; kNone if no circle is to blame
  std::string message;
  std::int64_t edit = kNone;  ///< the index of the edit in its batch (DiagramEditor::apply), otherwise kNone
  NamedOption option = {};
};

/// A value or an error. A function that returns a Result throws nothing for bad input or when memory runs out, and it
/// never aborts. Exceptions that the caller's callbacks and streams throw pass through unchanged.
///
/// Check before you access: `value()`, `*` and `->` of an error, and `error()` of a value, throw
/// std::bad_variant_access. `->` of a temporary gives a pointer that dies with it: use `value()` in a range-based for.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::move(value)) {}
  Result(Error error) : state_(std::move(error)) {}

  explicit operator bool() const { return ok(); }
  [[nodiscard]] bool ok() const { return std::holds_alternative<T>(state_); }

  [[nodiscard]] const T& value() const& { return std::get<T>(state_); }
  [[nodiscard]] T& value() & { return std::get<T>(state_); }
  /// Returns a copy, not a reference into a temporary, so `const auto& x = compute(circles).value();` is safe.
  [[nodiscard]] T value() && { return std::get<T>(std::move(state_)); }

  [[nodiscard]] const T& operator*() const& { return value(); }
  [[nodiscard]] T& operator*() & { return value(); }
  [[nodiscard]] T operator*() && { return std::move(*this).value(); }
  [[nodiscard]] const T* operator->() const { return &value(); }
  [[nodiscard]] T* operator->() { return &value(); }

  /// Returns the value, or `fallback` if there is an error.
  [[nodiscard]] T value_or(T fallback) const& { return ok() ? value() : std::move(fallback); }
  [[nodiscard]] T value_or(T fallback) && { return ok() ? std::move(*this).value() : std::move(fallback); }

  [[nodiscard]] const Error& error() const { return std::get<Error>(state_); }

 private:
  std::variant<T, Error> state_;
};

/// Success or an error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : state_(std::move(error)) {}

  explicit operator bool() const { return ok(); }
  [[nodiscard]] bool ok() const { return std::holds_alternative<std::monostate>(state_); }
  [[nodiscard]] const Error& error() const { return std::get<Error>(state_); }

 private:
  std::variant<std::monostate, Error> state_;
};

}  // namespace circle_voronoi
