// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

// In place of CGAL's header of this name: what happens when one of CGAL's assertions fails. There it is written to
// std::cerr before it is thrown, which links the whole of the iostreams into a WebAssembly module, a third of its size.

#include <CGAL/assertions.h>

#include <boost/next_prior.hpp>  // which other headers of CGAL rely on this one to include
#include <stdexcept>

namespace CGAL {

inline void assertion_fail(const char* expression, const char*, int, const char*) {
  throw std::logic_error(expression);
}
inline void precondition_fail(const char* expression, const char*, int, const char*) {
  throw std::logic_error(expression);
}
inline void postcondition_fail(const char* expression, const char*, int, const char*) {
  throw std::logic_error(expression);
}
inline void warning_fail(const char*, const char*, int, const char*) {}

}  // namespace CGAL
