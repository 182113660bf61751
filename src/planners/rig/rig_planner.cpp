// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/rig_planner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "planners/commands/shorten_drive.h"
#include "planners/rig/rig_search.h"
#include "planners/rig/softer_wheels.h"
#include "planners/rig/towed.h"
#include "search/enclosure.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan::rig {
namespace {

using namespace search;

constexpr double rounding = 1e-9;      // of the bound, relative
constexpr double worth_a_trial = 1.3;  // price of a route beside that of the best drive
constexpr double price_of_lack = 1e3;  // of a metre that strokes are too short [m or s]

/// A way to look, for what is open, narrow or full of turns.
struct Kind {
  double step, weight;
  int levels;
  int share;  ///< of the expansions, beside others
};
constexpr std::array<Kind, 4> kinds = {
    {{3, 8, 1, 1}, {2.2, 8, 2, 1}, {1.5, 8, 4, 1}, {1, 1.7, 1, 3}}};

/// By how much the strokes before and after gear changes are shorter than `least`, in all [m].
double missing(std::span<const Segment> segments, double least) {
  double sum = 0.0;
  double stroke = 0.0;
  bool changes_gear = false;
  for (const Segment& segment : segments) {
    if (segment.length * stroke < 0.0) {
      sum += std::max(0.0, least - std::abs(stroke));
      stroke = 0.0;
      changes_gear = true;
    }
    stroke += segment.length;
  }
  return changes_gear ? sum + std::max(0.0, least - std::abs(stroke)) : 0.0;
}

/// What came of a run so far.
class Run {
 public:
  Run(const Task& task, const PlanOptions& options, const planning::Pricing& pricing)
      : task_(task),
        tasks_(pricing.counts_time() ? with_softer_wheels(task) : std::deque<Task>{task}),
        options_(options),
        pricing_(pricing),
        min_stroke_(options.planner.number("min_stroke")),
        budget_(options.budget),
        unit_(0.3 * std::sqrt(turning_radius(task.vehicle) * task.vehicle.trailer->wheelbase)),
        guides_(task),
        towed_(towed_task(task)),
        bound_(least_cost(task, pricing)) {}

  /// Searches for a drive, in several ways by turns. False when the budget is spent.
  bool search();
  /// Proven: the tractor or the trailer cannot get from the start to the goal.
  [[nodiscard]] bool is_walled_in() const { return tractor_.is_proven() || trailer_.is_proven(); }
  /// Makes a drive cheaper until that brings next to nothing. False when the budget is spent.
  bool shorten();
  [[nodiscard]] PlannerAnswer answer();

 private:
  static constexpr int first_share = 128, most_share = 1 << 14;
  /// One of the ways to search.
  struct Search {
    std::optional<RigSearch> now;
    int rounds = 0;
    std::size_t task = 0;  // whose wheels it looks with
  };

  void look_for_walls();
  void begin(Search& search);
  void end(Search& search);
  [[nodiscard]] double cutoff() const;
  void keep(const std::vector<Segment>& segments, double wanted);
  [[nodiscard]] commands::DriveShortener::Measure measure() const;
  [[nodiscard]] bool is_good_enough() const {
    const double gap = options_.budget.target_gap.value_or(0.0);
    return best_ && best_wanted_ <= bound_ * (1 + std::max(gap, rounding));
  }

