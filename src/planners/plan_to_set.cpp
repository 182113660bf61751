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

#include "planners/anytime/compose.h"
#include "planners/goal_poses.h"
#include "planners/last_stretch.h"
#include "planners/pricing.h"
#include "planners/set_bounds.h"
#include "problem/goal_set.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::planning {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// Most goals of a region that are searched for: with one interval, and with several.
constexpr std::size_t max_goals_of_line = 16;
constexpr std::size_t max_goals_of_region = 64;
constexpr std::size_t max_goals_of_set = 2048;  // most goals of all regions, but two of each
constexpr std::size_t max_open_ways = 2;  // goals tried on open ground before the first search
/// Work on the most promising goal after which twice as many goals are looked at [iterations].
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
struct Candidate {
  GoalPoint point;
  Task task;
  double bound = 0.0;              // lower bound of the cost of paths to the goal
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
        bounds_(task, options.cost, time_price),
        budget_(options.budget) {
    alone_.goal_set.clear();
    add_goals();
  }

  [[nodiscard]] PlannerAnswer answer() {
    if (candidates_.empty()) return without_goals();
    while (!is_over()) {
      Candidate* const next = next_candidate();
      if (next != nullptr) go_on(*next);
      if (!refine() && next == nullptr) break;
    }
    return finished();
  }

 private:
  // ---- The goals of the set ----

  /// [1] [2] Adds the goals of the set, in the order of their searches.
  void add_goals() {
    std::vector<Candidate> goals;
    const std::size_t regions = task_.goal_set.size();
    const std::size_t share = std::max<std::size_t>(max_goals_of_set / regions, 2);
    for (std::size_t region = 0; region < regions; ++region) {
      if (!goals.empty() && budget_.is_interrupted()) {
        saw_all_ = false;
        break;
      }
      const bool is_line = number_of_intervals(task_, region) == 1;
      const std::size_t most = std::min(is_line ? max_goals_of_line : max_goals_of_region, share);
      spread(task_, region, most, [&](const GoalPoint& point) {
        ++looked_at_;
        std::optional<Candidate> goal = candidate_at(point);
        if (goal) goals.push_back(*std::move(goal));
        return goal.has_value();
      });
    }
    std::vector<Candidate*> order;
    order.reserve(goals.size());
    for (Candidate& goal : goals) order.push_back(&goal);
    std::ranges::stable_sort(order, {}, [](const Candidate* goal) { return goal->bound; });
    const auto last = order.begin() + looks_at_open_ways(order.size());
    const auto open =
        std::find_if(order.begin(), last, [this](const Candidate* goal) { return is_open(*goal); });
    if (open != last) std::rotate(order.begin(), open, open + 1);
    for (Candidate* const goal : order) {
      goal->rank = static_cast<int>(std::bit_width(candidates_.size()));
      candidates_.push_back(std::move(*goal));
    }
  }

  /// Number of goals that are tried on open ground: 0 if searches do not begin with that.
  [[nodiscard]] std::ptrdiff_t looks_at_open_ways(std::size_t goals) const {
    const bool begins_there = !task_.vehicle.trailer && task_.moving.empty() && task_.via.empty();
    return begins_there ? static_cast<std::ptrdiff_t>(std::min(goals, max_open_ways)) : 0;
  }

  /// Whether the search for the goal has a path at once, on open ground.
  [[nodiscard]] bool is_open(const Candidate& goal) const {
    return !anytime::open_ways(before_line(goal.task), pricing_.rule()).empty();
  }

  /// The goal at a point; none if the vehicle cannot stand there, or not come there straight.
  [[nodiscard]] std::optional<Candidate> candidate_at(const GoalPoint& point) {
    const LocalState state = state_of(task_, point);
    Candidate goal{.point = point,
                   .task = problem::task_to(alone_, state, task_.goal_set[point.region].curvature,
                                            options_.clearance)};
    if (!goal.task.checker->is_free(state)) return std::nullopt;
    ++free_;
    goal.bound = bounds_.to(goal.task);
    goal.task.last_stretch = last_stretch(task_, point);
    if (goal.task.last_stretch == 0.0) return goal;
    const Task before = before_line(goal.task);
    const Segment line = line_of(goal.task);
    const bool folds = std::abs(before.hitch_angles.goal) > task_.vehicle.max_hitch_angle;
    const bool may_drive = !folds && search::may_drive(pricing_.rule(), {&line, 1});
    if (!may_drive || !before.checker->is_free(goal_state(before), line)) return std::nullopt;
    if (pricing_.counts_time()) return goal;
    const double of_line = pricing_.rule().weight(search::gear_of(line)) * std::abs(line.length);
    goal.bound = std::max(goal.bound, bounds_.to(before) + of_line);
    return goal;
  }

  /// The answer if there is no goal to search for.
  [[nodiscard]] PlannerAnswer without_goals() const {
    const std::string poses = " poses of the goal that were looked at ";
    if (free_ == 0) {
      return {.status = PlanStatus::goal_in_collision,
              .reason = "none of the " + std::to_string(looked_at_) + poses + "is free"};
    }
    const bool saw_each = saw_all_ && std::ranges::none_of(task_.goal_set, is_continuous);
    return {.status = saw_each ? PlanStatus::no_path : PlanStatus::iteration_limit,
            .reason = "before none of the " + std::to_string(looked_at_) + poses +
                      "there is a free straight last stretch"};
  }

