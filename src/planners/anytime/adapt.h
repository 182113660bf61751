// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How is a route driven that was found as if the wheels turned at once?
//
// Method: docs/algorithms/anytime.md, "Wheels that turn at once".

#include <cstdint>
#include <optional>
#include <vector>

#include "planners/anytime/chain.h"
#include "planners/anytime/kinds.h"
#include "planners/anytime/source.h"

namespace vandplan::anytime {

/// Takes relaxed routes, whose wheels turn at once, and looks for a free route of the task along
/// each of them.
class Adapter final : public Source {
 public:
  /// The task and the rule outlive the adapter.
  Adapter(const Task& task, const CostRule& rule, std::uint64_t seed);

  /// A relaxed route from the start of the task to its goal. One that is like a route offered
  /// before is left out unless it is much cheaper.
  void offer(const Route& relaxed) override;

  /// One trial. True when a route of the task was found: `route`.
  [[nodiscard]] bool step() override;

  [[nodiscard]] Route route() const override { return route_; }
  [[nodiscard]] bool has_work() const override { return chain_ || !waiting_.empty(); }
  [[nodiscard]] std::int64_t solves() const override { return connector_.solves(); }
  [[nodiscard]] std::int64_t checks() const override { return connector_.checks(); }

 private:
  void begin();

  const Task& task_;
  Connector connector_;
  std::uint64_t seed_;
  std::uint64_t begun_ = 0;    // so far; each has a seed
  Kinds kinds_;                // that were offered
  std::vector<Path> waiting_;  // the next one last
  Path path_;                  // along which the chain leads
  std::optional<Chain> chain_;
  int trials_ = 0;  // spent on it
  Route route_;
};

}  // namespace vandplan::anytime
