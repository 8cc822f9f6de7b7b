// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "circle_voronoi/error.h"
#include "portable.h"

namespace circle_voronoi {

/// Carries an exception of the caller's callback or stream back to the caller.
struct CallbackThrew {
  std::exception_ptr thrown;
};

/// An error that becomes the result of the whole function when it is thrown inside `guarded`.
struct ThrownError {
  Error error;
};

/// Returns a callback whose exceptions `guarded` lets through. It refers to `callback`. An empty one stays empty.
template <class Callback>
Callback lettingThrough(const Callback& callback) {
  if (!callback) return {};
  return [&callback](const auto&... arguments) {
    try {
      callback(arguments...);
    } catch (...) {
      throw CallbackThrew{std::current_exception()};
    }
  };
}

/// Makes an error, with its message if there is memory for it.
inline Error errorWith(ErrorCode code, const char* message) noexcept {
  Error error;
  error.code = code;
  try {
    error.message = message;
  } catch (const std::bad_alloc&) {
    // The code says it.
  }
  return error;
}

/// Returns the error for the current exception. Rethrows exceptions of callbacks. Not inlined, because it is longer
/// than most of its callers.
CIRCLE_VORONOI_NEVER_INLINE inline Error errorInFlight() {
  try {
    throw;
  } catch (const CallbackThrew& callback) {
    std::rethrow_exception(callback.thrown);
  } catch (ThrownError& refusal) {
    return std::move(refusal.error);
  } catch (const std::bad_alloc&) {
    return errorWith(ErrorCode::tooManyCircles, "There is not enough memory.");
  } catch (const std::length_error&) {
    return errorWith(ErrorCode::tooManyCircles, "There are more circles, or candidates, than fit in memory.");
  } catch (const std::exception& exception) {
    return errorWith(ErrorCode::internal, exception.what());
  } catch (...) {
    return errorWith(ErrorCode::internal, "The computation failed.");
  }
}

/// Returns the result of `function`, or an error if it throws. Exceptions of callbacks (lettingThrough) pass through.
template <class Function>
auto guarded(Function function) -> decltype(function()) {
  try {
    return function();
  } catch (...) {
    return errorInFlight();
  }
}

}  // namespace circle_voronoi
