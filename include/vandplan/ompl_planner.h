// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does OMPL run the planners of this library?

#include <ompl/base/Planner.h>
#include <ompl/base/ScopedState.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/planner.h"

namespace vandplan::ompl {

/// One of our planners, or yours, as a planner of OMPL.
///
/// The space is a Reeds-Shepp space, and the validity checker ours: it says in which world and for
/// which vehicle one plans. Start and goal are those of the problem definition; with several, the
/// first valid ones. The margin is that of the validity checker. The planner ends when the
/// termination condition holds, which is asked about every millisecond from a thread of its own, or
/// when `options.budget` is spent. Every call of `solve` begins anew.
class Planner : public ::ompl::base::Planner {
 public:
  /// The planner of that name, with its defaults, planning by length. Throws InputError for an
  /// unknown name.
  explicit Planner(const ::ompl::base::SpaceInformationPtr& si,
                   const std::string& name = "anytime");
  /// A planner with options. Where the cost is not the length, OMPL still compares lengths. Throws
  /// InputError for options that it does not honour, or a steering other than `reeds_shepp`.
  Planner(const ::ompl::base::SpaceInformationPtr& si, vandplan::Planner planner,
          const PlanOptions& options);
  ~Planner() override;

  /// Throws ompl::Exception if space or validity checker will not do.
  void setup() override;
  ::ompl::base::PlannerStatus solve(const ::ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;
  /// The search tree, if the planner was asked to keep it (`keep_tree`); else the path.
  void getPlannerData(::ompl::base::PlannerData& data) const override;

  /// What the last call of `solve` brought: the exact path among other things.
  [[nodiscard]] const std::optional<PlanResult>& result() const noexcept { return result_; }

 private:
  void declare_options();
  void keep_nodes(const std::vector<Pose>& path);
  ::ompl::base::PlannerStatus report(const Problem& problem);

  vandplan::Planner planner_;
  PlanOptions options_;
  std::optional<PlanResult> result_ = {};
  std::vector<::ompl::base::ScopedState<>> nodes_ = {};  // for `getPlannerData`
  std::vector<std::int32_t> parents_ = {};
};

/// Poses from the start of a path to its end so that the shortest paths from each to the next are
/// the path itself, one after the other: arcs are cut into quarter turns. Segments are arcs and
/// lines.
[[nodiscard]] std::vector<Pose> way_points(const Path& path);

}  // namespace vandplan::ompl
