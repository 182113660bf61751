// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Plans by a probabilistic roadmap that is kept with the world for whoever plans there next.

#include "vandplan/planner.h"

namespace vandplan::prm {

/// Name, properties, options and function: docs/algorithms/prm.md.
[[nodiscard]] Planner planner();

}  // namespace vandplan::prm
