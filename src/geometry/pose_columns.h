// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Do columns of poses have as many numbers as results are wanted?

#include <string>

#include "vandplan/geometry.h"
#include "vandplan/input_error.h"

namespace vandplan::geometry {

/// Throws an InputError that names "nodes", unless every column has `size` numbers.
inline void expect_columns(const PoseColumns& columns, std::size_t size) {
  if (columns.x.size() == size && columns.y.size() == size && columns.heading.size() == size) {
    return;
  }
  throw InputError("nodes", "have not as many numbers in each column as there are results, " +
                                std::to_string(size));
}

}  // namespace vandplan::geometry
