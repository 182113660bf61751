// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "lab/field_d_star.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "base/trigonometry.h"
#include "lab/cost_field.h"
#include "lab/estimate_options.h"
#include "search/open_ground.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan::field_d_star {
namespace {

using namespace search;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double pi = std::numbers::pi;
constexpr double dear_within = 2.0;  // room where metres cost more [vehicle widths]
constexpr int rounds_of_a_side = 4;  // rounds with one cell size
constexpr double windows = 3.0;      // reach of an edge along the route [spacings]
constexpr int most_of_a_place = 8;   // poses drawn at each place, after round 0

/// Cost of a metre for the disc inside the vehicle: infinite where the disc does not fit, higher
/// where the rest of the vehicle may not fit.
class DiscCost {
 public:
  DiscCost(const Task& task, double near_weight)
      : world_(task.world->checker(speck(), {})),
        disc_(inner_radius(task.vehicle) + task.least_margin),
        dear_(dear_within * task.vehicle.width),
        weight_(near_weight) {}

  double operator()(const Point& point) const {
    const double room =
        world_->clearance(Local(Pose{point.x, point.y, 0.0}), disc_ + dear_) - disc_;
    if (room < 0.0) return infinity;
    return 1.0 + weight_ * std::max(0.0, 1.0 - room / dear_);
  }

 private:
  /// A vehicle of 2 mm, whose clearance stands for that of a point.
  static Vehicle speck() {
    Vehicle speck;
    speck.wheelbase = speck.width = 2e-3;
    speck.front_overhang = speck.rear_overhang = 0.0;
    return speck;
  }

  std::shared_ptr<const CollisionChecker> world_;
  double disc_, dear_;  // radius of the disc; room beyond it where metres cost more [m]
  double weight_;       // surcharge of a metre beside an obstacle
};

/// A polyline, whose points are found by their distance from the start.
class Route {
 public:
  explicit Route(std::vector<Point> points) : points_(std::move(points)), s_(points_.size(), 0.0) {
    for (std::size_t i = 1; i < points_.size(); ++i) {
      s_[i] =
          s_[i - 1] + std::hypot(points_[i].x - points_[i - 1].x, points_[i].y - points_[i - 1].y);
    }
  }

  [[nodiscard]] double length() const { return s_.back(); }

  /// The point at distance `s` from the start [m].
  [[nodiscard]] Point at(double s) const {
    const auto after = std::upper_bound(s_.begin() + 1, s_.end() - 1, s);
    const auto i = static_cast<std::size_t>(after - s_.begin());
    const double share =
        (std::clamp(s, 0.0, length()) - s_[i - 1]) / std::max(s_[i] - s_[i - 1], 1e-12);
    const Point& a = points_[i - 1];
    const Point& b = points_[i];
    return {a.x + share * (b.x - a.x), a.y + share * (b.y - a.y)};
  }

  /// The pose at distance `s` [m]. It looks along the chord from s - reach to s + reach.
  [[nodiscard]] LocalPose pose_at(double s, double reach) const {
    const Point here = at(s);
    const Point before = at(s - reach);
    const Point after = at(s + reach);
    return Local(Pose{here.x, here.y, base::atan_2(after.y - before.y, after.x - before.x)});
  }

 private:
  std::vector<Point> points_;
  std::vector<double> s_;  // distance of each point from the start [m]
};

/// A pose that a way may pass, and the cheapest way from the start to the pose.
struct Via {
  double s = 0.0;  // distance along the route [m]
  LocalPose pose = {};
  double cost = infinity;  // cost-to-come [m]; infinite: not reached
  std::int32_t from = -1;  // previous pose of the way, index; -1: none
};

/// A way from the start to the goal.
struct PoseWay {
  std::vector<Via> vias = {};  // poses between start and goal
  double cost = infinity;      // cost of the way [m]; infinite: there is none
};

// One run of the planner.
class FieldDStarRun {
 public:
  FieldDStarRun(const Task& task, const PlanOptions& options)
      : task_(task),
        options_(options),
        budget_(options.budget),
        rng_(options.budget.seed),
        connector_(task, length_rule(cost_rule(options.cost))),
        cost_(task, options.planner.number("near_weight")),
        spacing_(options.planner.number("spacing") * task.vehicle.min_turning_radius),
        most_cells_(static_cast<double>(options.planner.integer("max_cells"))),
        side_(options.planner.number("cell")) {}

  PlannerAnswer plan();

 private:
  [[nodiscard]] bool try_directly();
  /// Finds a route on the next finer cells that have one. False if no route is known, or the budget
  /// is spent.
  bool find_route();
  void draw_vias();
  void connect_vias();
  void keep();
  [[nodiscard]] std::vector<Segment> segments();
  [[nodiscard]] TreeSnapshot tree() const;

