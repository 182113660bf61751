// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which routes follow the paths that a source of the caller proposes?

#include <memory>

#include "planners/anytime/source.h"
#include "vandplan/planner.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

/// Makes a free route of each path that a source of the caller proposes, if it finds one.
class Proposals final : public Source {
 public:
  /// `paths` must not be null. The task outlives the object.
  Proposals(const Task& task, const search::CostRule& rule, std::unique_ptr<PathSource> paths,
            std::uint64_t seed);

  [[nodiscard]] bool step() override;
  [[nodiscard]] search::Route route() const override { return found_; }
  [[nodiscard]] bool has_work() const override { return paths_->has_work(); }
  void set_route(const search::Route& best) override;
  [[nodiscard]] Counts counts() const override { return counts_of(connector_); }

 private:
  const Task& task_;
  search::Connector connector_;
  std::unique_ptr<PathSource> paths_;
  std::uint64_t seed_;
  std::uint64_t proposed_ = 0;  // paths proposed so far; numbers their seeds
  search::Route found_;
};

}  // namespace vandplan::anytime
