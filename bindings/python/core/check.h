// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does Python see the judge's verdict?

#include <optional>
#include <string>

#include "vandplan/judge.h"
#include "vandplan/planner.h"

namespace vandplan::python {

/// Verdict of the judge on a path and, among moving obstacles, on its times; `PathCheck` in Python.
/// `valid`, `reason` and `at` cover both.
struct Verdict : PathCheck {
  std::optional<DriveCheck> drive = {};
  std::string times = {};  ///< "planned" or "fastest"; empty without moving obstacles.
};

/// Verdict on a planned path; empty if the judge was not called.
[[nodiscard]] std::optional<Verdict> verdict_of(const PlanResult& result);

}  // namespace vandplan::python