  const Task& task_;
  const PlanOptions& options_;
  Budget budget_;
  Rng rng_;
  Connector connector_;
  DiscCost cost_;
  double spacing_;          // distance of poses along a route [m]
  double most_cells_;       // largest number of cells of a field
  double side_;             // cell size of the next field [m]
  bool is_finest_ = false;  // whether the last field had the finest cells
  std::optional<Route> route_;
  std::int64_t settled_ = 0;   // settled nodes of all fields
  std::int64_t expanded_ = 0;  // poses whose edges were tried
  int round_ = 0;
  std::vector<Via> vias_;
  PoseWay best_;
  PlannerAnswer answer_;
};

bool FieldDStarRun::try_directly() {
  const auto direct = connector_.connect(task_.start, task_.goal);
  if (!direct) return false;
  answer_.status = PlanStatus::solved;
  answer_.segments = merged(direct->piece.view());
  const CostRule& rule = connector_.rule();
  answer_.lower_bound = search::cost_lower_bound(search::open_ground(task_, rule), rule, 0.0);
  answer_.anytime.push_back({budget_.elapsed(), 0, direct->cost});
  if (options_.planner.flag("keep_tree"))
    answer_.tree = TreeSnapshot{{task_.start, task_.goal}, {-1, 0}};
  return true;
}

bool FieldDStarRun::find_route() {
  while (!is_finest_) {
    const Bounds box = sampling_region(task_, Region::scene);
    const double width = box.x_max - box.x_min;
    const double height = box.y_max - box.y_min;
    const double least = std::max(
        {std::sqrt(width * height / most_cells_), std::max(width, height) / most_cells_, 0.05});
    const double side = std::max(side_, least);
    side_ = side / 2;
    is_finest_ = side_ < least;
    CostField field({box, side, cost_}, {task_.goal.x, task_.goal.y},
                    {task_.start.x, task_.start.y});
    do {
      if (!budget_.next()) return false;
    } while (field.step());
    settled_ += field.settled();
    std::vector<Point> points = field.route();
    if (points.empty()) continue;
    if (points.size() == 1) points.push_back(points.front());
    route_.emplace(std::move(points));
    return true;
  }
  return route_.has_value();
}

// Draws poses. First round: along the route, looking ahead or back. Later rounds: at random, ever
// further off the route, and the poses of the best way.
void FieldDStarRun::draw_vias() {
  vias_.assign(1, {0.0, task_.start, 0.0, -1});
  const double length = route_->length();
  const double step = round_ == 0 ? spacing_ : spacing_ * uniform(0.4, 1.2, rng_);
  const double first = round_ == 0 ? step : step * uniform(-0.5, 0.5, rng_);
  const double last = round_ == 0 ? length : length + step / 2;
  const double aside = 0.4 * task_.vehicle.width * std::sqrt(round_);
  const double turn = std::min(0.15 * std::sqrt(round_), pi / 2);
  const int count = round_ == 0 ? 2 : most_of_a_place;
  for (double s = first; s < last; s += step) {
    const LocalPose along = route_->pose_at(s, step / 2);
    for (int i = 0; i < count; ++i) {
      Pose off{0.0, 0.0, i % 2 == 0 ? 0.0 : pi};
      if (round_ > 0) {
        off.x = uniform(-step / 2, step / 2, rng_);
        off.y = uniform(-aside, aside, rng_);
        off.heading += uniform(-turn, turn, rng_);
      }
      const LocalPose pose = compose(along, off);
      if (connector_.is_free(pose)) vias_.push_back({std::clamp(s, 0.0, length), pose});
    }
  }
  for (const Via& via : best_.vias) vias_.push_back({std::min(via.s, length), via.pose});
  std::stable_sort(vias_.begin() + 1, vias_.end(),
                   [](const Via& a, const Via& b) { return a.s < b.s; });
  vias_.push_back({length, task_.goal});
}

// Finds the cheapest way to each pose, in the order of the poses along the route.
void FieldDStarRun::connect_vias() {
  const double reach = windows * spacing_;
  for (std::size_t i = 0; i + 1 < vias_.size(); ++i) {
    if (vias_[i].cost == infinity) continue;
    if (!budget_.next()) return;
    ++expanded_;
    const auto try_edge = [&](std::size_t to) {
      const LocalPose& pose = vias_[to].pose;
      const double left = std::hypot(task_.goal.x - pose.x, task_.goal.y - pose.y);
      const double cutoff = std::min(vias_[to].cost, best_.cost - left);
      const auto edge = connector_.connect(vias_[i].pose, pose, {vias_[i].cost, cutoff, {}});
      if (edge) vias_[to] = {vias_[to].s, pose, edge->cost, static_cast<std::int32_t>(i)};
    };
    for (std::size_t j = i + 1; j + 1 < vias_.size(); ++j) {
      if (vias_[j].s > vias_[i].s + reach) break;
      try_edge(j);
    }
    if (vias_.back().s <= vias_[i].s + 2 * reach) try_edge(vias_.size() - 1);
  }
}

void FieldDStarRun::keep() {
  const bool is_better = vias_.back().cost < best_.cost;
  if (options_.planner.flag("keep_tree") && (is_better || best_.cost == infinity)) {
    answer_.tree = tree();
  }
  if (!is_better) return;
  best_ = {{}, vias_.back().cost};
  for (std::int32_t at = vias_.back().from; at > 0; at = vias_[static_cast<std::size_t>(at)].from) {
    best_.vias.push_back(vias_[static_cast<std::size_t>(at)]);
  }
  std::reverse(best_.vias.begin(), best_.vias.end());
  answer_.anytime.push_back({budget_.elapsed(), budget_.iterations(), best_.cost});
}

std::vector<Segment> FieldDStarRun::segments() {
  std::vector<Segment> all;
  LocalPose from = task_.start;
  const auto go_to = [&](const LocalPose& to) {
    const std::optional<Piece> piece = connector_.steer(from, to);
    all.insert(all.end(), piece->view().begin(), piece->view().end());
    from = to;
  };
  for (const Via& via : best_.vias) go_to(via.pose);
  go_to(task_.goal);
  return merged(all);
}

// Tree of the cheapest ways to the poses of this round.
TreeSnapshot FieldDStarRun::tree() const {
  TreeSnapshot tree;
  std::vector<std::int32_t> place(vias_.size(), -1);
  for (std::size_t i = 0; i < vias_.size(); ++i) {
    const auto& [s, pose, cost, from] = vias_[i];
    if (cost == infinity) continue;
    place[i] = static_cast<std::int32_t>(tree.poses.size());
    tree.poses.push_back(pose);
    tree.parents.push_back(from < 0 ? -1 : place[static_cast<std::size_t>(from)]);
  }
  return tree;
}

// Field D* (Ferguson and Stentz 2006), and a vehicle that drives along its route.
//
//   [1] try the piece from start to goal: if it is free there is nothing shorter
//   until the budget is spent:
//   [2]   every few rounds: field := costs of the disc's ways to the goal, on ever finer cells;
//         route := the cheapest way from the start
//   [3]   poses := some along the route, looking ahead or back; later ones at random beside it
//   [4]   join each pose to those that follow within three spacings, the cheapest way to each first
//   [5]   keep the cheapest way to the goal; its poses are among those of the next round
PlannerAnswer FieldDStarRun::plan() {
  if (!budget_.exhausted() && try_directly()) return std::move(answer_);  // [1]
  while (!budget_.exhausted()) {
    const bool is_due = round_ % rounds_of_a_side == 0 && !is_finest_;
    if ((is_due || !route_) && !find_route() && !route_) break;  // [2]
    draw_vias();                                                 // [3]
    connect_vias();                                              // [4]
    keep();                                                      // [5]
    ++round_;
  }
  answer_.iterations = budget_.iterations();
  answer_.status = budget_.exhausted().value_or(PlanStatus::node_limit);
  if (answer_.status == PlanStatus::node_limit) answer_.reason = "the finest cells have no route";
  if (best_.cost < infinity) {
    answer_.status = PlanStatus::solved;
    answer_.segments = segments();
  }
  answer_.counters = {{"nodes", settled_},
                      {"expansions", expanded_},
                      {"exact_solves", connector_.solves()},
                      {"edge_checks", connector_.checks()}};
  if (options_.planner.flag("keep_tree") && !answer_.tree) {
    answer_.tree = TreeSnapshot{{task_.start}, {-1}};
  }
  return std::move(answer_);
}

}  // namespace

Planner planner() {
  return {.name = "field-d-star",
          .summary = "Field D* route, followed through poses beside it",
          .properties = {.family = "field-d-star",
                         .capabilities = {Capability::gears},
                         .anytime = true,
                         .groups = {"family"}},
          .options = {{.name = "cell",
                       .summary = "cell size of the first field [m]",
                       .default_value = 1.0,
                       .least = 0.05,
                       .most = 100},
                      {.name = "max_cells",
                       .summary = "largest number of cells",
                       .default_value = std::int64_t{4'000'000},
                       .least = 100,
                       .most = 16'000'000},
                      {.name = "near_weight",
                       .summary = "extra cost of a metre of route beside an obstacle",
                       .default_value = 3.0,
                       .least = 0,
                       .most = 1000},
                      {.name = "spacing",
                       .summary = "distance of poses along the route [turning radii]",
                       .default_value = 1.0,
                       .least = 0.05,
                       .most = 100},
                      {.name = "keep_tree",
                       .summary = "return the poses of the successful round",
                       .default_value = false}},
          .function = [](const Task& task, const PlanOptions& options) {
            return FieldDStarRun(task, options).plan();
          }};
}

}  // namespace vandplan::field_d_star
