// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// The module vandplan._core: everything of the package vandplan that is in C++.

#include <pybind11/pybind11.h>

#include "bindings/python/core/bind.h"
#include "vandplan/input_error.h"
#include "vandplan/version.h"

namespace vandplan::python {
namespace {

namespace py = pybind11;

/// Python class of InputError; lives as long as the module.
PyObject* input_error_type = nullptr;

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const InputError& error) {
    const py::object type = py::reinterpret_borrow<py::object>(input_error_type);
    py::object raised = type(error.what());
    raised.attr("where") = error.where();
    raised.attr("problem") = error.problem();
    PyErr_SetObject(input_error_type, raised.ptr());
  } catch (const py::cast_error&) {
    PyErr_SetString(PyExc_TypeError, "a value has a type that is of no use here");
  }
}

}  // namespace

void bind_errors(py::module_& module) {
  input_error_type = PyErr_NewExceptionWithDoc(
      "vandplan.InputError",
      "Wrong input, a ValueError. `where` names the place of the fault, `problem` says what is "
      "wrong\n"
      "there and what was expected. The message is that of the command line.",
      PyExc_ValueError, nullptr);
  module.add_object("InputError", input_error_type);
  py::register_exception_translator(&translate);
}

}  // namespace vandplan::python

PYBIND11_MODULE(_core, module) {
  namespace own = vandplan::python;
  pybind11::options options;
  options.disable_function_signatures();  // The docstrings have readable signatures.
  module.doc() = "The part of vandplan that is written in C++.";
  own::bind_errors(module);
  own::bind_path(module);
  own::bind_vehicle(module);
  own::bind_grid(module);
  own::bind_goal(module);
  own::bind_zone(module);
  own::bind_mask(module);
  own::bind_scenario(module);
  own::bind_lengths(module);
  own::bind_own_planner(module);
  own::bind_moving(module);
  own::bind_check(module);
  own::bind_result(module);
  own::bind_planning(module);
  own::bind_site(module);
  own::bind_speed(module);
  own::bind_driving(module);
  own::bind_replan(module);
  own::bind_live(module);
  own::bind_evaluation(module);
  own::bind_protocols(module);
  own::sign_all(module);
  const vandplan::BuildInfo build = vandplan::build_info();
  module.attr("__version__") = build.version;
}
