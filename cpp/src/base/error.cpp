// SPDX-License-Identifier: GPL-3.0-or-later
#include "circle_voronoi/error.h"

namespace circle_voronoi {

std::string_view errorCodeName(ErrorCode code) {
  switch (code) {
    case ErrorCode::nonFinite:
      return "nonFinite";
    case ErrorCode::negativeRadius:
      return "negativeRadius";
    case ErrorCode::coordinateTooLarge:
      return "coordinateTooLarge";
    case ErrorCode::tooManyCircles:
      return "tooManyCircles";
    case ErrorCode::badOption:
      return "badOption";
    case ErrorCode::notCertified:
      return "notCertified";
    case ErrorCode::notConverged:
      return "notConverged";
    case ErrorCode::unknownCircle:
      return "unknownCircle";
    case ErrorCode::badInput:
      return "badInput";
    case ErrorCode::badArithmetic:
      return "badArithmetic";
    case ErrorCode::notWritten:
      return "notWritten";
    case ErrorCode::internal:
      return "internal";
  }
  return "";
}

}  // namespace circle_voronoi
