// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do I let the default planner use paths that I know of?
//
//   const auto result = vandplan::plan(problem, vandplan::with_sources({{"mine", make}}));
//
// A source proposes paths while the planner runs. Each is checked, shortened and compared with what
// the planner finds itself. Whatever a source proposes, the answer has passed the judge.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "vandplan/planner.h"

namespace vandplan {

/// A path in the frame of a task.
struct LocalPath {
  LocalPose start;
  std::vector<Segment> segments;
};

/// Proposes paths in one run. Calls come one after the other, from any thread of the run. Answers
/// repeat if what a source does depends on the seed and on what it hears alone.
class PathSource {
 public:
  virtual ~PathSource() = default;

  /// One iteration of the run, at best some ten microseconds of work: a path, or none yet. A path
  /// may begin or end elsewhere, or hit something. The planner makes a free path of it that keeps
  /// to its way, if it can. A number that is not finite ends the run with InputError.
  [[nodiscard]] virtual std::optional<LocalPath> propose() = 0;

  /// Whether another call may bring a path. If none of the planner's workers has work, the run
  /// ends.
  [[nodiscard]] virtual bool has_work() const = 0;

  /// The cheapest path that the planner knows of [m], whoever proposed it; called when there is
  /// another one.
  virtual void hear(const LocalPath& /*best*/, double /*cost*/) {}
};

/// A source in its place.
struct NamedSource {
  std::string name;
  /// Makes the source for one run. The task and the options outlive the source; start and goal are
  /// free.
  std::function<std::unique_ptr<PathSource>(const Task&, const PlanOptions&)> make;
  std::int64_t share = 16;  ///< iterations of a round; [1, 10000]; a quarter of it at first
};

/// The default planner, with sources of paths beside its own workers. It ignores them with a
/// trailer. Throws InputError for a source without `make` or with a share out of range.
[[nodiscard]] Planner with_sources(std::vector<NamedSource> sources);

}  // namespace vandplan
