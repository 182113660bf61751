// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

#include "planners/anytime/shorten.h"
#include "planners/anytime/sources.h"
#include "search/grid_distance.h"
#include "search/wheels.h"

namespace vandplan::anytime {
namespace {

constexpr std::int64_t max_lattice_nodes = 300'000;  // nodes of one search: some 30 MB
/// Greediness of the way on the grid that guides the search over a whole site.
constexpr double greediness_of_far_way = 1.25;
/// Price of small clearance on that way. It leads where there is room to turn.
constexpr double price_of_far_way = 3.0;
constexpr std::int64_t one_turn = 256;  // expansions of a turn where searches take turns

// The rule without prices of steering and clearance, for a first route: shortening takes care of
// them.
CostRule gears_alone(CostRule rule) {
  rule.curvature_change_cost = 0.0;
  rule.clearance_weight = 0.0;
  rule.has_priced_ground = false;
  rule.slowness_price = 0.0;
  return rule;
}

/// End of the task at which the searches begin.
enum class Root { start, goal };

/// The rule in the direction of a search from `root`.
CostRule rule_from(const CostRule& rule, Root root) {
  return root == Root::start ? rule : reversed(rule, -rule.final_gear);
}

class Ladder final : public Source {
 public:
  Ladder(const Task& task, const CostRule& rule, Root root)
      : task_(task),
        scene_(sampling_region(task, Region::scene)),
        from_(root == Root::start ? task.start : task.goal),
        to_(root == Root::start ? task.goal : task.start),
        root_(root),
        is_far_(is_site(task, scene_)),
        rule_(rule),
        by_length_(task, length_rule(rule_from(rule, root))),
        by_price_(task, rule_from(rule, root)),
        cutoff_(std::numeric_limits<double>::infinity()) {
    if (is_far_) by_gears_.emplace(task, gears_alone(rule));
    next_guide();
  }

  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override;
  [[nodiscard]] bool has_work() const override { return !finished_; }
  [[nodiscard]] std::int64_t stage() const override { return static_cast<std::int64_t>(level_); }
  void set_cutoff(double cost) override { cutoff_ = cost; }
  [[nodiscard]] Counts counts() const override;

 private:
  [[nodiscard]] bool takes_turns() const;
  [[nodiscard]] bool is_known() const;
  bool step_rotation();
  bool step_strung();
  [[nodiscard]] DrivenBeside driven_beside_route(const CostRule& rule) const;
  void next_search();
  void next_guide();
  [[nodiscard]] bool needs_next_guide() const;
  [[nodiscard]] bool goes_far() const;

