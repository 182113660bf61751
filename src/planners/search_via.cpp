// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/search_via.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "planners/last_stretch.h"
#include "planners/leg_bounds.h"
#include "planners/pricing.h"
#include "planners/via_chain.h"
#include "problem/goal_set.h"
#include "search/route.h"
#include "search/wheels.h"
#include "vandplan/search.h"

namespace vandplan::planning {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
/// Iterations of a leg in one turn, and most of them for a leg of a trial.
constexpr std::int64_t work_of_turn = 256;
constexpr std::int64_t first_look = 32;      // iterations of each leg before a trial is dropped
constexpr double is_near_best = 1.05;        // a trial up to so many times the best gets its chance
constexpr double first_step_beside = 0.125;  // first step beside a node [share of its intervals]
constexpr double last_step_beside = 5e-4;    // last step
constexpr double worth_trying = 1.15;  // other poses are tried up to so many times the straight way
constexpr std::int64_t work_of_bounds = 20'000;  // pairs of parts of vias that bounds look at
constexpr double same_curvature = 2e-7;  // difference that is rounding, times the turning radius

/// The way between two neighbours of a chain, and the search for it.
struct ViaLeg {
  ViaLeg(Task of, std::size_t to) : task(std::move(of)), via(to) {}

  Task task;
  std::size_t via;                 // via that it leads to, or the number of vias
  std::optional<Path> known = {};  // path to begin with
  std::unique_ptr<PathSearch> search = {};
  std::optional<std::vector<Segment>> path = {};
  std::int64_t spent = 0;
  bool is_done = false;
  bool is_closed = false;   // whether it is proven that there is no path
  std::string reason = {};  // why there is no path; or empty
};

using LegPointer = std::shared_ptr<ViaLeg>;

/// Another node in the place of one of the chain, with the legs to it and from it.
struct ViaTrial {
  std::size_t via;
  ViaNode node;
  LegPointer legs[2];                // to it, and from it
  std::int64_t chance = first_look;  // iterations for each leg
};

class ViaSearch final : public PathSearch {
 public:
  /// `known`: path to begin with, if `passed` has the driven distance to each via.
  ViaSearch(const Task& task, const PlanOptions& options, double time_price, const Path* known,
            std::span<const double> passed, const SearchTo& search_to)
      : task_(task),
        options_(options),
        search_to_(search_to),
        pricing_(task, options.cost, time_price),
        budget_(options.budget),
        nodes_(task, pricing_.prices(), budget_),
        bounds_(task, pricing_, work_of_bounds) {
    options_.budget.max_iterations.reset();
    if (!passed.empty() && begin_along(*known, passed)) return;
    if (!nodes_.empty_via()) begin_chain();
  }

  bool advance(std::int64_t most) override {
    if (chain_.empty() || most <= 0 || budget_.is_interrupted()) return false;
    const std::int64_t share = std::min(most, work_of_turn);
    if (!best_) return find(share);
    const bool is_turn_of_trial = spent_on_trials_ <= spent_on_legs_;
    if (is_turn_of_trial && (trial_ || begin_trial())) {
      try_on(share);
      return true;
    }
    ViaLeg* const leg = leg_with_least_work();
    if (leg != nullptr) {
      spent_on_legs_ += go_on(*leg, share);
      take();
      return true;
    }
    if (!trial_ && !begin_trial()) return false;
    try_on(share);
    return true;
  }

  [[nodiscard]] std::optional<std::vector<Segment>> path() override { return best_; }
  [[nodiscard]] std::int64_t iterations() const override { return iterations_; }

  [[nodiscard]] PlannerAnswer answer() override {
    PlannerAnswer answer{.status = PlanStatus::solved, .iterations = iterations_};
    if (task_.moving.empty()) answer.lower_bound = bounds_.least(budget_);
    if (best_) {
      answer.segments = best_;
      answer.anytime = trace_;
      return answer;
    }
    answer.status = PlanStatus::iteration_limit;
    answer.reason = reason_;
    if (nodes_.is_cut_short()) return answer;
    if (const std::optional<std::size_t> via = nodes_.empty_via()) {
      answer.reason = nodes_.why_empty(*via);
      answer.status = nodes_.is_closed(*via) ? PlanStatus::no_path : PlanStatus::node_limit;
    } else if (is_walled_in_ || (chain_.empty() && is_proven_ && nodes_.are_all())) {
      answer.status = PlanStatus::no_path;
    } else if (chain_.empty()) {
      answer.status = PlanStatus::node_limit;
    }
    return answer;
  }