  const Task& task_;
  const std::deque<Task> tasks_;  // the task, and where time counts with softer wheels
  const PlanOptions& options_;
  const planning::Pricing& pricing_;
  double min_stroke_;  // that is asked for [m]
  Budget budget_;
  double unit_;  // of the steps of a search [m]
  Guides guides_;
  std::array<Search, kinds.size()> searches_;
  std::size_t turn_ = 0;     // of a search
  int share_ = first_share;  // of expansions, which grows
  int left_ = first_share;
  Task towed_;
  Enclosure tractor_{task_}, trailer_{towed_};
  double bound_;                               // no drive costs less [m]
  std::optional<std::vector<Segment>> found_;  // commands
  std::size_t found_with_ = 0;                 // task whose wheels obey them
  std::optional<std::vector<Segment>> best_;   // what is driven
  double best_cost_ = 0.0;
  double best_wanted_ = 0.0;  // its cost, and more where strokes are shorter than is asked for
  std::vector<CostSample> trace_;
  std::int64_t nodes_ = 0, checks_ = 0, closings_ = 0, bridges_ = 0, trials_ = 0;
  std::uint64_t shortened_ = 0;
};

/// A search that is at its end, or has found something, makes way for a finer one of its kind.
void Run::begin(Search& search) {
  const auto kind = static_cast<std::size_t>(&search - searches_.data());
  const auto& [step, weight, levels, share] = kinds[kind];
  const int round = search.rounds++;
  search.task = best_ ? (kind + static_cast<std::size_t>(round)) % tasks_.size() : 0;
  constexpr int most_rounds = 16;
  constexpr double finer = 0.7;
  const int finest = std::min(round, most_rounds);
  search.now.emplace(
      tasks_[search.task], pricing_.rule(), guides_,
      Fineness{.step = unit_ * step * std::pow(finer, finest % 6),
               .weight = round % 2 == 0 ? weight : 1 + weight / 4,
               .levels = levels,
               .most_nodes = static_cast<std::size_t>(40000 * std::exp2(0.5 * finest))});
}

void Run::end(Search& search) {
  if (!search.now) return;
  nodes_ += search.now->nodes();
  checks_ += search.now->checks();
  closings_ += search.now->closings();
  bridges_ += search.now->bridges();
  search.now.reset();
}

/// A while for each of both bodies; whoever has a path needs no proof that there is none.
void Run::look_for_walls() {
  if (best_) return;
  for (Enclosure* enclosure : {&tractor_, &trailer_}) {
    for (int i = 0; i < share_ && !budget_.is_interrupted() && enclosure->step(); ++i) {
    }
  }
}

bool Run::search() {
  while (!found_) {
    Search& search = searches_[turn_];
    if (!search.now) begin(search);
    if (best_) search.now->set_cutoff(cutoff());
    bool goes_on = true;
    for (; left_ > 0 && goes_on && !found_ && budget_.next(); --left_) {
      goes_on = search.now->step();
      found_ = search.now->take_found();
      found_with_ = search.task;
    }
    if (!goes_on || found_) end(search);
    if (budget_.exhausted()) break;
    if (left_ > 0 && !found_) continue;
    turn_ = (turn_ + 1) % kinds.size();
    if (turn_ == 0) {
      look_for_walls();
      if (is_walled_in()) break;
      share_ = std::min(2 * share_, most_share);
    }
    left_ = share_ * kinds[turn_].share;
  }
  return !budget_.exhausted() && !is_walled_in();
}

/// Measure that drives are compared by; none where the cost is a sum over segments. A metre that
/// strokes are too short costs more than any detour.
commands::DriveShortener::Measure Run::measure() const {
  if (!pricing_.counts_time() && min_stroke_ == 0.0) return {};
  return [this](std::span<const Segment> segments) {
    return pricing_.cost(segments, Looks::search) + price_of_lack * missing(segments, min_stroke_);
  };
}

/// From what price on routes are of no interest to a search.
double Run::cutoff() const {
  if (!pricing_.counts_time()) return best_wanted_;
  Driven driven = pricing_.rule().initial_gear;
  return worth_a_trial * drive_cost(pricing_.rule(), *best_, driven);
}

void Run::keep(const std::vector<Segment>& segments, double wanted) {
  if (best_ && wanted >= best_wanted_) return;
  best_ = segments;
  best_wanted_ = wanted;
  best_cost_ = wanted - price_of_lack * missing(segments, min_stroke_);
  // A drive with longer strokes may cost more than the one before.
  std::erase_if(trace_, [&](const CostSample& sample) { return sample.cost <= best_cost_; });
  trace_.push_back({budget_.elapsed(), budget_.iterations(), best_cost_});
}

bool Run::shorten() {
  if (!found_) return !budget_.exhausted();
  std::vector<Segment> commands = *std::exchange(found_, std::nullopt);
  for (std::size_t i = found_with_; i < tasks_.size() && !budget_.exhausted(); ++i) {
    const Task& task = tasks_[i];
    std::optional<std::vector<Segment>> chain = commands;
    if (i != found_with_) chain = obeyed(task, std::move(commands));
    if (!chain) break;
    DriveShortener shortener(task, pricing_.rule(), *chain,
                             stream_seed(options_.budget.seed, shortened_++), measure());
    keep(shortener.segments(), shortener.cost());
    while (!shortener.is_stalled() && !is_good_enough() && budget_.next()) {
      ++trials_;
      if (shortener.step()) keep(shortener.segments(), shortener.cost());
    }
    checks_ += shortener.checks();
    commands = shortener.commands();
  }
  return !budget_.exhausted() && !is_good_enough();
}

PlannerAnswer Run::answer() {
  for (Search& search : searches_) end(search);
  PlannerAnswer answer;
  answer.status = best_ ? PlanStatus::solved : budget_.reason();
  if (!best_ && is_walled_in()) {
    answer.status = PlanStatus::no_path;
    answer.reason = std::string("proven: nothing as wide as the ") +
                    (tractor_.is_proven() ? "vehicle" : "trailer") +
                    " gets from the start to the goal";
  }
  answer.segments = std::move(best_);
  answer.lower_bound = answer.segments ? std::min(bound_ * (1 - rounding), best_cost_) : 0.0;
  answer.iterations = budget_.iterations();
  answer.anytime = std::move(trace_);
  answer.counters = {{"nodes", nodes_},
                     {"edge_checks", checks_},
                     {"closings", closings_},
                     {"bridges", bridges_},
                     {"trials", trials_}};
  return answer;
}

}  // namespace

// Searches from both ends look for each other, and what they find is made exact and then cheaper:
//
//   until the budget is spent, or it is proven that there is no path:
//   [1]   search, forward from the start and back from the goal, until exact steering joins two
//         states or two of them are near: a drive by way of both is bent until it ends at the goal
//   [2]   change a few segments at random and close the gap; keep what is cheaper and free
PlannerAnswer plan_rig(const Task& task, const PlanOptions& options,
                       const planning::Pricing& pricing) {
  Run run(task, options, pricing);
  while (run.search() && run.shorten()) {
  }
  return run.answer();
}

}  // namespace vandplan::rig
