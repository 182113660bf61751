// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/boxes.h"
#include "planners/anytime/kinds.h"
#include "planners/anytime/shorten.h"
#include "planners/anytime/sources.h"
#include "search/clearance_raster.h"
#include "search/drive_field.h"
#include "search/grid_distance.h"

namespace vandplan::anytime {
namespace {

/// Headings and cells of passes, in turns. Coarse cells and fine cells find different ways, because
/// it is luck which poses they keep. So passes differ.
constexpr std::array<FieldOptions, 4> survey_passes = {
    {{16, 0.4}, {24, 0.25}, {18, 0.3}, {36, 0.25}}};
constexpr double shift = 0.618;  // shift of the cells each time all passes were used [cells]
/// A way may cost so many times the best route, because ways are crooked, and a joining word so
/// many times the steps that it replaces.
constexpr double crooked = 1.2;
constexpr std::int64_t max_poses = 200'000;  // poses expanded by the field from the goal
constexpr double max_cells = 1e6;            // cells of places and headings in one field
constexpr int poses_of_step = 32;            // poses expanded in one step
constexpr int steps_of_preparing = 8;        // steps of grid and raster in one step
constexpr double border = 2.0;               // border around the scene [turning radii]
constexpr double room_of_step = 0.2;         // room that the longest step needs [turning radii]
constexpr std::int64_t bin_headings = 8;     // bins of the heading
/// A word that joins two branches replaces so many steps of one branch, and half as many of the
/// other.
constexpr std::array<std::size_t, 7> steps_replaced = {1, 2, 3, 4, 6, 8, 12};

Bounds box_around(const Task& task) {
  const Bounds scene = sampling_region(task, Region::scene);
  const double more = border * task.vehicle.min_turning_radius;
  return geometry::shared(task.world->local().bounds, geometry::widened(scene, more));
}

Driven driven_of(const Connector& connector, const DriveField::Node& node) {
  return {node.gear, node.side / connector.radius()};
}

class Survey final : public Source {
 public:
  Survey(const Task& task, const CostRule& rule)
      : task_(task),
        forth_(task, rule),
        back_(task, reversed(rule, -rule.final_gear)),
        box_(box_around(task)) {}

  [[nodiscard]] bool step() override;
  [[nodiscard]] Route route() const override { return route_; }
  void set_cutoff(double cost) override { cutoff_ = cost; }
  [[nodiscard]] std::int64_t stage() const override { return static_cast<std::int64_t>(passes_); }
  [[nodiscard]] Counts counts() const override { return counts_of(forth_) += counts_of(back_); }

 private:
  /// Steps of a field from its root to one of its nodes.
  struct Branch {
    std::vector<DriveField::Node> nodes;
    std::vector<LocalPose> poses;  // exact poses: the root, and after each step
  };

  [[nodiscard]] bool prepare();
  void begin_pass();
  [[nodiscard]] bool meet(std::int32_t id);
  [[nodiscard]] bool go_back();
  void go_forth();
  [[nodiscard]] bool go_on();
  [[nodiscard]] bool lead_through(std::int32_t node);
  [[nodiscard]] static Branch branch(const DriveField& field, const LocalPose& root,
                                     std::int32_t node);
  [[nodiscard]] bool join(const Branch& head, const Branch& tail);
  [[nodiscard]] DrivenBeside driven_around(const Branch& head, std::size_t heads,
                                           const Branch& tail, std::size_t tails) const;
  void put_together(const Branch& head, std::size_t heads, const Piece& joint, const Branch& tail,
                    std::size_t tails);
  [[nodiscard]] bool is_free() const;
  [[nodiscard]] std::size_t bin_of(const LocalPose& pose, GearSign gear) const;
  void end();

