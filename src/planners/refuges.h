// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where beside its path can the vehicle wait while an obstacle passes?
//
// A refuge is a pose where the vehicle waits while an obstacle goes by: docs/algorithms/moving.md.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "planners/path_search.h"
#include "vandplan/path.h"
#include "vandplan/plan_options.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan::in_time {

/// A refuge, and paths to it and on to the goal.
struct Detour {
  LocalPose refuge;
  std::vector<Segment> there = {};   ///< path from the start to the refuge; empty with a trailer
  std::vector<Segment> onward = {};  ///< path from the refuge to the goal; empty with a trailer
};

/// Draws random refuges beside paths.
class Refuges {
 public:
  /// Detours are made of words that are cheapest by `rule`. The task outlives the object.
  Refuges(const Task& task, const search::CostRule& rule, const PlanOptions& options);

  /// The shortest detour via a few random poses beside the path, where obstacle `passing` can go
  /// by. It leaves the path before the pose and comes back behind it. None if no pose will do.
  [[nodiscard]] std::optional<Detour> draw(const Path& path, std::size_t passing);
  /// A path along a detour without crumbs, which stay where its parts are joined. With a trailer
  /// the path stays as it is.
  [[nodiscard]] std::vector<Segment> tidied(std::vector<Segment> path);
  /// Iterations so far: tries to leave the path or to come back to it.
  [[nodiscard]] std::int64_t iterations() const { return draws_ + connector_.solves(); }

 private:
  [[nodiscard]] LocalPose pose_beside(const LocalPose& on_path);
  [[nodiscard]] bool lets_pass(const LocalPose& pose, std::size_t passing) const;
  [[nodiscard]] std::optional<Detour> detour(const Path& path, double s, const LocalPose& refuge);
  [[nodiscard]] std::optional<std::vector<Segment>> way_there(const Path& path, double s,
                                                              const LocalPose& refuge);
  [[nodiscard]] std::optional<std::vector<Segment>> way_onward(const Path& path, double s,
                                                               const LocalPose& refuge);

  const Task& task_;
  search::Connector connector_;
  double margin_;
  Rng rng_;
  std::int64_t draws_ = 0;
};

/// Makes a search for a path; it begins with a known path if that is not empty.
using SearchMaker =
    std::function<std::unique_ptr<planning::PathSearch>(const Task&, const Path& known)>;

/// A search for paths along a detour.
[[nodiscard]] std::unique_ptr<planning::PathSearch> search_through(const Task& task,
                                                                   const Detour& detour,
                                                                   SearchMaker make_search);

}  // namespace vandplan::in_time
