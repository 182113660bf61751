// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/plan_to_set.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <deque>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "planners/goal_poses.h"
#include "planners/last_stretch.h"
#include "planners/out_of_reach.h"
#include "planners/pricing.h"
#include "planners/set_goals.h"
#include "vandplan/search.h"

namespace vandplan::planning {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Work on the most promising goal after which another one is looked at [iterations].
constexpr double work_of_doubling = 64.0;
/// Work on a goal is weighted by its cost over the best cost, to a power that grows, as a first
/// path says little. The power grows by 1 in so many iterations, up to `severity`.
constexpr std::int64_t work_of_power = 128;
constexpr std::int64_t severity = 32;
/// Factor over the best cost that a goal without a path counts as.
constexpr double doubt = 1.08;
constexpr std::int64_t chance = 256;  // iterations that a goal gets for a fair chance
constexpr double dropped = 1.2;       // a goal that costs so many times the best is dropped
/// First and last distance of goals beside the best one, in shares of their intervals.
constexpr double first_share = 0.125;
constexpr double last_share = 5e-4;

/// A goal of the set and the search for a path to it.
struct Candidate : SetGoal {
  int rank = 0;                    // the goal joins when the number of goals has doubled so often
  std::optional<Path> known = {};  // path to a goal nearby
  std::unique_ptr<PathSearch> search = {};
  std::optional<std::vector<Segment>> path = {};
  double cost = endless;
  std::int64_t spent = 0;
  double begun = 0.0;  // when the search began [s]
  bool is_done = false;
  bool is_closed = false;  // whether it is proven that there is no path
};

/// Goals beside the best one, which are tried together.
struct Refinement {
  const Candidate* middle = nullptr;
  double share = first_share;
  std::vector<Candidate*> tried;
};

class SetRun {
 public:
  SetRun(const Task& task, const PlanOptions& options, double time_price, const SearchTo& search_to)
      : task_(task),
        options_(options),
        time_price_(time_price),
        search_to_(search_to),
        pricing_(task, options.cost, time_price),
        budget_(options.budget),
        goals_(task, options, time_price, budget_) {
    goals_.spread_out();
  }

  [[nodiscard]] PlannerAnswer answer() {
    if (!join() && !(goals_.look_closer() && join())) return goals_.without_goals();
    while (!is_over()) {
      Candidate* const next = next_candidate();
      if (next != nullptr) go_on(*next);
      if (best_ != nullptr && goals_.is_narrow()) (void)goals_.look_closer();
      // In the end the time for that may be over.
      if (best_ != nullptr && task_.moving.empty()) (void)goals_.bound_of_regions();
      if (!refine() && next == nullptr) break;
    }
    return finished();
  }

 private:
  // ---- Whose turn it is ----

  /// [2] The next goal of the set becomes a candidate; false if there is none.
  bool join() {
    std::optional<SetGoal> goal = goals_.next();
    if (!goal) return false;
    candidates_.push_back({*std::move(goal), next_rank()});
    ++joined_;
    return true;
  }

  [[nodiscard]] int next_rank() const { return static_cast<int>(std::bit_width(joined_)); }

  /// Work that counts for a goal of a rank on which so much was done. Before there is a path all
  /// goals of a rank together get half as much work as the first goal, which may be as good.
  [[nodiscard]] double counted(double work, int rank) const {
    return best_ == nullptr ? std::ldexp(work + work_of_doubling, rank)
                            : work + work_of_doubling * (1 + rank);
  }

  [[nodiscard]] bool may_win(const Candidate& goal) const {
    return !goal.is_done && (best_ == nullptr || &goal == best_ || goal.bound < best_->cost);
  }

  /// [3] [4] Priority of a goal; the one with the least comes next.
  [[nodiscard]] double priority(const Candidate& goal) const {
    const double work = counted(static_cast<double>(goal.spent), goal.path ? 0 : goal.rank);
    if (best_ == nullptr) return work;
    const double dearer = goal.path ? goal.cost / best_->cost : doubt;
    double weight = 1.0;
    for (std::int64_t i = std::min(goal.spent / work_of_power, severity); i > 0; --i) {
      weight *= dearer;
    }
    return work * weight;
  }

  /// The goal whose turn it is; null: none. All goals beside the best one count as one goal,
  /// because they hardly find paths of another kind.
  [[nodiscard]] Candidate* next_candidate() {
    Candidate* next = nullptr;
    Candidate* next_beside = nullptr;
    double least = endless;
    const auto look_at = [&](Candidate& goal) {
      if (!may_win(goal)) return;
      if (goal.known) {
        if (next_beside == nullptr || goal.spent < next_beside->spent) next_beside = &goal;
        return;
      }
      const double work = priority(goal);
      if (work >= least) return;
      least = work;
      next = &goal;
    };
    for (Candidate& goal : candidates_) look_at(goal);
    const double best = best_ == nullptr ? endless : best_->cost;
    while (goals_.least_waiting() < best && counted(0.0, next_rank()) < least && join()) {
      look_at(candidates_.back());
    }
    const bool is_beside = static_cast<double>(work_beside_) + work_of_doubling < least;
    return next_beside != nullptr && is_beside ? next_beside : next;
  }

