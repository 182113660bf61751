// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do names that were replaced keep working for one version?

#include <pybind11/pybind11.h>

#include <optional>
#include <string>

namespace vandplan::python {

/// Warns that an old name was used: a DeprecationWarning.
inline void warn_of_old_name(const std::string& old_name, const std::string& name) {
  const std::string text = old_name + " is deprecated, write " + name;
  if (PyErr_WarnEx(PyExc_DeprecationWarning, text.c_str(), 1) != 0) {
    throw pybind11::error_already_set();
  }
}

/// Value of a keyword, or the one that was given by its old name.
template <typename Value>
[[nodiscard]] std::optional<Value> renamed(const char* name, std::optional<Value> value,
                                           const char* old_name,
                                           const std::optional<Value>& old_value) {
  if (!old_value) return value;
  warn_of_old_name(old_name, name);
  return value ? value : old_value;
}

/// Adds a property by its old name.
template <typename Class, typename Get>
void add_old_property(Class& bound, const char* old_name, const char* name, Get get) {
  using Self = typename Class::type;
  const auto warned = [=](const Self& self) {
    warn_of_old_name(old_name, name);
    return get(self);
  };
  const std::string about = std::string("Old name of `") + name + "`.";
  bound.def_property_readonly(old_name, warned, about.c_str());
}

/// Adds a method with one argument by its old name. `signature` is what follows the name in help,
/// such as "(t) -> float".
template <typename Class, typename Result, typename Value, typename... Default>
void add_old_method(Class& bound, const char* old_name, const char* name, const char* signature,
                    Result (*call)(const typename Class::type&, Value),
                    const Default&... argument) {
  const auto warned = [=](const typename Class::type& self, Value value) {
    warn_of_old_name(old_name, name);
    return call(self, value);
  };
  const std::string about = std::string(old_name) + signature + "\n\nOld name of `" + name + "`.";
  bound.def(old_name, warned, argument..., about.c_str());
}

}  // namespace vandplan::python
