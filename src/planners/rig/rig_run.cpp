// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/rig_run.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <string>
#include <utility>

#include "planners/commands/short_strokes.h"
#include "planners/rig/behind_tractor.h"
#include "planners/rig/room_for_margin.h"
#include "planners/rig/softer_wheels.h"
#include "planners/rig/towed.h"
#include "vandplan/random.h"

namespace vandplan::rig {
namespace {

using namespace search;

constexpr double rounding = 1e-9;      // relative rounding of the bound
constexpr double worth_a_trial = 1.3;  // a route may cost so many times the best drive

/// Settings of a search, for ways that are open, narrow or full of turns.
struct Kind {
  double step, weight;
  int levels;
  int share;  ///< share of the expansions, relative to other searches
};
constexpr std::array<Kind, 7> kinds = {{{3, 8, 1, 1},
                                        {2.2, 8, 2, 1},
                                        {1.5, 8, 4, 1},
                                        {1, 1.7, 1, 3},
                                        {3, 8, 1, 1},
                                        {2.2, 8, 2, 1},
                                        {1.5, 8, 4, 1}}};
/// Index of the search that hardly reverses until there is a drive.
constexpr std::size_t forward_kind = 4;
constexpr std::size_t bare_kinds = 5;  // index of the first search without the margin

/// Trials between two checks whether a drive may become the best one.
constexpr int trials_of_look = 128;
/// A drive is given up if so many times its last gain would not make it the best one.
constexpr double hope = 6.0;

/// Prices of the searches for the first drive, whatever the prices in force.
CostRule helpful_rule(const CostOptions& cost) {
  CostOptions options = driver_style;
  options.initial_gear = cost.initial_gear;
  options.gears = cost.gears;
  return cost_rule(options);
}

/// Prices that lead to other kinds of drive: they hardly reverse.
CostRule forward_rule(const CostOptions& cost) {
  CostOptions options = driver_style;
  options.initial_gear = cost.initial_gear;
  options.gears = cost.gears;
  options.reverse_weight = 1000.0;
  options.gear_change_cost = 100.0;
  return cost_rule(options);
}

}  // namespace

Run::Run(const Task& task, const PlanOptions& options, const planning::Pricing& pricing)
    : task_(task),
      tasks_(pricing.counts_time() ? with_softer_wheels(task) : std::deque<Task>{task}),
      options_(options),
      pricing_(pricing),
      min_stroke_(options.planner.number("min_stroke")),
      budget_(options.budget),
      rules_{pricing.rule(), helpful_rule(options.cost), pricing.rule(),
             forward_rule(options.cost)},
      unit_(search_unit(task.vehicle)),
      bare_(without_margin(task, options.clearance.margin)),
      guides_(task),
      towed_(towed_task(task)),
      bound_(least_cost(task, pricing)),
      least_(least_cost(task, pricing, Ends::exact)) {}

bool Run::is_good_enough() const {
  const double gap = options_.budget.target_gap.value_or(0.0);
  return best_ && best_wanted_ <= std::max(bound_ * (1 + gap), least_ * (1 + rounding));
}

double Run::time_left() const {
  return std::max(options_.budget.time_limit.value_or(0.0) - budget_.elapsed(), 0.0);
}

/// Begins a search in place of one that has ended or found a drive. It is finer each time. Before
/// the first drive searches have helpful prices; then each has all prices in turn.
void Run::begin(Search& search) {
  const auto kind = static_cast<std::size_t>(&search - searches_.data());
  const auto& [step, weight, levels, share] = kinds[kind];
  const int round = search.rounds++;
  constexpr int most_rounds = 16;
  constexpr double finer = 0.7;
  const int finest = std::min(round, most_rounds);
  const std::size_t first_rule = kind == forward_kind ? 3 : 1;
  const std::size_t later = pricing_.counts_time() ? 0 : (static_cast<std::size_t>(round) + kind);
  const std::size_t rule = best_ ? later % rules_.size() : first_rule;
  search.task = best_ ? (kind + static_cast<std::size_t>(round)) % tasks_.size() : 0;
  search.is_of_prices = rule % 2 == 0;
  search.is_bare = kind >= bare_kinds;
  search.now.emplace(
      search.is_bare ? *bare_ : tasks_[search.task], rules_[rule], guides_,
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

/// Works for a while on proofs that tractor or trailer cannot get there, unless there is a drive.
void Run::look_for_walls() {
  if (best_) return;
  for (Enclosure* enclosure : {&tractor_, &trailer_}) {
    for (int i = 0; i < share_ && !budget_.is_interrupted() && enclosure->step(); ++i) {
    }
  }
}

/// Where the way is far, [1] comes before the searches, which take long there.
void Run::begin() {
  constexpr double far = 12;  // distance that is far [turning radii]
  constexpr std::int64_t work_of_far_way = 1000;
  const double apart = std::hypot(task_.goal.x - task_.start.x, task_.goal.y - task_.start.y);
  if (apart > far * turning_radius(task_.vehicle)) follow_tractor(work_of_far_way);
}

/// [2] Does some expansions of a search, and takes a drive that it finds.
void Run::turn(Search& search, int expansions) {
  if (!search.now) begin(search);
  if (best_ && search.is_of_prices) search.now->set_cutoff(cutoff());
  while (expansions-- > 0 && budget_.next()) {
    const bool goes_on = search.now->step();
    std::optional<std::vector<Segment>> found = search.now->take_found();
    if (goes_on && !found) continue;
    end(search);
    if (found && search.is_bare) widen(*found);
    if (found && !search.is_bare) take(std::move(*found), search.task);
    return;
  }
}

/// [1] Plans another path of the tractor and follows it.
void Run::follow_tractor(std::int64_t work) {
  constexpr std::array radii = {1.3, 1.05, 1.6};
  constexpr std::array reverse_weights = {20.0, 2.0};
  const auto turn = static_cast<std::size_t>(follows_++);
  const TractorTerms terms{.radius = radii[turn % radii.size()] * turning_radius(task_.vehicle),
                           .reverse_weight = reverse_weights[turn / 2 % reverse_weights.size()],
                           .distance = 0.4 * task_.vehicle.trailer->wheelbase,
                           .iterations = work,
                           .expansions = work,
                           .seed = stream_seed(options_.budget.seed, turn)};
  const auto drive = drive_behind_tractor(task_, options_, terms, budget_);
  if (drive) take(*drive, 0);
}

bool Run::search() {
  for (std::size_t i = 0; i < kinds.size() && !is_over(); ++i) {
    if (i >= bare_kinds && (best_ || !bare_)) break;
    const bool had_drive = best_.has_value();
    turn(searches_[i], share_ * kinds[i].share);
    if (!had_drive && best_) break;  // the other searches have not had the prices in force
  }
  const bool tries_others = !pricing_.counts_time() || !best_;  // by time a trial takes long
  if (tries_others && !is_over()) follow_tractor(share_);
  if (tries_others && !is_over()) polish();
  look_for_walls();
  share_ = std::min(2 * share_, most_share);
  return !is_over();
}

/// Measure that drives are compared by; none where the cost is a sum over segments. A metre that
/// strokes are too short costs more than any detour.
commands::DriveShortener::Measure Run::measure() const {
  if (!pricing_.counts_time() && min_stroke_ == 0.0) return {};
  return [this](std::span<const Segment> segments) {
    return pricing_.cost(segments, Looks::search) + commands::price_of_lack(segments, min_stroke_);
  };
}

/// Price from which on searches ignore routes.
double Run::cutoff() const {
  if (!pricing_.counts_time()) return best_wanted_;
  Driven driven = pricing_.rule().initial_gear;
  return worth_a_trial * drive_cost(pricing_.rule(), *best_, driven);
}

void Run::keep(const DriveShortener& drive, std::size_t task) {
  if (best_ && drive.cost() >= best_wanted_) return;
  best_ = drive.segments();
  best_commands_ = drive.commands();
  best_with_ = task;
  best_wanted_ = drive.cost();
  best_cost_ = best_wanted_ - commands::price_of_lack(*best_, min_stroke_);
  note_cost();
}

/// Adds the cost of the best drive to the trace. A drive with longer strokes may cost more than the
/// one before.
void Run::note_cost() {
  std::erase_if(trace_, [&](const CostSample& sample) { return sample.cost <= best_cost_; });
  trace_.push_back({budget_.elapsed(), budget_.iterations(), best_cost_});
}

/// [4] Makes a drive cheaper as long as it is the best one or may become it.
void Run::shorten(DriveShortener& drive, std::size_t task) {
  keep(drive, task);
  double before = drive.cost();
  for (int trial = 1; !drive.is_stalled() && !is_good_enough() && budget_.next(); ++trial) {
    ++trials_;
    if (drive.step()) keep(drive, task);
    if (pricing_.counts_time() || trial % trials_of_look != 0) continue;
    const double gain = before - drive.cost();
    if (drive.cost() - hope * gain > best_wanted_) break;
    before = drive.cost();
  }
  checks_ += drive.checks();
}

/// Takes a drive that the wheels of task `with` obey, and shortens it with these wheels, then with
/// softer ones. The drive is kept even if the budget is spent.
void Run::take(std::vector<Segment> commands, std::size_t with) {
  for (std::size_t i = with; i < tasks_.size() && (i == with || !budget_.exhausted()); ++i) {
    const Task& task = tasks_[i];
    std::optional<std::vector<Segment>> chain = commands;
    if (i != with) chain = commands::obeyed(task, std::move(commands));
    if (!chain) return;
    DriveShortener drive(task, pricing_.rule(), *chain,
                         stream_seed(options_.budget.seed, shortened_++), measure());
    shorten(drive, i);
    commands = drive.commands();
  }
}

/// [2] Moves a drive that is free without the margin away from obstacles, until it keeps the
/// margin.
void Run::widen(const std::vector<Segment>& commands) {
  const CostRule rule = rule_of_room(options_.clearance.margin);
  DriveShortener drive(*bare_, rule, commands, stream_seed(options_.budget.seed, shortened_++));
  while (!drive.is_stalled() && budget_.next()) {
    ++trials_;
    if (!drive.step()) continue;
    std::optional<std::vector<Segment>> chain = commands::obeyed(task_, drive.commands());
    if (!chain) continue;
    take(*std::move(chain), 0);
    break;
  }
  checks_ += drive.checks();
  if (best_ || (!roomiest_.empty() && drive.cost() >= lack_)) return;
  roomiest_ = drive.commands();
  lack_ = drive.cost();
}

void Run::take_from(const Run& stricter, std::int64_t iterations) {
  budget_.spend(budget_.left(iterations, 0));
  if (!stricter.best_ || stricter.best_wanted_ >= best_wanted_) return;
  best_ = stricter.best_;
  best_commands_.clear();  // the stricter run shortens it again
  best_wanted_ = stricter.best_wanted_;
  best_cost_ = stricter.best_cost_;
  note_cost();
}

/// [5] Shortens the best drive again. If there is none, moves the roomiest drive away from
/// obstacles.
void Run::polish() {
  if (best_ && !best_commands_.empty()) take(best_commands_, best_with_);
  if (!best_ && !roomiest_.empty()) widen(std::vector(roomiest_));
}

PlannerAnswer Run::answer() {
  for (Search& search : searches_) end(search);
  PlannerAnswer answer;
  answer.status = best_ ? PlanStatus::solved : budget_.exhausted().value_or(PlanStatus::stopped);
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

}  // namespace vandplan::rig
