// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace circle_voronoi::python {

void addDiagram(pybind11::module_& module);
void addRegions(pybind11::module_& module);
void addUpdates(pybind11::module_& module);
void addFiles(pybind11::module_& module);
void addPeriodic(pybind11::module_& module);
void addSphere(pybind11::module_& module);

}  // namespace circle_voronoi::python
