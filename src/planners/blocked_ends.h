// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Is a moving obstacle where the vehicle begins, or does one stay where the vehicle has to stay?

#include <string>

#include "vandplan/problem.h"

namespace vandplan::in_time {

/// Which moving obstacle makes every drive impossible because it blocks the start or the goal;
/// empty: none does.
[[nodiscard]] std::string proof_of_none(const Task& task, double margin);

}  // namespace vandplan::in_time
