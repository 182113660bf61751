// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/leg_bounds.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "search/open_rows.h"
#include "steering/words.h"

namespace vandplan::planning {
namespace {

constexpr double no_chain = std::numeric_limits<double>::infinity();
constexpr double fine_part = 1e-4;  // finest size of a part, relative to the bound
constexpr std::array<search::GearSign, 2> gear_signs = {1, -1};

double gap_between(const Bounds& a, const Bounds& b) {
  const double dx = std::max({a.x_min - b.x_max, b.x_min - a.x_max, 0.0});
  const double dy = std::max({a.y_min - b.y_max, b.y_min - a.y_max, 0.0});
  return std::hypot(dx, dy);
}

/// The part that holds one pose, up to what it may be off.
PlacedPart placed_pose(const Pose& pose, const steering::Closing& off) {
  return {
      pose,
      off,
      {pose.x - off.position, pose.x + off.position, pose.y - off.position, pose.y + off.position}};
}

/// Whether the rear axle is at one place in the region, with any headings.
bool is_one_place(const GoalRegion* region) {
  if (region == nullptr) return true;
  const auto& [x, y] = std::pair(region->x, region->y);
  return region->area.empty() && !region->is_of_trailer && x.least == x.most && y.least == y.most;
}

}  // namespace

LegBounds::LegBounds(const Task& task, const Pricing& pricing, std::int64_t work)
    : pricing_(pricing),
      vehicle_(task.vehicle),
      via_(task.via),
      rule_(pricing.rule()),
      work_(work) {
  // By length, bounds hold for exact ends.
  const steering::Closing off = rule_.is_length() ? steering::Closing{} : steering::judged;
  if (pricing.counts_time()) rule_ = search::length_rule(rule_);
  stages_.push_back({{placed_pose(task.start, off)}});
  for (const Via& via : task.via) add_stops(task, via.any_of, false);
  if (task.goal_set.empty()) {
    stages_.push_back({{placed_pose(task.goal, off)}});
  } else {
    add_stops(task, task.goal_set, true);
  }
  for (std::size_t i = 0; i + 1 < stages_.size(); ++i) {
    auto& legs = legs_.emplace_back();
    legs.reserve(stages_[i].size());
    for (const Stop& from : stages_[i]) {
      auto& row = legs.emplace_back();
      row.reserve(stages_[i + 1].size());
      for (const Stop& to : stages_[i + 1]) row.push_back(blunt_leg(from, to));
    }
  }
}

/// Adds a stage with a stop for each region. Of vias, poses that are not free are left out, unless
/// all are blocked; of the goal, single poses are.
void LegBounds::add_stops(const Task& task, const std::vector<GoalRegion>& regions, bool is_goal) {
  Task alone = task;
  alone.goal_set = regions;
  std::vector<Stop> blocked;
  std::vector<Stop>& stops = stages_.emplace_back();
  for (std::size_t i = 0; i < regions.size(); ++i) {
    if (is_goal && !is_continuous(regions[i])) continue;
    for (const RegionPart& part : whole(regions[i], i)) {
      Stop stop{placed(vehicle_, regions[i], part), part, &regions[i]};
      bool is_free = true;
      if (!is_continuous(regions[i])) {
        const LocalState state = state_of(alone, part.middle);
        stop.place.pose = static_cast<const State&>(state).pose;
        is_free = task.checker->is_free(state);
      }
      (is_free ? stops : blocked).push_back(std::move(stop));
    }
  }
  if (stops.empty()) stops = std::move(blocked);
}

/// What the distance alone says of a leg.
LegBounds::Leg LegBounds::blunt_leg(const Stop& from, const Stop& to) const {
  const double gap = gap_between(from.place.box, to.place.box);
  return {.ground = {gap, gap, gap, 0.0}};
}

void LegBounds::sharpen(Leg& leg, const Stop& from, const Stop& to) const {
  if (leg.is_sharp) return;
  leg.is_sharp = true;
  const search::OpenGround sharp = search::open_ground(
      from.place.pose, from.place.off, to.place.pose, to.place.off, vehicle_.min_turning_radius);
  leg.ground = {std::max(leg.ground.forward, sharp.forward),
                std::max(leg.ground.reverse, sharp.reverse),
                std::max(leg.ground.shortest, sharp.shortest), sharp.leeway};
}

// The rear axle has the same way whatever the headings, and so has a disc around it.
void LegBounds::raise(std::size_t leg, const Pose& from, const Pose& to, const Proven& proven) {
  const double wall = proven.walled_in.empty() ? 0.0 : std::numeric_limits<double>::infinity();
  const double around = std::max(proven.shortest, wall);
  const double turning = std::max(proven.shortest_turn, wall);
  const bool tells_headings = search::bound_disc(vehicle_).ahead != 0.0;
  const auto is_at = [](const Stop& stop, const Pose& pose) {
    return (stop.region == nullptr || !is_continuous(*stop.region)) && stop.place.pose == pose;
  };
  const auto is_there = [&](const Stop& stop, const Pose& pose) {
    const Pose& middle = stop.place.pose;
    return is_at(stop, pose) ||
           (is_one_place(stop.region) && middle.x == pose.x && middle.y == pose.y);
  };
  for (std::size_t i = 0; i < stages_[leg].size(); ++i) {
    const Stop& first = stages_[leg][i];
    if (!is_there(first, from)) continue;
    for (std::size_t j = 0; j < stages_[leg + 1].size(); ++j) {
      const Stop& last = stages_[leg + 1][j];
      if (!is_there(last, to)) continue;
      Leg& known = legs_[leg][i][j];
      known.added = std::max(known.added, proven.added);
      known.in_zones = std::max(known.in_zones, proven.in_zones);
      const bool is_exact = is_at(first, from) && is_at(last, to);
      if (tells_headings && !is_exact) continue;
      double least = around - first.place.off.position - last.place.off.position;
      if (is_exact) {
        sharpen(known, first, last);
        least = std::max(least, turning - known.ground.leeway);
      }
      if (least <= known.around) continue;
      known.around = least;
      is_settled_ = false;
    }
  }
}

/// Cost of a leg that is driven in one gear at first and in another at last. If both are the same,
/// the gear changes twice or not at all.
double LegBounds::run(const Leg& leg, std::size_t first, std::size_t last) const {
  const search::GearSign gear = gear_signs[first];
  if (!rule_.allows(gear) || !rule_.allows(gear_signs[last])) return no_chain;
  const double metre = std::min(rule_.forward_weight, rule_.reverse_weight);
  const double mixed = metre * std::max(leg.ground.shortest, leg.around);
  if (first != last) return mixed + rule_.gear_change_cost;
  const double in_gear = gear > 0 ? leg.ground.forward : leg.ground.reverse;
  const double all = rule_.weight(gear) * std::max(in_gear, leg.around);
  return rule_.allows_both() ? std::min(all, mixed + 2 * rule_.gear_change_cost) : all;
}

/// Length of a leg in the gears that are allowed.
double LegBounds::length(const Leg& leg) const {
  const double least = std::max(leg.ground.shortest, leg.around);
  if (least <= 0.0 || rule_.allows_both()) return least;
  return std::max(least, rule_.allows(1) ? leg.ground.forward : leg.ground.reverse);
}

/// Goes on along a leg from a stop that is reached in either gear. A leg without a metre has none.
void LegBounds::go_on(const Leg& leg, const Gears& before, std::size_t from, Gears& reached) const {
  const auto offer = [&](std::size_t gear, double cost, std::size_t last) {
    if (cost < reached[last].cost) reached[last] = {cost, from, gear};
  };
  const bool may_stand = std::max(leg.ground.shortest, leg.around) <= 0.0;
  for (std::size_t gear = 0; gear < 2; ++gear) {
    if (may_stand) offer(gear, before[gear].cost, gear);
    for (std::size_t first = 0; first < 2; ++first) {
      const double change = first == gear ? 0.0 : rule_.gear_change_cost;
      for (std::size_t last = 0; last < 2; ++last) {
        offer(gear, before[gear].cost + change + run(leg, first, last), last);
      }
    }
  }
}

/// Finds the cheapest chain, stage by stage. Gives back the number of pairs looked at.
std::int64_t LegBounds::find_chain() {
  std::vector<std::vector<Gears>> reached;
  Gears begin;
  for (std::size_t gear = 0; gear < 2; ++gear) {
    const bool is_wrong = rule_.initial_gear != 0 && rule_.initial_gear != gear_signs[gear];
    begin[gear].cost = is_wrong ? no_chain : 0.0;
  }
  reached.push_back({begin});
  std::int64_t looks = 0;
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    std::vector<Gears> next(stages_[i + 1].size(), Gears{{{no_chain}, {no_chain}}});
    for (std::size_t from = 0; from < stages_[i].size(); ++from) {
      for (std::size_t to = 0; to < next.size(); ++to) {
        go_on(legs_[i][from][to], reached.back()[from], from, next[to]);
      }
    }
    looks += static_cast<std::int64_t>(stages_[i].size() * next.size());
    reached.push_back(std::move(next));
  }
  least_ = no_chain;
  std::size_t stop = 0, gear = 0;
  for (std::size_t i = 0; i < reached.back().size(); ++i) {
    for (std::size_t last = 0; last < 2; ++last) {
      if (reached.back()[i][last].cost >= least_) continue;
      least_ = reached.back()[i][last].cost;
      stop = i;
      gear = last;
    }
  }
  chain_.assign(stages_.size(), 0);
  if (least_ == no_chain) return looks;
  for (std::size_t i = stages_.size(); i-- > 0;) {
    chain_[i] = stop;
    const Reached& there = reached[i][stop][gear];
    stop = there.from;
    gear = there.gear;
  }
  return looks;
}

