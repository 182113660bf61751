// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which table of the site holds for the ground as it is now?

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "replanning/deadline.h"
#include "replanning/known_ground.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/replanner.h"
#include "vandplan/site_table.h"

namespace vandplan::replanning {

/// A table of the site that follows patches. It has a world of its own, in the table's frame: a
/// replanner's world has another origin.
class KnownSite {
 public:
  /// The options are complete. Throws InputError naming "site" if the table was made for another
  /// vehicle or other prices.
  KnownSite(std::shared_ptr<ChangingSiteTable> table, const Scenario& scenario,
            const PlanOptions& options);

  /// Applies a patch that the replanner's ground has taken.
  void patch(const WorldPatch& patch) { ground_.patch(patch); }

  /// The table of ways to the goals of a problem, past vias or not, as `local` has it in its frame.
  /// It is repaired first, until `end`. Null if it is left aside; `reason` then says why.
  [[nodiscard]] std::shared_ptr<const SiteTable> to_goals_of(const Problem& problem, bool has_vias,
                                                             const KnownGround& local,
                                                             const Deadline& end);

  /// Why the table was left aside; empty if it was not.
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

 private:
  [[nodiscard]] std::vector<std::size_t> goals_of(const Problem& problem, bool has_vias) const;
  [[nodiscard]] bool is_repaired(const std::vector<std::size_t>& goals, const Deadline& end);

  std::shared_ptr<ChangingSiteTable> table_;
  Vehicle vehicle_;
  Pose start_;
  PlanOptions options_;
  KnownGround ground_;                      // in the table's frame
  std::shared_ptr<const SiteTable> local_;  // the last answer, for these goals and this version
  std::vector<std::size_t> goals_;
  std::int64_t version_ = 0;
  std::string reason_;
};

}  // namespace vandplan::replanning