  /// Lower bound of the cost of paths to continuous regions.
  [[nodiscard]] double bound_of_regions() {
    if (!bound_of_regions_) bound_of_regions_ = bounds_.to_regions();
    return *bound_of_regions_;
  }

  [[nodiscard]] bool is_single(const Candidate& goal) const {
    return !is_continuous(task_.goal_set[goal.point.region]);
  }

  // ---- Whose turn it is ----

  [[nodiscard]] bool may_win(const Candidate& goal) const {
    return !goal.is_done && (best_ == nullptr || &goal == best_ || goal.bound < best_->cost);
  }

  /// [3] [4] Priority of a goal; the one with the least comes next.
  [[nodiscard]] double priority(const Candidate& goal) const {
    const double joins = work_of_doubling * (goal.path ? 0 : goal.rank);
    const double work = static_cast<double>(goal.spent) + work_of_doubling + joins;
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
    for (Candidate& goal : candidates_) {
      if (!may_win(goal)) continue;
      if (goal.known) {
        if (next_beside == nullptr || goal.spent < next_beside->spent) next_beside = &goal;
        continue;
      }
      const double work = priority(goal);
      if (work >= least) continue;
      least = work;
      next = &goal;
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
                        ? search_with_line(goal.task, options, time_price_, known, search_to_)
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
    if (best_ == nullptr || is_single(*best_)) return false;
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
      std::optional<Candidate> goal = candidate_at(point);
      if (!goal || goal->bound >= best_->cost) continue;
      goal->known = known;
      candidates_.push_back(*std::move(goal));
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
    if (!saw_all_) return 0.0;
    double least = bound_of_regions();
    for (const Candidate& goal : candidates_) {
      if (is_single(goal)) least = std::min(least, goal.bound);
    }
    return least;
  }

  /// [6] Whether the budget is spent, or the best cost is within `target_gap` of the bound.
  [[nodiscard]] bool is_over() {
    if (budget_.exhausted()) return true;
    const std::optional<double>& gap = options_.budget.target_gap;
    return gap && best_ != nullptr && best_->cost <= (1 + *gap) * lower_bound();
  }

  PlannerAnswer finished() {
    PlannerAnswer answer;
    if (best_ != nullptr && best_->search) answer = best_->search->answer();
    if (best_ != nullptr && !best_->search) answer.segments = best_->path;
    if (best_ == nullptr) {
      answer.status = budget_.exhausted().value_or(PlanStatus::iteration_limit);
      explain(answer);
      return answer;
    }
    answer.status = PlanStatus::solved;
    answer.iterations = budget_.iterations();
    answer.anytime = std::move(trace_);
    for (Candidate& goal : candidates_) {
      if (goal.search && is_single(goal) && goal.bound < best_->cost) take_proof(goal);
    }
    answer.lower_bound.reset();
    if (task_.moving.empty()) answer.lower_bound = std::min(lower_bound(), best_->cost);
    return answer;
  }

  void explain(PlannerAnswer& answer) {
    answer.iterations = budget_.iterations();
    const bool all_closed =
        std::ranges::all_of(candidates_, [](const Candidate& goal) { return goal.is_closed; });
    if (!all_closed || !saw_all_ || bound_of_regions() < endless) return;
    answer.status = PlanStatus::no_path;
    const std::size_t closed = candidates_.size();
    const std::string reason = candidates_.front().search->answer().reason;
    answer.reason = reason;
    if (closed > 1)
      answer.reason += "; so for all " + std::to_string(closed) + " goals that are free";
  }

  static constexpr std::int64_t max_turn_iterations = std::int64_t{1}
                                                      << 40;  // iterations: no limit

  const Task& task_;
  Task alone_ = task_;  // the task without its set
  const PlanOptions& options_;
  double time_price_;
  const SearchTo& search_to_;
  Pricing pricing_;
  SetBounds bounds_;
  search::Budget budget_;
  std::deque<Candidate> candidates_;
  std::size_t looked_at_ = 0;  // goals looked at
  std::size_t free_ = 0;       // goals where the vehicle can stand
  bool saw_all_ = true;        // whether no region was left out for lack of time
  std::optional<double> bound_of_regions_;
  Candidate* best_ = nullptr;
  std::int64_t work_beside_ = 0;  // work on goals beside the best one [iterations]
  std::optional<Refinement> refinement_;
  std::vector<CostSample> trace_;
};

}  // namespace

PlannerAnswer plan_to_set(const Task& task, const PlanOptions& options, double time_price,
                          const SearchTo& search_to) {
  return SetRun(task, options, time_price, search_to).answer();
}

SearchTo restarted_search(std::function<PlannerAnswer(const Task&, const PlanOptions&)> planner) {
  return [planner = std::move(planner)](const Task& task, const PlanOptions& options,
                                        const Path* /*known*/) {
    return restarted([&task, planner](const PlanOptions& round) { return planner(task, round); },
                     options);
  };
}

}  // namespace vandplan::planning
