// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a campaign run?

#include <atomic>
#include <functional>

#include "evaluation/campaign.h"
#include "evaluation/store.h"

namespace vandplan {

/// How far a campaign is.
struct Progress {
  int total = 0;                    ///< runs of the campaign
  int kept = 0;                     ///< of these, found in the store
  int done = 0;                     ///< run now
  double elapsed = 0.0;             ///< since the first run began [s]
  const RunRecord* last = nullptr;  ///< the run just finished, or none

  /// Expected time to the end [s].
  [[nodiscard]] double left() const noexcept;
};

struct RunnerOptions {
  int jobs = 1;                             ///< runs at once, each on one thread; >= 1
  const std::atomic<bool>* stop = nullptr;  ///< ends the campaign; runs in flight are dropped
  /// Called after every run and now and then, on the thread of the caller; or none.
  std::function<void(const Progress&)> report = {};
};

/// Does what the store does not yet hold of a campaign, each finished run stored at once, and
/// returns how far it came. Throws InputError when an input is no good or when more jobs than
/// cores would compete for a time budget.
Progress run_campaign(const Campaign& campaign, Store& store, const RunnerOptions& options);

}  // namespace vandplan
