// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/behind_tractor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "planners/anytime/compose.h"
#include "planners/rig/rig_search.h"
#include "sites/way.h"
#include "vandplan/random.h"
#include "vandplan/vehicle.h"

namespace vandplan::rig {
namespace {

using search::Budget;

constexpr int most_widenings = 6;           // times that searched parts are widened
constexpr std::int64_t most_of_part = 400;  // most expansions of one search
constexpr std::size_t most_parts = 32;      // most parts of the path that one search replaces
/// Share of its limit to which the hitch angle is set where the trailer would fold up.
constexpr double fold_kept = 0.5;

/// How one path after the other is planned.
struct Manner {
  double radius;    ///< least turning radius of the tractor [turning radii of the rig]
  bool is_forward;  ///< whether the path is planned and followed in forward gear alone
};
/// Without the forward one, drives that back up a little would keep out longer ones that never do.
constexpr std::array<Manner, 3> manners = {{{1.3, false}, {1.05, false}, {1.6, true}}};
/// Prices of a metre in reverse: of the first paths, of the next ones, and so on [m].
constexpr std::array reverse_weights = {20.0, 2.0};
/// Clearance below which metres of a path cost more [wheelbases of the trailer].
constexpr double roomy = 0.4;
constexpr std::int64_t first_later_work = 128, most_later_work = 1 << 14;

/// The task of the tractor without its trailer.
Task tractor_task(const Task& task, double radius) {
  Task alone = task;
  alone.vehicle.trailer.reset();
  alone.vehicle.min_turning_radius = std::max(radius, task.vehicle.min_turning_radius);
  alone.hitch_angles = {};
  if (task.steering != Steering::reeds_shepp) alone.steering = Steering::continuous;
  const double sharpest = 1 / alone.vehicle.min_turning_radius;
  alone.curvatures.start = std::clamp(task.curvatures.start, -sharpest, sharpest);
  alone.curvatures.goal = std::clamp(task.curvatures.goal, -sharpest, sharpest);
  alone.checker = task.world->checker(alone.vehicle, {.wanted = task.least_margin});
  return alone;
}

}  // namespace

class Follower {
 public:
  Follower(const Task& task, const search::CostRule& rule, std::span<const Segment> way);

  /// Expands a state of the search that replaces a part. False when nothing is left to do.
  bool step();
  /// A free drive of the rig; none if none was found.
  [[nodiscard]] std::optional<std::vector<Segment>> drive() const;
  [[nodiscard]] std::int64_t checks() const { return checks_; }

 private:
  /// Parts [first, second) of the path.
  using Parts = std::pair<std::size_t, std::size_t>;
  /// Search for a drive that replaces parts.
  struct Replacing {
    Replacing(Task of, const search::CostRule& rule, double unit)
        : task(std::move(of)),
          guides(task),
          search(task, rule, guides, {.step = 2.2 * unit, .weight = 8, .levels = 2}) {}

    Task task;
    Guides guides;
    RigSearch search;
    std::int64_t left = most_of_part;  // expansions left
  };

  [[nodiscard]] std::optional<Parts> next_unsolved() const;
  bool begin(const Parts& parts);
  bool widen();

