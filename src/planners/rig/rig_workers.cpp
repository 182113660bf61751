// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/rig_workers.h"

#include <utility>

#include "vandplan/random.h"

namespace vandplan::rig {

using anytime::Counts, anytime::Drive, anytime::Found, anytime::Told;

ChainSeeker::ChainSeeker(std::shared_ptr<const Setting> setting,
                         std::unique_ptr<ChainSource> source, std::uint64_t seed)
    : setting_(std::move(setting)), source_(std::move(source)), seed_(seed) {}

// A drive that became the best is made cheaper by `BestImprover` from the next round on.
void ChainSeeker::listen(const Told& told) {
  if (std::exchange(has_won_, false)) drop();
  if (told.drive == nullptr) return;
  if (told.drive->cost < best_) best_ = told.drive->cost;
  source_->hear(*told.drive);
}

void ChainSeeker::drop() {
  if (improver_) checks_ += improver_->checks();
  improver_.reset();
}

Found ChainSeeker::work(std::int64_t iterations, const Told& told, const search::Budget& budget) {
  Found found;
  if (iterations > 0) listen(told);
  const auto note = [&] {
    if (improver_->cost() >= best_) return;
    best_ = improver_->cost();
    has_won_ = true;
    found.improvements.push_back({budget.elapsed(), found.iterations, best_});
    found.drive = improver_->drive();
  };
  while (found.iterations < iterations && has_work() && !budget.is_interrupted()) {
    const std::int64_t left = iterations - found.iterations;
    if (!improver_) {
      const Found first = source_->work(left, budget);
      found.iterations += first.iterations;
      if (!first.drive) continue;
      improver_.emplace(*setting_, *first.drive, stream_seed(seed_, taken_++));
      note();
      continue;
    }
    ++found.iterations;
    const bool goes_on = improver_->step(best_);
    note();
    if (!goes_on) drop();
    if (best_ <= told.enough) break;
  }
  return found;
}

Counts ChainSeeker::counts() const {
  Counts counts = source_->counts();
  counts.checks += checks_ + (improver_ ? improver_->checks() : 0);
  return counts;
}

BestImprover::BestImprover(std::shared_ptr<const Setting> setting, std::uint64_t seed)
    : setting_(std::move(setting)), seed_(seed) {}

void BestImprover::begin(const Drive& best) {
  if (improver_) checks_ += improver_->checks();
  improver_.emplace(*setting_, best, stream_seed(seed_, begun_++));
}

Found BestImprover::work(std::int64_t iterations, const Told& told, const search::Budget& budget) {
  if (iterations > 0 && told.drive != nullptr && (!best_ || told.drive->cost < best_->cost)) {
    best_ = *told.drive;
    begin(*best_);
  }
  const auto step = [this]() -> std::optional<double> {
    if (!improver_->step(best_->cost)) {
      begin(*best_);
      return std::nullopt;
    }
    if (improver_->cost() >= best_->cost) return std::nullopt;
    best_ = improver_->drive();
    return best_->cost;
  };
  Found found = anytime::work_in_steps(
      iterations, told.enough, budget, [this] { return improver_.has_value(); }, step);
  if (!found.improvements.empty()) found.drive = best_;
  return found;
}

Counts BestImprover::counts() const {
  return {.checks = checks_ + (improver_ ? improver_->checks() : 0)};
}

}  // namespace vandplan::rig
