// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Random trees that grow where paths are good: hRRT, IkRRT and BkRRT (Urmson & Simmons 2003).
// Theory and pseudo-code: docs/algorithms/hrrt.md.

#include "vandplan/planner.h"

namespace vandplan::hrrt {

/// Nodes near a sample whose quality is tested.
enum class Selection {
  nearest,     ///< hRRT: the nearest node alone
  first_of_k,  ///< IkRRT: the k nearest nodes, one by one, until one passes
  best_of_k    ///< BkRRT: the best of the k nearest nodes alone
};

/// The planner "hrrt", "ikrrt" or "bkrrt", by the selection.
[[nodiscard]] Planner planner(Selection selection);

}  // namespace vandplan::hrrt
