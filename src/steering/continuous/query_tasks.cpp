// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/query_tasks.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/trigonometry.h"
#include "base/trigonometry_series.h"
#include "simd/turn_kernels.h"
#include "steering/mean_frame.h"

namespace vandplan::steering::continuous {
namespace {

/// A winding at one end of a query.
struct StraightenedEnd {
  Pose pose;        ///< pose at which the wheels are straight
  Segment segment;  ///< the clothoid, driven from the start onward or from the goal backward
};

/// The ways to straighten the wheels from a pose with `curvature`: forward and in reverse.
std::array<StraightenedEnd, 2> straightened_ends(const Pose& pose, double curvature,
                                                 const SharpTurns& turns) {
  const double length = std::abs(curvature) * turns.ramp();
  const double rate = curvature > 0 ? -turns.sharpness() : turns.sharpness();
  const Turned wound = turns.turn(length, TurnEnds::stands_after).reversed();
  const double turn = curvature > 0 ? wound.angle : -wound.angle;
  const double aside = curvature > 0 ? wound.y : -wound.y;
  const auto [sin, cos] = base::sin_cos(pose.heading);
  std::array<StraightenedEnd, 2> ends;
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

/// Adds a task for each pair of windings.
void add_tasks(QueryTasks& all, const std::array<Pose, 4>& from, const std::array<Pose, 4>& to,
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

UnitQuery unit_query(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                     const ContinuousQuery& query) {
  const double radius = steering.radius();
  const auto bounded = [&](double curvature) { return std::clamp(curvature * radius, -1.0, 1.0); };
  const bool may_jump = steering.continuity() == Continuity::between_stops;
  const Stops stops{may_jump && query.start_stands, may_jump, may_jump && query.goal_stands};
  return {{0, 0, from.heading},
          {(to.x - from.x) / radius, (to.y - from.y) / radius, to.heading},
          stops,
          stops.start ? 0.0 : bounded(query.start_curvature),
          stops.goal ? 0.0 : bounded(query.goal_curvature),
          query.cutoff / radius};
}

DirectTask::DirectTask(const UnitQuery& query) noexcept : query_(query) {
  const double dx = query.to.x - query.from.x, dy = query.to.y - query.from.y;
  straight_ = std::sqrt(dx * dx + dy * dy);
}

const WordTask& DirectTask::task() noexcept {
  if (!made_) made_.emplace(mean_frame(query_.from, query_.to, 1), Windings{}, query_.stops);
  return *made_;
}

QueryTasks tasks_of(const WordSolver& solver, const UnitQuery& query, const Stops& stops,
                    DirectTask& direct) {
  QueryTasks all;
  const bool is_near = direct.is_shorter_than(solver.turns().ramp());
  all.breadth = is_near ? SearchBreadth::many : SearchBreadth::likely;
  if (query.start_curvature == 0 && query.goal_curvature == 0) {
    all.tasks[0] = direct.task();
    all.tasks[0].stops = stops;
    all.windings[0] = {};
    all.count = 1;
    return all;
  }
  const double k0 = query.start_curvature;
  const double k1 = query.goal_curvature;
  const auto starts = straightened_ends(query.from, k0, solver.turns());
  const auto goals = straightened_ends(query.to, k1, solver.turns());
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
      all.windings[all.count++] = {first, {0, -back.length, -back.curvature_rate}};
    }
  }
  add_tasks(all, from, to, windings, stops);
  return all;
}

}  // namespace vandplan::steering::continuous
