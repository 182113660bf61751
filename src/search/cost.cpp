// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "vandplan/search.h"
#include "vandplan/vehicle.h"

namespace vandplan::search {
namespace {

// Samples of the clearance for each `clearance_distance`. The search uses the midpoint rule. Its
// error is 1/8 of the squared step where the clearance reaches the distance or has a kink, and less
// elsewhere. The answer takes more samples where two rules differ by more than `agreement` [of the
// cost of a metre].
constexpr double samples_of_search = 2;
constexpr double fewest_samples_of_answer = 8;
constexpr double max_samples_of_answer = 64;
constexpr double agreement = 1e-4;
constexpr double max_samples_of_search_at_path = 2e4;  // Samples of a path, whatever its length.
constexpr double max_samples_of_answer_at_path = 1e6;
// At a kink both rules can be equally wrong and agree. The error shrinks with the parts.
constexpr double fewest_samples_of_answer_at_path = 256;
// Metres that a point of the body usually moves for each metre driven. Bodies long for their
// turning radius move faster and need more samples.
constexpr double usual_swing = 3;
// Steps that one sample may skip at first; doubled as long as nothing is near.
constexpr double looks_ahead = 4;

/// Largest distance of a point of the body from the rear axle [m].
double reach_of(const Vehicle& vehicle) {
  const Footprint body = footprint(vehicle);
  return std::hypot(std::max(body.front, body.rear), body.half_width);
}

/// Vehicle, with its trailer if any, on a segment where clearances are sampled.
struct SampledSegment {
  const Task& task;
  const LocalState& from;
  const Segment& segment;

  [[nodiscard]] double clearance(double driven, double most, double enough) const {
    const Segment part = part_of(segment, 0.0, driven);
    return task.checker->clearance(advance(task.vehicle, from, part), most, enough);
  }

  /// Largest distance that a point of the bodies moves for each metre driven [m].
  [[nodiscard]] double swing() const {
    const double length = std::abs(segment.length);
    const double tightest =
        std::max(std::abs(segment.curvature), std::abs(curvature_at(segment, length)));
    const double of_vehicle = 1 + reach_of(task.vehicle) * tightest;
    if (!task.vehicle.trailer) return of_vehicle;
    const Trailer& trailer = *task.vehicle.trailer;
    const double reach =
        std::hypot(std::max(trailer.wheelbase + trailer.front_overhang, trailer.rear_overhang),
                   trailer.width / 2);
    const double of_hitch = std::hypot(1.0, task.vehicle.hitch * tightest);
    return std::max(of_vehicle, of_hitch * (1 + reach / trailer.wheelbase));
  }
};

/// Distances from one sample to the next along the path [m].
struct SamplingSteps {
  double usual;
  double least;  ///< Keeps the number of samples on a long path small.
};

/// Clearances along a segment, at increasing places. A vehicle without a trailer is moved by an arc
/// of the mean curvature if that is off by less than a millimetre.
class Steps {
 public:
  explicit Steps(const SampledSegment& sampled)
      : sampled_(sampled), pose_(Local(sampled.from.pose)) {}

  [[nodiscard]] double clearance(double driven, double most, double enough) {
    if (sampled_.task.vehicle.trailer) return sampled_.clearance(driven, most, enough);
    const Segment& segment = sampled_.segment;
    const double way = driven - driven_;
    const Segment arc{curvature_at(segment, driven_ + way / 2), std::copysign(way, segment.length)};
    const bool is_like_it = std::abs(segment.curvature_rate) * way * way * way < 12 * max_error;
    pose_ = advance(pose_, is_like_it ? arc : part_of(segment, driven_, driven));
    driven_ = driven;
    return sampled_.task.checker->clearance(pose_, most, enough);
  }

 private:
  static constexpr double max_error = 1e-3;  // Largest error of a pose [m].

  const SampledSegment& sampled_;
  LocalPose pose_;
  double driven_ = 0.0;
};

/// Integral of max(0, 1 - clearance / distance) along a segment, by the midpoint rule [m].
double nearness(const SampledSegment& sampled, double distance, const SamplingSteps& steps,
                double most) {
  const double length = std::abs(sampled.segment.length);
  const double swing = sampled.swing();
  const double step = std::max(steps.least, steps.usual / std::max(1.0, swing / usual_swing));
  const double count = std::ceil(length / step);
  const double h = length / count;
  const double moved = swing * h;  // Largest move of a point of the body between samples [m].
  double sum = 0.0;
  double ahead = looks_ahead;
  Steps along(sampled);
  for (double i = 0; i < count && sum <= most;) {
    const double farthest = distance + ahead * moved;
    const double clearance = along.clearance((i + 0.5) * h, farthest, distance);
    if (clearance < distance) {
      sum += h * (1 - clearance / distance);
      i += 1;
    } else {
      i += 1 + std::floor((clearance - distance) / moved);
    }
    ahead = clearance < farthest ? looks_ahead : 2 * ahead;
  }
  return sum;
}

/// Integral of max(0, 1 - clearance / distance) along a segment, with the answer's accuracy [m].
class ExactNearness {
 public:
  /// Parts are at most `most` metres long. They are halved while two rules differ by more than
  /// `tolerance` in the mean.
  ExactNearness(const SampledSegment& sampled, double distance, double most, double tolerance)
      : sampled_(sampled),
        distance_(distance),
        most_(most),
        least_(most * fewest_samples_of_answer / max_samples_of_answer),
        tolerance_(tolerance) {}