/// Sharpens the legs of the chain, or halves its widest part. False if that hardly raises the
/// bound.
bool LegBounds::improve_chain() {
  bool is_sharper = false;
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    Leg& leg = legs_[i][chain_[i]][chain_[i + 1]];
    is_sharper |= !leg.is_sharp;
    sharpen(leg, stages_[i][chain_[i]], stages_[i + 1][chain_[i + 1]]);
  }
  if (is_sharper) return true;
  double widest = fine_part * least_;
  std::size_t stage = 0;
  for (std::size_t i = 0; i < stages_.size(); ++i) {
    const Stop& stop = stages_[i][chain_[i]];
    if (stop.region == nullptr || !is_continuous(*stop.region)) continue;
    const double size =
        stop.place.off.position + vehicle_.min_turning_radius * stop.place.off.heading;
    if (size <= widest) continue;
    widest = size;
    stage = i;
  }
  if (stage == 0) return false;
  halve(stage, chain_[stage]);
  return true;
}

/// Replaces a stop by both halves of its part. No leg of theirs is shorter than that of the whole.
void LegBounds::halve(std::size_t stage, std::size_t stop) {
  std::vector<Stop>& stops = stages_[stage];
  const Stop old_stop = stops[stop];
  const auto parts = halves(*old_stop.region, vehicle_.min_turning_radius, old_stop.part);
  const auto half = [&](std::size_t i) {
    return Stop{placed(vehicle_, *old_stop.region, parts[i]), parts[i], old_stop.region};
  };
  stops[stop] = half(0);
  stops.push_back(half(1));
  const auto split = [&](const Leg& old, const Stop& from, const Stop& to) {
    Leg leg = old;
    leg.is_sharp = false;
    leg.around = std::max(leg.around, gap_between(from.place.box, to.place.box));
    return leg;
  };
  for (std::size_t i = 0; i < stages_[stage - 1].size(); ++i) {
    const Stop& from = stages_[stage - 1][i];
    std::vector<Leg>& row = legs_[stage - 1][i];
    row.push_back(split(row[stop], from, stops.back()));
    row[stop] = split(row[stop], from, stops[stop]);
  }
  if (stage == legs_.size()) return;
  std::vector<std::vector<Leg>>& rows = legs_[stage];
  std::vector<Leg> last = rows[stop];
  for (std::size_t j = 0; j < last.size(); ++j) {
    const Stop& to = stages_[stage + 1][j];
    last[j] = split(rows[stop][j], stops.back(), to);
    rows[stop][j] = split(rows[stop][j], stops[stop], to);
  }
  rows.push_back(std::move(last));
}