 private:
  // ---- Legs ----

  /// The leg that leads to node `via` of a chain, or to the goal.
  [[nodiscard]] LegPointer leg_to(const std::vector<ViaNode>& chain, std::size_t via) const {
    Task leg = task_;
    leg.via.clear();
    if (via > 0) {
      const ViaNode& from = chain[via - 1];
      leg.moving.clear();  // when the leg begins is not known
      leg.start = Local(from.state.pose);
      leg.hitch_angles.start = from.state.hitch_angle;
      leg.curvatures.start = from.curvature;
      leg.beyond.start = from.gear;
      leg.beyond.stands_at_start = from.stands;
    }
    if (via < chain.size()) {
      const ViaNode& to = chain[via];
      leg.goal = Local(to.state.pose);
      leg.hitch_angles.goal = to.state.hitch_angle;
      leg.curvatures.goal = to.curvature;
      leg.beyond.goal = to.gear;
      leg.beyond.stands_at_goal = to.stands;
    }
    problem::tell_ends_apart(leg);
    return std::make_shared<ViaLeg>(std::move(leg), via);
  }

  /// Goes on with a leg; the number of iterations. `known`: path to a place nearby, or null.
  std::int64_t go_on(ViaLeg& leg, std::int64_t most, const ViaLeg* known = nullptr) {
    if (is_there(leg.task)) {
      leg.path.emplace();
      leg.is_done = true;
      return 0;
    }
    if (!leg.search) {
      PlanOptions options = options_;
      if (options.budget.time_limit) {
        *options.budget.time_limit = std::max(*options.budget.time_limit - budget_.elapsed(), 0.0);
      }
      if (leg.task.beyond.start != 0) {
        options.cost.initial_gear =
            leg.task.beyond.start > 0 ? InitialGear::forward : InitialGear::reverse;
      }
      std::optional<Path> along = leg.known;
      if (known != nullptr && known->path) along = Path{known->task.start, *known->path};
      leg.search = search_to_(leg.task, options, along ? &*along : nullptr);
    }
    const std::int64_t before = leg.search->iterations();
    leg.is_done = !leg.search->advance(most);
    const std::int64_t work = std::max<std::int64_t>(leg.search->iterations() - before, 1);
    leg.spent += work;
    iterations_ += work;
    leg.path = leg.search->path();
    bounds_.raise(leg.via, leg.task.start, leg.task.goal, leg.search->proven());
    if (iterations_ >= next_bound_) {  // in the end the time for that may be over
      (void)bounds_.least(budget_);
      next_bound_ = iterations_ + iterations_ / 4;
    }
    if (leg.is_done && !leg.path) {
      const PlannerAnswer answer = leg.search->answer();
      leg.is_closed = answer.status == PlanStatus::no_path;
      leg.reason = answer.reason;
    }
    return work;
  }

  [[nodiscard]] ViaLeg* leg_with_least_work() const {
    ViaLeg* least = nullptr;
    for (const LegPointer& leg : legs_) {
      if (!leg->is_done && (least == nullptr || leg->spent < least->spent)) least = leg.get();
    }
    return least;
  }

  // ---- The first chain that can be driven ----

  /// Takes the best chain, with those legs of the last one that are the same.
  void begin_chain() {
    const std::vector<ViaNode> last =
        std::exchange(chain_, nodes_.best_chain().value_or(std::vector<ViaNode>()));
    const std::vector<LegPointer> old = std::exchange(legs_, {});
    if (chain_.empty()) return;
    const auto stays = [&](std::size_t i) {
      return old.size() > i && (i == chain_.size() || last[i].number == chain_[i].number);
    };
    for (std::size_t i = 0; i <= chain_.size(); ++i) {
      const bool is_same = stays(i) && (i == 0 || stays(i - 1));
      legs_.push_back(is_same ? old[i] : leg_to(chain_, i));
    }
  }

