// SPDX-License-Identifier: GPL-3.0-or-later
// The extension module circle_voronoi._core: the library's functions on arrays whose shapes and types the Python
// sources have checked. No numbers are computed here.
#include "module.h"

#include <pybind11/pybind11.h>

#include "errors.h"

namespace {

/// Returns whether the current interpreter is not the first one of the process. pybind11 keeps one set of types for all
/// interpreters, so that a second one would use objects of the first.
bool isInSubinterpreter() { return PyInterpreterState_Get() != PyInterpreterState_Main(); }

/// A plain function, because Python copies the module into other interpreters without initializing it.
PyObject* inSubinterpreter(PyObject*, PyObject*) { return PyBool_FromLong(isInSubinterpreter() ? 1 : 0); }

PyMethodDef plainFunctions[] = {{"in_subinterpreter", inSubinterpreter, METH_NOARGS, nullptr},
                                {nullptr, nullptr, 0, nullptr}};

}  // namespace

PYBIND11_MODULE(_core_of_main, module) {
  using namespace circle_voronoi::python;
  module.attr("__name__") = "circle_voronoi._core";
  module.attr("__version__") = CIRCLE_VORONOI_VERSION;
  translateErrors();
  addDiagram(module);
  addRegions(module);
  addUpdates(module);
  addFiles(module);
  addPeriodic(module);
  addSphere(module);
  if (PyModule_AddFunctions(module.ptr(), plainFunctions) != 0) throw pybind11::error_already_set();
}

/// Python calls this function by its name. The check comes before any of pybind11's state exists.
extern "C" PYBIND11_EXPORT PyObject* PyInit__core() {
  if (!isInSubinterpreter()) return PyInit__core_of_main();
  PyErr_SetString(PyExc_ImportError, "circle_voronoi cannot be imported in a subinterpreter.");
  return nullptr;
}
