#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <chrono>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "gvd/error.hpp"
#include "gvd/names.hpp"
#include "gvd/progress.hpp"

// How Python calls the library: without the interpreter's lock, and with names in place of enumerators.
namespace gvd::python {

namespace py = pybind11;

/// Runs `work(progress)` without the interpreter's lock, so that other Python threads go on.
///
/// `callback`: None, or a function of the step's name and the fraction done; it cancels by returning False. It is
/// called at the first report and then ten times a second at most, and Ctrl-C is looked for as often: both need the
/// lock. An exception of the callback, KeyboardInterrupt included, ends the work and is raised again.
template <class Work>
auto run_unlocked(const py::object& callback, Work&& work) {
  using Clock = std::chrono::steady_clock;
  constexpr std::chrono::milliseconds kInterval(100);
  Clock::time_point next = Clock::now();
  bool raised = false;
  const Progress progress = [&](std::string_view step, double fraction) {
    if (raised) return false;
    if (Clock::now() < next) return true;
    next = Clock::now() + kInterval;
    const py::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0) return !(raised = true);
    if (callback.is_none()) return true;
    PyObject* const answer = PyObject_CallFunction(callback.ptr(), "sd", std::string(step).c_str(), fraction);
    if (answer == nullptr) return !(raised = true);
    const int is_false = PyObject_RichCompareBool(answer, Py_False, Py_EQ);  // NumPy has a False of its own
    Py_DECREF(answer);
    if (is_false < 0) return !(raised = true);
    return is_false == 0;
  };
  try {
    const py::gil_scoped_release unlocked;
    return std::forward<Work>(work)(progress);
  } catch (const Error&) {
    if (raised) throw py::error_already_set();
    throw;
  }
}

/// The value that `name` stands for. Throws Error{invalid_option} that names the option and lists the names.
template <class T>
T choose(std::string_view option, const std::string& name, const Choices<T>& choices) {
  if (const std::optional<T> value = value_in(choices, name)) return *value;
  throw Error(ErrorCode::invalid_option,
              fmt::format("{}: '{}' is none of {}", option, name, fmt::join(names_in(choices), ", ")));
}

}  // namespace gvd::python
