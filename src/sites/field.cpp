// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "sites/field.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "base/trigonometry.h"
#include "geometry/boxes.h"

namespace vandplan::sites {
namespace {

using search::CostRule;

/// Costs up to which ways are looked for: turning radii, and sides of the site.
constexpr double most_radii = 160.0;
constexpr double most_sides = 8.0;
constexpr double sure_steps = 0.3;       // clearance above which a step is free [step lengths]
constexpr double sure_fineness = 4.0;    // added to that clearance [errors of the raster]
constexpr double bucket_of_step = 0.98;  // width of a bucket [cheapest step]
constexpr double slack_of_cell = 1e-2;   // by which places may be off [cells]

/// Begins to bring what is needed soon into the cache. A field spends most of its time waiting for
/// memory.
void fetch(const auto& soon) { __builtin_prefetch(&soon); }

}  // namespace

SiteField::SiteField(const SiteGrid& grid, const Bounds& box, const Task& task,
                     const PlanOptions& options)
    : grid_(grid),
      box_(box),
      options_(options),
      turn_(2 * std::numbers::pi / grid.headings),
      x_min_(static_cast<float>(box.x_min)),
      y_min_(static_cast<float>(box.y_min)),
      x_end_(static_cast<float>(box.x_max)),
      y_end_(static_cast<float>(box.y_max)),
      cells_of_metre_(static_cast<float>(1 / grid.cell)),
      most_(static_cast<float>(std::max(
          most_radii * grid.radius, most_sides * (box.x_max - box.x_min + box.y_max - box.y_min)))),
      states_(static_cast<std::size_t>(2 * grid.pairs())),
      labels_(new Label[states_.size()]),
      changed_words_(static_cast<std::size_t>(words_of(grid)), 1) {
  set_ground(task);
  make_steps();
  root();
}

/// The raster is wider than the box of the poses, since bodies reach beyond it.
void SiteField::set_ground(const Task& task) {
  task_ = task;
  rule_ = reversed(search::cost_rule(options_.cost, task_), 0);
  const double longest = std::max(site_step(grid_, 1, 0).length, site_step(grid_, 1, 1).length);
  largest_ = std::max(rule_.clearance_distance, sure_steps * longest);
  double reach = 0.0;
  for (const Point& corner : body_outline(task_.vehicle)) {
    reach = std::max(reach, std::hypot(corner.x, corner.y));
  }
  raster_ =
      std::make_unique<search::ClearanceRaster>(task_, geometry::widened(box_, reach), largest_);
  while (raster_->step()) {
  }
  find_priced_cells(longest, reach);
}

/// `longest`: of the steps [m], `reach`: of the body from the rear axle [m].
void SiteField::find_priced_cells(double longest, double reach) {
  const double around = longest + grid_.cell;  // from the middle of a cell
  std::vector<Bounds> boxes;
  const Surroundings& ground = task_.world->local();
  for (const Zone& zone : ground.zones) {
    if (zone.cost == 1.0) continue;
    const double aside = zone.body ? reach : 0.0;
    boxes.push_back(geometry::widened(bounding_box(zone.area), around + aside));
  }
  for (const Mask& mask : ground.masks) {
    if (mask.use != MaskUse::cost) continue;
    boxes.push_back(geometry::widened(bounding_box(outline(mask.map)), around));
  }
  priced_.clear();
  for (std::int32_t row = 0; row < grid_.rows; ++row) {
    for (std::int32_t column = 0; column < grid_.columns; ++column) {
      const Point middle{box_.x_min + (column + 0.5) * grid_.cell,
                         box_.y_min + (row + 0.5) * grid_.cell};
      priced_.push_back(std::any_of(boxes.begin(), boxes.end(),
                                    [&](const Bounds& box) { return contains(box, middle); }));
    }
  }
}

void SiteField::make_steps() {
  gear_change_ = static_cast<float>(rule_.gear_change_cost);
  turning_ = static_cast<float>(rule_.curvature_change_cost / grid_.radius / arcs_of_site);
  clearance_weight_ = static_cast<float>(rule_.clearance_weight);
  clearances_of_metre_ = static_cast<float>(1 / rule_.clearance_distance);
  double cheapest = std::numeric_limits<double>::infinity();
  const auto first_cell = [this](double way) {
    return static_cast<std::int16_t>(std::floor(-way / grid_.cell - slack_of_cell));
  };
  const auto last_cell = [this](double way) {
    return static_cast<std::int16_t>(std::floor(1 - way / grid_.cell + slack_of_cell));
  };
  for (int heading = 0; heading < grid_.headings; ++heading) {
    const Pose from{0.0, 0.0, task_.goal.heading + heading * turn_};
    headings_.push_back(wrap_angle(from.heading));
    const base::SinCos direction = base::sin_cos(from.heading);
    cos_.push_back(static_cast<float>(direction.cos));
    sin_.push_back(static_cast<float>(direction.sin));
    for (const int gear : {1, -1}) {
      for (int arc = -arcs_of_site; arc <= arcs_of_site; ++arc) {
        const Segment segment = site_step(grid_, gear, arc);
        const double length = std::abs(segment.length);
        const double cost = rule_.weight(gear) * length;
        const Pose to = advance(from, segment);
        const int turned = (heading + side_of_arc(arc) * gear + grid_.headings) % grid_.headings;
        const double sure =
            sure_steps * length + sure_fineness * static_cast<double>(raster_->fineness());
        cheapest = std::min(cheapest, cost);
        steps_.push_back({static_cast<float>(to.x), static_cast<float>(to.y),
                          static_cast<float>(length), static_cast<float>(cost),
                          static_cast<float>(sure), first_cell(to.x), last_cell(to.x),
                          first_cell(to.y), last_cell(to.y), static_cast<std::int16_t>(turned),
                          static_cast<std::int8_t>(arc), static_cast<std::int8_t>(gear)});
      }
    }
  }
  buckets_of_metre_ = static_cast<float>(1 / (bucket_of_step * cheapest));
}

/// Forgets all labels.
void SiteField::reset() {
  std::ranges::fill(states_, State{});
  std::ranges::fill(changed_words_, std::uint8_t{1});
  buckets_.clear();
}

/// [2] Makes the label of the goal, if the goal is free. All labels depend on it.
void SiteField::root() {
  Label label{};
  label.x = static_cast<float>(task_.goal.x);
  label.y = static_cast<float>(task_.goal.y);
  label.near = near_at(raster_->clearance(label.x, label.y, cos_[0], sin_[0]));
  label.parent = none;
  label.is_sure = true;
  const std::int64_t cell = cell_of(label.x, label.y);
  if (cell < 0) return;
  root_ = state_of(cell, 0, 1);
  const bool is_free = task_.checker->is_free(task_.goal);
  const bool is_known = states_[root_].cost == 0.0F;
  if (is_known && is_free && labels_[root_].near == label.near) return;
  if (is_known) reset();
  if (is_free) take({root_, 0.0F, label});
}

const SiteField::Step& SiteField::step_of(int heading, int gear, int arc) const noexcept {
  return steps_[static_cast<std::size_t>((heading * 2 + (gear < 0 ? 1 : 0)) * arcs + arc +
                                         arcs_of_site)];
}

std::span<const SiteField::Step> SiteField::steps_from(int heading) const noexcept {
  return {&steps_[static_cast<std::size_t>(heading * 2 * arcs)], 2 * arcs};
}

LocalPose SiteField::pose(const Label& label) const noexcept {
  return Local(Pose{static_cast<double>(label.x), static_cast<double>(label.y),
                    headings_[static_cast<std::size_t>(label.heading)]});
}

std::int64_t SiteField::cell_of(float x, float y) const noexcept {
  const float column = (x - x_min_) * cells_of_metre_;
  const float row = (y - y_min_) * cells_of_metre_;
  const bool is_inside = column >= 0.0F && row >= 0.0F &&
                         column < static_cast<float>(grid_.columns) &&
                         row < static_cast<float>(grid_.rows) && x <= x_end_ && y <= y_end_;
  if (!is_inside) return -1;
  return static_cast<std::int64_t>(row) * grid_.columns + static_cast<std::int64_t>(column);
}

SiteField::Id SiteField::state_of(std::int64_t cell, int heading, int gear) const noexcept {
  return static_cast<Id>((cell * grid_.headings + heading) * 2 + (gear < 0 ? 1 : 0));
}

/// Cost that small clearance adds to a metre.
float SiteField::near_at(float clearance) const noexcept {
  return clearance_weight_ *
         std::max(0.0F, 1.0F - std::max(clearance, 0.0F) * clearances_of_metre_);
}

// ---- offers ----

/// Cost at the end of a step, without surcharges; infinite for a step that must not be driven.
float SiteField::cost_of(const Label& from, float cost, const Step& step) const noexcept {
  cost += step.cost;
  if (from.gear == 0) return cost;
  if (from.gear != step.gear) {
    if (from.arc == step.arc) return infinite;  // back where it came from
    cost += gear_change_;
  }
  return cost + turning_ * static_cast<float>(std::abs(step.arc - from.arc));
}

/// Whether a label of this cost may be the one of a state. Labels are dropped that cost at least as
/// much as the one in the other gear and a gear change.
bool SiteField::is_worth(Id state, float cost) const noexcept {
  if (!(cost <= states_[state].cost) || cost > most_) return false;
  const Id twin = state ^ 1U;
  return states_[twin].status != Status::settled || !is_beaten(state, cost, twin);
}

bool SiteField::is_beaten(Id state, float cost, Id twin) const noexcept {
  const float other = states_[twin].cost + gear_change_;
  return other < cost || (other == cost && twin < state);
}

/// [3] Equal costs are told apart by the states that they come from, so that order decides nothing.
bool SiteField::is_better(const Offer& offer) const noexcept {
  if (!is_worth(offer.state, offer.cost)) return false;
  if (offer.cost < states_[offer.state].cost) return true;
  const Label& label = labels_[offer.state];
  return std::pair(offer.label.parent, offer.label.arc) < std::pair(label.parent, label.arc);
}

/// Cost that small clearance and zones add to a step.
float SiteField::surcharge(const Label& from, const Label& to) const {
  const float near = to.near + from.near;
  const bool has_price =
      rule_.has_priced_ground && priced_[static_cast<std::size_t>(cell_of(from.x, from.y))];
  if (near == 0.0F && !has_price) return 0.0F;
  const Segment step = site_step(grid_, to.gear, to.arc);
  double metres = std::abs(step.length);
  if (has_price) {
    metres = 0.0;
    for (const GroundPart& part : task_.checker->ground_along(pose(from), step)) {
      metres += part.cost * (part.end - part.begin);
    }
  }
  const double factor = 1.0 + 0.5 * static_cast<double>(near);
  return static_cast<float>(rule_.weight(to.gear) * (factor * metres - std::abs(step.length)));
}

/// Adds what the raster knows to an offer. False if an obstacle overlaps the body.
bool SiteField::look_at(Offer& offer) const {
  Label& label = offer.label;
  const auto heading = static_cast<std::size_t>(label.heading);
  const float clearance = raster_->clearance(label.x, label.y, cos_[heading], sin_[heading]);
  if (clearance < -raster_->fineness()) return false;
  const Label& from = labels_[label.parent];
  label.near = near_at(clearance);
  label.is_sure = is_trusted() && clearance >= step_of(from.heading, label.gear, label.arc).sure;
  offer.cost += surcharge(from, label);
  return true;
}

/// The exact check of the step to a label.
bool SiteField::is_free(const Label& label) const {
  return task_.checker->is_free(pose(labels_[label.parent]),
                                site_step(grid_, label.gear, label.arc), rule_.in_time);
}

void SiteField::take(const Offer& offer) {
  states_[offer.state].cost = offer.cost;
  labels_[offer.state] = offer.label;
  push(offer.state, offer.cost);
}

/// Takes the best free offer of all settled states, if it betters the label.
void SiteField::pull(Id state) {
  const int gear = state % 2 == 0 ? 1 : -1;
  if (!rule_.allows(gear)) return;
  const auto headings = static_cast<Id>(2 * grid_.headings);
  const auto heading = static_cast<int>(state % headings / 2);
  const auto column = static_cast<std::int32_t>(state / headings % static_cast<Id>(grid_.columns));
  const auto row = static_cast<std::int32_t>(state / headings / static_cast<Id>(grid_.columns));
  for (int arc = -arcs_of_site; arc <= arcs_of_site; ++arc) {
    const int before = (heading - side_of_arc(arc) * gear + grid_.headings) % grid_.headings;
    const Step& step = step_of(before, gear, arc);
    const std::int32_t left = std::max(0, column + step.left);
    const std::int32_t right = std::min(grid_.columns - 1, column + step.right);
    const std::int32_t high = std::min(grid_.rows - 1, row + step.high);
    for (std::int32_t y = std::max(0, row + step.low); y <= high; ++y) {
      for (std::int32_t x = left; x <= right; ++x) {
        const Id first = state_of(std::int64_t{y} * grid_.columns + x, before, 1);
        pull_from(first, step, state);
        pull_from(first + 1, step, state);
      }
    }
  }
}

void SiteField::pull_from(Id from, const Step& step, Id state) {
  const bool is_of_use = states_[from].status == Status::settled &&
                         states_[from].cost + step.cost <= states_[state].cost;
  if (!is_of_use) return;
  const Label& label = labels_[from];
  const float x = label.x + step.x;
  const float y = label.y + step.y;
  const std::int64_t cell = cell_of(x, y);
  if (cell < 0 || state_of(cell, step.heading, step.gear) != state) return;
  Offer offer{state, cost_of(label, states_[from].cost, step),
              Label{x, y, 0.0F, from, step.heading, step.arc, step.gear, false, false}};
  if (!is_worth(state, offer.cost) || !look_at(offer) || !is_better(offer)) return;
  if (!offer.label.is_sure && !is_free(offer.label)) return;
  offer.label.is_checked = !offer.label.is_sure;
  take(offer);
}

// ---- Dijkstra's algorithm ----

std::size_t SiteField::bucket_of(float cost) const noexcept {
  return static_cast<std::size_t>(cost * buckets_of_metre_);
}

void SiteField::push(Id state, float cost) {
  const std::size_t bucket = std::max(front_, bucket_of(cost));
  if (bucket >= buckets_.size()) buckets_.resize(bucket + 1);
  buckets_[bucket].push_back(state);
}

/// Makes sure of a label that costs no more than the front. Whatever could better it is settled.
void SiteField::confirm(Id state) {
  if (states_[state].status == Status::settled) return;
  if (states_[state].status == Status::orphan) {
    states_[state].status = Status::open;
    // No offer costs less than the front, so most states are beaten by their twins.
    if (is_worth(state, static_cast<float>(front_) / buckets_of_metre_)) pull(state);
  }
  if (!is_ripe(state)) return;
  Label& label = labels_[state];
  if (label.is_sure || label.is_checked) return;
  label.is_checked = is_free(label);
  if (label.is_checked) return;
  states_[state].cost = infinite;
  pull(state);
}

bool SiteField::is_ripe(Id state) const noexcept {
  return states_[state].status != Status::settled && states_[state].cost < infinite &&
         bucket_of(states_[state].cost) <= front_;
}

bool SiteField::spread(const std::function<bool()>& is_over) {
  for (front_ = 0; front_ < buckets_.size(); ++front_) {
    if (!buckets_[front_].empty() && is_over()) {
      front_ = 0;
      return false;
    }
    // In the order of memory, which is faster.
    std::ranges::sort(buckets_[front_]);
    const auto again = std::unique(buckets_[front_].begin(), buckets_[front_].end());
    buckets_[front_].erase(again, buckets_[front_].end());
    for (std::size_t i = 0; i < buckets_[front_].size(); ++i) confirm(buckets_[front_][i]);
    for (const Id state : buckets_[front_]) {
      if (is_ripe(state) && is_beaten(state, states_[state].cost, state ^ 1U))
        states_[state].cost = infinite;
    }
    const std::vector<Id> ripe = std::exchange(buckets_[front_], {});
    for (std::size_t i = 0; i < ripe.size(); ++i) {
      if (i + 1 < ripe.size()) fetch(labels_[ripe[i + 1]]);
      if (is_ripe(ripe[i])) settle(ripe[i]);
    }
  }
  front_ = 0;
  return true;
}

void SiteField::settle(Id state) {
  states_[state].status = Status::settled;
  mark(state);
  const Id twin = state ^ 1U;
  if (states_[twin].cost < infinite && is_beaten(twin, states_[twin].cost, state)) withdraw(twin);
  expand(state);
}

void SiteField::expand(Id state) {
  const Label from = labels_[state];
  const float cost_so_far = states_[state].cost;
  std::array<Id, 2 * arcs> ends;
  const std::span<const Step> steps = steps_from(from.heading);
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const std::int64_t cell = cell_of(from.x + steps[i].x, from.y + steps[i].y);
    ends[i] = cell < 0 ? none : state_of(cell, steps[i].heading, steps[i].gear);
    if (cell >= 0) fetch(states_[ends[i]]);
  }
  for (std::size_t i = 0; i < ends.size(); ++i) {
    const Step& step = steps[i];
    const float cost = cost_of(from, cost_so_far, step);
    if (ends[i] == none || !is_worth(ends[i], cost)) continue;
    Offer offer{ends[i], cost,
                Label{from.x + step.x, from.y + step.y, 0.0F, state, step.heading, step.arc,
                      step.gear, false, false}};
    if (!look_at(offer) || !is_better(offer)) continue;
    if (states_[offer.state].status == Status::settled) {
      // Only among changes. What is settled gives way to nothing but what is known to be free.
      if (!offer.label.is_sure && !is_free(offer.label)) continue;
      offer.label.is_checked = !offer.label.is_sure;
      withdraw(offer.state);
    }
    take(offer);
  }
}

}  // namespace vandplan::sites
