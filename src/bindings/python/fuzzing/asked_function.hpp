// A Python function that a fuzzer asks.
// SPDX-License-Identifier: MIT
#pragma once

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>

#include <atomic>
#include <exception>
#include <stdexcept>
#include <string>

namespace touchstone::python {

namespace py = pybind11;

/// The function under test.
class AskedFunction {
 public:
  /// @param stop  becomes true when the function ends the run
  AskedFunction(const py::object& solver, std::atomic<bool>& stop) : solver_(solver), stop_(stop) {}

  /// The result of call(function), under the lock. What that throws becomes an exception that holds nothing of Python:
  /// of a finding it is the text. What is no `Exception`, such as KeyboardInterrupt, ends the run, and so does one that
  /// all of the first calls end with.
  template <class Call>
  auto ask(const Call& call) {
    if (ending_) throw std::runtime_error("the run has ended");
    const py::gil_scoped_acquire locked;
    try {
      try {
        const auto reply = call(solver_);
        answered_ = true;
        return reply;
      } catch (const py::builtin_exception& error) {  // of the words here about a reply
        error.set_error();
        throw py::error_already_set();
      }
    } catch (py::error_already_set& error) {
      if (!error.matches(PyExc_Exception) || fails_from_the_start(error.what())) {
        ending_ = std::current_exception();
        stop_ = true;
      }
      throw std::runtime_error(error.what());
    }
  }

  /// Throws what ended the run, if something did.
  void rethrow() const {
    if (ending_) std::rethrow_exception(ending_);
  }

 private:
  /// Whether there was no answer yet, and as many calls failed with one text that the function cannot be meant so: one
  /// with other arguments, say.
  bool fails_from_the_start(const std::string& text) {
    constexpr int kAlike = 20;
    if (answered_ || (failures_ > 0 && text != first_text_)) {
      answered_ = true;
      return false;
    }
    first_text_ = text;
    return ++failures_ == kAlike;
  }

  const py::object& solver_;
  std::atomic<bool>& stop_;
  std::exception_ptr ending_;
  bool answered_ = false;  ///< or failed in several ways
  int failures_ = 0;
  std::string first_text_;
};

inline bool is_bool(py::handle value) {
  return PyBool_Check(value.ptr()) || py::isinstance(value, py::module_::import("numpy").attr("bool_"));
}

/// A number of a reply. @param refuse  throws, for what is no number
template <class Refuse>
double reply_number(py::handle value, const Refuse& refuse) {
  if (is_bool(value) || py::isinstance<py::array>(value)) refuse();
  const double number = PyFloat_AsDouble(value.ptr());
  if (number == -1 && PyErr_Occurred() != nullptr) {
    if (PyErr_ExceptionMatches(PyExc_TypeError) == 0) throw py::error_already_set();
    PyErr_Clear();
    refuse();
  }
  return number;
}

/// @throws TypeError  for what cannot be called. @param arguments  what it must take: "kind, start, end"
inline void check_callable(const py::object& solver, const std::string& arguments) {
  if (PyCallable_Check(solver.ptr()) != 0) return;
  throw py::type_error(std::string("solver is of type ") + Py_TYPE(solver.ptr())->tp_name +
                       "; it must be a function of (" + arguments + ")");
}

}  // namespace touchstone::python
