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
/// The space must be a Reeds-Shepp space, and the validity checker ours: it gives the world, the
/// vehicle and the margin. Start and goal are those of the problem definition; with several, the
/// first valid ones. Every call of `solve` begins anew.
///
/// The planner ends when `options.budget` is spent or the termination condition holds. A thread of
/// its own asks the condition about every millisecond.
class Planner : public ::ompl::base::Planner {
 public:
  /// The planner of that name, with its defaults, planning by length. Throws InputError naming
  /// "planner" for an unknown name.
  explicit Planner(const ::ompl::base::SpaceInformationPtr& si,
                   const std::string& name = "anytime");
  /// A planner with options. If the cost is not the length, OMPL still compares lengths. Throws
  /// InputError naming an option that the planner does not honour, or "steering" for a steering
  /// other than `reeds_shepp`.
  Planner(const ::ompl::base::SpaceInformationPtr& si, vandplan::Planner planner,
          const PlanOptions& options);
  ~Planner() override;

  /// Checks space and validity checker. Throws ompl::Exception if they do not fit.
  void setup() override;
  ::ompl::base::PlannerStatus solve(const ::ompl::base::PlannerTerminationCondition& ptc) override;
  void clear() override;
  /// Gives the search tree, if the planner was asked to keep it (`keep_tree`), or the path.
  void getPlannerData(::ompl::base::PlannerData& data) const override;

  /// Result of the last call of `solve`, which has the exact path, in the frame of the states.
  [[nodiscard]] const std::optional<PlanResult>& result() const noexcept { return result_; }

 private:
  void declare_options();
  void keep_nodes(const std::vector<Pose>& path);
  ::ompl::base::PlannerStatus report(const Problem& problem);

  vandplan::Planner planner_;
  PlanOptions options_;
  std::optional<PlanResult> result_ = {};
  std::vector<::ompl::base::ScopedState<>> nodes_ = {};  // nodes of `getPlannerData`
  std::vector<std::int32_t> parents_ = {};
};

/// Poses from the start of a path to its end, in its frame. The shortest paths from each pose to
/// the next are the path itself: arcs are cut into quarter turns. The segments must be arcs and
/// lines.
[[nodiscard]] std::vector<Pose> way_points(const Path& path);

}  // namespace vandplan::ompl
