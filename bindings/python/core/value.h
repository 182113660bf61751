// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a struct become a Python class that can be read, copied and pickled?

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <functional>
#include <utility>
#include <vector>

#include "vandplan/input_error.h"

namespace vandplan::python {

/// Python class with immutable values. Pickling and copying use the parts that are named here.
template <typename T>
class ValueClass {
 public:
  template <typename... Extra>
  ValueClass(pybind11::module_& module, const char* name, const Extra&... about)
      : bound_(module, name, about...) {}

  /// Adds a readable member, which is also a part for pickle.
  template <typename Member, typename Base>
  ValueClass& field(const char* name, Member Base::*member, const char* about) {
    bound_.def_property_readonly(
        name, [member](const T& self) { return self.*member; }, about);
    return part(member);
  }

  /// Adds a member as a part for pickle only.
  template <typename Member, typename Base>
  ValueClass& part(Member Base::*member) {
    return part(
        [member](const T& self) { return pybind11::cast(self.*member); },
        [member](T& self, const pybind11::handle& value) { self.*member = value.cast<Member>(); });
  }

  ValueClass& part(std::function<pybind11::object(const T&)> get,
                   std::function<void(T&, const pybind11::handle&)> set) {
    parts_.push_back({std::move(get), std::move(set)});
    return *this;
  }

  /// Finishes the list of parts. Other methods may be added to the returned class.
  pybind11::class_<T>& pickled() {
    const auto state_of = [parts = parts_](const T& self) {
      pybind11::tuple state(parts.size());
      for (std::size_t i = 0; i < parts.size(); ++i) state[i] = parts[i].get(self);
      return state;
    };
    const auto from = [parts = parts_](const pybind11::tuple& state) {
      if (state.size() != parts.size()) {
        throw InputError("pickle", "is of another version of vandplan");
      }
      T self;
      for (std::size_t i = 0; i < parts.size(); ++i) parts[i].set(self, state[i]);
      return self;
    };
    bound_.def(pybind11::pickle(state_of, from));
    return bound_;
  }

 private:
  struct Part {
    std::function<pybind11::object(const T&)> get;
    std::function<void(T&, const pybind11::handle&)> set;
  };
  pybind11::class_<T> bound_;
  std::vector<Part> parts_;
};

}  // namespace vandplan::python
