// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do simulated drives with and without replanning share in Python?

#include <pybind11/numpy.h>
#include <pybind11/stl.h>

#include <string>
#include <vector>

#include "vandplan/drive.h"
#include "vandplan/input_error.h"

namespace vandplan::python {

/// Moves a keyword from `keywords` to `value`, if it is there; None keeps the default. Throws
/// InputError naming the keyword if its type is wrong.
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

/// Throws InputError naming a keyword that is left over.
void expect_nothing_left(const pybind11::dict& keywords);

/// Log of a drive as columns for users: a dict of arrays.
[[nodiscard]] pybind11::dict log_columns(const std::vector<DriveMoment>& log);
/// Log of a drive as a table for pickle, with a row for each moment.
[[nodiscard]] pybind11::array_t<double> log_table(const std::vector<DriveMoment>& log);
/// Log of a drive from a table that `log_table` made.
[[nodiscard]] std::vector<DriveMoment> log_from(const pybind11::handle& table);

}  // namespace vandplan::python