  [[nodiscard]] double integral() const {
    const double length = std::abs(sampled_.segment.length);
    const double swing = sampled_.swing();
    double sum = 0.0;
    double ahead = looks_ahead * most_;
    for (double s = 0.0; s < length;) {
      const double farthest = distance_ + swing * ahead;
      const double clearance = sampled_.clearance(s, farthest, distance_);
      const double nothing = (clearance - distance_) / swing;  // Nothing is near for this distance.
      ahead = clearance < farthest ? looks_ahead * most_ : 2 * ahead;
      if (nothing >= most_) {
        s += nothing;
        continue;
      }
      const double end = std::min(s + most_, length);
      sum += part(s, end, {at(s), at((s + end) / 2), at(end)});
      s = end;
    }
    return sum;
  }

 private:
  [[nodiscard]] double at(double s) const {
    return std::max(0.0, 1 - sampled_.clearance(s, distance_, distance_) / distance_);
  }

  /// Integral over a part, by three parabolas that agree (Simpson's rule). `values`: at begin,
  /// middle and end.
  [[nodiscard]] double part(double begin, double end, const std::array<double, 3>& values) const {
    const auto [first, middle, last] = values;
    const double quarter = (end - begin) / 4;
    const double left = at(begin + quarter);
    const double right = at(end - quarter);
    const double once = (first + 4 * middle + last) / 6;
    const double twice = (first + 4 * (left + right) + 2 * middle + last) / 12;
    if (std::abs(twice - once) <= tolerance_ || end - begin <= least_) return twice * 4 * quarter;
    const double half = begin + 2 * quarter;
    return part(begin, half, {first, left, middle}) + part(half, end, {middle, right, last});
  }

