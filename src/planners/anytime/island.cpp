// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/island.h"

#include <algorithm>
#include <limits>

#include "planners/shared_options.h"
#include "search/far_guide.h"

namespace vandplan::anytime {
namespace {

constexpr double hopeless_excess = 20.0;             // over the best cost, times the trials it took
constexpr double hopeless_excess_with_prices = 8.0;  // more routes come then
constexpr double worth_a_try = 0.98;                 // of the cost of a route of its kind
constexpr std::size_t remembered = 6;                // routes that were given up
constexpr int checks_of_time = 4;                    // iterations between two looks at the clock

}  // namespace

Island::Island(Work work, const Task& task, const CostRule& rule, const Bounds& region,
               std::uint64_t seed, bool keeps_losers)
    : task_(task),
      region_(region),
      work_(work),
      seed_(seed),
      keeps_losers_(keeps_losers),
      scope_(FarGuide::is_wanted(task, sampling_region(task, Region::scene)) ? Scope::windows
                                                                             : Scope::all),
      connector_(task, rule),
      best_cost_(std::numeric_limits<double>::infinity()),
      handed_on_cost_(best_cost_) {}

// At the first run: what another island finds before it may make it needless.
void Island::prepare() {
  is_prepared_ = true;
  const CostRule& rule = connector_.rule();
  switch (work_) {
    case Work::refine:  // [6] has the best route only
      break;
    case Work::search_from_start:  // [4]
      ladder_.emplace(task_, rule, Root::start);
      break;
    case Work::search_from_goal:  // [3]
      ladder_.emplace(task_, rule, Root::goal);
      break;
    case Work::random_trees:  // [2]
      attempts_.emplace(task_, rule, region_, stream_seed(seed_, 0));
      break;
    case Work::detours:  // [6b]
      detours_.emplace(task_, rule, stream_seed(seed_, 0), scope_);
      break;
    case Work::survey:  // [6c]
      survey_.emplace(task_, rule);
      break;
    case Work::bend:  // [6d]
      bender_.emplace(task_, rule, stream_seed(seed_, 0));
      break;
    case Work::adapt:  // [6f]
      adapter_.emplace(task_, rule, stream_seed(seed_, 0));
      break;
    case Work::bound:  // [7]
      geodesic_.emplace(task_, best_cost_);
      flood_.emplace(task_);
      break;
  }
}

std::int64_t Island::solves() const {
  return connector_.solves() + (ladder_ ? ladder_->solves() : 0) +
         (attempts_ ? attempts_->connector().solves() : 0) + (detours_ ? detours_->solves() : 0) +
         (survey_ ? survey_->solves() : 0) + (adapter_ ? adapter_->solves() : 0);
}

std::int64_t Island::checks() const {
  return connector_.checks() + (ladder_ ? ladder_->checks() : 0) +
         (attempts_ ? attempts_->connector().checks() : 0) + (detours_ ? detours_->checks() : 0) +
         (survey_ ? survey_->checks() : 0) + (bender_ ? bender_->checks() : 0) +
         (adapter_ ? adapter_->checks() : 0);
}

std::size_t Island::nodes() const {
  return ladder_     ? ladder_->size()
         : attempts_ ? attempts_->size()
         : detours_  ? detours_->size()
                     : 0;
}

bool Island::has_work() const {
  return !is_prepared_ || candidate_ || (bender_ && bender_->has_work()) ||
         (adapter_ && adapter_->has_work()) || attempts_ || detours_ || survey_ ||
         (geodesic_ && !bound_is_final_) || (ladder_ && !ladder_->is_finished());
}

// A route that is far above the best after many trials will not win: what shortening gains falls
// about as one over the number of trials (docs/algorithms/anytime.md).
bool Island::is_hopeless() const {
  const double excess = candidate_->cost() / best_cost_ - 1.0;
  const double most = connector_.rule().is_length() ? hopeless_excess : hopeless_excess_with_prices;
  return candidate_->is_stalled() ||
         excess * static_cast<double>(trials_) / candidate_->trials_for_one() > most;
}

// With prices searches find many routes of the kinds that were tried in vain.
bool Island::is_known(const Route& route) const {
  if (route.cost < best_cost_) return false;
  return std::ranges::any_of(given_up_, [&](const Route& other) {
    return route.cost > worth_a_try * other.cost && are_alike(route, other, connector_.radius());
  });
}

void Island::give_up() {
  if (keeps_losers_) losers_.push_back(candidate_->route());
  candidate_.reset();
  if (connector_.rule().is_length()) return;
  if (given_up_.size() == remembered) given_up_.erase(given_up_.begin());
  given_up_.push_back(std::move(raw_));
}

std::optional<Route> Island::search() {
  if (geodesic_) {
    bound_is_final_ = !geodesic_->step();
  } else if (adapter_) {
    if (adapter_->step()) return adapter_->route();
  } else if (survey_) {
    survey_->set_cutoff(best_cost_);
    if (survey_->step()) return survey_->route();
  } else if (detours_) {
    if (detours_->step()) return detours_->route();
  } else if (ladder_) {
    ladder_->set_cutoff(best_cost_);
    if (ladder_->step()) return ladder_->route();
  } else if (attempts_ && attempts_->step()) {
    return attempts_->route();
  }
  return std::nullopt;
}

void Island::raise(std::int64_t steps, const Budget& budget) {
  for (std::int64_t i = 0; i < steps && may_raise(); ++i) {
    if (i % checks_of_time == 0 && budget.is_interrupted()) return;
    flood_is_final_ = !flood_->step(best_cost_);
  }
}

// True when it has a route better than all it knew of.
bool Island::step() {
  if (bender_) {
    if (!bender_->step() || bender_->cost() >= best_cost_) return false;
    best_cost_ = bender_->cost();
    return true;
  }
  if (!candidate_) {
    std::optional<Route> route = search();
    if (!route) return false;
    if (connector_.rule().clearance_weight > 0.0) price(connector_, *route);
    if (is_known(*route)) return false;
    if (!connector_.rule().is_length()) raw_ = *route;
    candidate_.emplace(connector_, *std::move(route), stream_seed(seed_, ++candidates_), scope_);
    trials_ = 0;
  } else {
    candidate_->step();  // [5] [6]
    ++trials_;
  }
  const bool won = candidate_->cost() < best_cost_;
  if (won) {
    best_cost_ = candidate_->cost();
    // Another one that has won in this slice may be of another kind.
    if (offer_ && keeps_losers_) losers_.push_back(*std::move(offer_));
    if (work_ != Work::refine) offer_ = candidate_->route();
  }
  if (work_ != Work::refine && !won && is_hopeless()) give_up();
  if (work_ != Work::refine && won) candidate_.reset();
  return won;
}

std::optional<BentDrive> Island::begin_with(const Path& known) {
  prepare();
  bender_->offer(known.segments);
  if (!bender_->step()) return std::nullopt;
  best_cost_ = bender_->cost();
  return bender_->best();
}

// The refining island goes on with the best route, whoever found it.
void Island::take_over(const Route& best) {
  if (best.cost >= best_cost_) return;
  best_cost_ = best.cost;
  if (work_ == Work::refine)
    candidate_.emplace(connector_, best, stream_seed(seed_, ++candidates_), scope_);
}

Slice Island::run(std::int64_t iterations, const Route* best, const Budget& budget, double enough) {
  Slice slice;
  losers_.clear();
  offer_.reset();
  if (best != nullptr) take_over(*best);
  if (!is_prepared_ && iterations > 0) prepare();
  if ((detours_ || bender_) && best != nullptr && best->cost < handed_on_cost_) {
    handed_on_cost_ = best->cost;
    if (detours_) detours_->set_route(*best);
    if (bender_) bender_->offer(*best);
  }
  while (slice.iterations < iterations && has_work()) {
    if (slice.iterations % checks_of_time == 0 && budget.is_interrupted()) break;
    ++slice.iterations;
    if (!step()) continue;
    slice.improvements.push_back({budget.elapsed(), slice.iterations, best_cost_});
    if (best_cost_ <= enough) break;
  }
  slice.losers = std::move(losers_);
  if (slice.improvements.empty()) return slice;
  if (bender_) {
    slice.drive = bender_->best();
    return slice;
  }
  // Nothing but what won changes the best route.
  slice.route = work_ == Work::refine ? candidate_->route() : offer_;
  best_cost_ = slice.route->cost;
  return slice;
}

}  // namespace vandplan::anytime