  /// Begins with the legs of a path. False if it does not pass the vias at free nodes.
  bool begin_along(const Path& path, std::span<const double> passed) {
    std::optional<std::vector<ViaNode>> chain = nodes_.along(path, passed);
    if (!chain) return false;
    chain_ = *std::move(chain);
    for (std::size_t i = 0; i <= chain_.size(); ++i) {
      legs_.push_back(leg_to(chain_, i));
      const double begin = i == 0 ? 0.0 : passed[i - 1];
      const double end = i == chain_.size() ? infinite : passed[i];
      legs_.back()->known =
          Path{legs_.back()->task.start, search::part_of(path.segments, begin, end)};
    }
    return true;
  }

  /// Goes on with the first leg without a path, or with one whose wheels would have to jump. Other
  /// chains are tried in between.
  bool find(std::int64_t most) {
    take();
    if (best_) return true;
    std::size_t i = 0;
    while (i < legs_.size() && legs_[i]->path && (i == 0 || fits_behind(i))) ++i;
    if (i == legs_.size()) return false;  // an endless cost
    ViaLeg& leg = *legs_[i];
    const std::size_t from = i == 0 ? 0 : chain_[i - 1].number;
    const std::size_t to = i == chain_.size() ? 0 : chain_[i].number;
    if (!leg.is_done) {
      const std::int64_t work = go_on(leg, most);
      spent_on_legs_ += work;
      in_vain_ = leg.path && (i == 0 || fits_behind(i)) ? 0 : in_vain_ + work;
      // Tries take one turn, two, one, four, ... (Luby et al. 1993).
      if (leg.is_done || in_vain_ < work_of_turn << std::countr_zero(tries_)) return true;
      in_vain_ = 0;
      ++tries_;
      nodes_.doubt(i, from, to);
      begin_chain();
      return true;
    }
    is_proven_ = is_proven_ && leg.is_closed;
    is_walled_in_ = leg.is_closed && nodes_.is_out_of_reach(i, budget_);
    if (!leg.reason.empty()) {
      const std::string end = i == chain_.size() ? "the goal" : "via[" + std::to_string(i) + "]";
      reason_ = "on the way to " + end + ": " + leg.reason;
    }
    nodes_.give_up(i, from, to);
    begin_chain();
    return !chain_.empty() && !is_walled_in_;
  }

  /// Whether leg `i` fits behind the one before it.
  [[nodiscard]] bool fits_behind(std::size_t i) const {
    const ViaLeg& before = *legs_[i - 1];
    return before.path->empty() || legs_[i]->path->empty() || fits(before.path->back(), *legs_[i]);
  }

  // ---- Better nodes ----

  /// The path along some legs; none if one has no path, or the wheels would have to jump.
  [[nodiscard]] std::optional<std::vector<Segment>> joined(std::span<const LegPointer> legs) const {
    std::vector<Segment> whole;
    for (const LegPointer& leg : legs) {
      if (!leg->path) return std::nullopt;
      if (!whole.empty() && !leg->path->empty() && !fits(whole.back(), *leg)) return std::nullopt;
      whole.insert(whole.end(), leg->path->begin(), leg->path->end());
    }
    return whole;
  }

  [[nodiscard]] bool fits(const Segment& before, const ViaLeg& leg) const {
    const Segment& next = leg.path->front();
    search::Driven last = search::last_driven(before);
    if (search::rolling_beyond(leg.task, true) == 0) last.gear = 0;
    const double jump = std::abs(next.curvature - last.curvature);
    return search::may_jump(task_.steering, last, search::gear_of(next)) ||
           jump * task_.vehicle.min_turning_radius <= same_curvature;
  }

  [[nodiscard]] double cost_of(const std::optional<std::vector<Segment>>& path) const {
    return path ? pricing_.cost(*path, search::ClearanceSampling::search) : infinite;
  }

