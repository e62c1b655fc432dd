// The parts of the module.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/pybind11.h>

#include "python/bound.hpp"

namespace touchstone::python {

namespace py = pybind11;

void define_queries(py::module_& module);
/// `Mesh`.
void define_mesh(py::module_& module);
/// The questions about meshes, and what they return.
void define_meshes(py::module_& module);
/// `MeshReader` and `frame_files`.
void define_mesh_files(py::module_& module);
void define_curved(py::module_& module);
void define_proofs(py::module_& module);
/// `judge`.
void define_judging(py::module_& module);
void define_fuzzing(py::module_& module);
void define_step_fuzzing(py::module_& module);
/// `page`, which is None in a build without the view layer.
void define_pages(py::module_& module);
/// `mesh_page`, which is None there, too.
void define_mesh_pages(py::module_& module);
/// Makes one line of what pybind11 says of arguments that do not fit, for each function and method of the module.
void shorten_messages(const py::module_& module);

}  // namespace touchstone::python
