// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/proposals.h"

#include <optional>
#include <utility>

#include "path/finite.h"
#include "planners/anytime/chain.h"
#include "vandplan/input_error.h"

namespace vandplan::anytime {

Proposals::Proposals(const Task& task, const CostRule& rule, std::unique_ptr<PathSource> paths,
                     std::uint64_t seed)
    : task_(task), connector_(task, rule), paths_(std::move(paths)), seed_(seed) {
  if (!paths_) throw InputError("sources", "expected a source of paths, nothing was made");
}

bool Proposals::step() {
  std::optional<LocalPath> proposed = paths_->propose();
  if (!proposed) return false;
  const Path path{proposed->start, std::move(proposed->segments)};
  path::check_finite(path);
  std::optional<Route> route =
      route_along(task_, connector_, path, stream_seed(seed_, proposed_++));
  if (!route) return false;
  found_ = *std::move(route);
  return true;
}

void Proposals::set_route(const Route& best) {
  paths_->hear({best.start, path_of(best).segments}, best.cost);
}

}  // namespace vandplan::anytime
