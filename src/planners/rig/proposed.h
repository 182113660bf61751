// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which drives of a rig follow the paths that a source of the caller proposes?

#include <memory>

#include "planners/rig/chain_source.h"
#include "vandplan/planner.h"

namespace vandplan::rig {

/// Makes a free drive of each path that a source of the caller proposes, if it finds one.
class Proposed final : public ChainSource {
 public:
  /// `paths` must not be null.
  Proposed(std::shared_ptr<const Setting> setting, std::unique_ptr<PathSource> paths);

  [[nodiscard]] anytime::Found work(std::int64_t most, const search::Budget& budget) override;
  [[nodiscard]] bool has_work() const override { return paths_->has_work(); }
  void hear(const anytime::Drive& best) override;
  [[nodiscard]] anytime::Counts counts() const override { return {}; }

 private:
  std::shared_ptr<const Setting> setting_;
  std::unique_ptr<PathSource> paths_;
  double told_cost_;  // cost of the best drive that the source was told
};

}  // namespace vandplan::rig
