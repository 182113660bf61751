// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a test of every planner named?

#include <gtest/gtest.h>

#include <algorithm>
#include <ostream>
#include <string>

#include "vandplan/planner.h"

namespace vandplan {

/// What a test that fails prints of its planner.
inline void PrintTo(const Planner& planner, std::ostream* out) { *out << planner.name; }

/// The planner's name as a test may have it.
inline std::string name_of_test(const testing::TestParamInfo<Planner>& planner) {
  std::string name = planner.param.name;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
}

}  // namespace vandplan
