// The module touchstone._core. The package around it, src/bindings/python/touchstone, has the documented functions.
// SPDX-License-Identifier: MIT
#include <pybind11/pybind11.h>

#include <exception>

#include <touchstone/error.hpp>
#include <touchstone/version.hpp>

#include "python/answers.hpp"
#include "python/arguments.hpp"
#include "python/define.hpp"
#include "python/rigid/define_bodies.hpp"

PYBIND11_MODULE(_core, module) {
  namespace python = touchstone::python;
  pybind11::options options;
  options.disable_function_signatures();  // those of the package are better
  pybind11::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const touchstone::Error& error) {
      PyErr_SetString(PyExc_ValueError, error.what());
    }
  });
  module.attr("__version__") = touchstone::version();
  module.attr("_names") = python::all_names();
  python::define_answers(module);
  python::define_queries(module);
  python::define_mesh(module);
  python::define_meshes(module);
  python::define_bodies(module);
  python::define_mesh_files(module);
  python::define_curved(module);
  python::define_proofs(module);
  python::define_judging(module);
  python::define_fuzzing(module);
  python::define_step_fuzzing(module);
#ifdef TOUCHSTONE_PYTHON_WITH_PAGES
  python::define_pages(module);
  python::define_mesh_pages(module);
#else
  for (const char* name : {"page", "claims_page", "mesh_page"}) module.attr(name) = pybind11::none();
#endif
  python::shorten_messages(module);
}
