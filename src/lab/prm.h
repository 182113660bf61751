// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Plans by a probabilistic roadmap, which is kept with the world for later queries.

#include "vandplan/planner.h"

namespace vandplan::prm {

/// The planner "prm". Method: docs/algorithms/prm.md.
[[nodiscard]] Planner planner();

}  // namespace vandplan::prm
