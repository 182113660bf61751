// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <optional>
#include <utility>

#include "path/finite.h"
#include "planners/anytime/chain.h"
#include "planners/anytime/sources.h"
#include "vandplan/input_error.h"

namespace vandplan::anytime {
namespace {

class Proposals final : public Source {
 public:
  Proposals(const Task& task, const CostRule& rule, std::unique_ptr<PathSource> paths,
            std::uint64_t seed)
      : task_(task), connector_(task, rule), paths_(std::move(paths)), seed_(seed) {
    if (!paths_) throw InputError("sources", "expected a source of paths, nothing was made");
  }

  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override { return found_; }
  [[nodiscard]] bool has_work() const override { return paths_->has_work(); }
  void set_route(const Route& best) override;
  [[nodiscard]] Counts counts() const override { return counts_of(connector_); }

 private:
  const Task& task_;
  Connector connector_;
  std::unique_ptr<PathSource> paths_;
  std::uint64_t seed_;
  std::uint64_t proposed_ = 0;  // paths proposed so far; numbers their seeds
  Route found_;
};

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

}  // namespace

std::unique_ptr<Source> proposals(const Task& task, const CostRule& rule,
                                  std::unique_ptr<PathSource> paths, std::uint64_t seed) {
  return std::make_unique<Proposals>(task, rule, std::move(paths), seed);
}

}  // namespace vandplan::anytime
