// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/drive_field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "base/trigonometry.h"

namespace vandplan::search {
namespace {

// Length of a straight step [cells]; long enough to leave its cell.
constexpr double straight_cells = 1.5;
constexpr double bucket = 0.02;  // Range of ranks in a bucket [turning radii].
constexpr double max_buckets = 8192.0;
constexpr float sure_steps = 0.3F;     // Clearance above which a step is free [step lengths].
constexpr float sure_fineness = 4.0F;  // Added to that clearance [errors of the raster].
constexpr float patience = 2.0F;  // Increase of a rank after which a node waits again [buckets].
constexpr float unasked = -1.0F;

/// Begins to bring what is needed soon into the cache. A field spends most of its time waiting for
/// memory.
void fetch(const auto& soon) { __builtin_prefetch(&soon); }

}  // namespace

DriveField::DriveField(Connector& connector, ClearanceRaster& raster, const Bounds& box,
                       const FieldOptions& options, const Pose& root, GearSign driven, double most)
    : connector_(connector),
      raster_(raster),
      root_(root),
      headings_(options.headings),
      turn_(2 * std::numbers::pi / options.headings),
      x_min_(static_cast<float>(box.x_min)),
      y_min_(static_cast<float>(box.y_min)),
      // Finite, so that what leads nowhere never waits.
      cutoff_(static_cast<float>(
          std::min(most, static_cast<double>(std::numeric_limits<float>::max())))) {
  const double radius = connector.radius();
  const double cell = options.cell * radius;
  const CostRule& rule = connector.rule();
  cells_of_metre_ = static_cast<float>(1 / cell);
  buckets_of_metre_ = static_cast<float>(std::min(1 / (bucket * radius), max_buckets / most));
  columns_ = static_cast<std::int64_t>((box.x_max - box.x_min) / cell) + 1;
  rows_ = static_cast<std::int64_t>((box.y_max - box.y_min) / cell) + 1;
  gear_change_ = static_cast<float>(rule.gear_change_cost);
  turning_ = static_cast<float>(rule.curvature_change_cost / radius);
  clearance_weight_ = static_cast<float>(rule.clearance_weight);
  clearances_of_metre_ = static_cast<float>(1 / rule.clearance_distance);
  states_.resize(static_cast<std::size_t>(columns_ * rows_ * headings_ * 2));
  for (int heading = 0; heading < headings_; ++heading) {
    const Pose from{0.0, 0.0, root.heading + heading * turn_};
    const base::SinCos direction = base::sin_cos(from.heading);
    cos_.push_back(static_cast<float>(direction.cos));
    sin_.push_back(static_cast<float>(direction.sin));
    for (const GearSign gear : {1, -1}) {
      if (!rule.allows(gear)) continue;
      const double weight = rule.weight(gear);
      for (const int side : {0, 1, -1}) {
        const double length = side == 0 ? straight_cells * cell : turn_ * radius;
        const Pose to = advance(from, Segment{side / radius, gear * length});
        const int turned = (heading + side * gear + headings_) % headings_;
        steps_.push_back({static_cast<float>(to.x), static_cast<float>(to.y),
                          static_cast<float>(length), static_cast<float>(weight * length),
                          static_cast<std::int16_t>(turned), static_cast<std::int8_t>(side),
                          static_cast<std::int8_t>(gear)});
      }
    }
  }
  Node first{static_cast<float>(root.x),
             static_cast<float>(root.y),
             0.0F,
             0.0F,
             none,
             0,
             0,
             static_cast<std::int8_t>(driven),
             true};
  first.near = near_at(clearance_at(first));
  nodes_.push_back(first);
}

void DriveField::look_towards(const Guide& guide) {
  guide_ = &guide;
  guided_.assign(static_cast<std::size_t>(columns_ * rows_), unasked);
  push({0.0F, 0});
}

void DriveField::look_towards(const DriveField& opposite) {
  opposite_ = &opposite;
  push({opposite.onward(*this, nodes_.front()).cost, 0});
}

LocalPose DriveField::pose(const Node& node) const {
  return Local(Pose{static_cast<double>(node.x), static_cast<double>(node.y),
                    wrap_angle(root_.heading + node.heading * turn_)});
}

Segment DriveField::step_to(const Node& node) const {
  const double length =
      node.side == 0 ? static_cast<double>(steps_.front().length) : turn_ * connector_.radius();
  return {node.side / connector_.radius(), node.gear * length};
}

/// Index of the cell of a point; -1 outside the box.
std::int64_t DriveField::cell_of(float x, float y) const noexcept {
  const float column = (x - x_min_) * cells_of_metre_;
  const float row = (y - y_min_) * cells_of_metre_;
  const bool is_inside = column >= 0.0F && row >= 0.0F && column < static_cast<float>(columns_) &&
                         row < static_cast<float>(rows_);
  if (!is_inside) return -1;
  return static_cast<std::int64_t>(row) * columns_ + static_cast<std::int64_t>(column);
}

std::size_t DriveField::state_of(std::int64_t cell, int heading, int gear) const noexcept {
  return static_cast<std::size_t>((cell * headings_ + heading) * 2 + (gear < 0 ? 1 : 0));
}

DriveField::Onward DriveField::onward(const DriveField& other, const Node& node) const {
  Onward best;
  const std::int64_t cell = cell_of(node.x, node.y);
  if (cell < 0) return best;
  const double turned = (other.root_.heading - root_.heading) / turn_ + node.heading;
  const int heading = static_cast<int>(std::lround(turned) % headings_ + headings_) % headings_;
  for (const int gear : {1, -1}) {
    const State& state = states_[state_of(cell, heading, gear)];
    if (state.node == none) continue;
    const bool changes = node.gear == gear;  // The field's node is driven in the opposite gear.
    const float cost = state.cost + (changes ? gear_change_ : 0.0F);
    if (cost < best.cost) best = {state.node, cost};
  }
  return best;
}

float DriveField::to_go(const Node& node, std::int64_t cell) {
  if (opposite_ != nullptr) return opposite_->onward(*this, node).cost;
  float& known = guided_[static_cast<std::size_t>(cell)];
  if (known == unasked) {
    const std::int64_t column = cell % columns_;
    const std::int64_t row = cell / columns_;
    const auto side = static_cast<double>(cells_of_metre_);
    known = static_cast<float>(
        guide_->at(static_cast<double>(x_min_) + (static_cast<double>(column) + 0.5) / side,
                   static_cast<double>(y_min_) + (static_cast<double>(row) + 0.5) / side));
  }
  return known;
}

void DriveField::push(const Entry& entry) {
  if (!(entry.rank <= cutoff_)) return;
  const auto wanted = static_cast<std::size_t>(entry.rank * buckets_of_metre_);
  const std::size_t i = std::max(wanted, front_);
  if (i >= buckets_.size()) buckets_.resize(i + 1);
  buckets_[i].push_back(entry);
  ++waiting_;
}

void DriveField::find_front() {
  while (buckets_[front_].empty()) ++front_;
}

double DriveField::least_cost() {
  find_front();
  return static_cast<double>(static_cast<float>(front_) / buckets_of_metre_);
}

float DriveField::clearance_at(const Node& node) noexcept {
  const auto heading = static_cast<std::size_t>(node.heading);
  return raster_.clearance(node.x, node.y, cos_[heading], sin_[heading]);
}

/// Cost that small clearance adds to a metre.
float DriveField::near_at(float clearance) const noexcept {
  return clearance_weight_ *
         std::max(0.0F, 1.0F - std::max(clearance, 0.0F) * clearances_of_metre_);
}

/// Whether the step to a node is free. Adds the cost of small clearance to the node and its rank.
bool DriveField::enter(Node& node, float& rank) {
  const Node& parent = this->node(node.parent);
  const float clearance = clearance_at(node);
  if (clearance < -raster_.fineness()) return false;  // An obstacle overlaps the body.
  const Segment step = step_to(node);
  const float sure =
      sure_steps * static_cast<float>(std::abs(step.length)) + sure_fineness * raster_.fineness();
  const bool is_sure = clearance >= sure && raster_.is_trusted();
  if (!is_sure && !connector_.is_free(pose(parent), step)) return false;
  if (is_sure && raster_.has_rules() && !connector_.obeys_zones(pose(parent), step)) return false;
  node.is_open = true;
  node.near = near_at(clearance);
  const float added = 0.5F * (node.near + parent.near) * static_cast<float>(std::abs(step.length));
  node.cost += added;
  rank += added;
  return true;
}

void DriveField::expand(std::int32_t id) {
  const Node node = this->node(id);
  const std::size_t count = steps_.size() / static_cast<std::size_t>(headings_);
  const std::span<const Step> steps =
      std::span(steps_).subspan(static_cast<std::size_t>(node.heading) * count, count);
  for (const Step& step : steps) {
    const std::int64_t cell = cell_of(node.x + step.x, node.y + step.y);
    if (cell >= 0) fetch(states_[state_of(cell, step.heading, step.gear)]);
  }
  for (const Step& step : steps) {
    const bool changes = node.gear == -step.gear;
    if (changes && node.side == step.side && node.parent != none) continue;
    const float x = node.x + step.x;
    const float y = node.y + step.y;
    const std::int64_t cell = cell_of(x, y);
    if (cell < 0) continue;
    const std::size_t at = state_of(cell, step.heading, step.gear);
    State& state = states_[at];
    if (state.node != none) continue;
    float cost = node.cost + step.cost;
    if (changes) cost += gear_change_;
    if (node.parent != none) cost += turning_ * static_cast<float>(std::abs(step.side - node.side));
    if (cost >= state.cost || cost >= states_[at ^ 1U].cost + gear_change_) continue;
    const Node next{x, y, cost, 0.0F, id, step.heading, step.side, step.gear, false};
    const float rank = cost + to_go(next, cell);
    if (!(rank <= cutoff_)) continue;
    state.cost = cost;
    push({rank, static_cast<std::int32_t>(nodes_.size())});
    nodes_.push_back(next);
  }
}

std::int32_t DriveField::step() {
  if (waiting_ == 0) return none;
  find_front();
  Entry entry = buckets_[front_].back();
  buckets_[front_].pop_back();
  --waiting_;
  if (!buckets_[front_].empty()) {
    fetch(nodes_[static_cast<std::size_t>(buckets_[front_].back().node)]);
  }
  Node& node = nodes_[static_cast<std::size_t>(entry.node)];
  const std::int64_t cell = cell_of(node.x, node.y);
  if (cell < 0 || entry.rank > cutoff_) return none;
  State& state = states_[state_of(cell, node.heading, node.gear)];
  if (state.node != none) return none;
  if (!node.is_open) {
    if (!enter(node, entry.rank)) return none;
    if (entry.rank * buckets_of_metre_ > static_cast<float>(front_) + patience) {
      push(entry);
      return none;
    }
  }
  state = {node.cost, entry.node};
  expand(entry.node);
  return entry.node;
}

}  // namespace vandplan::search
