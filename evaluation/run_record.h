// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is stored of a finished run, and of the environment that made it?

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>

#include "vandplan/plan_options.h"
#include "vandplan/planner.h"

namespace vandplan::evaluation {

/// Program and machine. Times of different environments are never compared.
struct Environment {
  std::string version;
  std::string compiler;
  std::string build_type;
  std::string executable;  ///< fingerprint of the program's file
  std::string processor;
  int cores = 0;
  std::string system;
  bool operator==(const Environment&) const = default;
};

/// Environment of this program on this machine.
[[nodiscard]] Environment this_environment();

/// Current time in UTC, such as "2026-11-21T05:16:33Z".
[[nodiscard]] std::string utc_now();

/// Options that many runs share, without the seed: a million runs that differ in their seeds alone
/// have one copy.
class SharedOptions {
 public:
  SharedOptions() : SharedOptions(PlanOptions{}) {}
  // NOLINTNEXTLINE(google-explicit-constructor): the class replaces a PlanOptions value
  SharedOptions(PlanOptions options)
      : options_(std::make_shared<const PlanOptions>(std::move(options))) {}

  const PlanOptions& operator*() const noexcept { return *options_; }
  const PlanOptions* operator->() const noexcept { return options_.get(); }
  /// Changes the options of this run alone; other runs keep the old copy.
  template <class Change>
  void change(Change change) {
    PlanOptions changed = *options_;
    change(changed);
    options_ = std::make_shared<const PlanOptions>(std::move(changed));
  }
  /// Address of the copy; it is equal for all runs that share the copy.
  [[nodiscard]] const void* identity() const noexcept { return options_.get(); }
  bool operator==(const SharedOptions& other) const { return *options_ == *other.options_; }

 private:
  std::shared_ptr<const PlanOptions> options_;
};

/// A finished run.
struct RunRecord {
  std::size_t environment = 0;  ///< index of the environment in the store
  std::size_t scenario = 0;     ///< index of the scenario in the store
  std::size_t goal = 0;         ///< index of the goal in the scenario
  std::string planner;
  Region region = Region::bounds;  ///< region in whose comparison the run takes part
  SharedOptions options;           ///< options of the run; the seed in them is ignored
  std::uint64_t seed = 1;
  int jobs = 1;         ///< number of runs that were carried out at once
  std::string started;  ///< start time, from `utc_now`
  PlanResult result;    ///< result without the tree and the judge's figures
};

/// Whether a run measured the times of its phases, which slows it down.
[[nodiscard]] bool is_profiled(const RunRecord& run);

/// Statistics of one call of the program: its runs, and the time spent on them and beside them.
struct Session {
  std::size_t environment = 0;  ///< index of the environment in the store
  std::string started;          ///< start time, from `utc_now`
  int jobs = 1;
  int runs = 0;
  double wall_time = 0.0;      ///< time from the first run to the last [s]
  double planning_time = 0.0;  ///< time in the planners, summed over all jobs [s]
  double judging_time = 0.0;   ///< time in the judge, summed over all jobs [s]
  double storing_time = 0.0;   ///< time of writing to the store [s]
  bool operator==(const Session&) const = default;
};

}  // namespace vandplan::evaluation
