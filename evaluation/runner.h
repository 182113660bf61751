// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the runs of a campaign carried out and stored?

#include "evaluation/campaign.h"
#include "evaluation/store.h"

namespace vandplan::evaluation {

/// Carries out all runs of a campaign that the store does not hold, and stores each at once.
/// Returns the progress. Throws InputError for bad input, or when more jobs than cores would
/// compete for a time budget. Exceptions of planners pass through.
Progress run_campaign(const Campaign& campaign, Store& store, const RunnerOptions& options);

}  // namespace vandplan::evaluation
