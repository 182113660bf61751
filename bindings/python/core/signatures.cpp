// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do docstrings get signatures in the form that `inspect.signature` reads?
//
// A docstring "plan(scenario, *, seed=1) -> Result\n\nText" becomes "plan(scenario, *,
// seed=1)\n--\n\n-> Result\n\nText". Python removes the first part from `__doc__` and parses it.
// For classes the signature belongs to `__init__`.

#include <cstdlib>
#include <cstring>
#include <string>
#include <string_view>

#include "bindings/python/core/bind.h"

namespace vandplan::python {
namespace {

namespace py = pybind11;

/// Parts of a docstring.
struct Docstring {
  std::string arguments = {};  ///< "(scenario, *, seed=1)" on one line; empty if there are none.
  std::string returned = {};   ///< "Result"; empty if there is none.
  std::string text = {};
};

/// Position after the bracket that closes the first one; npos if it is not closed.
std::size_t end_of_brackets(std::string_view text) {
  int open = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '(' || text[i] == '[' || text[i] == '{') ++open;
    if (text[i] == ')' || text[i] == ']' || text[i] == '}') --open;
    if (open == 0) return i + 1;
  }
  return std::string_view::npos;
}

/// Text with line breaks and indentation replaced by single spaces.
std::string one_line(std::string_view text) {
  std::string line;
  for (const char c : text) {
    const bool is_gap = c == '\n' || c == ' ';
    if (!is_gap || (!line.empty() && line.back() != ' ')) line += is_gap ? ' ' : c;
  }
  return line;
}

Docstring parts_of(std::string_view doc, std::string_view name) {
  if (!doc.starts_with(name) || doc.substr(name.size(), 1) != "(") return {};
  const std::string_view rest = doc.substr(name.size());
  const std::size_t end = end_of_brackets(rest);
  if (end == std::string_view::npos) return {};
  Docstring parts{.arguments = one_line(rest.substr(0, end))};
  const std::size_t text = rest.find("\n\n", end);
  const std::string_view after = rest.substr(end, text - end);
  if (after.starts_with(" -> ")) parts.returned = one_line(after.substr(4));
  if (text != std::string_view::npos) parts.text = rest.substr(text + 2);
  return parts;
}

std::string signed_text(const std::string& name, const Docstring& parts, bool is_method) {
  std::string arguments = parts.arguments;
  if (is_method) arguments.insert(1, arguments == "()" ? "self" : "self, ");
  std::string doc = name + arguments + "\n--\n\n";
  if (!parts.returned.empty()) doc += "-> " + parts.returned + "\n\n";
  return doc + parts.text;
}

/// C function behind a Python function or method; null if there is none.
PyMethodDef* definition_of(py::handle function) {
  if (PyInstanceMethod_Check(function.ptr()) != 0) {
    function = PyInstanceMethod_GET_FUNCTION(function.ptr());
  }
  if (PyCFunction_Check(function.ptr()) == 0) return nullptr;
  return reinterpret_cast<PyCFunctionObject*>(function.ptr())->m_ml;
}

/// Replaces a docstring. pybind11 frees docstrings with `free`.
void replace_doc(PyMethodDef& definition, const std::string& doc) {
  std::free(const_cast<char*>(definition.ml_doc));
  definition.ml_doc = strdup(doc.c_str());
}

void sign(const std::string& name, const py::handle& function, bool is_method) {
  PyMethodDef* const definition = definition_of(function);
  if (definition == nullptr || definition->ml_doc == nullptr) return;
  const Docstring parts = parts_of(definition->ml_doc, name);
  if (!parts.arguments.empty()) replace_doc(*definition, signed_text(name, parts, is_method));
}

/// Signs the methods of a class, and `__init__` with the head of the class's docstring.
void sign_class(const std::string& name, const py::handle& type) {
  const auto members = py::dict(type.attr("__dict__"));
  auto* const static_type = reinterpret_cast<PyObject*>(&PyStaticMethod_Type);
  for (const auto& [key, member] : members) {
    const bool is_static = PyObject_IsInstance(member.ptr(), static_type) == 1;
    const py::object function =
        is_static ? member.attr("__func__") : py::reinterpret_borrow<py::object>(member);
    sign(py::str(key), function, !is_static);
  }
  if (!members.contains("__init__") || type.attr("__doc__").is_none()) return;
  const Docstring parts = parts_of(std::string(py::str(type.attr("__doc__"))), name);
  PyMethodDef* const definition = definition_of(members["__init__"]);
  if (definition == nullptr || parts.arguments.empty()) return;
  replace_doc(*definition, signed_text("__init__", {.arguments = parts.arguments}, true));
}

}  // namespace

void sign_all(py::module_& module) {
  for (const auto& [key, value] : py::dict(module.attr("__dict__"))) {
    const std::string name = py::str(key);
    if (PyType_Check(value.ptr()) != 0) {
      sign_class(name, value);
    } else {
      sign(name, value, false);
    }
  }
}

}  // namespace vandplan::python
