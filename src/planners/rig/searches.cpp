// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/searches.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "vandplan/random.h"

namespace vandplan::rig {

using search::CostRule;

namespace {

/// A route may cost so many times the best drive, if time counts.
constexpr double worth_a_trial = 1.3;
/// A search has a step that is so many times the step of the one before, for some searches.
constexpr double finer = 0.7;
constexpr std::size_t finer_rounds = 6;  // searches of a cycle, after which steps are large again
/// Shift of the steps from one cycle to the next [searches]. Multiples of the golden ratio spread
/// evenly, so no step comes again: a search with the same step would find the same drive.
constexpr double shift_of_cycle = 0.618;
constexpr std::size_t most_rounds = 16;  // searches after which they grow no more
constexpr double first_nodes = 40000.0;  // nodes at which the first search of a line ends

/// Settings of the searches without the margin.
constexpr std::array<LineSettings, 2> bare_kinds = {
    {{2.2, 8, 2, 128, 1, 0}, {1.5, 8, 4, 128, 1, 0}}};
/// Expansions until the roomiest drive is moved again.
constexpr std::int64_t expansions_until_another_try = 1024;

/// A driver's prices, whatever the prices in force.
CostOptions helpful_prices(const CostOptions& cost) {
  CostOptions options = driver_style;
  options.initial_gear = cost.initial_gear;
  options.gears = cost.gears;
  return options;
}

/// Rule whose cost is how far, and on how many metres, a drive is nearer to obstacles than the
/// margin; the length hardly counts.
CostRule rule_of_room(double margin) {
  constexpr double price = 1000.0;  // weight beside which the length is small
  constexpr double least = 0.01;    // least clearance distance of the rule [m]
  CostOptions options = shortest_style;
  options.clearance_weight = price;
  options.clearance_distance = std::max(margin + 2 * CollisionChecker::tolerance, least);
  return search::cost_rule(options);
}

}  // namespace

Searches::Searches(std::shared_ptr<const Setting> setting, std::span<const LineSettings> kinds,
                   std::vector<const Task*> tasks)
    : setting_(std::move(setting)),
      rules_{setting_->pricing.rule(), search::cost_rule(helpful_prices(setting_->options.cost))},
      tasks_(std::move(tasks)) {
  for (const LineSettings& kind : kinds) lines_.push_back({.kind = kind});
  std::ranges::transform(rules_, forward_rules_.begin(), [](const CostRule& rule) {
    return search::restricted(rule, AllowedGears::forward);
  });
}

// Begins a search in place of one that has ended or found a drive. It is finer each time. Until one
// of the lines has found a drive they have helpful prices, so that they find drives of other kinds
// than other workers do. Then they have all prices in turn.
void Searches::begin(Line& line) {
  const std::size_t round = line.round++, shift = round + line.kind.first_turn;
  const std::size_t later = setting_->pricing.counts_time() ? 0 : shift % rules_.size();
  const std::size_t rule = has_found_ ? later : line.kind.first_price;
  line.task = has_found_ ? shift % tasks_.size() : 0;
  line.has_prices_in_force = rule == 0;
  const std::size_t grown = std::min(round, most_rounds);
  const std::size_t cycles = round / finer_rounds;
  const double cycle = shift_of_cycle * static_cast<double>(cycles);
  const double exponent = static_cast<double>(round % finer_rounds) + cycle - std::floor(cycle);
  const double step = line.kind.step * std::pow(finer, exponent);
  const bool is_forward = line.kind.is_forward && setting_->pricing.rule().allows_both();
  line.search.emplace(
      *tasks_[line.task], is_forward ? forward_rules_[rule] : rules_[rule], setting_->guides,
      Fineness{.step = setting_->unit * step,
               .weight = round % 2 == 0 ? line.kind.weight : 1 + line.kind.weight / 4,
               .levels = line.kind.levels,
               .most_nodes = static_cast<std::size_t>(
                   first_nodes * std::exp2(0.5 * static_cast<double>(grown)))});
  if (line.has_prices_in_force) line.search->set_cutoff(cutoff_);
}

void Searches::end(Line& line) {
  former_.checks += line.search->checks();
  former_.solves += line.search->solves();
  line.search.reset();
}

// [2] Expands states, line by line.
anytime::Found Searches::work(std::int64_t most, const search::Budget& budget) {
  anytime::Found found;
  std::int64_t& steps = found.iterations;
  while (steps < most && !found.drive && (steps == 0 || !budget.is_interrupted())) {
    Line& line = lines_[turn_];
    if (!line.search) begin(line);
    const bool goes_on = line.search->step();
    ++steps;
    std::optional<std::vector<Command>> commands = line.search->take_found();
    if (!goes_on || commands) end(line);
    if (commands) {
      has_found_ = true;
      found.drive = anytime::Drive{.commands = *std::move(commands), .wheels = line.task};
    }
    if (++done_ < line.kind.share) continue;
    done_ = 0;
    turn_ = (turn_ + 1) % lines_.size();
  }
  return found;
}

void Searches::hear(const anytime::Drive& best) {
  cutoff_ = best.cost;
  if (setting_->pricing.counts_time()) {
    cutoff_ = worth_a_trial * search::drive_cost(setting_->pricing.rule(), best.segments);
  }
  for (Line& line : lines_) {
    if (line.search && line.has_prices_in_force) line.search->set_cutoff(cutoff_);
  }
}

anytime::Counts Searches::counts() const {
  anytime::Counts counts = former_;
  for (const Line& line : lines_) {
    if (!line.search) continue;
    counts.checks += line.search->checks();
    counts.solves += line.search->solves();
    counts.nodes += line.search->nodes();
  }
  return counts;
}

BareSearches::BareSearches(std::shared_ptr<const Setting> setting, std::uint64_t seed)
    : setting_(setting),
      searches_(setting, bare_kinds, {&*setting->bare}),
      rule_(rule_of_room(setting->options.clearance.margin)),
      seed_(seed) {}

void BareSearches::begin(std::span<const Command> commands) {
  if (widened_) checks_ += widened_->checks();
  widened_.emplace(*setting_->bare, rule_, commands, stream_seed(seed_, begun_++));
}

// [2] Moves the drive away from obstacles by one trial. The commands when it keeps the margin.
std::optional<anytime::Drive> BareSearches::widen() {
  std::optional<anytime::Drive> found;
  if (widened_->step()) {
    std::optional<std::vector<Command>> commands =
        commands::obeyed(setting_->task, widened_->commands());
    if (commands) found = anytime::Drive{.commands = *std::move(commands)};
  }
  if (!found && !widened_->is_stalled()) return found;
  if (!found && (roomiest_.empty() || widened_->cost() < lack_)) {
    roomiest_ = widened_->commands();
    lack_ = widened_->cost();
  }
  checks_ += widened_->checks();
  widened_.reset();
  searched_ = 0;
  return found;
}

anytime::Found BareSearches::work(std::int64_t most, const search::Budget& budget) {
  if (!widened_ && !roomiest_.empty() && searched_ >= expansions_until_another_try) {
    begin(roomiest_);
  }
  if (!widened_) {
    const anytime::Found bare = searches_.work(most, budget);
    searched_ += bare.iterations;
    if (bare.drive) begin(bare.drive->commands);
    return {.iterations = bare.iterations};
  }
  anytime::Found found;
  std::int64_t& steps = found.iterations;
  for (; steps < most && widened_ && (steps == 0 || !budget.is_interrupted()); ++steps) {
    found.drive = widen();
  }
  return found;
}

anytime::Counts BareSearches::counts() const {
  anytime::Counts counts = searches_.counts();
  counts.checks += checks_ + (widened_ ? widened_->checks() : 0);
  return counts;
}

}  // namespace vandplan::rig
