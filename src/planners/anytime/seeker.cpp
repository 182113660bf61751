// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "planners/anytime/shorten.h"
#include "planners/anytime/workers.h"

namespace vandplan::anytime {
namespace {

class Seeker final : public Worker {
 public:
  Seeker(const Task& task, const CostRule& rule, std::uint64_t seed,
         std::function<std::unique_ptr<Source>()> make)
      : make_(std::move(make)),
        connector_(task, rule),
        seed_(seed),
        best_cost_(std::numeric_limits<double>::infinity()),
        told_cost_(best_cost_) {}

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

bool Seeker::has_work() const { return !source_ || candidate_ || source_->has_work(); }

void Seeker::offer(const Route& route) {
  if (!source_) source_ = make_();
  source_->offer(route);
}

Counts Seeker::counts() const {
  Counts counts = counts_of(connector_);
  if (source_) counts += source_->counts();
  return counts;
}

// Whether the candidate will not win: it is far above the best route after many trials.
bool Seeker::is_hopeless() const {
  const double excess = candidate_->cost() / best_cost_ - 1.0;
  return candidate_->is_stalled() ||
         excess * static_cast<double>(trials_) / candidate_->trials_for_one() > hopeless;
}

void Seeker::give_up() {
  given_up_.push_back(candidate_->route());
  candidate_.reset();
}

// True when the source has found a route that is worth shortening.
bool Seeker::begin() {
  source_->set_cutoff(best_cost_);
  if (!source_->step()) return false;
  Route route = source_->route();
  if (connector_.rule().has_surcharge()) price(connector_, route);
  candidate_.emplace(connector_, std::move(route), stream_seed(seed_, ++candidates_));
  trials_ = 0;
  return true;
}

// The cost of a new best route, if there is one.
std::optional<double> Seeker::step() {
  if (candidate_) {
    candidate_->step();  // [4]
    ++trials_;
  } else if (!begin()) {
    return std::nullopt;
  }
  if (candidate_->cost() >= best_cost_) {
    if (is_hopeless()) give_up();
    return std::nullopt;
  }
  best_cost_ = candidate_->cost();
  // The former winner of this round may be of another kind.
  if (winner_) given_up_.push_back(*std::move(winner_));
  winner_ = candidate_->route();
  candidate_.reset();
  return best_cost_;
}

void Seeker::listen(const Told& told) {
  if (told.route == nullptr) return;
  best_cost_ = std::min(best_cost_, told.route->cost);
  if (!source_ || told.route->cost >= told_cost_) return;
  told_cost_ = told.route->cost;
  source_->set_route(*told.route);
}

Found Seeker::work(std::int64_t iterations, const Told& told, const Budget& budget) {
  if (!source_ && iterations > 0) source_ = make_();
  listen(told);
  winner_.reset();
  Found found = work_in_steps(
      iterations, told.enough, budget, [this] { return has_work(); }, [this] { return step(); });
  found.given_up = std::exchange(given_up_, {});
  if (!winner_) return found;
  best_cost_ = winner_->cost;
  found.route = std::move(winner_);
  return found;
}

}  // namespace

std::unique_ptr<Worker> seeker(const Task& task, const CostRule& rule, std::uint64_t seed,
                               std::function<std::unique_ptr<Source>()> make) {
  return std::make_unique<Seeker>(task, rule, seed, std::move(make));
}

}  // namespace vandplan::anytime
