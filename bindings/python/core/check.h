// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the judge say in Python?

#include <optional>
#include <string>

#include "vandplan/drive_check.h"
#include "vandplan/path_check.h"
#include "vandplan/planner.h"

namespace vandplan::python {

/// The judge's verdict on a path and, where something moves, on its times. Python calls it
/// PathCheck. `valid`, `reason` and `at` are those of both.
struct Verdict : PathCheck {
  std::optional<DriveCheck> drive = {};
  std::string times = {};  ///< "planned", "fastest", or empty where nothing moves
};

/// What the judge found of a path that was planned.
[[nodiscard]] std::optional<Verdict> verdict_of(const PlanResult& result);

}  // namespace vandplan::python
