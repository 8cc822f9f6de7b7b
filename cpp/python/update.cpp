// SPDX-License-Identifier: GPL-3.0-or-later
// An editor: edits by id, and the certified diagram after them.
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <memory>
#include <utility>
#include <vector>

#include "arrays.h"
#include "circle_voronoi/editor.h"
#include "errors.h"
#include "interruptible.h"
#include "module.h"

namespace py = pybind11;

namespace circle_voronoi::python {
namespace {

using SharedEditor = std::shared_ptr<DiagramEditor>;

SharedEditor editorOf(const Doubles& circles, bool weights) {
  return interruptible([circles = circlesOf(circles), weights](const Cancellation&) {
    return std::make_shared<DiagramEditor>(valueOf(DiagramEditor::from(circles, {weights})));
  });
}

/// Applies all edits or none. An edit in progress is never abandoned, because the editor would change behind its
/// owner's back.
void apply(DiagramEditor& editor, const Ints& removed, const Ints& replaced, const Doubles& replacements,
           const Doubles& inserted) {
  std::vector<Edit> edits;
  for (py::ssize_t k = 0; k < removed.size(); ++k) edits.push_back({Edit::Kind::remove, removed.data()[k], {}});
  const auto circles = circlesOf(replacements);
  for (std::size_t k = 0; k < circles.size(); ++k) {
    edits.push_back({Edit::Kind::replace, replaced.data()[k], circles[k]});
  }
  for (const Circle& circle : circlesOf(inserted)) edits.push_back({Edit::Kind::insert, {}, circle});
  const py::gil_scoped_release released;
  valueOf(editor.apply(edits));
}

}  // namespace

void addUpdates(py::module_& module) {
  py::class_<DiagramEditor, SharedEditor>(module, "Editor")
      .def(py::init(&editorOf))
      .def("apply", apply)
      .def("ids", [](const DiagramEditor& editor) { return arrayOf<std::int32_t>(editor.ids()); })
      .def("snapshot", [](const SharedEditor& editor) {
        return interruptible(
            [editor](const Cancellation&) { return std::make_shared<Diagram>(valueOf(editor->snapshot())); });
      });
}

}  // namespace circle_voronoi::python
