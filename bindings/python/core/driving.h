// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do drives among others share with those alone, in Python?

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "vandplan/drive.h"
#include "vandplan/input_error.h"

namespace vandplan::python {

/// Takes a keyword out of those that are left, if it is there; None leaves the default. Throws
/// InputError naming it when it is of another type.
template <typename Value>
void take(pybind11::dict& keywords, const char* name, Value& value) {
  if (!keywords.contains(name)) return;
  const pybind11::object given = keywords.attr("pop")(name);
  if (given.is_none()) return;
  try {
    value = given.cast<Value>();
  } catch (const pybind11::cast_error&) {
    throw InputError(name,
                     "is " + std::string(pybind11::repr(given)) + ", which is of no use here");
  }
}

void take_drive_options(pybind11::dict& keywords, DriveOptions& options);

/// Throws InputError naming a keyword that nobody took.
void expect_nothing_left(const pybind11::dict& keywords);

/// A log as columns for users, and as a table for pickle.
[[nodiscard]] pybind11::dict log_columns(const std::vector<DriveMoment>& log);
[[nodiscard]] pybind11::array_t<double> log_table(const std::vector<DriveMoment>& log);
[[nodiscard]] std::vector<DriveMoment> log_from(const pybind11::handle& table);

}  // namespace vandplan::python
