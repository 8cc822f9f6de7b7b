// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "guarded.h"

namespace circle_voronoi {

/// Throws the error for a clip that is not certified.
[[noreturn]] inline void refuseClip(const char* message) {
  throw ThrownError{errorWith(ErrorCode::notCertified, message)};
}

}  // namespace circle_voronoi
