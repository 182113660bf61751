// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a campaign run?

#include "evaluation/campaign.h"
#include "evaluation/store.h"

namespace vandplan::evaluation {

/// Does what the store does not yet hold of a campaign, each finished run stored at once, and
/// returns how far it came. Throws InputError when an input is no good or when more jobs than
/// cores would compete for a time budget; and what a planner throws.
Progress run_campaign(const Campaign& campaign, Store& store, const RunnerOptions& options);

}  // namespace vandplan::evaluation
