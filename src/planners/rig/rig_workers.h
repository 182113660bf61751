// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Who finds drives of a rig, and who makes them cheaper?
//
// Method: docs/algorithms/trailers.md.

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>

#include "planners/anytime/worker.h"
#include "planners/rig/chain_source.h"
#include "planners/rig/improver.h"

namespace vandplan::rig {

/// Takes drives from a source one by one, and makes each cheaper as long as it may become the best.
class ChainSeeker final : public anytime::Worker {
 public:
  ChainSeeker(std::shared_ptr<const Setting> setting, std::unique_ptr<ChainSource> source,
              std::uint64_t seed);

  [[nodiscard]] bool has_work() const override { return improver_ || source_->has_work(); }
  [[nodiscard]] anytime::Found work(std::int64_t iterations, const anytime::Told& told,
                                    const search::Budget& budget) override;
  [[nodiscard]] anytime::Counts counts() const override;

 private:
  void listen(const anytime::Told& told);
  void drop();

  std::shared_ptr<const Setting> setting_;
  std::unique_ptr<ChainSource> source_;
  std::uint64_t seed_;
  std::uint64_t taken_ = 0;           // drives taken so far; numbers their seeds
  std::optional<Improver> improver_;  // the drive that is made cheaper
  double best_ =
      std::numeric_limits<double>::infinity();  // least cost of all drives that are known
  bool has_won_ = false;     // whether the drive at hand became the best in this round
  std::int64_t checks_ = 0;  // checks of former drives
};

/// [5] Makes the best drive of all workers cheaper, again and again.
class BestImprover final : public anytime::Worker {
 public:
  BestImprover(std::shared_ptr<const Setting> setting, std::uint64_t seed);

  [[nodiscard]] bool has_work() const override { return true; }
  [[nodiscard]] anytime::Found work(std::int64_t iterations, const anytime::Told& told,
                                    const search::Budget& budget) override;
  [[nodiscard]] anytime::Counts counts() const override;

 private:
  void begin(const anytime::Drive& best);

  std::shared_ptr<const Setting> setting_;
  std::uint64_t seed_;
  std::uint64_t begun_ = 0;  // drives begun so far; numbers their seeds
  std::optional<Improver> improver_;
  std::optional<anytime::Drive> best_;  // cheapest drive that the worker knows
  std::int64_t checks_ = 0;             // checks of former drives
};

}  // namespace vandplan::rig
