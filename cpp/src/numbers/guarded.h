// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <exception>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include "circle_voronoi/error.h"

namespace circle_voronoi {

/// What a callback of the caller threw, on its way to the caller.
struct CallbackThrew {
  std::exception_ptr thrown;
};

/// Thrown where an error is the result of the whole.
struct Refusal {
  Error error;
};

/// A callback whose exceptions `guarded` lets through; an empty one stays empty. It refers to `callback`.
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

/// An error with a message if there is memory for it.
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

/// The error that the exception in flight stands for; one of a callback goes on as it came. One function for all
/// callers, whose code would be longer than their own.
[[gnu::noinline]] inline Error errorInFlight() {
  try {
    throw;
  } catch (const CallbackThrew& callback) {
    std::rethrow_exception(callback.thrown);
  } catch (Refusal& refusal) {
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

/// The result of `function`; an error if anything is thrown in it but by a callback (lettingThrough), whose exception
/// goes on as it came.
template <class Function>
auto guarded(Function function) -> decltype(function()) {
  try {
    return function();
  } catch (...) {
    return errorInFlight();
  }
}

}  // namespace circle_voronoi
