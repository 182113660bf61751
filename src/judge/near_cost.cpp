// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "judge/near_cost.h"

#include <algorithm>
#include <cmath>

namespace vandplan::judge {
namespace {

constexpr double looks = 64;           // for each `clearance_distance`
constexpr double most_looks = 1e6;     // for a path
constexpr double usual_swing = 3;      // corners that move faster than the axle need more looks
constexpr Real most_at_once = 1000.0;  // metres that one look may show to be far from everything

class Integral {
 public:
  Integral(std::span<const Body> bodies, double distance, Real step)
      : bodies_(bodies), distance_(distance), step_(step) {}

  /// Of max(0, 1 - clearance / distance), from `begin` to `end` of a stretch [m].
  [[nodiscard]] Real over(std::size_t stretch, Real begin, Real end) {
    const Real middle = (begin + end) / 2;
    const Real half = (end - begin) / 2;
    if (half <= most_at_once && clearance(stretch, middle, half) >= distance_) return 0;
    if (end - begin <= step_) {
      const double here = clearance(stretch, middle, 0);
      return (end - begin) * std::max(0.0, 1 - here / distance_);
    }
    return over(stretch, begin, middle) + over(stretch, middle, end);
  }

 private:
  [[nodiscard]] double clearance(std::size_t stretch, Real t, Real half) {
    double least = distance_;
    for (const Body& body : bodies_) {
      least = clearance_of(body, {stretch, t}, static_cast<double>(half), least, effort_);
    }
    return least;
  }

  std::span<const Body> bodies_;
  double distance_;
  Real step_;
  Effort effort_;
};

}  // namespace

double near_cost(std::span<const Body> bodies, const CostOptions& rule) {
  if (rule.clearance_weight == 0.0 || bodies[0].ground.is_empty()) return 0.0;
  const Track& track = bodies[0].track;
  const double distance = rule.clearance_distance;
  if (!(distance > 0.0)) return 0.0;
  Real sum = 0;
  for (std::size_t i = 0; i < track.stretches.size(); ++i) {
    const Stretch& stretch = track.stretches[i];
    Real swing = 0;
    for (const Body& body : bodies) swing = std::max<Real>(swing, speed_of(body, stretch));
    const Real step = std::max<Real>(distance / looks / std::max<Real>(1, swing / usual_swing),
                                     track.length / most_looks);
    Integral integral(bodies, distance, step);
    const Real weight = stretch.direction > 0 ? 1.0 : rule.reverse_weight;
    sum += weight * integral.over(i, 0, stretch.length);
  }
  return static_cast<double>(rule.clearance_weight * sum);
}

}  // namespace vandplan::judge
