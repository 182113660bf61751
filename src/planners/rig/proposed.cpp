// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/proposed.h"

#include <limits>
#include <utility>
#include <vector>

#include "path/finite.h"
#include "vandplan/input_error.h"

namespace vandplan::rig {

Proposed::Proposed(std::shared_ptr<const Setting> setting, std::unique_ptr<PathSource> paths)
    : setting_(std::move(setting)),
      paths_(std::move(paths)),
      told_cost_(std::numeric_limits<double>::infinity()) {
  if (!paths_) throw InputError("sources", "expected a source of paths, nothing was made");
}

anytime::Found Proposed::work(std::int64_t /*most*/, const search::Budget& /*budget*/) {
  anytime::Found found{.iterations = 1};
  const std::optional<LocalPath> proposed = paths_->propose();
  if (!proposed) return found;
  path::check_finite({proposed->start, proposed->segments});
  auto commands = commands::exact_commands(setting_->task, proposed->segments);
  if (commands) found.drive = anytime::Drive{.commands = *std::move(commands)};
  return found;
}

void Proposed::hear(const anytime::Drive& best) {
  if (best.cost >= told_cost_) return;
  told_cost_ = best.cost;
  paths_->hear({setting_->task.start, best.segments}, best.cost);
}

}  // namespace vandplan::rig