  const Task& task_;
  Connector forth_, back_;  // steer from the start, and from the goal backwards
  Bounds box_;
  double cutoff_ = std::numeric_limits<double>::infinity();
  std::unique_ptr<GridDistance> guide_;
  std::unique_ptr<ClearanceRaster> raster_;
  bool is_prepared_ = false;
  std::size_t passes_ = 0;  // passes so far
  double most_ = 0.0;       // largest cost of a way in this pass [m]
  FieldOptions options_;    // cells of this pass
  Bounds cells_ = {};       // area that the cells cover, shifted in later passes
  std::unique_ptr<DriveField> from_goal_, from_start_;
  bool has_met_ = false;                 // whether the field from the goal has reached the start
  std::int64_t poses_ = 0;               // poses expanded by the field from the goal
  std::vector<bool> covered_;            // bins that routes of this pass lead through
  double bin_ = 1.0;                     // side of a bin [m]
  std::int64_t columns_ = 0, rows_ = 0;  // bins along x and y
  Kinds kinds_;
  Route route_;
};

// Prepares the guide and the raster. True when both are complete.
bool Survey::prepare() {
  if (!guide_) {
    const CostRule& rule = forth_.rule();
    const Bounds scene = sampling_region(task_, Region::scene);
    guide_ = std::make_unique<GridDistance>(
        task_, scene, task_.start, task_.goal,
        GridDistance::Options{.side = side_over_all(task_, scene, fine_guide_side),
                              .price = {rule.clearance_weight, rule.clearance_distance}});
    raster_ = std::make_unique<ClearanceRaster>(
        task_, box_, std::max(rule.clearance_distance, room_of_step * forth_.radius()));
    return false;
  }
  for (int i = 0; i < steps_of_preparing; ++i) {
    if (!guide_->step() && !raster_->step()) return true;
  }
  return false;
}

void Survey::begin_pass() {
  most_ = crooked * cutoff_;
  options_ = survey_passes[passes_ % survey_passes.size()];
  const double area = (box_.x_max - box_.x_min) * (box_.y_max - box_.y_min);
  const double least_cell = std::sqrt(area * options_.headings / max_cells) / forth_.radius();
  options_.cell = std::max(options_.cell, least_cell);
  const std::size_t times_around = passes_ / survey_passes.size();
  const double shifts = shift * static_cast<double>(times_around);
  const double offset = std::fmod(shifts, 1.0) * options_.cell * forth_.radius();
  cells_ = {box_.x_min - offset, box_.x_max, box_.y_min - offset, box_.y_max};
  from_goal_ =
      std::make_unique<DriveField>(back_, *raster_, cells_, options_, task_.goal, 0, most_);
  from_goal_->look_towards(*guide_);
  has_met_ = false;
  poses_ = 0;
}

// Looks whether a pose of the field from the goal is at the start. The first such way tells what
// ways cost with these cells. True when it becomes a route.
bool Survey::meet(std::int32_t id) {
  const DriveField::Node& node = from_goal_->node(id);
  const double side = options_.cell * forth_.radius();
  const double dx = task_.start.x - static_cast<double>(node.x);
  const double dy = task_.start.y - static_cast<double>(node.y);
  if (dx * dx + dy * dy >= side * side || static_cast<double>(node.cost) > most_) return false;
  const double turn = wrap_angle(task_.start.heading - from_goal_->pose(node).heading);
  if (std::abs(turn) > std::numbers::pi / options_.headings) return false;
  has_met_ = true;
  from_goal_->set_cutoff(worth_shortening * static_cast<double>(node.cost) + forth_.radius());
  if (!join({{}, {task_.start}}, branch(*from_goal_, task_.goal, id))) return false;
  price(forth_, route_);
  return kinds_.is_new(route_, forth_.radius());
}

// Expands poses of the field from the goal. True when there is a route.
bool Survey::go_back() {
  for (int i = 0; i < poses_of_step && !from_goal_->is_exhausted(); ++i) {
    const std::int32_t id = from_goal_->step();
    ++poses_;
    if (id == DriveField::none || has_met_) continue;
    if (meet(id)) return true;
  }
  if (from_goal_->is_exhausted() || poses_ > max_poses) go_forth();
  return false;
}

void Survey::go_forth() {
  from_start_ = std::make_unique<DriveField>(forth_, *raster_, cells_, options_, task_.start,
                                             forth_.rule().initial_gear, most_);
  from_start_->look_towards(*from_goal_);
  if (from_start_->is_exhausted()) return end();
  from_start_->set_cutoff(worth_shortening * from_start_->least_cost() + forth_.radius());
  bin_ = std::max(1.0, 2 * options_.cell) * forth_.radius();
  columns_ = static_cast<std::int64_t>((box_.x_max - box_.x_min) / bin_) + 2;
  rows_ = static_cast<std::int64_t>((box_.y_max - box_.y_min) / bin_) + 2;
  covered_.assign(static_cast<std::size_t>(columns_ * rows_ * bin_headings * 2), false);
}

// Expands poses of the field from the start. True when there is a route.
bool Survey::go_on() {
  for (int i = 0; i < poses_of_step && !from_start_->is_exhausted(); ++i) {
    const std::int32_t id = from_start_->step();
    if (id == DriveField::none) continue;
    const DriveField::Node& node = from_start_->node(id);
    if (node.parent == DriveField::none) continue;
    if (!covered_[bin_of(from_start_->pose(node), node.gear)]) return lead_through(id);
  }
  if (from_start_->is_exhausted()) end();
  return false;
}

void Survey::end() {
  from_goal_.reset();
  from_start_.reset();
  ++passes_;
}

bool Survey::step() {
  if (!is_prepared_) {
    is_prepared_ = prepare();
    return false;
  }
  if (from_start_) return go_on();
  if (from_goal_) return go_back();
  begin_pass();
  return false;
}

std::size_t Survey::bin_of(const LocalPose& pose, GearSign gear) const {
  const double turned = (pose.heading / (2 * std::numbers::pi) + 0.5) * bin_headings;
  const auto column = static_cast<std::int64_t>(std::max(0.0, (pose.x - box_.x_min) / bin_));
  const auto row = static_cast<std::int64_t>(std::max(0.0, (pose.y - box_.y_min) / bin_));
  const std::int64_t place = std::min(row, rows_ - 1) * columns_ + std::min(column, columns_ - 1);
  const std::int64_t heading = static_cast<std::int64_t>(turned) % bin_headings;
  return static_cast<std::size_t>((place * bin_headings + heading) * 2 + (gear < 0 ? 1 : 0));
}

Survey::Branch Survey::branch(const DriveField& field, const LocalPose& root, std::int32_t node) {
  Branch result;
  for (; field.node(node).parent != DriveField::none; node = field.node(node).parent) {
    result.nodes.push_back(field.node(node));
  }
  std::reverse(result.nodes.begin(), result.nodes.end());
  result.poses.push_back(root);
  for (const DriveField::Node& step : result.nodes) {
    result.poses.push_back(advance(result.poses.back(), field.step_to(step)));
  }
  return result;
}

// Makes a route by way of a node of the field from the start. False if it is blocked or of a known
// kind.
bool Survey::lead_through(std::int32_t node) {
  const std::int32_t onward = from_goal_->onward(*from_start_, from_start_->node(node)).node;
  if (onward == DriveField::none) return false;
  const Branch head = branch(*from_start_, task_.start, node);
  const Branch tail = branch(*from_goal_, task_.goal, onward);
  for (std::size_t i = 0; i < head.nodes.size(); ++i) {
    covered_[bin_of(head.poses[i + 1], head.nodes[i].gear)] = true;
  }
  for (std::size_t i = 0; i < tail.nodes.size(); ++i) {
    covered_[bin_of(tail.poses[i + 1], -tail.nodes[i].gear)] = true;
  }
  if (!join(head, tail)) return false;
  price(forth_, route_);
  return kinds_.is_new(route_, forth_.radius());
}

DrivenBeside Survey::driven_around(const Branch& head, std::size_t heads, const Branch& tail,
                                   std::size_t tails) const {
  DrivenBeside beside{forth_.rule().initial_gear, forth_.rule().final_gear};
  if (heads > 0) beside.before = driven_of(forth_, head.nodes[heads - 1]);
  if (tails > 0) {
    beside.after = driven_of(forth_, tail.nodes[tails - 1]);
    beside.after.gear *= -1;
  }
  return beside;
}

// Joins two branches that end in one cell, but not at one pose: a word replaces some steps of both.
// False if no such route is free.
bool Survey::join(const Branch& head, const Branch& tail) {
  const auto cost_of_last = [](const Branch& branch, std::size_t steps) {
    if (steps == 0) return 0.0;
    const std::size_t left = branch.nodes.size() - steps;
    const float before = left == 0 ? 0.0F : branch.nodes[left - 1].cost;
    return static_cast<double>(branch.nodes.back().cost - before);
  };
  for (const std::size_t more : steps_replaced) {
    for (const auto& [wanted_of_head, wanted_of_tail] :
         {std::pair{more, more / 2}, std::pair{more / 2, more}}) {
      const std::size_t of_head = std::min(wanted_of_head, head.nodes.size());
      const std::size_t of_tail = std::min(wanted_of_tail, tail.nodes.size());
      const std::size_t heads = head.nodes.size() - of_head;
      const std::size_t tails = tail.nodes.size() - of_tail;
      const double replaced = cost_of_last(head, of_head) + cost_of_last(tail, of_tail);
      const double cutoff = crooked * replaced;
      const std::optional<Connection> joint =
          forth_.connect(head.poses[heads], tail.poses[tails],
                         {0.0, cutoff, driven_around(head, heads, tail, tails)});
      if (!joint) continue;
      put_together(head, heads, joint->piece, tail, tails);
      if (is_free()) return true;
    }
  }
  return false;
}

void Survey::put_together(const Branch& head, std::size_t heads, const Piece& joint,
                          const Branch& tail, std::size_t tails) {
  route_ = {task_.start, {}, 0.0};
  for (std::size_t i = 0; i < heads; ++i) {
    drive_on(route_.legs, from_start_->step_to(head.nodes[i]), head.poses[i + 1]);
  }
  route_.legs.push_back({joint, tail.poses[tails]});
  std::vector<Leg> rest;
  for (std::size_t i = tails; i > 0; --i) {
    Segment step = from_goal_->step_to(tail.nodes[i - 1]);
    step.length = -step.length;
    drive_on(rest, step, tail.poses[i - 1]);
  }
  route_.append(rest);
}

// Checks the whole route, because fields skip exact checks where there is much room.
bool Survey::is_free() const {
  return task_.checker->is_free(task_.start, path_of(route_).segments);
}

}  // namespace

std::unique_ptr<Source> survey(const Task& task, const CostRule& rule) {
  return std::make_unique<Survey>(task, rule);
}

}  // namespace vandplan::anytime
