// SPDX-License-Identifier: GPL-3.0-or-later
#include "errors.h"

#include <string>

namespace py = pybind11;

namespace circle_voronoi::python {

void translateErrors() {
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const Failed& failed) {
      const Error& error = failed.error;
      const auto indexOrNone = [](std::int64_t index) -> py::object {
        return index == kNone ? py::object(py::none()) : py::int_(index);
      };
      const py::object type = py::module_::import("circle_voronoi._errors").attr("CircleVoronoiError");
      const py::object exception = type(error.message, std::string(errorCodeName(error.code)),
                                        indexOrNone(error.circle), indexOrNone(error.edit));
      PyErr_SetObject(type.ptr(), exception.ptr());
    }
  });
}

}  // namespace circle_voronoi::python
