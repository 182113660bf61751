// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/near_cost.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vandplan::judge {
namespace {

constexpr double looks = 64;  // largest number of samples per `clearance_distance`
// Least number of samples per `clearance_distance` where the cost is not 0.
constexpr double fewest_looks = 8;
// Largest difference of two integration rules, relative to the cost of a metre.
constexpr double agreement = 1e-4;
constexpr double most_looks = 1e6;  // largest number of samples of a path
// Least number of samples of a path: two rules together may overlook a kink.
constexpr double least_looks = 256;
// Corners that move faster than this, per metre of the axle, need more samples.
constexpr double usual_swing = 3;
// Largest half length that one look may prove free of cost [m].
constexpr Real most_at_once = 1000.0;

class Integral {
 public:
  /// `swing` bounds the motion of any point of the bodies per metre driven.
  Integral(std::span<const Body> bodies, const CostOptions& rule, double swing, Real step)
      : bodies_(bodies),
        distance_(*rule.clearance_distance),
        swing_(swing),
        step_(step),
        most_(step * looks / fewest_looks),
        tolerance_(agreement / std::max(1.0, *rule.clearance_weight)) {}

  /// Integral of max(0, 1 - clearance / distance) from `begin` to `end` of a stretch [m].
  [[nodiscard]] Real over(std::size_t stretch, Real begin, Real end) {
    const Real middle = (begin + end) / 2;
    if (end - begin <= 4 * most_) return near(stretch, begin, end);
    const Real half = (end - begin) / 2;
    if (half > most_at_once) return over(stretch, begin, middle) + over(stretch, middle, end);
    // The clearance in the middle bounds the clearance elsewhere, by the motion of the bodies.
    const double moved = swing_ * static_cast<double>(half);
    const double here = clearance(stretch, middle, distance_ + moved);
    if (here >= distance_ + moved) return 0;
    if (here + moved < distance_) return near(stretch, begin, end);
    return over(stretch, begin, middle) + over(stretch, middle, end);
  }

 private:
  /// Like `over`, for parts that are near obstacles.
  [[nodiscard]] Real near(std::size_t stretch, Real begin, Real end) {
    const Real middle = (begin + end) / 2;
    if (end - begin > 4 * most_) return near(stretch, begin, middle) + near(stretch, middle, end);
    return simpson(stretch, begin, end,
                   {at(stretch, begin), at(stretch, middle), at(stretch, end)});
  }

  /// Simpson's rule from the values at both ends and in the middle. The part is halved until that
  /// changes little, which happens mostly at kinks.
  [[nodiscard]] Real simpson(std::size_t stretch, Real begin, Real end,
                             const std::array<double, 3>& values) {
    const auto& [first, middle, last] = values;
    const Real length = end - begin;
    const double left = at(stretch, begin + length / 4);
    const double right = at(stretch, end - length / 4);
    const Real once = (first + 4 * middle + last) / 6;
    const Real twice = (first + 4 * left + 2 * middle + 4 * right + last) / 12;
    if (std::abs(twice - once) <= tolerance_ || length <= 4 * step_) return twice * length;
    const Real half = begin + length / 2;
    return simpson(stretch, begin, half, {first, left, middle}) +
           simpson(stretch, half, end, {middle, right, last});
  }

  [[nodiscard]] double at(std::size_t stretch, Real t) {
    return std::max(0.0, 1 - clearance(stretch, t, distance_) / distance_);
  }

  [[nodiscard]] double clearance(std::size_t stretch, Real t, double most) {
    for (const Body& body : bodies_) most = clearance_of(body, {stretch, t}, most, effort_);
    return most;
  }

  std::span<const Body> bodies_;
  double distance_;
  double swing_;
  Real step_;  // least distance between samples [m]
  Real most_;  // largest distance between samples [m]
  double tolerance_;
  Effort effort_;
};

Real weight_of(const Stretch& stretch, const CostOptions& rule) {
  return stretch.direction > 0 ? *rule.forward_weight : *rule.reverse_weight;
}

}  // namespace

double near_cost(std::span<const Body> bodies, const CostOptions& stated,
                 std::span<const PricedPart> parts) {
  const CostOptions rule = filled(stated, shortest_style);
  if (rule.clearance_weight == 0.0 || bodies[0].ground.is_empty()) return 0.0;
  const Track& track = bodies[0].track;
  const double distance = *rule.clearance_distance;
  if (!(distance > 0.0)) return 0.0;
  Real sum = 0;
  for (const auto& [i, begin, end, factor, max_speed] : parts) {
    const Stretch& stretch = track.stretches[i];
    double swing = 0;
    for (const Body& body : bodies) swing = std::max(swing, speed_of(body, stretch));
    const Real usual = distance / looks / std::max(1.0, swing / usual_swing);
    const Real step =
        std::max<Real>(std::min<Real>(usual, track.length / least_looks * fewest_looks / looks),
                       track.length / most_looks);
    Integral integral(bodies, rule, swing, step);
    sum += factor * weight_of(stretch, rule) * integral.over(i, begin, end);
  }
  return static_cast<double>(*rule.clearance_weight * sum);
}

double zone_cost(const Track& track, const CostOptions& stated, std::span<const PricedPart> parts) {
  const CostOptions rule = filled(stated, shortest_style);
  Real sum = 0;
  for (const auto& [i, begin, end, factor, max_speed] : parts) {
    if (factor != 1) sum += (factor - 1) * (end - begin) * weight_of(track.stretches[i], rule);
  }
  return static_cast<double>(sum);
}

}  // namespace vandplan::judge
