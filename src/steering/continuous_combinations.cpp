// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_combinations.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/trigonometry.h"
#include "base/trigonometry_series.h"
#include "simd/turn_kernels.h"
#include "steering/mean_frame.h"

namespace vandplan::steering {
namespace {

/// A way to begin or to end a path: a clothoid between bent and straight wheels.
struct End {
  Pose pose;        ///< pose at which the wheels are straight
  Segment segment;  ///< the clothoid, driven from the start onward or from the goal backward
};

/// The ways to straighten the wheels from a pose with `curvature`: forward and in reverse.
std::array<End, 2> ends_of(const Pose& pose, double curvature, const SharpTurns& turns) {
  const double length = std::abs(curvature) * turns.ramp();
  const double rate = curvature > 0 ? -turns.sharpness() : turns.sharpness();
  const Turned wound = turns.turn(length, Ends::stands_after).reversed();
  const double turn = curvature > 0 ? wound.angle : -wound.angle;
  const double aside = curvature > 0 ? wound.y : -wound.y;
  const auto [sin, cos] = base::sin_cos(pose.heading);
  std::array<End, 2> ends;
  for (std::size_t i = 0; i < 2; ++i) {
    const double gear = i == 0 ? 1 : -1;
    const double ahead = gear * wound.x;
    ends[i] = {{pose.x + ahead * cos - aside * sin, pose.y + ahead * sin + aside * cos,
                pose.heading + gear * turn},
               {curvature, gear * length, rate}};
  }
  return ends;
}

/// Sines and cosines of eight angles at once.
class Directions {
 public:
  explicit Directions(const std::array<double, simd::turns_of_batch>& angles) {
    const auto is_moderate = [](double a) { return std::abs(a) <= base::series::moderate; };
    if (std::ranges::all_of(angles, is_moderate)) {
      simd::sines_and_cosines(angles, sines_, cosines_);
      return;
    }
    for (std::size_t i = 0; i < angles.size(); ++i) {
      const auto [sin, cos] = base::sin_cos(angles[i]);
      sines_[i] = sin;
      cosines_[i] = cos;
    }
  }

  [[nodiscard]] base::SinCos of(std::size_t i) const { return {sines_[i], cosines_[i]}; }

 private:
  std::array<double, simd::turns_of_batch> sines_, cosines_;
};

/// Adds the tasks of all ways to begin and to end.
void add_tasks(Combinations& all, const std::array<Pose, 4>& from, const std::array<Pose, 4>& to,
               const std::array<Windings, 4>& windings, const Stops& stops) {
  std::array<MeanHeading, 4> headings{};
  std::array<double, simd::turns_of_batch> angles{};
  for (std::size_t i = 0; i < all.count; ++i) {
    headings[i] = mean_heading(from[i].heading, to[i].heading);
    angles[i] = headings[i].mean;
    angles[4 + i] = std::abs(headings[i].half_turn);
  }
  const Directions directions(angles);
  for (std::size_t i = 0; i < all.count; ++i) {
    const MeanFrame frame = mean_frame(from[i], to[i], 1, headings[i], directions.of(i));
    all.tasks[i] = {frame, windings[i], stops, directions.of(4 + i)};
  }
}

}  // namespace

Direct::Direct(const EndsTask& task) noexcept : task_(task) {
  const double dx = task.to.x - task.from.x, dy = task.to.y - task.from.y;
  straight_ = std::sqrt(dx * dx + dy * dy);
}

const WordTask& Direct::task() noexcept {
  if (!known_) known_.emplace(mean_frame(task_.from, task_.to, 1), Windings{}, task_.stops);
  return *known_;
}

Combinations combinations_of(const WordSolver& solver, const EndsTask& task, const Stops& stops,
                             Direct& direct) {
  Combinations all;
  const bool is_near = direct.is_shorter_than(solver.turns().ramp());
  all.looked = is_near ? Looked::many : Looked::likely;
  if (task.start_curvature == 0 && task.goal_curvature == 0) {
    all.tasks[0] = direct.task();
    all.tasks[0].stops = stops;
    all.around[0] = {};
    all.count = 1;
    return all;
  }
  const double k0 = task.start_curvature;
  const double k1 = task.goal_curvature;
  const auto starts = ends_of(task.from, k0, solver.turns());
  const auto goals = ends_of(task.to, k1, solver.turns());
  const auto sign = [](double v) { return v < 0 ? -1.0 : 1.0; };
  std::array<Pose, 4> from, to;
  std::array<Windings, 4> windings;
  for (std::size_t i = 0; i < (k0 == 0 ? 1U : 2U); ++i) {
    for (std::size_t j = 0; j < (k1 == 0 ? 1U : 2U); ++j) {
      const Segment& first = starts[i].segment;
      const Segment& back = goals[j].segment;
      windings[all.count] = {{-sign(first.length), sign(k0), std::abs(first.length)},
                             {sign(back.length), sign(k1), std::abs(back.length)}};
      from[all.count] = starts[i].pose;
      to[all.count] = goals[j].pose;
      all.around[all.count++] = {first, {0, -back.length, -back.curvature_rate}};
    }
  }
  add_tasks(all, from, to, windings, stops);
  return all;
}

}  // namespace vandplan::steering