  void go_on(Candidate& goal) {
    if (is_at_start(goal)) {
      goal.path.emplace();
      goal.cost = 0.0;
      goal.is_done = true;
      note(goal);
      return;
    }
    if (!goal.search) {
      PlanOptions options = options_;
      options.budget.max_iterations.reset();
      if (options.budget.time_limit) {
        *options.budget.time_limit = std::max(*options.budget.time_limit - budget_.elapsed(), 0.0);
      }
      goal.begun = budget_.elapsed();
      const Path* const known = goal.known ? &*goal.known : nullptr;
      goal.search = task_.moving.empty()
                        ? search_with_line(goal.task, options, time_price_, known, {}, search_to_)
                        : search_to_(goal.task, options, known);
    }
    const std::int64_t done = goal.search->iterations();
    goal.is_done = !goal.search->advance(budget_.left(max_turn_iterations, 0));
    const std::int64_t work = goal.search->iterations() - done;
    budget_.spend(work);
    goal.spent += std::max<std::int64_t>(work, 1);
    if (goal.known) work_beside_ += std::max<std::int64_t>(work, 1);
    take_path(goal);
    if (options_.budget.target_gap || (goal.is_done && !goal.path)) take_proof(goal);
    const bool had_its_chance = goal.path && goal.spent > 4 * chance;
    if (had_its_chance && &goal != best_ && goal.cost > dropped * best_->cost) give_up(goal);
  }

  static void give_up(Candidate& goal) {
    goal.is_done = true;
    goal.search.reset();
  }

  [[nodiscard]] bool is_at_start(const Candidate& goal) const {
    return task_.moving.empty() && is_there(goal.task);
  }

  void take_path(Candidate& goal) {
    std::optional<std::vector<Segment>> path = goal.search->path();
    if (!path || path == goal.path) return;
    const double cost = cost_of(goal, *path);
    if (goal.path && cost >= goal.cost) return;
    goal.path = std::move(path);
    goal.cost = cost;
    note(goal);
  }

  /// Cost of a path to a goal. Among moving obstacles the drive may have to wait.
  [[nodiscard]] double cost_of(const Candidate& goal, const std::vector<Segment>& path) const {
    if (task_.moving.empty()) return pricing_.cost(path, search::ClearanceSampling::search);
    const Pricing pricing(goal.task, options_.cost, time_price_);
    return pricing.timed_cost(pricing.path_cost(path, search::ClearanceSampling::search),
                              goal.search->answer().speeds->duration);
  }

  void take_proof(Candidate& goal) {
    const PlannerAnswer answer = goal.search->answer();
    goal.is_closed = goal.is_done && answer.status == PlanStatus::no_path;
    if (goal.is_closed) goal.bound = endless;
    if (goal.is_closed && best_ == nullptr && may_be_walled_in_) {
      may_be_walled_in_ = false;
      is_walled_in_ = is_out_of_reach(task_, task_.goal_set, pricing_.rule().only_gear(), budget_);
    }
    if (task_.moving.empty()) goal.bound = std::max(goal.bound, answer.lower_bound.value_or(0.0));
  }

  void note(Candidate& goal) {
    if (best_ != nullptr && goal.cost >= best_->cost) return;
    best_ = &goal;
    if (!goal.search) {
      trace_.push_back({budget_.elapsed(), budget_.iterations(), goal.cost});
      return;
    }
    // The trace gets what the search has found since it began, if that is better than all before.
    const std::int64_t others = budget_.iterations() - goal.search->iterations();
    for (const auto& [time, iteration, cost] : goal.search->answer().anytime) {
      const CostSample sample{goal.begun + time, std::max<std::int64_t>(others, 0) + iteration,
                              cost};
      const bool is_new = trace_.empty() || sample.iteration > trace_.back().iteration;
      if (!is_new || (!trace_.empty() && task_.moving.empty() && cost >= trace_.back().cost))
        continue;
      trace_.push_back(sample);
      if (trace_.size() > 1) {
        trace_.back().time = std::max(sample.time, trace_[trace_.size() - 2].time);
      }
    }
  }

  // ---- Between the goals of a continuous region ----

  /// [5] Tries goals beside the best one, ever nearer to it. False if there are none to try.
  bool refine() {
    if (best_ == nullptr || goals_.is_single(*best_)) return false;
    if (!best_->is_done && best_->spent < chance / 4) return true;
    if (refinement_ && !is_tried(*refinement_)) return true;
    if (refinement_ && refinement_->middle == best_) {
      if (refinement_->share <= last_share) return false;
      refinement_->share /= 2;
    } else {
      const bool is_one_of_them =
          refinement_ && std::ranges::find(refinement_->tried, best_) != refinement_->tried.end();
      if (!refinement_) refinement_.emplace();
      refinement_->middle = best_;
      if (!is_one_of_them) refinement_->share = first_share;
    }
    for (Candidate* const goal : refinement_->tried) {
      if (goal != best_) give_up(*goal);
    }
    refinement_->tried.clear();
    const Path known{task_.start, *best_->path};
    for (const GoalPoint& point : beside(task_, best_->point, refinement_->share)) {
      std::optional<SetGoal> goal = goals_.at(point);
      if (!goal || goal->bound >= best_->cost) continue;
      candidates_.push_back({*std::move(goal), 0, known});
      refinement_->tried.push_back(&candidates_.back());
    }
    return true;
  }

