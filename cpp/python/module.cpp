// SPDX-License-Identifier: GPL-3.0-or-later
// The extension module circle_voronoi._core: the library's functions on arrays whose shapes and types the Python
// sources have checked. No numbers are computed here.
#include "module.h"

#include <pybind11/pybind11.h>

#include "errors.h"

PYBIND11_MODULE(_core, module) {
  using namespace circle_voronoi::python;
  module.attr("__name__") = "circle_voronoi._core";
  translateErrors();
  addDiagram(module);
  addRegions(module);
  addUpdates(module);
  addFiles(module);
  addPeriodic(module);
}
