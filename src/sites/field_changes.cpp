// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Repair of a field where the ground has changed.
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/trigonometry.h"
#include "sites/field.h"
#include "vandplan/vehicle.h"

namespace vandplan::sites {
namespace {

constexpr double raster_cells = 3.0;  // by which a place of the raster may be off [its cells]

}  // namespace

void SiteField::renew(const Task& task, std::span<const GroundChange> changed) {
  const bool had_prices = rule_.has_priced_ground;
  const bool was_trusted = is_trusted();
  set_ground(task);
  if (rule_.has_priced_ground != had_prices || is_trusted() != was_trusted) reset();
  root();
  double longest = 0.0;
  for (const Step& step : steps_) longest = std::max(longest, static_cast<double>(step.length));
  const double seen = std::max(
      task_.least_margin + largest_ + raster_cells * 4 * static_cast<double>(raster_->fineness()),
      options_.clearance.margin + longest + swing(longest));
  for (const GroundChange& change : changed) {
    for_states_near(change.box, seen, [&](Id state) {
      if (!still_holds(state, change.box)) clear(state);
    });
  }
  for (const GroundChange& change : changed) {
    if (!change.frees) continue;
    for_states_near(change.box, seen + longest + swing(longest), [&](Id state) {
      if (states_[state].status == Status::settled) expand(state);
    });
  }
}

/// How far a point of the body moves aside at most on a step of that length [m].
double SiteField::swing(double length) const {
  const Footprint body = footprint(task_.vehicle);
  return turn_ * (std::max(body.front, body.rear) + length);
}

/// Visits all states with labels whose bodies come so near to a box, and some more.
template <typename Visit>
void SiteField::for_states_near(const Bounds& box, double distance, Visit visit) const {
  const Footprint body = footprint(task_.vehicle);
  const double middle = (body.front - body.rear) / 2;
  const double half = grid_.cell / 2;
  const double reach = distance + std::hypot((body.front + body.rear) / 2, body.half_width) +
                       grid_.cell;  // from the middle of a cell
  const auto visit_if_near = [&](Id state) {
    if (has_label_near(state, box, distance)) visit(state);
  };
  for (int heading = 0; heading < grid_.headings; ++heading) {
    const auto i = static_cast<std::size_t>(heading);
    const double x = box_.x_min + half + middle * static_cast<double>(cos_[i]);
    const double y = box_.y_min + half + middle * static_cast<double>(sin_[i]);
    const auto index = [this](double offset, std::int32_t count) {
      return static_cast<std::int64_t>(std::clamp(offset / grid_.cell, 0.0, count - 1.0));
    };
    const std::int64_t right = index(box.x_max + reach - x, grid_.columns);
    const std::int64_t high = index(box.y_max + reach - y, grid_.rows);
    for (std::int64_t row = index(box.y_min - reach - y, grid_.rows); row <= high; ++row) {
      for (std::int64_t column = index(box.x_min - reach - x, grid_.columns); column <= right;
           ++column) {
        const Id first = state_of(row * grid_.columns + column, heading, 1);
        visit_if_near(first);
        visit_if_near(first + 1);
      }
    }
  }
}

bool SiteField::has_label_near(Id state, const Bounds& box, double distance) const {
  return states_[state].cost < infinite && is_near(labels_[state], box, distance, distance);
}

/// [2] Whether the step to a state is still free and costs the same. What was exactly free is so
/// where nothing has changed.
bool SiteField::still_holds(Id state, const Bounds& changed) {
  Label& label = labels_[state];
  if (label.parent == none) return true;  // `root` has seen to it
  const Label& from = labels_[label.parent];
  const Step& step = step_of(from.heading, label.gear, label.arc);
  Offer offer{state, cost_of(from, states_[label.parent].cost, step), label};
  if (!look_at(offer)) return false;
  if (offer.cost != states_[state].cost || offer.label.near != label.near) return false;
  const double margin = options_.clearance.margin + 2 * CollisionChecker::tolerance;
  const auto length = static_cast<double>(step.length);
  const double aside = step.arc == 0 ? 0.0 : swing(length);
  const double turned = step.arc == 0 ? 0.0 : turn_ * footprint(task_.vehicle).half_width;
  if (is_near(label, changed, margin + length + turned, margin + aside)) label.is_checked = false;
  label.is_sure = offer.label.is_sure;
  if (label.is_sure || label.is_checked) return true;
  label.is_checked = is_free(label);
  return label.is_checked;
}

/// Whether the body at a label comes so near to a box, ahead of it or aside.
bool SiteField::is_near(const Label& label, const Bounds& box, double ahead, double aside) const {
  const Footprint body = footprint(task_.vehicle);
  const auto heading = static_cast<std::size_t>(label.heading);
  const auto cos = static_cast<double>(cos_[heading]);
  const auto sin = static_cast<double>(sin_[heading]);
  const double x = (box.x_min + box.x_max) / 2 - static_cast<double>(label.x);
  const double y = (box.y_min + box.y_max) / 2 - static_cast<double>(label.y);
  const double half_width = (box.x_max - box.x_min) / 2;
  const double half_height = (box.y_max - box.y_min) / 2;
  const double along = half_width * std::abs(cos) + half_height * std::abs(sin) + ahead;
  const double across = half_width * std::abs(sin) + half_height * std::abs(cos) + aside;
  const double forward = cos * x + sin * y;
  return forward <= body.front + along && forward >= -body.rear - along &&
         std::abs(cos * y - sin * x) <= body.half_width + across;
}

/// Asks for a label again, when the states are settled that may offer one at such a cost. So does
/// the state in the other gear: the label may have kept better offers from it than it has taken
/// since.
void SiteField::orphan(Id state, float cost) {
  const auto ask = [this](Id which, float at) {
    states_[which].status = Status::orphan;
    push(which, at);
  };
  ask(state, cost);
  const State& twin = states_[state ^ 1U];
  if (twin.status != Status::settled && twin.cost >= cost + gear_change_) {
    ask(state ^ 1U, cost + gear_change_);
  }
}

/// Takes the label from a state, and the labels that depend on it.
void SiteField::withdraw(Id state) {
  withdrawn_.assign(1, state);
  for (bool is_first = true; !withdrawn_.empty(); is_first = false) {
    const Id next = withdrawn_.back();
    withdrawn_.pop_back();
    const float cost = std::exchange(states_[next].cost, infinite);
    if (states_[next].status == Status::settled) {
      states_[next].status = Status::open;
      find_children(next, cost);
      mark(next);
    }
    if (!is_first) orphan(next, cost);
  }
}

/// Takes the label from a state whose step does not hold any more.
void SiteField::clear(Id state) {
  const float cost = states_[state].cost;
  withdraw(state);
  orphan(state, cost);
}

/// Adds the states whose labels come from a state.
void SiteField::find_children(Id state, float cost) {
  const Label& from = labels_[state];
  for (const Step& step : steps_from(from.heading)) {
    if (cost_of(from, cost, step) == infinite) continue;
    const std::int64_t cell = cell_of(from.x + step.x, from.y + step.y);
    if (cell < 0) continue;
    const Id child = state_of(cell, step.heading, step.gear);
    const bool is_child = states_[child].cost < infinite && labels_[child].parent == state &&
                          labels_[child].arc == step.arc;
    if (is_child) withdrawn_.push_back(child);
  }
}

// ---- numbers ----

/// [4] What a table keeps of a state.
SiteRecord SiteField::record(Id state) const {
  const Label& label = labels_[state];
  SiteRecord record{.pair = state / 2,
                    .gear = state % 2 == 0 ? -1 : 1,
                    .entry = {.cost = static_cast<double>(states_[state].cost)}};
  record.entry.is_goal = label.parent == none;
  if (record.entry.is_goal) return record;
  const auto headings = static_cast<std::int32_t>(2 * grid_.headings);
  const std::int32_t here = static_cast<std::int32_t>(state) / headings;
  const std::int32_t next = static_cast<std::int32_t>(label.parent) / headings;
  record.entry.arc = label.arc;
  record.entry.rows = next / grid_.columns - here / grid_.columns;
  record.entry.columns = next - here - record.entry.rows * grid_.columns;
  record.entry.next_gear = label.parent == root_ ? 0 : label.parent % 2 == 0 ? -1 : 1;
  return record;
}

void SiteField::write(std::string& numbers, SiteLayer& layer) {
  double largest = 0.0;
  for (const State& state : states_) {
    if (state.cost < infinite) largest = std::max(largest, static_cast<double>(state.cost));
  }
  const auto records_of = [this](std::uint64_t word, std::vector<SiteRecord>& records) {
    const auto end =
        static_cast<Id>(std::min<std::uint64_t>(states_.size(), (word + 1) * 2 * pairs_of_word));
    for (auto id = static_cast<Id>(word * 2 * pairs_of_word); id < end; id += 2) {
      // Records begin with driving forward, which is the reverse of the field.
      for (const Id state : {id + 1, id}) {
        if (states_[state].status == Status::settled) records.push_back(record(state));
      }
    }
  };
  numbers = layer_to_bytes(grid_, {largest, changed_words_, records_of}, layer, numbers);
  std::ranges::fill(changed_words_, std::uint8_t{0});
}

}  // namespace vandplan::sites
