// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I let the default planner use paths that I know of?
//
//   const auto result = vandplan::plan(problem, vandplan::with_sources({{"mine", make}}));
//
// A source proposes paths while the planner runs. The planner checks and shortens each, and
// compares it with the paths that it finds itself. Whatever a source proposes, the result has
// passed the judge.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/planner.h"

namespace vandplan {

/// A path in the frame of a task, which is the world's.
struct LocalPath {
  LocalPose start;
  std::vector<Segment> segments;
};

/// Proposes paths in one run. Calls come one after the other, from any thread of the run. Results
/// repeat if the source depends only on the seed and on what `hear` is given.
class PathSource {
 public:
  virtual ~PathSource() = default;

  /// A path, or none yet: one iteration of the run, at best some ten microseconds of work. The path
  /// is in the frame of the task. It may begin or end elsewhere, or hit something: the planner
  /// makes a free path along it, if it can. A number that is not finite ends the run with
  /// InputError.
  [[nodiscard]] virtual std::optional<LocalPath> propose() = 0;

  /// Whether another call of `propose` may bring a path. The run ends when none of the planner's
  /// workers has work.
  [[nodiscard]] virtual bool has_work() const = 0;

  /// Receives the cheapest path so far, in the frame of the task, and its cost [m]. It is called
  /// when the planner has a cheaper path, whoever proposed it.
  virtual void hear(const LocalPath& /*best*/, double /*cost*/) {}
};

/// A source of paths under a name, with its share of the work.
struct NamedSource {
  std::string name;  ///< name of the source; error messages have it
  /// Makes the source for one run; required. The task and the options outlive the source. Start and
  /// goal of the task are free.
  std::function<std::unique_ptr<PathSource>(const Task&, const PlanOptions&)> make;
  /// Iterations of the source in a round while no path is known; [1, 10000]. The round after the
  /// first path has a quarter of it. Later rounds have up to 16 times as much.
  std::int64_t share = 16;
};

/// The default planner, with sources of paths beside its own workers. For a vehicle with a trailer
/// a path is that of the tractor. Throws InputError naming "source NAME" if it has no `make` or its
/// share is out of range.
[[nodiscard]] Planner with_sources(std::vector<NamedSource> sources);

}  // namespace vandplan
