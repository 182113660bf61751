// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous_ends.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/trigonometry.h"
#include "steering/continuous_combinations.h"
#include "steering/mean_frame.h"

namespace vandplan::steering {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();
constexpr double two_pi = 2 * std::numbers::pi;

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

/// A path that always exists: straight on, left turn, line, left turn, with both turns to full
/// lock.
UnitSegments detour(const SharpTurns& turns, const MeanFrame& f) {
  const auto [cx, cy] = turns.centre();
  const auto [sin, cos] = base::sin_cos(f.half_turn);
  // Vector between the centres of the turns; a line before the first turn moves its centre.
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

bool is_nothing(const MeanFrame& f) { return f.x == 0 && f.y == 0 && f.half_turn == 0; }

/// Adds `saved`, of the other sign, to a segment's length. A rest as small as rounding becomes 0.
void shorten(Segment& segment, double saved) {
  const double rest = segment.length + saved;
  const bool is_gone = rest * segment.length <= 0 || std::abs(rest) < 1e-14;
  segment.length = is_gone ? 0 : rest;
}

/// The path of a word with its windings. A winding that the word drives back is left out.
UnitPath driven(const WordSolver& solver, const Combinations& all, std::size_t which,
                const FoundWord& found) {
  const Windings& windings = all.tasks[which].windings;
  const auto& [first, last] = all.around[which];
  UnitSegments inner = as_made_by(found.symmetry, solver.segments_of(found.word));
  const Windings only_start{windings.start, {}}, only_goal{{}, windings.goal};
  const bool skips_first = saved(solver, found, only_start) > 0;
  const bool skips_last = saved(solver, found, only_goal) > 0;
  if (skips_first) {
    Segment& s = inner.list[0];
    s.curvature = first.curvature;
    shorten(s, first.length);
  }
  if (skips_last) shorten(inner.list[inner.count - 1], last.length);
  UnitPath path;
  if (!skips_first) path.segments.add(first);
  for (std::size_t i = 0; i < inner.count; ++i) path.segments.add(inner.list[i]);
  if (!skips_last) path.segments.add(last);
  path.length = windings.length() + found.word.length - saved(solver, found, windings);
  return path;
}

/// The path of the two windings, with the detour between them unless they meet.
UnitPath without_word(const WordSolver& solver, const Combinations& all, std::size_t which) {
  const WordTask& task = all.tasks[which];
  const auto& [first, last] = all.around[which];
  UnitSegments inner;
  if (!is_nothing(task.frame)) inner = detour(solver.turns(), task.frame);
  UnitPath path;
  path.segments.add(first);
  for (std::size_t i = 0; i < inner.count; ++i) path.segments.add(inner.list[i]);
  path.segments.add(last);
  path.length = task.windings.length() + length_of(inner);
  return path;
}

/// The shortest path found: combination number `which`, with a word or without one.
struct Answer {
  double length = infinite;
  std::size_t which = 0;
  std::optional<FoundWord> word;
};

/// The shortest path by the quick search, which looks for words up to the cutoff.
Answer quick_answer(const WordSolver& solver, const Combinations& all, double cutoff) {
  Answer answer;
  for (std::size_t i = 0; i < all.count; ++i) {
    const double wound = all.tasks[i].windings.length();
    if (is_nothing(all.tasks[i].frame) && wound < answer.length) answer = {wound, i, std::nullopt};
  }
  const auto least = least_word(solver, {all.tasks.data(), all.count},
                                std::min(answer.length, cutoff), all.looked);
  if (least) answer = {least->length, least->task, least->found};
  return answer;
}

Answer answer_of(const WordSolver& solver, const Combinations& all, Direct& direct, double cutoff) {
  Answer answer = quick_answer(solver, all, cutoff);
  // No shortest path is a whole turn longer than that of Reeds and Shepp [turning radii].
  const double longer = 2 + 6 * solver.turns().ramp();
  if (direct.is_at_least(std::min(answer.length, cutoff) - longer)) return answer;
  for (std::size_t i = 0; i < all.count; ++i) {  // all words, not only likely ones
    const Windings& windings = all.tasks[i].windings;
    for (const FoundWord& found : all_words(solver, all.tasks[i])) {
      const double length = windings.length() + found.word.length - saved(solver, found, windings);
      if (length < answer.length) answer = {length, i, found};
    }
  }
  if (answer.length == infinite) {
    answer.length = without_word(solver, all, 0).length;
  }
  return answer;
}

/// Alternatives to `stops` with fewer places where the curvature jumps.
std::array<Stops, 4> with_fewer(const Stops& stops) {
  return {Stops{}, {false, true, false}, {stops.start, true, false}, {false, true, stops.goal}};
}

/// The shortest path, and the combinations that its `which` counts.
struct Solution {
  Combinations combinations;
  Answer answer;
};

Solution solution_of(const WordSolver& solver, const EndsTask& task, Direct& direct) {
  Solution solution{combinations_of(solver, task, task.stops, direct), {}};
  const double cutoff = task.cutoff * (1 + 1e-9) + 1e-12;  // rounding excludes no path
  solution.answer = answer_of(solver, solution.combinations, direct, cutoff);
  // Jumps nearly always help, so fewer of them are tried only if the path is suspiciously long.
  constexpr double suspicious = 1.2;
  if (!task.stops.inside ||
      std::min(solution.answer.length, cutoff) <= suspicious * direct.length()) {
    return solution;
  }
  const auto fewer = with_fewer(task.stops);
  for (std::size_t i = 0; i < fewer.size(); ++i) {
    if (i > 0 && fewer[i] == task.stops) break;
    const Combinations other = combinations_of(solver, task, fewer[i], direct);
    const Answer answer =
        i == 0 ? answer_of(solver, other, direct, cutoff) : quick_answer(solver, other, cutoff);
    if (answer.length < solution.answer.length) solution = {other, answer};
  }
  return solution;
}

}  // namespace

std::optional<UnitPath> least_path(const WordSolver& solver, const EndsTask& task) {
  Direct direct(task);
  const auto [combinations, answer] = solution_of(solver, task, direct);
  if (answer.length > task.cutoff) return std::nullopt;
  return answer.word ? driven(solver, combinations, answer.which, *answer.word)
                     : without_word(solver, combinations, answer.which);
}

double least_length(const WordSolver& solver, const EndsTask& task) {
  Direct direct(task);
  const bool has_cutoff = task.cutoff < infinite;
  if (has_cutoff && direct.length() > task.cutoff * (1 + 1e-9) + 1e-12) return infinite;
  const double length = solution_of(solver, task, direct).answer.length;
  return length > task.cutoff ? infinite : length;
}

std::vector<UnitPath> all_paths(const WordSolver& solver, const EndsTask& task) {
  std::vector<UnitPath> paths;
  const auto take = [&](const UnitPath& path) {
    if (path.length <= task.cutoff) paths.push_back(path);
  };
  Direct direct(task);
  const Combinations all = combinations_of(solver, task, task.stops, direct);
  for (std::size_t i = 0; i < all.count; ++i) {
    WordTask words = all.tasks[i];
    take(without_word(solver, all, i));
    if (is_nothing(words.frame)) continue;
    for (const FoundWord& found : all_words(solver, words)) take(driven(solver, all, i, found));
    if (!task.stops.inside) continue;
    words.stops = {};
    for (const FoundWord& found : all_words(solver, words)) take(driven(solver, all, i, found));
  }
  return paths;
}

EndsTask ends_task(const ContinuousSteering& steering, const Pose& from, const Pose& to,
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

void for_cheap_paths(const WordSolver& solver, std::span<const PricedEnds> tasks,
                     const PathPrices& prices, int gear_changes, double cutoff,
                     const TakePath& take) {
  std::vector<PricedTask> words;
  struct Origin {
    std::size_t task, which;
  };
  std::vector<Origin> origins;
  std::vector<Combinations> all;
  double dearest = cutoff;
  for (const PricedEnds& ends : tasks) {
    Direct direct(ends.task);
    const Combinations& made =
        all.emplace_back(combinations_of(solver, ends.task, ends.task.stops, direct));
    for (std::size_t i = 0; i < made.count; ++i) {
      if (is_nothing(made.tasks[i].frame)) {
        const bool changes = made.around[i].first.length * made.around[i].last.length < 0;
        if (gear_changes != (changes ? 1 : 0)) continue;
        dearest = std::min(dearest, take(all.size() - 1, without_word(solver, made, i)));
        continue;
      }
      // After a winding a word may begin, and before one end, in any gear.
      const bool begins = ends.task.start_curvature == 0;
      const bool goes_over = ends.task.goal_curvature == 0;
      words.push_back({made.tasks[i], begins ? ends.first_gear : 0, goes_over ? ends.last_gear : 0,
                       begins ? prices.before : 0, goes_over ? prices.after : 0});
      origins.push_back({all.size() - 1, i});
    }
  }
  for_cheap_words(solver, words, prices.word, gear_changes, dearest,
                  [&](std::size_t i, const FoundWord& found) {
                    const auto [task, which] = origins[i];
                    return take(task, driven(solver, all[task], which, found));
                  });
}

Piece scaled(const UnitPath& path, double radius) {
  Piece piece;
  for (std::size_t i = 0; i < path.segments.count; ++i) {
    const Segment& s = path.segments.list[i];
    piece.segments[piece.count++] = {s.curvature / radius, s.length * radius,
                                     s.curvature_rate / radius / radius};
  }
  piece.length = path.length * radius;
  return piece;
}

}  // namespace vandplan::steering