  /// Takes the path along the chain if it is better than the best so far.
  void take() {
    std::optional<std::vector<Segment>> path = joined(legs_);
    const double cost = cost_of(path);
    if (!path || cost >= cost_) return;
    best_ = std::move(path);
    cost_ = cost;
    trace_.push_back({budget_.elapsed(), iterations_, cost});
  }

  /// Puts nodes to try beside those of the chain into the queue.
  void find_trials() {
    for (std::size_t via = 0; via < chain_.size(); ++via) {
      const auto wait = [&](const std::vector<ViaNode>& nodes) {
        for (const ViaNode& node : nodes) waiting_.push_back({via, node});
      };
      if (is_first_round_) wait(nodes_.others(chain_, via, worth_trying));
      wait(nodes_.beside(chain_, via, step_));
    }
    is_first_round_ = false;
    if (!has_gained_) step_ /= 2;
    has_gained_ = false;
  }

  /// Begins to try the next node. False if there is none left.
  bool begin_trial() {
    while (waiting_.empty()) {
      if (step_ < last_step_beside || chain_.empty()) return false;
      find_trials();
    }
    const auto [via, node] = waiting_.front();
    waiting_.pop_front();
    std::vector<ViaNode> chain = chain_;
    chain[via] = node;
    trial_ = ViaTrial{via, node, {leg_to(chain, via), leg_to(chain, via + 1)}};
    return true;
  }

  /// Goes on with a trial. Once its legs have had their chance, it replaces the node or is dropped.
  void try_on(std::int64_t most) {
    ViaTrial& trial = *trial_;
    const std::size_t via = trial.via;
    std::vector<LegPointer> legs = legs_;
    for (std::size_t end = 0; end < 2; ++end) {
      ViaLeg& leg = *trial.legs[end];
      const LegPointer old = std::exchange(legs[via + end], trial.legs[end]);
      if (leg.is_done || leg.spent >= trial.chance) continue;
      const std::int64_t share = std::min(most, trial.chance - leg.spent);
      spent_on_trials_ += std::max<std::int64_t>(go_on(leg, share, old.get()), 1);
      return;
    }
    const double cost = cost_of(joined(legs));
    if (cost >= cost_ && cost < is_near_best * cost_ && trial.chance < work_of_turn) {
      trial.chance = work_of_turn;
      return;
    }
    if (cost < cost_) {
      legs_ = std::move(legs);
      chain_[via] = trial.node;
      has_gained_ = true;
      take();
    }
    trial_.reset();
  }

  const Task& task_;
  PlanOptions options_;
  SearchTo search_to_;
  Pricing pricing_;
  search::Budget budget_;
  ViaNodes nodes_;
  LegBounds bounds_;
  std::vector<ViaNode> chain_;                // empty if there is no chain left
  std::vector<LegPointer> legs_;              // legs of the chain, one more than nodes
  std::optional<std::vector<Segment>> best_;  // best path so far
  double cost_ = infinite;
  std::vector<CostSample> trace_;
  std::int64_t iterations_ = 0, spent_on_legs_ = 0, spent_on_trials_ = 0;
  std::int64_t in_vain_ = 0;                    // iterations of the try on the present leg
  std::uint64_t tries_ = 1;                     // tries on legs, with this one
  std::int64_t next_bound_ = 4 * work_of_turn;  // iteration at which the bound is looked at
  std::string reason_;                          // why the last leg that was given up has no path
  bool is_walled_in_ = false;  // whether it is proven that a via or the goal cannot be reached
  bool is_proven_ = true;      // whether all legs that were given up are proven to have no path
  std::deque<std::pair<std::size_t, ViaNode>> waiting_;  // nodes to try, with their vias
  std::optional<ViaTrial> trial_;
  double step_ = first_step_beside;
  bool is_first_round_ = true;
  bool has_gained_ = false;  // whether a trial of this round was better
};

}  // namespace

std::unique_ptr<PathSearch> search_via(const Task& task, const PlanOptions& options,
                                       double time_price, const Path* known,
                                       std::span<const double> passed, const SearchTo& search_to) {
  if (task.via.empty()) return search_to(task, options, known);
  return std::make_unique<ViaSearch>(task, options, time_price, known, passed, search_to);
}

}  // namespace vandplan::planning