/// Lower bounds of the lengths of the moves between the places where the vehicle stands: each of
/// its own legs, and of the longest all that is left of the bound.
// The fastest drive of a move takes a time that is concave in its length. So metres that may be in
// any move cost least in the longest one: time(l + x) - time(l) falls with l.
std::vector<double> LegBounds::moves() const {
  std::vector<double> moves;
  std::vector<double> reached(stages_.front().size(), 0.0);
  for (std::size_t i = 0; i < legs_.size(); ++i) {
    std::vector<double> next(stages_[i + 1].size(), no_chain);
    for (std::size_t from = 0; from < reached.size(); ++from) {
      for (std::size_t to = 0; to < next.size(); ++to) {
        next[to] = std::min(next[to], reached[from] + length(legs_[i][from][to]));
      }
    }
    reached = std::move(next);
    const bool is_goal = i + 1 == legs_.size();
    if (!is_goal && !via_[i].stop) continue;
    moves.push_back(*std::min_element(reached.begin(), reached.end()));
    std::fill(reached.begin(), reached.end(), 0.0);
  }
  const double all = std::accumulate(moves.begin(), moves.end(), 0.0);
  *std::max_element(moves.begin(), moves.end()) += std::max(least_ - all, 0.0);
  return moves;
}

/// Sum over all legs of the least that is known of any of their pairs.
double LegBounds::sum_of_least(double Leg::*known) const {
  double sum = 0.0;
  for (const auto& pairs : legs_) {
    double least = no_chain;
    for (const std::vector<Leg>& row : pairs) {
      for (const Leg& leg : row) least = std::min(least, leg.*known);
    }
    sum += least;
  }
  return sum;
}

double LegBounds::least() { return least(search::Budget({})); }

double LegBounds::least(const search::Budget& budget) {
  while (!is_settled_ && !budget.is_interrupted()) {
    work_ -= find_chain();
    is_settled_ = work_ <= 0 || least_ == no_chain || !improve_chain();
  }
  if (least_ == no_chain) return least_;
  const double by_lengths =
      pricing_.counts_time() ? pricing_.cost_lower_bound(moves(), least_) : least_;
  return std::max(by_lengths + sum_of_least(&Leg::added), sum_of_least(&Leg::in_zones));
}

}  // namespace vandplan::planning
