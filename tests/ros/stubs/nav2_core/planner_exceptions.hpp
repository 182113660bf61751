// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Stand-in for Nav2: the names that our plugins use.

#include <stdexcept>

namespace nav2_core {
struct PlannerException : std::runtime_error {
  using runtime_error::runtime_error;
};
struct StartOccupied : PlannerException {
  using PlannerException::PlannerException;
};
struct GoalOccupied : PlannerException {
  using PlannerException::PlannerException;
};
struct StartOutsideMapBounds : PlannerException {
  using PlannerException::PlannerException;
};
struct GoalOutsideMapBounds : PlannerException {
  using PlannerException::PlannerException;
};
struct NoValidPathCouldBeFound : PlannerException {
  using PlannerException::PlannerException;
};
struct PlannerTimedOut : PlannerException {
  using PlannerException::PlannerException;
};
struct PlannerTFError : PlannerException {
  using PlannerException::PlannerException;
};
struct PlannerCancelled : PlannerException {
  using PlannerException::PlannerException;
};
}  // namespace nav2_core
