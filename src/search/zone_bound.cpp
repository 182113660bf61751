// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "search/zone_bound.h"

#include <algorithm>
#include <cmath>

#include "geometry/boxes.h"
#include "geometry/polygon.h"
#include "vandplan/vehicle.h"

namespace vandplan::search {
namespace {

constexpr double coarsest_cell = 0.5;         // [m]
constexpr double coarsest_priced_cell = 1.0;  // it tells soon what wide zones add [m]
constexpr double finest_cell = 0.05;          // [m]
constexpr double slack_of_edges = 2e-3;       // of places; larger than all tolerances [m]
constexpr double slack_of_ends = 2e-6;        // of a path's ends; larger than the judge's [m]
constexpr double slowest = 1e3;               // longest time that a metre takes in a proof [s]
constexpr int entries_of_step = 64;
/// Least ratio of a straight distance to the way along sides and diagonals of cells, cos(pi / 8),
/// less rounding of sums.
constexpr double straight_of_octagon = 0.9237;

/// Half the diagonal of a cell and some slack: all of it is as near to its middle [m].
double reach_of_cell(double side) { return side * std::sqrt(0.5) + slack_of_edges; }

Bounds at_point(const LocalPose& pose) { return {pose.x, pose.x, pose.y, pose.y}; }

AllowedGears other_gear(GearSign only) {
  return only > 0 ? AllowedGears::reverse : AllowedGears::forward;
}

}  // namespace

// Entries at no cost need no order: only streets do.
void ZoneBound::Front::push(const Entry& entry) {
  if (entry.cost <= level_ && entry.along == -endless) {
    now_.push_back(entry);
  } else {
    later_.push(entry);
  }
}

ZoneBound::Entry ZoneBound::Front::take() {
  if (now_.empty()) {
    const Entry entry = later_.top();
    later_.pop();
    level_ = entry.cost;
    return entry;
  }
  const Entry entry = now_.back();
  now_.pop_back();
  return entry;
}

// Where a way leaves the box around all that counts, each of its places can be moved to the nearest
// one of the box, where there are no rules, prices and obstacles.
ZoneBound::ZoneBound(const Task& task, GearSign only, const MetreCost& cost,
                     const std::vector<Bounds>& places)
    : task_(task),
      cost_(cost),
      places_(places),
      clearance_(inner_radius(task.vehicle)),
      one_way_(task.world->local().zones, {0.0, clearance_}, task.vehicle.min_turning_radius,
               task.world->local().bounds) {
  const Surroundings& ground = task.world->local();
  for (const Zone& zone : ground.zones) {
    if (!zone.closed && (only == 0 || zone.gears != other_gear(only))) continue;
    closed_.push_back({zone.area, zone.body ? clearance_ : 0.0});
  }
  for (const Zone& zone : ground.zones) {
    if (zone.cost == 1.0 && !zone.max_speed) continue;
    const double near = zone.body ? clearance_ : 0.0;
    priced_.push_back({geometry::widened(bounding_box(zone.area), near), &zone, near});
  }
  for (const Mask& mask : ground.masks) {
    if (mask.use != MaskUse::obstacles) masks_.emplace_back(mask);
  }
  const bool has_prices = (cost.priced > 0.0 && task.checker->has_prices()) ||
                          (cost.second > 0.0 && task.checker->has_speed_limits());
  const bool has_streets = !one_way_.barring().empty();
  const bool counts = is_priced() ? has_prices || (has_streets && cost.anywhere > 0.0)
                                  : has_streets || !closed_.empty();
  if (!counts && places.empty()) return;
  if (places.empty()) places_ = {at_point(task.goal)};
  const double coarsest = is_priced() ? coarsest_priced_cell : coarsest_cell;
  const double around = 2 * (clearance_ + task.least_margin) + 2 * coarsest;
  box_ = geometry::shared(ground.bounds, geometry::widened(scene(), around));
  side_ = 2 * coarsest;
  while (cells_of(side_ / 2) > most_cells()) side_ *= 2;
  if (!next_lattice()) side_ = 0.0;
}

double ZoneBound::most_cells() const noexcept { return is_priced() ? 1e6 : 4e6; }

/// Number of cells of a side [m].
double ZoneBound::cells_of(double side) const noexcept {
  return ((box_.x_max - box_.x_min) / side + 1) * ((box_.y_max - box_.y_min) / side + 1);
}

bool ZoneBound::is_priced() const noexcept {
  return cost_.anywhere + cost_.priced + cost_.second > 0.0;
}

/// Box around start, goal, zones, masks and obstacles.
Bounds ZoneBound::scene() const {
  const Surroundings& ground = task_.world->local();
  Bounds scene = at_point(task_.start);
  const auto add = [&](const Bounds& box) { scene = geometry::united(scene, box); };
  for (const Bounds& box : places_) add(box);
  for (const ClosedArea& closed : closed_) add(bounding_box(closed.area));
  for (const Bounds& street : one_way_.barring()) add(street);
  if (is_priced()) {
    for (const Zone& zone : ground.zones) add(bounding_box(zone.area));
    for (const Mask& mask : ground.masks) add(bounding_box(outline(mask.map)));
  }
  for (const Polygon& obstacle : ground.obstacles) add(bounding_box(obstacle));
  if (ground.map) add(bounding_box(outline(*ground.map)));
  return scene;
}

/// Takes the next lattice on which the cells of start and goal are open and differ. False if there
/// is none.
bool ZoneBound::next_lattice() {
  for (;;) {
    side_ /= 2;
    if (side_ < finest_cell || !(cells_of(side_) <= most_cells())) return false;
    columns_ = static_cast<std::int64_t>((box_.x_max - box_.x_min) / side_ + 1);
    rows_ = static_cast<std::int64_t>((box_.y_max - box_.y_min) / side_ + 1);
    const double near = clearance_ + task_.least_margin - reach_of_cell(side_);
    uses_obstacles_ = near > 0.0;
    if (uses_obstacles_) open_rows_ = OpenRows(task_, box_, side_, near);
    known_.clear();
    known_.resize(static_cast<std::size_t>(columns_ * rows_) / Row{}.size() + 1);
    held_ = 0;
    const bool meet = begin_all();
    if (!meet && fronts_[start].size() > 0 && fronts_[goal].size() > 0) return true;
  }
}

/// Lets both floods begin. True if they meet at once.
bool ZoneBound::begin_all() {
  fronts_ = {};
  goals_.clear();
  if (begin(start, at_point(task_.start))) return true;
  return std::ranges::any_of(places_, [this](const Bounds& box) { return begin(goal, box); });
}

/// Lets a flood begin at the open cells around a box. True if the floods meet there.
bool ZoneBound::begin(End end, const Bounds& box) {
  const auto cell_of = [&](double place, std::int64_t count) {
    return std::clamp<std::int64_t>(static_cast<std::int64_t>(place / side_), 0, count - 1);
  };
  const auto [x_min, x_max, y_min, y_max] = geometry::widened(box, slack_of_ends);
  const Point middle{box.x_min + (box.x_max - box.x_min) / 2,
                     box.y_min + (box.y_max - box.y_min) / 2};
  const double off = (box.x_max - box.x_min + box.y_max - box.y_min) / 2 + slack_of_edges;
  bool are_met = false;
  const std::int64_t last_column = cell_of(x_max - box_.x_min, columns_);
  const std::int64_t last_row = cell_of(y_max - box_.y_min, rows_);
  for (std::int64_t column = cell_of(x_min - box_.x_min, columns_); column <= last_column;
       ++column) {
    for (std::int64_t row = cell_of(y_min - box_.y_min, rows_); row <= last_row; ++row) {
      const std::int64_t cell = row * columns_ + column;
      if (!is_open(cell)) continue;
      if (end == goal) goals_.push_back(cell);
      float along = -endless;
      if (const int street = cell_at(cell).street; street >= 0) {
        along = one_way_.range_along(street, middle, off, end == goal).least;
      }
      for (int corner = 0; corner < (is_priced() ? 4 : 1); ++corner) {
        are_met |= reach(end, {0.0F, along, cell, corner});
      }
    }
  }
  return are_met;
}

Point ZoneBound::middle_of(std::int64_t cell) const {
  const std::int64_t column = cell % columns_;
  const std::int64_t row = cell / columns_;
  return {box_.x_min + (static_cast<double>(column) + 0.5) * side_,
          box_.y_min + (static_cast<double>(row) + 0.5) * side_};
}

/// What is known of a cell. The reference stays valid for this lattice.
ZoneBound::Known& ZoneBound::known(std::int64_t cell) {
  const auto number = static_cast<std::size_t>(cell);
  std::unique_ptr<Row>& row = known_[number / Row{}.size()];
  if (!row) {
    row = std::make_unique<Row>();
    held_ += static_cast<std::int64_t>(row->size());
  }
  return (*row)[number % row->size()];
}

/// Cost of a metre at the cheapest place of a cell; infinite if it is closed.
double ZoneBound::metre_at(const Point& middle) const {
  const double reach = reach_of_cell(side_);
  const Bounds& bounds = task_.world->local().bounds;
  for (const auto& [area, near] : closed_) {
    if (geometry::distance_in_bounds(area, bounds, middle) <= near - reach) return endless;
  }
  if (!is_priced()) return 0.0;
  GroundPart part;
  for (const auto& [box, zone, near] : priced_) {
    const bool holds_all = contains(geometry::widened(box, reach), middle) &&
                           geometry::distance_in_bounds(zone->area, bounds, middle) <= near - reach;
    if (!holds_all) continue;
    part.cost *= zone->cost;
    part.max_speed = std::min(part.max_speed, zone->max_speed.value_or(part.max_speed));
  }
  for (const collision::MaskCells& mask : masks_) mask.tell_least(middle, reach, part);
  const auto is_near = [&](const LocalPose& end, double ramp) {
    return ramp > 0.0 && std::hypot(end.x - middle.x, end.y - middle.y) <= ramp + reach;
  };
  const bool is_on_ramp =
      is_near(task_.start, cost_.ramps[0]) || is_near(task_.goal, cost_.ramps[1]);
  double metre = cost_.anywhere + cost_.priced * (part.cost - 1);
  if (cost_.second > 0.0 && part.max_speed < cost_.top_speed && !is_on_ramp) {
    metre += cost_.second * std::min(1 / part.max_speed - 1 / cost_.top_speed, slowest);
  }
  return metre;
}

const ZoneBound::Cell& ZoneBound::cell_at(std::int64_t number) {
  Cell& cell = known(number).cell;
  if (cell.metre >= 0.0F) return cell;
  cell.metre = endless;
  if (uses_obstacles_) {
    const auto column = static_cast<std::int32_t>(number % columns_);
    const OpenRows::Row& runs = open_rows_.row(static_cast<std::int32_t>(number / columns_));
    const auto is_in = [&](const OpenRows::Run& r) { return r.begin <= column && column < r.end; };
    if (std::none_of(runs.begin(), runs.end(), is_in)) return cell;
  }
  const Point middle = middle_of(number);
  cell.metre = static_cast<float>(metre_at(middle));
  cell.street = static_cast<std::int16_t>(one_way_.street_of(middle, side_ * std::sqrt(0.5)));
  return cell;
}

bool ZoneBound::is_open(std::int64_t cell) { return cell_at(cell).metre < endless; }

/// Whether a path may lead through a cell that both floods reached. The place along a street grows
/// from the start on; the flood from the goal knows its opposite.
bool ZoneBound::meet(const Known& cell) {
  const float from_start = cell.reached[start][0], to_goal = cell.reached[goal][0];
  if (from_start == endless || to_goal == endless) return false;
  return from_start <= -to_goal + static_cast<float>(slack_of_edges);
}

/// Adds an entry to a flood, unless one is known that is as good. True if a path may have arrived:
/// the floods meet.
bool ZoneBound::reach(End end, const Entry& entry) {
  Known& cell = known(entry.cell);
  float& along = cell.reached[end][static_cast<std::size_t>(entry.corner)];
  if (is_priced()) {  // Whether it is as good is known when its turn comes.
    if (along > entry.along) fronts_[end].push(entry);
    return false;
  }
  if (along <= entry.along) return false;
  along = entry.along;
  fronts_[end].push(entry);
  return meet(cell);
}

/// Crosses a side of an entry's cell, if a path may. True if the floods meet. Sides are numbered
/// from the right, counter-clockwise.
bool ZoneBound::cross(End end, const Entry& entry, int side) {
  const std::int64_t column = entry.cell % columns_, row = entry.cell / columns_;
  const bool is_across = side % 2 == 0;
  const int step = side < 2 ? 1 : -1;
  const std::int64_t to = is_across ? column + step : row + step;
  if (to < 0 || to >= (is_across ? columns_ : rows_)) return false;
  const std::int64_t cell = entry.cell + (is_across ? step : step * columns_);
  if (!is_open(cell)) return false;
  const Point middle = middle_of(entry.cell);
  const Point of_side{middle.x + (is_across ? step * side_ / 2 : 0.0),
                      middle.y + (is_across ? 0.0 : step * side_ / 2)};
  if (one_way_.bars(of_side, side_, end == start ? side : (side + 2) % 4)) return false;
  const int before = cell_at(entry.cell).street, after = cell_at(cell).street;
  float along = -endless;
  for (const int street : {before, after}) {
    if (street < 0) continue;
    const auto [least, most] = one_way_.range_along(street, of_side, side_ / 2, end == goal);
    if (street == before && most < entry.along - static_cast<float>(slack_of_edges)) return false;
    if (street == after) along = before == after ? std::max(entry.along, least) : least;
  }
  return reach(end,
               {entry.cost, along, cell, is_priced() ? entry.corner ^ (is_across ? 1 : 2) : 0});
}

/// Expands the cheapest entry of a flood. True when it arrives.
bool ZoneBound::expand(End end) {
  const Entry entry = fronts_[end].take();
  float& along = known(entry.cell).reached[end][static_cast<std::size_t>(entry.corner)];
  if (!is_priced()) {
    if (along < entry.along) return false;
    bool are_met = false;
    for (int side = 0; side < 4; ++side) are_met |= cross(end, entry, side);
    return are_met;
  }
  if (along <= entry.along) return false;
  along = entry.along;
  bound_ = std::max(bound_, straight_of_octagon * static_cast<double>(entry.cost));
  if (std::ranges::find(goals_, entry.cell) != goals_.end()) return true;
  const double metre = static_cast<double>(cell_at(entry.cell).metre);
  for (const int corner : {1, 2, 3}) {
    const double length = corner == 3 ? side_ * std::sqrt(2.0) : side_;
    const float cost = entry.cost + static_cast<float>(metre * length);
    (void)reach(end, {cost, entry.along, entry.cell, entry.corner ^ corner});
  }
  (void)cross(end, entry, (entry.corner & 1) != 0 ? 0 : 2);
  (void)cross(end, entry, (entry.corner & 2) != 0 ? 1 : 3);
  return false;
}

bool ZoneBound::step() {
  if (side_ == 0.0 || is_proven_) return false;
  for (int i = 0; i < entries_of_step; ++i) {
    const bool is_from_start = is_priced() || fronts_[start].size() <= fronts_[goal].size();
    const End end = is_from_start ? start : goal;
    if (fronts_[end].size() == 0) {
      is_proven_ = true;
      return false;
    }
    if (!expand(end)) continue;
    if (!next_lattice()) side_ = 0.0;
    return side_ != 0.0;
  }
  return true;
}

}  // namespace vandplan::search
