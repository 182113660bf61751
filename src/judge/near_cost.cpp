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
  Integral(const Ground& ground, const Outlines& outlines, double distance, Real step)
      : ground_(ground), outlines_(outlines), distance_(distance), step_(step) {}

  /// Of max(0, 1 - clearance / distance), from `begin` to `end` of a stretch [m].
  [[nodiscard]] Real over(const Stretch& stretch, Real begin, Real end) {
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
  [[nodiscard]] double clearance(const Stretch& stretch, Real t, Real half) {
    const auto curvature = static_cast<double>(curvature_at(stretch, t));
    const auto rate = static_cast<double>(stretch.rate);
    return ground_.clearance({after(stretch, t), curvature, static_cast<double>(half), rate},
                             outlines_, distance_, effort_);
  }

  const Ground& ground_;
  const Outlines& outlines_;
  double distance_;
  Real step_;
  Effort effort_;
};

}  // namespace

double near_cost(const Track& track, const Ground& ground, const Outlines& outlines,
                 const CostOptions& rule) {
  if (rule.clearance_weight == 0.0 || ground.is_empty()) return 0.0;
  const double distance = rule.clearance_distance;
  if (!(distance > 0.0)) return 0.0;
  const double reach = reach_of(outlines.body);
  Real sum = 0;
  for (const Stretch& stretch : track.stretches) {
    const Real swing = 1 + steepest(stretch) * reach;
    const Real step = std::max<Real>(distance / looks / std::max<Real>(1, swing / usual_swing),
                                     track.length / most_looks);
    Integral integral(ground, outlines, distance, step);
    const Real weight = stretch.direction > 0 ? 1.0 : rule.reverse_weight;
    sum += weight * integral.over(stretch, 0, stretch.length);
  }
  return static_cast<double>(rule.clearance_weight * sum);
}

}  // namespace vandplan::judge
