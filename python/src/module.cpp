// The module _gvd: the library as the Python package needs it. The classes and functions that users meet are in
// python/gvd, with their documents and checks of arguments; nothing here is meant to be called by others.
#include <string>
#include <string_view>

#include "bindings.hpp"
#include "gvd/error.hpp"
#include "gvd/placeholders.hpp"
#include "gvd/version.hpp"

namespace gvd::python {

std::string spell_argument(std::string_view name, std::string_view value) {
  std::string spelled(name);
  if (value.empty()) return spelled;
  if (value == "true") return spelled + "=True";
  if (value == "false") return "no_" + spelled + "=True";
  return spelled + "='" + std::string(value) + '\'';
}

namespace {

/// Raises the library's errors as gvd.Error. The package loads this module, so its class is looked up when needed.
void translate_error(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const Error& error) {
    const py::object type = py::module_::import("gvd._error").attr("Error");
    // Names of files need not be UTF-8; Python keeps such bytes as it does in its own names of files.
    const std::string text = spell_options(error.text(), {spell_argument});
    const auto message = py::reinterpret_steal<py::object>(
        PyUnicode_DecodeUTF8(text.data(), py::ssize_t(text.size()), "surrogateescape"));
    const py::object raised = type(message, kErrorCodeNames[std::size_t(error.code())], error.element());
    PyErr_SetObject(type.ptr(), raised.ptr());
  }
}

}  // namespace
}  // namespace gvd::python

PYBIND11_MODULE(_gvd, module) {
  using namespace gvd::python;
  py::register_local_exception_translator(&translate_error);
  module.attr("version") = gvd::version();
  bind_diagram(module);  // first: the others take its options
  bind_mesh(module);
  bind_curves(module);
  bind_distances(module);
  bind_remesh(module);
}