  const SampledSegment& sampled_;
  double distance_;
  double most_;
  double least_;
  double tolerance_;
};

double exact_nearness(const SampledSegment& sampled, const CostRule& rule, double whole) {
  const double slower = std::max(1.0, sampled.swing() / usual_swing);
  const double usual = rule.clearance_distance / fewest_samples_of_answer / slower;
  const double most = 4 * std::max(std::min(usual, whole / fewest_samples_of_answer_at_path),
                                   whole / max_samples_of_answer_at_path);
  return ExactNearness(sampled, rule.clearance_distance, most,
                       agreement / std::max(1.0, rule.clearance_weight))
      .integral();
}

}  // namespace

CostRule cost_rule(const CostOptions& options) {
  const CostOptions all = filled(options, shortest_style);
  const CostRule rule{.forward_weight = *all.forward_weight,
                      .reverse_weight = *all.reverse_weight,
                      .gear_change_cost = *all.gear_change_cost,
                      .initial_gear = direction_of(all.initial_gear),
                      .curvature_change_cost = *all.curvature_change_cost,
                      .clearance_weight = *all.clearance_weight,
                      .clearance_distance = *all.clearance_distance};
  return restricted(rule, all.gears);
}

CostRule cost_rule(const CostOptions& options, const Task& task) {
  CostRule rule = cost_rule(options);
  rule.has_priced_ground = task.checker->has_prices();
  return rule;
}

CostRule restricted(CostRule rule, AllowedGears gears) {
  constexpr double never = std::numeric_limits<double>::infinity();
  if (gears == AllowedGears::forward) rule.reverse_weight = never;
  if (gears == AllowedGears::reverse) rule.forward_weight = never;
  return rule;
}

CostRule length_rule(const CostRule& rule) {
  const auto weight = [&](GearSign gear) { return rule.allows(gear) ? 1.0 : rule.weight(gear); };
  return {.forward_weight = weight(1), .reverse_weight = weight(-1), .in_time = rule.in_time};
}

CostRule reversed(const CostRule& rule, GearSign before) {
  CostRule result = rule;
  std::swap(result.forward_weight, result.reverse_weight);
  result.initial_gear = before;
  result.in_time = rule.in_time == InTime::onward ? InTime::backward : InTime::onward;
  result.final_gear = 0;
  return result;
}

Driven first_driven(const Piece& piece) {
  if (piece.count == 0) return {};
  const Segment& first = piece.segments[0];
  return {gear_of(first), first.curvature};
}

Driven last_driven(const Segment& segment) {
  return {gear_of(segment), curvature_at(segment, std::abs(segment.length))};
}

Driven last_driven(const Piece& piece) {
  return piece.count == 0 ? Driven{} : last_driven(piece.segments[piece.count - 1U]);
}

bool may_drive(const CostRule& rule, std::span<const Segment> segments) {
  return rule.allows_both() || std::ranges::all_of(segments, [&](const Segment& s) {
           return s.length == 0.0 || rule.allows(gear_of(s));
         });
}

double change_cost(const CostRule& rule, const Driven& from, const Driven& to) {
  const double cost = from.gear * to.gear < 0 ? rule.gear_change_cost : 0.0;
  if (rule.curvature_change_cost == 0.0) return cost;
  const double change = std::abs(to.curvature - from.curvature);
  return std::isnan(change) ? cost : cost + rule.curvature_change_cost * change;
}

double drive_cost(const CostRule& rule, std::span<const Segment> segments, Driven& driven) {
  if (rule.is_length()) {  // nothing depends on what was driven
    driven = segments.empty() ? driven : last_driven(segments.back());
    return length(segments);
  }
  double sum = 0.0;
  for (const Segment& segment : segments) {
    if (segment.length == 0.0) continue;
    const double size = std::abs(segment.length);
    const GearSign next = gear_of(segment);
    sum += change_cost(rule, driven, {next, segment.curvature}) + rule.weight(next) * size;
    if (segment.curvature_rate != 0.0) {
      sum += rule.curvature_change_cost * std::abs(segment.curvature_rate) * size;
    }
    driven = last_driven(segment);
  }
  return sum;
}

double drive_cost(const CostRule& rule, std::span<const Segment> segments) {
  Driven driven = rule.initial_gear;
  const double sum = drive_cost(rule, segments, driven);
  return sum + change_cost(rule, driven, rule.final_gear);
}

namespace {

/// Sum of a surcharge over all segments; above `cutoff` it is any number above it.
/// `surcharge(state, segment, cutoff)`: surcharge of one segment from a state.
template <class Surcharge>
double sum_along(const Task& task, const CostRule& rule, const LocalState& from,
                 std::span<const Segment> segments, double cutoff, Surcharge surcharge) {
  double sum = 0.0;
  LocalState state = from;
  for (const Segment& segment : segments) {
    if (segment.length == 0.0) continue;
    if (sum > cutoff) break;
    const GearSign gear = gear_of(segment);
    if (!rule.allows(gear)) return rule.weight(gear);
    sum += surcharge(state, segment, cutoff - sum);
    state = advance(task.vehicle, state, segment);
  }
  return sum;
}

/// Surcharge near obstacles alone. `whole`: length of the path of which the segments are a part
/// [m].
double near_cost(const Task& task, const CostRule& rule, const LocalState& from,
                 std::span<const Segment> segments, double whole, ClearanceSampling sampling,
                 double cutoff) {
  if (rule.clearance_weight == 0.0) return 0.0;
  const double distance = rule.clearance_distance;
  const SamplingSteps steps{distance / samples_of_search, whole / max_samples_of_search_at_path};
  const auto near = [&](const LocalState& state, const Segment& segment, double left) {
    const double price = rule.clearance_weight * rule.weight(gear_of(segment));
    const SampledSegment sampled{task, state, segment};
    return price * (sampling == ClearanceSampling::answer
                        ? exact_nearness(sampled, rule, whole)
                        : nearness(sampled, distance, steps, left / price));
  };
  return sum_along(task, rule, from, segments, cutoff, near);
}

/// Surcharge of one segment in zones, and near obstacles there.
double ground_cost(const Task& task, const CostRule& rule, const LocalState& from,
                   const Segment& segment, double whole, ClearanceSampling sampling,
                   double cutoff) {
  const GearSign gear = gear_of(segment);
  const auto& top = task.vehicle.limits.max_speed;
  const double usual = 1 / (gear > 0 ? top.forward : top.reverse);  // [s/m]
  double sum = 0.0;
  const GroundRules which = rule.slowness_price == 0.0 ? GroundRules::prices : GroundRules::all;
  for (const auto& [begin, end, factor, max_speed] :
       task.checker->ground_along(from, segment, which)) {
    if (sum > cutoff) break;
    const double of_zone = rule.has_priced_ground ? factor : 1.0;
    sum += (of_zone - 1.0) * rule.weight(gear) * (end - begin);
    sum += rule.slowness_price * std::max(0.0, 1 / max_speed - usual) * (end - begin);
    if (rule.clearance_weight == 0.0) continue;
    const Segment part = part_of(segment, begin, end);
    const LocalState there = advance(task.vehicle, from, part_of(segment, 0.0, begin));
    sum += of_zone *
           near_cost(task, rule, there, {&part, 1}, whole, sampling, (cutoff - sum) / of_zone);
  }
  return sum;
}

}  // namespace

double clearance_cost(const Task& task, const CostRule& rule, const LocalState& from,
                      std::span<const Segment> segments, ClearanceSampling sampling,
                      double cutoff) {
  const double whole = length(segments);
  if (!rule.tells_grounds()) return near_cost(task, rule, from, segments, whole, sampling, cutoff);
  const auto on_ground = [&](const LocalState& state, const Segment& segment, double left) {
    return ground_cost(task, rule, state, segment, whole, sampling, left);
  };
  return sum_along(task, rule, from, segments, cutoff, on_ground);
}

}  // namespace vandplan::search