  [[nodiscard]] bool is_tried(const Refinement& refinement) const {
    return std::ranges::all_of(refinement.tried, [this](const Candidate* goal) {
      return !may_win(*goal) || goal->spent >= std::min<std::int64_t>(chance, best_->spent) ||
             goal == best_;
    });
  }

  // ---- The end ----

  /// Lower bound of the cost of paths to all goals of the set.
  [[nodiscard]] double lower_bound() {
    if (!goals_.saw_all()) return 0.0;
    double least = goals_.bound_of_regions();
    std::size_t seen = 0;
    while (seen < candidates_.size() || (goals_.least_waiting() < least && join())) {
      const Candidate& goal = candidates_[seen++];
      if (goals_.is_single(goal)) least = std::min(least, goal.bound);
    }
    least = std::min(least, goals_.least_waiting());  // once interrupted, none joins
    // A goal that joined just now may have shown that one is left out without a proof.
    return goals_.saw_all() ? least : 0.0;
  }

  /// [6] Whether the budget is spent, or the best cost is within `target_gap` of the bound.
  [[nodiscard]] bool is_over() {
    if (is_walled_in_ || budget_.exhausted()) return true;
    const std::optional<double>& gap = options_.budget.target_gap;
    return gap && best_ != nullptr && best_->cost <= (1 + *gap) * lower_bound();
  }

  PlannerAnswer finished() {
    PlannerAnswer answer;
    if (best_ != nullptr && best_->search) answer = best_->search->answer();
    if (best_ != nullptr && !best_->search) answer.segments = best_->path;
    if (best_ == nullptr) {
      answer.status = budget_.exhausted().value_or(PlanStatus::node_limit);
      explain(answer);
      return answer;
    }
    answer.status = PlanStatus::solved;
    answer.iterations = budget_.iterations();
    answer.anytime = std::move(trace_);
    for (Candidate& goal : candidates_) {
      if (goal.search && goals_.is_single(goal) && goal.bound < best_->cost) take_proof(goal);
    }
    answer.lower_bound.reset();
    if (task_.moving.empty()) answer.lower_bound = std::min(lower_bound(), best_->cost);
    return answer;
  }

  void explain(PlannerAnswer& answer) {
    answer.iterations = budget_.iterations();
    const bool all_closed =
        std::ranges::all_of(candidates_, [](const Candidate& goal) { return goal.is_closed; });
    const bool is_open = goals_.least_waiting() < endless || !all_closed || !goals_.saw_all() ||
                         goals_.bound_of_regions() < endless;
    if (is_open && !is_walled_in_) {
      if (answer.status == PlanStatus::node_limit) answer.reason = why_none_goes_on();
      return;
    }
    answer.status = PlanStatus::no_path;
    if (is_walled_in_) {
      answer.reason = "proven: nothing gets from the start to any place of the goal";
      return;
    }
    const std::size_t closed = candidates_.size();
    answer.reason = candidates_.front().search->answer().reason;
    if (closed > 1) {
      answer.reason += "; so for all " + std::to_string(closed) + " goals that are free";
    }
  }

  /// Why no search goes on, although nothing is proven of the set.
  [[nodiscard]] std::string why_none_goes_on() const {
    for (const Candidate& goal : candidates_) {
      const std::string reason = goal.search ? goal.search->answer().reason : "";
      if (!reason.empty()) return "no search for a goal goes on; the first: " + reason;
    }
    return "no search for a goal goes on";
  }

  static constexpr std::int64_t max_turn_iterations = std::int64_t{1}
                                                      << 40;  // iterations: no limit

  const Task& task_;
  const PlanOptions& options_;
  double time_price_;
  const SearchTo& search_to_;
  Pricing pricing_;
  search::Budget budget_;
  SetGoals goals_;
  std::deque<Candidate> candidates_;
  std::size_t joined_ = 0;  // candidates that were spread out over the set
  Candidate* best_ = nullptr;
  std::int64_t work_beside_ = 0;  // work on goals beside the best one [iterations]
  bool may_be_walled_in_ = std::ranges::any_of(task_.goal_set, is_continuous);
  bool is_walled_in_ = false;  // whether it is proven that no place of the set can be reached
  std::optional<Refinement> refinement_;
  std::vector<CostSample> trace_;
};

}  // namespace

PlannerAnswer plan_to_set(const Task& task, const PlanOptions& options, double time_price,
                          const SearchTo& search_to) {
  return SetRun(task, options, time_price, search_to).answer();
}

}  // namespace vandplan::planning
