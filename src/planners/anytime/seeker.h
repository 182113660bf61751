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

/// Takes routes from a source, one after the other, and shortens each for as long as it may become
/// the best one.
class Seeker final : public Worker {
 public:
  /// `make` is called when the worker gets its first iterations or its first offer: what other
  /// workers find before may make it needless. The task and the rule outlive the worker.
  Seeker(const Task& task, const CostRule& rule, Scope scope, std::uint64_t seed,
         std::function<std::unique_ptr<Source>()> make);

  [[nodiscard]] bool has_work() const override;
  [[nodiscard]] Found work(std::int64_t iterations, const Told& told,
                           const Budget& budget) override;
  void offer(const Route& route) override;
  [[nodiscard]] Counts counts() const override;
  /// The source; null before the first iteration.
  [[nodiscard]] const Source* source() const { return source_.get(); }

 private:
  void listen(const Told& told);
  std::optional<double> step();
  [[nodiscard]] bool begin();
  [[nodiscard]] bool is_hopeless() const;
  [[nodiscard]] bool is_known(const Route& route) const;
  void give_up();

  std::function<std::unique_ptr<Source>()> make_;
  std::unique_ptr<Source> source_;
  Connector connector_;
  Scope scope_;
  std::uint64_t seed_;
  double best_cost_;                    // of all routes that it knows of
  double told_cost_;                    // of the best route that the source was told
  std::optional<Shortener> candidate_;  // a route that may win yet
  Route raw_;                           // the candidate as it was found
  std::int64_t trials_ = 0;             // spent on the candidate
  std::uint64_t candidates_ = 0;        // so far; each has a seed
  std::optional<Route> winner_;         // of this round
  std::vector<Route> given_up_;         // in this round, shortened
  std::vector<Route> in_vain_;          // the last ones that were given up, as they were found
};

}  // namespace vandplan::anytime
