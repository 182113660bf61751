// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "search/wheels.h"
#include "steering/continuous/priced_pieces.h"
#include "steering/words.h"
#include "vandplan/input_error.h"
#include "vandplan/search.h"
#include "vandplan/steering.h"

namespace vandplan::search {
namespace {

constexpr double least_worth = 1e-6;  // Cost that is accepted for one segment less [m].
constexpr double nothing = 1e-12;     // Length up to which a cut segment is dropped [m].

void append(Piece& piece, const Segment& segment) {
  piece.segments[piece.count++] = segment;
  piece.length += std::abs(segment.length);
}

/// Whether a piece has a segment so short that cutting the piece would drop it. The wheels would be
/// turned at a stop beside it.
bool holds_crumb(const Piece& piece) {
  return std::ranges::any_of(piece.view(),
                             [](const Segment& s) { return std::abs(s.length) <= nothing; });
}

/// Numbers of gear changes that a piece may have, in the order of trial.
std::span<const int> changes_of(const CostRule& rule) {
  static constexpr std::array changes = {0, 1, 2};
  return std::span(changes).first(rule.allows_both() ? changes.size() : 1);
}

double rate_of(const Vehicle& vehicle) {
  const double turning = vehicle.min_turning_radius;
  const double most = supported_sharpness.most / turning / turning;
  return std::min(max_curvature_rate(vehicle), most * (1 - 1e-12));
}

std::optional<ContinuousSteering> continuous_steering(const Task& task) {
  if (task.steering == Steering::reeds_shepp) return std::nullopt;
  const double radius = continuous_radius(task.vehicle);
  const auto held = [&](double curvature, GearSign beyond) {
    return holds_wheels(task, beyond) ? std::abs(curvature) : 0.0;
  };
  const double given = std::max(held(task.curvatures.start, rolling_beyond(task, true)),
                                held(task.curvatures.goal, rolling_beyond(task, false)));
  if (given * radius > 1 + 1e-12) {
    throw InputError("curvature", "of start or goal is " + std::to_string(given) +
                                      " 1/m, expected at most " + std::to_string(1 / radius) +
                                      " with wheels that turn so slowly");
  }
  return ContinuousSteering(
      radius, rate_of(task.vehicle),
      task.steering == Steering::continuous ? Continuity::throughout : Continuity::between_stops);
}

/// Calls `visit(s, is_straight)` for places `s` [m] where the wheels are straight or the gear
/// changes. On a line these are its ends and the place nearest to `wanted`.
template <typename Visit>
void for_cuts(const Piece& piece, double wanted, double radius, Visit visit) {
  double s = 0.0;
  GearSign gear = 0;
  for (const Segment& segment : piece.view()) {
    const double length = std::abs(segment.length);
    const double end = curvature_at(segment, length);
    const auto is_straight = [&](double curvature) {
      return std::abs(curvature) * radius < straight_wheels;
    };
    if (is_straight(segment.curvature)) {
      visit(s, true);
    } else if (gear_of(segment) == -gear) {
      visit(s, false);
    }
    if (is_straight(segment.curvature) && is_straight(end)) {
      visit(std::clamp(wanted, s, s + length), true);
    } else if (segment.curvature * end < 0.0) {
      visit(s + length * segment.curvature / (segment.curvature - end), true);
    }
    if (is_straight(end)) visit(s + length, true);
    gear = gear_of(segment);
    s += length;
  }
}

}  // namespace

Connector::Connector(const Task& task, const CostRule& rule, bool profile)
    : task_(task),
      checker_(*task.checker),
      radius_(task.vehicle.min_turning_radius),
      rule_(rule),
      continuous_(continuous_steering(task)),
      steering_(profile),
      checking_(profile) {}

std::optional<Connection> Connector::connect(const LocalState& from, const LocalPose& to,
                                             const Terms& terms) {
  const std::optional<Piece> piece =
      steer(Local(from.pose), to, terms.beside, terms.cutoff - terms.cost_so_far);
  if (!piece) return std::nullopt;
  const double total = terms.cost_so_far + cost(*piece, terms.beside);
  if (total >= terms.cutoff || !is_free(from, *piece)) return std::nullopt;
  const double near = clearance_cost(from, piece->view(), terms.cutoff - total);
  if (total + near >= terms.cutoff) return std::nullopt;
  return Connection{*piece, total + near};
}

std::optional<Piece> Connector::steer(const LocalPose& from, const LocalPose& to,
                                      const DrivenBeside& beside, double cutoff) {
  ++solves_;
  steering_.start();
  std::optional<Piece> best;
  if (continuous_) {
    best = continuous_piece(from, to, beside, cutoff);
  } else {
    best = reeds_shepp(from, to, radius_);
    if (!rule_.is_length()) best = cheapest_word(from, to, beside, *best, cutoff);
    if (!may_drive(rule_, best->view())) best.reset();
  }
  steering_.stop();
  return best;
}

double continuous_radius(const Vehicle& vehicle) noexcept {
  constexpr double least = 0.1;
  static_assert(least > supported_sharpness.least);
  const double widest = std::sqrt(least / rate_of(vehicle)) * (1 + 1e-12);
  return std::max(vehicle.min_turning_radius, widest);
}

bool Connector::may_jump(const Driven& before, const Driven& after) const {
  return search::may_jump(task_.steering, before, after.gear);
}

// Standing ends come first, since no piece is shorter than one that begins and ends standing.
void Connector::find_ends(const LocalPose& pose, const Driven& beside,
                          std::vector<End>& ends) const {
  ends.clear();
  const bool between_stops = continuous_->continuity() == Continuity::between_stops;
  const bool is_start = pose == task_.start;
  const bool is_end = is_start || pose == task_.goal;
  const GearSign beyond = rolling_beyond(task_, is_start);
  const bool is_outermost = beside.gear == 0 || !beside.is_known();
  const bool may_change = beside.gear != 0 && rule_.allows(-beside.gear);
  if (is_end && (is_outermost || beyond != 0)) {
    const double given = is_start ? task_.curvatures.start : task_.curvatures.goal;
    if (between_stops && beyond != 0 && may_change) ends.push_back({true, given, -beside.gear});
    ends.push_back({between_stops && beyond == 0, given, 0});
    return;
  }
  if (between_stops && may_change) ends.push_back({true, 0.0, -beside.gear});
  const bool is_straight =
      !beside.is_known() || std::abs(beside.curvature) * radius_ < straight_wheels;
  if (!is_straight) return;
  // In the other gear the standing end costs no more, so that gear is left out.
  const bool is_one_gear = !ends.empty() && !rule_.is_length();
  ends.push_back({false, 0.0, is_one_gear ? beside.gear : 0});
}

std::optional<Piece> Connector::continuous_piece(const LocalPose& from, const LocalPose& to,
                                                 const DrivenBeside& beside, double cutoff) {
  const double shortest = reeds_shepp_length(from, to, radius_);
  if (from == to || shortest >= cutoff) return std::nullopt;
  find_ends(from, beside.before, starts_);
  find_ends(to, beside.after, goals_);
  std::optional<Piece> best;
  double least = cutoff;
  const auto consider = [&](const Piece& piece, const End& start, const End& goal) {
    if (holds_crumb(piece)) return;
    if (first_driven(piece).gear == -start.gear || last_driven(piece).gear == -goal.gear) return;
    const double total = cost(piece, beside);
    if (total >= least) return;
    best = piece;
    least = total;
  };
  const GearSign only = rule_.only_gear();
  const auto gear_at = [&](const End& end) { return only == 0 ? end.gear : only; };
  std::vector<steering::continuous::PieceEnds> ends;
  for (const End& start : starts_) {
    for (const End& goal : goals_) {
      const ContinuousQuery query{start.curvature, goal.curvature, least, start.stands,
                                  goal.stands};
      ends.push_back({query, gear_at(start), gear_at(goal)});
    }
  }
  const std::size_t count = goals_.size();
  if (rule_.is_length()) {
    for (std::size_t i = 0; i < ends.size(); ++i) {
      ends[i].query.cutoff = least;
      const auto piece = continuous_->steer(from, to, ends[i].query);
      if (piece) consider(*piece, starts_[i / count], goals_[i % count]);
    }
    return best;
  }
  // Each further gear change has to be worth its price.
  for (const int changes : changes_of(rule_)) {
    if (shortest + changes * rule_.gear_change_cost >= least) break;
    const steering::continuous::PieceRequest request{changes,
                                                     least,
                                                     rule_.weight(only == 0 ? 1 : only),
                                                     rule_.weight(only == 0 ? -1 : only),
                                                     rule_.gear_change_cost,
                                                     beside.before.gear,
                                                     beside.after.gear};
    steering::continuous::for_priced_pieces(
        *continuous_, from, to, ends, request, [&](const Piece& piece, std::size_t i) {
          consider(piece, starts_[i / count], goals_[i % count]);
          return least;
        });
  }
  return best;
}

// Cheapest of all words; of equal costs the one with fewest segments. Words with few gear changes
// are tried first, as each change has to be worth its price and most are not.
Piece Connector::cheapest_word(const LocalPose& from, const LocalPose& to,
                               const DrivenBeside& beside, const Piece& shortest, double cutoff) {
  // The piece to the goal is the last one, so nothing is added at its end. Wide arcs seldom fit
  // between obstacles, and would hide words that fit. If the drive goes on, it would carry an error
  // on.
  const bool goes_on = task_.beyond.goal != 0 || task_.beyond.stands_at_goal;
  const bool is_last = to == task_.goal && !goes_on;
  const steering::Closing& closing = is_last ? steering::at_goal : steering::on_the_way;
  Piece best = shortest;
  double best_cost = cost(best, beside);
  for (const int changes : changes_of(rule_)) {
    const double most = std::min(best_cost + least_worth, cutoff);
    const double longest = most - changes * rule_.gear_change_cost;
    if (longest < shortest.length) break;
    steering::find_words(from, to, radius_, {changes, longest, closing, is_last}, words_);
    for (const Piece& word : words_) {
      const double word_cost = cost(word, beside);
      const double crumb = word.count < best.count ? least_worth : 0.0;
      if (word_cost >= best_cost + crumb) continue;
      best = word;
      best_cost = word_cost;
    }
  }
  return best;
}

double Connector::least_cost(const LocalPose& from, const LocalPose& to,
                             const DrivenBeside& beside) {
  ++solves_;
  const double shortest = reeds_shepp_length(from, to, radius_);
  if (rule_.is_length()) return shortest;
  double least = std::numeric_limits<double>::infinity();
  if (rule_.allows_both()) {
    const double metre = std::min(rule_.forward_weight, rule_.reverse_weight);
    least = metre * shortest + rule_.gear_change_cost;
  }
  for (const GearSign gear : {1, -1}) {
    if (!rule_.allows(gear)) continue;
    const double weight = rule_.weight(gear);
    const double joints =
        change_cost(rule_, beside.before, gear) + change_cost(rule_, gear, beside.after);
    if (weight * shortest + joints >= least) continue;
    const double length =
        gear > 0 ? dubins_length(from, to, radius_) : dubins_length(to, from, radius_);
    least = std::min(least, weight * length + joints);
  }
  return least;
}

double Connector::cost(const Piece& piece, const DrivenBeside& beside) const {
  if (rule_.is_length()) return piece.length;
  Driven driven = beside.before;
  const double sum = drive_cost(rule_, piece.view(), driven);
  return sum + change_cost(rule_, driven, beside.after);
}

bool Connector::is_free(const LocalState& from, const Piece& piece) {
  ++checks_;
  checking_.start();
  const bool free = checker_.is_free(from, piece.view(), rule_.in_time);
  checking_.stop();
  return free;
}

bool Connector::is_free(const LocalState& from, const Segment& segment) {
  ++checks_;
  return checker_.is_free(from, segment, rule_.in_time);
}

Piece Connector::free_prefix(const LocalState& from, const Piece& piece) {
  Piece result;
  LocalState state = from;
  for (const Segment& segment : piece.view()) {
    if (is_free(state, segment)) {
      append(result, segment);
      state = advance(task_.vehicle, state, segment);
      continue;
    }
    Segment part = segment;
    part.length /= 2;
    for (int i = 0; i < 4; ++i, part.length /= 2) {
      if (!is_free(state, part)) continue;
      append(result, part);
      break;
    }
    break;
  }
  if (!continuous_) return result;
  double straight = 0.0;
  for_cuts(result, result.length, radius_, [&](double s, bool is_straight) {
    if (is_straight) straight = std::max(straight, s);
  });
  return prefix(result, straight);
}

double nearest_cut(const Piece& piece, double s, double radius) {
  double nearest = s < piece.length / 2 ? 0.0 : piece.length;
  for_cuts(piece, s, radius, [&](double cut, bool) {
    if (std::abs(cut - s) < std::abs(nearest - s)) nearest = cut;
  });
  return nearest;
}

Piece prefix(const Piece& piece, double s) {
  Piece result;
  double left = s;
  for (const Segment& segment : piece.view()) {
    const double part = std::min(left, std::abs(segment.length));
    if (left <= nothing) break;
    if (part <= 0.0) continue;
    append(result, part_of(segment, 0.0, part));
    left -= part;
  }
  return result;
}

Piece suffix(const Piece& piece, double s) {
  Piece result;
  double skip = s;
  for (const Segment& segment : piece.view()) {
    const double length = std::abs(segment.length);
    const double begin = std::max(skip, 0.0);
    skip -= length;
    if (length > begin + nothing) append(result, part_of(segment, begin, length));
  }
  return result;
}

Pose end_of(const Pose& from, const Piece& piece) {
  Pose pose = from;
  for (const Segment& segment : piece.view()) pose = advance(pose, segment);
  return pose;
}

}  // namespace vandplan::search
