// SPDX-License-Identifier: MIT
// The compiled half of the Python module: its parts, and how the library's exceptions become
// Python's.
#include "bindings.h"
#include "call_ledger.h"
#include "moivre/expression/source.h"
#include "moivre/report/version.h"

namespace moivre::python {
namespace {

namespace py = pybind11;

// pybind11's translators are plain functions, without a place for it.
py::handle parse_error_type;

py::list faults_of(const ParseError& error) {
  py::list faults;
  for (const Diagnostic& fault : error.diagnostics()) {
    faults.append(py::make_tuple(fault.at.line, fault.at.column, fault.message));
  }
  return faults;
}

/// moivre.ParseError is Python's own (python/moivre/_errors.py), so that it can be pickled and
/// documented there.
void translate(std::exception_ptr raised) {
  try {
    if (raised) std::rethrow_exception(raised);
  } catch (const ParseError& error) {
    const py::object made = parse_error_type(error.what(), faults_of(error));
    PyErr_SetObject(parse_error_type.ptr(), made.ptr());
  }
}

}  // namespace
}  // namespace moivre::python

PYBIND11_MODULE(_moivre, module) {
  using namespace moivre::python;
  module.attr("__version__") = std::string(moivre::version());
  const pybind11::object errors = pybind11::module_::import("moivre._errors");
  parse_error_type = errors.attr("ParseError").cast<pybind11::object>().release();
  pybind11::register_exception_translator(translate);
  bind_ledgers(module);
  bind_systems(module);
  bind_families(module);
  bind_mechanisms(module);
  bind_arms(module);
}
