// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a route that was just found become the best one?

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "planners/anytime/shorten.h"
#include "planners/anytime/source.h"
#include "planners/anytime/worker.h"

namespace vandplan::anytime {

/// Takes routes from a source one by one, and shortens each as long as it may become the best.
class Seeker final : public Worker {
 public:
  /// `make` is called when the worker gets its first iterations or its first offer. Other workers
  /// may make it needless before. The task and the rule outlive the worker.
  Seeker(const Task& task, const CostRule& rule, std::uint64_t seed,
         std::function<std::unique_ptr<Source>()> make);

  [[nodiscard]] bool has_work() const override;
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  void offer(const Route& route) override;
  [[nodiscard]] Counts counts() const override;
  [[nodiscard]] std::int64_t stage() const override { return source_ ? source_->stage() : 0; }

 private:
  void listen(const Told& told);
  std::optional<double> step();
  [[nodiscard]] bool begin();
  [[nodiscard]] bool is_hopeless() const;
  void give_up();

  std::function<std::unique_ptr<Source>()> make_;
  std::unique_ptr<Source> source_;
  Connector connector_;
  std::uint64_t seed_;
  double best_cost_;                    // least cost of all routes that the worker knows
  double told_cost_;                    // cost of the best route that the source was told
  std::optional<Shortener> candidate_;  // route that is being shortened and may become the best
  std::int64_t trials_ = 0;             // trials spent on the candidate
  std::uint64_t candidates_ = 0;        // candidates so far; numbers their seeds
  std::optional<Route> winner_;         // best new route of this round
  std::vector<Route> given_up_;         // routes given up in this round, shortened
};

}  // namespace vandplan::anytime