  const Task& task_;
  search::CostRule rule_;           // prices of the searches
  double unit_;                     // unit of the steps of a search [m]
  std::vector<Segment> way_;        // path of the tractor, cut into parts
  std::vector<State> states_;       // states of the rig before each part, and at the goal
  std::vector<double> curvatures_;  // curvatures before each part, and at the goal
  std::vector<bool> is_free_;       // whether the rig can drive each part freely
  std::map<Parts, std::vector<Segment>> solved_;  // drives that replace parts
  std::optional<Parts> parts_;                    // parts that the search at hand replaces
  std::unique_ptr<Replacing> replacing_;          // the search at hand; null: none
  int widenings_ = 0;
  std::size_t by_ = 2;  // parts on either side by which parts are widened next
  bool is_over_ = false;
  std::int64_t checks_ = 0;
};

Follower::Follower(const Task& task, const search::CostRule& rule, std::span<const Segment> way)
    : task_(task), rule_(rule), unit_(search_unit(task.vehicle)) {
  const double most = 2 * unit_;
  for (const Segment& segment : way) {
    const double size = std::abs(segment.length);
    const int parts = std::max(1, static_cast<int>(std::ceil(size / most)));
    for (int i = 0; i < parts; ++i) {
      way_.push_back(part_of(segment, size * i / parts, size * (i + 1) / parts));
    }
  }
  State state = start_state(task);
  for (const Segment& part : way_) {
    states_.push_back(state);
    curvatures_.push_back(part.curvature);
    const bool is_forward = part.length > 0.0;
    State next = advance(task.vehicle, state, part);
    const double fold = largest_hitch_angle(task.vehicle, state.hitch_angle, part);
    const bool folds = fold > task.vehicle.max_hitch_angle;
    is_free_.push_back(is_forward && !folds && task.checker->is_free(Local(state), part));
    if (!is_forward) next.hitch_angle = 0.0;
    if (folds && is_forward) {
      next.hitch_angle = std::copysign(fold_kept * task.vehicle.max_hitch_angle, next.hitch_angle);
    }
    state = next;
  }
  states_.push_back(goal_state(task));
  curvatures_.push_back(task.curvatures.goal);
  curvatures_.front() = task.curvatures.start;
  if (!is_free_.empty()) is_free_.back() = false;
  if (!is_free_.empty() && way_.front().curvature != task.curvatures.start &&
      task.steering == Steering::continuous) {
    is_free_.front() = false;
  }
}

std::optional<Follower::Parts> Follower::next_unsolved() const {
  for (std::size_t i = 0; i < is_free_.size(); ++i) {
    if (is_free_[i]) continue;
    std::size_t end = i;
    while (end < is_free_.size() && !is_free_[end]) ++end;
    if (!solved_.contains({i, end})) return Parts{i, end};
    i = end;
  }
  return std::nullopt;
}

// Begins a search from the state before some parts to the state behind them. False if the rig hits
// something at one of them.
bool Follower::begin(const Parts& parts) {
  const auto [first, last] = parts;
  Task task = task_;
  task.start = Local(states_[first].pose);
  task.goal = Local(states_[last].pose);
  task.hitch_angles = {states_[first].hitch_angle, states_[last].hitch_angle};
  task.curvatures = {curvatures_[first], curvatures_[last]};
  if (task.steering != Steering::reeds_shepp) task.steering = Steering::continuous;
  if (!task.checker->is_free(Local(states_[first])) ||
      !task.checker->is_free(Local(states_[last]))) {
    return false;
  }
  replacing_ = std::make_unique<Replacing>(std::move(task), rule_, unit_);
  return true;
}

// Lets the search replace more of the path. False if that has been tried often enough.
bool Follower::widen() {
  const auto [begin, end] = *parts_;
  const bool is_whole = end - begin == way_.size();
  if (is_whole || ++widenings_ > most_widenings) return false;
  const std::size_t first = begin - std::min(begin, by_);
  const std::size_t last = std::min(is_free_.size(), end + by_);
  for (std::size_t i = first; i < last; ++i) is_free_[i] = false;
  by_ *= 2;
  return true;
}

bool Follower::step() {
  if (is_over_) return false;
  if (!replacing_) {
    parts_ = next_unsolved();
    const bool is_solvable = parts_ && parts_->second - parts_->first <= most_parts;
    if (!is_solvable || (!begin(*parts_) && !widen())) is_over_ = true;
    return !is_over_;
  }
  const bool goes_on = replacing_->search.step() && --replacing_->left > 0;
  const auto found = replacing_->search.take_found();
  if (goes_on && !found) return true;
  if (found) {
    const search::DrivenBeside ends = search::driven_at_ends(replacing_->task);
    const commands::Wheels wheels(task_.vehicle, replacing_->task.steering);
    solved_[*parts_] = wheels.driven(*found, ends.before);
  }
  checks_ += replacing_->search.checks();
  replacing_.reset();
  if (!found && !widen()) is_over_ = true;
  return !is_over_;
}

std::optional<std::vector<Segment>> Follower::drive() const {
  if (next_unsolved()) return std::nullopt;
  std::vector<Segment> whole;
  for (std::size_t i = 0; i < way_.size(); ++i) {
    if (is_free_[i]) {
      whole.push_back(way_[i]);
      continue;
    }
    std::size_t end = i;
    while (end < is_free_.size() && !is_free_[end]) ++end;
    const std::vector<Segment>& part = solved_.at({i, end});
    whole.insert(whole.end(), part.begin(), part.end());
    i = end - 1;
  }
  return merged(whole);
}

BehindTractor::BehindTractor(std::shared_ptr<const Setting> setting, std::int64_t first_work,
                             std::uint64_t seed)
    : setting_(std::move(setting)), most_work_(first_work), seed_(seed) {}

BehindTractor::~BehindTractor() = default;

// Begins to follow the way that a table of the site knows for the tractor. False without one.
bool BehindTractor::follow_table() {
  const bool may_ask = setting_->site != nullptr && !has_asked_table_;
  has_asked_table_ = true;
  if (!may_ask) return false;
  const Task alone = tractor_task(setting_->task, 0.0);
  const auto way = sites::way_in_world(*setting_->site, alone, setting_->options.cost);
  if (!way || way->path.segments.empty()) return false;
  follow_way(way->path.segments, setting_->options.cost.gears);
  return true;
}

void BehindTractor::follow_way(std::span<const Segment> way, AllowedGears gears) {
  const search::CostRule rule = search::restricted(search::cost_rule(driver_style), gears);
  follower_ = std::make_unique<Follower>(setting_->task, rule, way);
  work_left_ = most_work_;
}

// [1] Begins to plan a path of the tractor, in another manner each time. It gets more work if the
// one before led to no drive.
void BehindTractor::begin(const Budget& budget) {
  const std::size_t path = paths_++;
  const Manner& manner = manners[path % manners.size()];
  if (path > 0 && !std::exchange(has_led_to_drive_, false)) {
    most_work_ = std::clamp(2 * most_work_, first_later_work, most_later_work);
  }
  work_left_ = most_work_;
  const Task& task = setting_->task;
  alone_ = tractor_task(task, manner.radius * turning_radius(task.vehicle));
  if (!alone_->checker->is_free(alone_->start) || !alone_->checker->is_free(alone_->goal)) return;
  options_ = setting_->options;
  options_.cost = driver_style;
  options_.cost.reverse_weight = reverse_weights[path / 2 % reverse_weights.size()];
  options_.cost.clearance_distance = roomy * task.vehicle.trailer->wheelbase;
  options_.cost.initial_gear = setting_->options.cost.initial_gear;
  options_.cost.gears = setting_->options.cost.gears;
  if (manner.is_forward && options_.cost.gears == AllowedGears::both) {
    options_.cost.gears = AllowedGears::forward;
  }
  options_.budget.seed = stream_seed(seed_, paths_);
  options_.budget.threads = 1;
  options_.budget.target_gap.reset();
  options_.budget.max_iterations.reset();
  if (options_.budget.time_limit) {
    *options_.budget.time_limit = std::max(*options_.budget.time_limit - budget.elapsed(), 0.0);
  }
  const search::Budget clock(options_.budget);
  path_ = anytime::begin_run(anytime::compose(*alone_, options_, 0.0, {}), clock, options_.budget);
}

// Goes on planning the path; follows it when that is over.
std::int64_t BehindTractor::plan(std::int64_t most) {
  const std::int64_t before = path_->iterations();
  const bool goes_on = path_->advance(std::min(most, work_left_));
  const std::int64_t steps = std::max<std::int64_t>(path_->iterations() - before, 1);
  work_left_ -= steps;
  if (goes_on && work_left_ > 0) return steps;
  const std::optional<std::vector<Segment>> way = path_->path();
  path_.reset();
  if (way && !way->empty()) follow_way(*way, options_.cost.gears);
  return steps;
}

// Goes on following. The commands of the exact drive when that ends with one.
std::optional<anytime::Drive> BehindTractor::follow() {
  if (--work_left_ > 0 && follower_->step()) return std::nullopt;
  const std::optional<std::vector<Segment>> drive = follower_->drive();
  counts_.checks += follower_->checks();
  follower_.reset();
  if (!drive) return std::nullopt;
  auto commands = commands::exact_commands(setting_->task, *drive);
  if (!commands) return std::nullopt;
  has_led_to_drive_ = true;
  return anytime::Drive{.commands = *std::move(commands)};
}

anytime::Found BehindTractor::work(std::int64_t most, const Budget& budget) {
  anytime::Found found;
  std::int64_t& steps = found.iterations;
  while (steps < most && !found.drive && (steps == 0 || !budget.is_interrupted())) {
    if (path_) {
      steps += plan(most - steps);
      continue;
    }
    if (follower_) {
      found.drive = follow();
    } else if (!follow_table()) {
      begin(budget);
    }
    ++steps;
  }
  return found;
}

}  // namespace vandplan::rig