  const Task& task_;
  Bounds scene_;
  LocalPose from_;
  LocalPose to_;
  Root root_;
  bool is_far_;    // whether the task goes over a whole site
  CostRule rule_;  // prices of the route
  /// Steers searches before a route is known.
  Connector by_length_;
  /// Steers searches once a route is known, in their direction.
  Connector by_price_;
  /// Steers along a way over a whole site.
  std::optional<Connector> by_gears_;
  std::optional<GridDistance> guide_;
  double guide_side_ = 1.0;  // side of the next guide's cells [vehicle widths]
  bool guided_ = false;      // whether the guide is complete
  bool finished_ = false;    // whether the finest search is done
  std::size_t level_ = 0;    // index of the next search
  bool is_done_ = false;     // whether the current search has found what it can
  double cutoff_;
  /// Drives along the way of the guide over a whole site; null if that failed.
  std::unique_ptr<Source> strung_;
  std::optional<Lattice> lattice_;  // current search, where `strung_` is null
  std::unique_ptr<Source> rotation_;
};

void Ladder::next_guide() {
  lattice_.reset();
  if (goes_far()) {
    guide_.emplace(task_, scene_, to_, from_,
                   GridDistance::Options{.side = task_.vehicle.width,
                                         .price = {price_of_far_way, 2 * task_.vehicle.width},
                                         .greediness = greediness_of_far_way,
                                         .detour = 1.0});
  } else {
    // Without a price of clearance a first route is found sooner.
    const double weight = is_known() ? rule_.clearance_weight : 0.0;
    guide_.emplace(task_, scene_, to_, from_,
                   GridDistance::Options{.side = side_over_all(task_, scene_, guide_side_),
                                         .price = {weight, rule_.clearance_distance}});
  }
  guide_side_ /= 2;
  guided_ = false;
}

// Gears and curvatures before and after the route of a search, in its direction.
DrivenBeside Ladder::driven_beside_route(const CostRule& rule) const {
  if (root_ == Root::start) return driven_at_ends(task_, rule.initial_gear);
  const auto [before, after] = driven_at_ends(task_);
  return {{-after.gear, after.curvature}, {0, before.curvature}};
}

void Ladder::next_search() {
  lattice_.reset();
  strung_.reset();
  if (level_ == coarse_to_fine.size()) {
    finished_ = true;
    return;
  }
  lattice_.emplace(from_, to_, driven_beside_route(by_length_.rule()), coarse_to_fine[level_],
                   *guide_, by_length_);
  if (goes_far() && guide_->is_connected()) {
    std::vector<Point> way = guide_->way();
    if (root_ == Root::goal) std::reverse(way.begin(), way.end());
    strung_ = strung(task_, std::move(way), *by_gears_);
  }
  ++level_;
  is_done_ = false;
}

bool Ladder::step() {
  if (!guided_) {
    if (guide_->step()) return false;
    // Coarse cells may close a narrow opening.
    guided_ = guide_->is_connected() || is_far_ || guide_side_ < fine_guide_side;
    if (!guided_) next_guide();
    // A known route is better than a search without a guide.
    if (guided_ && is_far_ && is_known() && !guide_->is_connected()) finished_ = true;
    return false;
  }
  if (takes_turns()) return step_rotation();
  if (!lattice_ || is_done_ || lattice_->is_exhausted() || lattice_->size() > max_lattice_nodes) {
    finished_ = is_far_ && is_known() && level_ > 0;  // shortening finds the routes beside it
    if (finished_) return false;
    if (needs_next_guide()) {
      next_guide();
      return false;
    }
    next_search();
  }
  if (finished_) return false;
  if (strung_) return step_strung();
  lattice_->set_cutoff(worth_shortening * cutoff_);
  const bool found = !lattice_->is_exhausted() && lattice_->step();
  is_done_ = found && is_far_;
  return found;
}

// Goes on along the way of the guide. True when its end is reached and the route is not much dearer
// than the best.
bool Ladder::step_strung() {
  is_done_ = strung_->step();
  if (!is_done_ && !strung_->has_work()) strung_.reset();
  return is_done_ && route().cost < worth_shortening * cutoff_;
}

// Whether the next search is the one over a whole site.
bool Ladder::goes_far() const { return is_far_ && level_ == 0; }

// Whether the next search has another guide: a finer one after the first search.
bool Ladder::needs_next_guide() const { return level_ == 1 && guide_side_ > fine_guide_side / 2; }

// Whether different searches take turns.
bool Ladder::takes_turns() const { return !is_far_ && !rule_.is_length() && is_known(); }

bool Ladder::is_known() const { return cutoff_ < std::numeric_limits<double>::infinity(); }

bool Ladder::step_rotation() {
  if (!rotation_) {
    lattice_.reset();
    if (guide_side_ > fine_guide_side / 2) {
      next_guide();
      return false;
    }
    const bool is_tight = level_ > coarse_searches;
    rotation_ = rotation(from_, to_, driven_beside_route(by_price_.rule()),
                         std::span(coarse_to_fine).subspan(is_tight ? level_ - 1 : 0),
                         is_tight ? max_lattice_nodes : one_turn, *guide_, by_price_);
  }
  rotation_->set_cutoff(worth_shortening * cutoff_);
  const bool found = rotation_->step();
  finished_ = !rotation_->has_work();
  return found;
}

Counts Ladder::counts() const {
  Counts sum = counts_of(by_length_) += counts_of(by_price_);
  if (by_gears_) sum += counts_of(*by_gears_);
  sum.nodes = rotation_ ? rotation_->counts().nodes : lattice_ ? lattice_->size() : 0;
  return sum;
}

Route Ladder::route() const {
  if (strung_) {
    Route route = strung_->route();
    route.cost = cost_of(rule_, route);
    return route;
  }
  Route route = rotation_ ? rotation_->route() : lattice_->route();
  if (rule_.is_length() && root_ == Root::start) return route;
  if (root_ == Root::goal) route = reversed(route);
  route.cost = cost_of(rule_, route);
  return route;
}

}  // namespace

std::unique_ptr<Source> ladder_from_start(const Task& task, const CostRule& rule) {
  return std::make_unique<Ladder>(task, rule, Root::start);
}

std::unique_ptr<Source> ladder_from_goal(const Task& task, const CostRule& rule) {
  return std::make_unique<Ladder>(task, rule, Root::goal);
}

}  // namespace vandplan::anytime
