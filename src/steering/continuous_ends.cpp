// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_ends.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/trigonometry.h"
#include "steering/mean_frame.h"

namespace vandplan::steering {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double two_pi = 2 * std::numbers::pi;

MeanFrame folded(const MeanFrame& f) {
  return {std::abs(f.x), std::abs(f.y), std::abs(f.half_turn)};
}

/// What undoes `folded`. For the frame from the other end it differs in all three, zeros included.
Symmetry unfolding(const MeanFrame& f) {
  const bool backwards = f.x != 0 ? f.x < 0 : f.y != 0 ? f.y < 0 : f.half_turn < 0;
  const auto is_negative = [&](double v) { return v != 0 ? v < 0 : backwards; };
  return {backwards, is_negative(f.y), is_negative(f.half_turn)};
}

Segment from_its_end(const Segment& s) {
  return {curvature_at(s, std::abs(s.length)), s.length, -s.curvature_rate};
}

UnitSegments as_made_by(const Symmetry& symmetry, const UnitSegments& segments) {
  UnitSegments result = segments;
  const double side = symmetry.swaps_sides() ? -1 : 1;
  const double gear = symmetry.swaps_gears() ? -1 : 1;
  for (std::size_t i = 0; i < segments.count; ++i) {
    Segment s = symmetry.swaps_ends() ? from_its_end(segments.list[segments.count - 1 - i])
                                      : segments.list[i];
    s.curvature *= side;
    s.curvature_rate *= side;
    s.length *= gear;
    result.list[i] = s;
  }
  return result;
}

double length_of(const UnitSegments& segments) {
  double sum = 0;
  for (std::size_t i = 0; i < segments.count; ++i) sum += std::abs(segments.list[i].length);
  return sum;
}

/// A path that there always is: straight on, a turn to the left, a line, a turn to the left, all of
/// them to full lock.
UnitSegments detour(const SharpTurns& turns, const MeanFrame& f) {
  const auto [cx, cy] = turns.centre();
  const auto [sin, cos] = base::sin_cos(f.half_turn);
  // Between the centres of the turns; a line before the first moves its centre.
  const double gap = std::max(2 * cx, 0.0);
  double dx = f.x - 2 * cos * cx;
  double dy = f.y;
  dx += -sin * cy - (sin * cy);
  double ahead = 0;
  if (dx * dx + dy * dy < gap * gap) {
    ahead = 2 * gap;
    dx -= ahead * cos;
    dy += ahead * sin;
  }
  const double heading = base::atan_2(dy, dx);
  const double least = turns.ramp();  // the angle of both clothoids
  const auto enough = [&](double angle) {
    return angle - two_pi * std::floor((angle - least) / two_pi);
  };
  UnitSegments s;
  s.add({0, ahead, 0});
  const auto turn = [&](double angle) {
    s.add({0, turns.ramp(), turns.sharpness()});
    s.add({1, angle - least, 0});
    s.add({1, turns.ramp(), -turns.sharpness()});
  };
  turn(enough(heading + f.half_turn));
  s.add({0, std::sqrt(dx * dx + dy * dy) - 2 * cx, 0});
  turn(enough(f.half_turn - heading));
  return s;
}

/// One of the ways to start or to end: what is driven while the wheels are turned.
struct Winding {
  Pose pose;        ///< where they are straight
  Segment segment;  ///< from the start on, or up to the goal
};

std::array<Winding, 2> unwindings(const Pose& pose, double curvature, double sharpness) {
  std::array<Winding, 2> both;
  for (std::size_t i = 0; i < 2; ++i) {
    const double length = (i == 0 ? 1 : -1) * std::abs(curvature) / sharpness;
    const Segment segment{curvature, length, curvature > 0 ? -sharpness : sharpness};
    both[i] = {length == 0 ? pose : advance(pose, segment), segment};
  }
  return both;
}

/// Whether the second segment begins by driving back the first, which ends with straight wheels.
bool drives_back(const Segment& wound, const Segment& next) {
  return wound.length != 0 && next.curvature == 0 && next.curvature_rate == -wound.curvature_rate &&
         wound.length * next.length < 0 && std::abs(next.length) >= std::abs(wound.length);
}

UnitSegments joined(const Segment& first, UnitSegments inner, const Segment& last) {
  const bool skips_first = inner.count > 0 && drives_back(first, inner.list[0]);
  if (skips_first) {
    Segment& s = inner.list[0];
    s.curvature = first.curvature;
    s.length += first.length;
  }
  bool skips_last = false;
  if (inner.count > 0) {
    Segment& s = inner.list[inner.count - 1];
    Segment back = from_its_end(last);
    if (std::abs(curvature_at(s, std::abs(s.length))) < 1e-9) {
      Segment end = from_its_end(s);
      end.curvature = 0;
      skips_last = drives_back(back, end) && (inner.count > 1 || !skips_first);
    }
    if (skips_last) s.length += last.length;
  }
  UnitSegments all;
  if (!skips_first) all.add(first);
  for (std::size_t i = 0; i < inner.count; ++i) all.add(inner.list[i]);
  if (!skips_last) all.add(last);
  return all;
}

/// Calls `take` with every path.
template <typename Take>
void for_each_path(const WordSolver& solver, const EndsTask& task, bool jumps, Take take) {
  const double k0 = jumps ? 0 : task.start_curvature;
  const double k1 = jumps ? 0 : task.goal_curvature;
  const auto starts = unwindings(task.from, k0, solver.turns().sharpness());
  const auto goals = unwindings(task.to, k1, solver.turns().sharpness());
  for (std::size_t i = 0; i < (k0 == 0 ? 1U : 2U); ++i) {
    for (std::size_t j = 0; j < (k1 == 0 ? 1U : 2U); ++j) {
      const MeanFrame frame = mean_frame(starts[i].pose, goals[j].pose, 1);
      const Symmetry undo = unfolding(frame);
      const Segment& back = goals[j].segment;
      const Segment last{0, -back.length, -back.curvature_rate};
      const auto give = [&](const UnitSegments& segments) {
        const UnitSegments all = joined(starts[i].segment, as_made_by(undo, segments), last);
        const double length = length_of(all);
        if (length <= task.cutoff) take(UnitPath{all, length});
      };
      if (frame.x == 0 && frame.y == 0 && frame.half_turn == 0) {
        give({});
        continue;
      }
      bool any = false;
      const auto all_of = [&](bool with_jumps) {
        for (const FoundWord& found : all_words(solver, folded(frame), with_jumps)) {
          give(as_made_by(found.symmetry, solver.segments_of(found.word)));
          any = true;
        }
      };
      if (jumps) all_of(true);
      all_of(false);
      if (!any) give(detour(solver.turns(), folded(frame)));
    }
  }
}

}  // namespace

std::optional<UnitPath> least_path(const WordSolver& solver, const EndsTask& task, bool jumps) {
  std::optional<UnitPath> least;
  for_each_path(solver, task, jumps, [&](const UnitPath& path) {
    if (!least || path.length < least->length) least = path;
  });
  return least;
}

double least_length(const WordSolver& solver, const EndsTask& task, bool jumps) {
  const auto path = least_path(solver, task, jumps);
  return path ? path->length : infinite;
}

std::vector<UnitPath> all_paths(const WordSolver& solver, const EndsTask& task, bool jumps) {
  std::vector<UnitPath> paths;
  for_each_path(solver, task, jumps, [&](const UnitPath& path) { paths.push_back(path); });
  return paths;
}

}  // namespace vandplan::steering
