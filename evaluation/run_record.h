// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is known of a finished run, and where was it made?

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

/// This program on this machine.
[[nodiscard]] Environment this_environment();

/// The time now in UTC, "2026-11-21T05:16:33Z".
[[nodiscard]] std::string utc_now();

/// Options that many runs have in common, all but the seed: of a million runs that differ in their
/// seeds only there is one copy.
class SharedOptions {
 public:
  SharedOptions() : SharedOptions(PlanOptions{}) {}
  // NOLINTNEXTLINE(google-explicit-constructor): a value that is kept in another way
  SharedOptions(PlanOptions options)
      : options_(std::make_shared<const PlanOptions>(std::move(options))) {}

  const PlanOptions& operator*() const noexcept { return *options_; }
  const PlanOptions* operator->() const noexcept { return options_.get(); }
  /// Changes these and no other run's.
  template <class Change>
  void change(Change change) {
    PlanOptions changed = *options_;
    change(changed);
    options_ = std::make_shared<const PlanOptions>(std::move(changed));
  }
  /// The same for all who have the same copy.
  [[nodiscard]] const void* identity() const noexcept { return options_.get(); }
  bool operator==(const SharedOptions& other) const { return *options_ == *other.options_; }

 private:
  std::shared_ptr<const PlanOptions> options_;
};

/// A finished run.
struct RunRecord {
  std::size_t environment = 0;  ///< index in the store
  std::size_t scenario = 0;     ///< index in the store
  std::size_t goal = 0;         ///< of the scenario
  std::string planner;
  Region region = Region::bounds;  ///< in whose comparison the run takes part
  SharedOptions options;           ///< that were in force, but for the seed
  std::uint64_t seed = 1;
  int jobs = 1;         ///< how many runs went on at once
  std::string started;  ///< `utc_now`
  PlanResult result;    ///< without tree and the judge's figures
};

/// Whether a run measured where its time went, which slows it down.
[[nodiscard]] bool is_profiled(const RunRecord& run);

/// What one call of the program did, and what it cost beside the runs themselves.
struct Session {
  std::size_t environment = 0;  ///< index in the store
  std::string started;          ///< `utc_now`
  int jobs = 1;
  int runs = 0;
  double wall_time = 0.0;      ///< from the first run to the last [s]
  double planning_time = 0.0;  ///< in the planners, all jobs together [s]
  double judging_time = 0.0;   ///< in the judge, all jobs together [s]
  double storing_time = 0.0;   ///< writing to the store [s]
  bool operator==(const Session&) const = default;
};

}  // namespace vandplan::evaluation
