// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does an error name?

#include <gtest/gtest.h>

#include <string>

#include "vandplan/input_error.h"

namespace vandplan {

/// Where the error that `action` throws says that something is wrong; "nothing" if it throws none.
template <typename Action>
std::string place_of_error(Action action) {
  try {
    action();
  } catch (const InputError& error) {
    EXPECT_NE(error.problem(), "");
    return error.where();
  }
  return "nothing";
}

}  // namespace vandplan
