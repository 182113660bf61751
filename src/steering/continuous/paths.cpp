// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/paths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/trigonometry.h"
#include "steering/continuous/circle_word.h"
#include "steering/mean_frame.h"

namespace vandplan::steering::continuous {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

Segment from_its_end(const Segment& s) {
  return {curvature_at(s, std::abs(s.length)), s.length, -s.curvature_rate};
}

UnitSegments mirrored(const UnitSegments& segments, const Symmetry& symmetry) {
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
UnitSegments fallback(const SharpTurns& turns, const MeanFrame& f) {
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
  const double min_angle = turns.ramp();  // the angle of both clothoids
  const auto enough = [&](double angle) {
    return angle - full_turn * std::floor((angle - min_angle) / full_turn);
  };
  UnitSegments s;
  s.add({0, ahead, 0});
  const auto turn = [&](double angle) {
    s.add({0, turns.ramp(), turns.sharpness()});
    s.add({1, angle - min_angle, 0});
    s.add({1, turns.ramp(), -turns.sharpness()});
  };
  turn(enough(heading + f.half_turn));
  s.add({0, std::sqrt(dx * dx + dy * dy) - 2 * cx, 0});
  turn(enough(f.half_turn - heading));
  return s;
}

bool are_equal_poses(const MeanFrame& f) { return f.x == 0 && f.y == 0 && f.half_turn == 0; }

/// Adds `saved`, of the other sign, to a segment's length. A rest as small as rounding becomes 0.
void shorten(Segment& segment, double saved) {
  const double rest = segment.length + saved;
  const bool is_gone = rest * segment.length <= 0 || std::abs(rest) < 1e-14;
  segment.length = is_gone ? 0 : rest;
}

/// The path of a word with its windings. A winding that the word drives back is left out.
UnitPath path_with(const WordSolver& solver, const QueryTasks& all, std::size_t which,
                   const FoundWord& found) {
  const Windings& windings = all.tasks[which].windings;
  const auto& [first, last] = all.windings[which];
  UnitSegments inner = mirrored(solver.segments_of(found.word), found.symmetry);
  const Windings only_start{windings.start, {}}, only_goal{{}, windings.goal};
  const bool skips_first = saved_length(solver, found, only_start) > 0;
  const bool skips_last = saved_length(solver, found, only_goal) > 0;
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
  path.length = windings.length() + found.word.length - saved_length(solver, found, windings);
  return path;
}

/// The path of two windings, with the fallback between them unless they meet.
UnitPath path_without_word(const WordSolver& solver, const QueryTasks& all, std::size_t which) {
  const WordTask& task = all.tasks[which];
  const auto& [first, last] = all.windings[which];
  UnitSegments inner;
  if (!are_equal_poses(task.frame)) inner = fallback(solver.turns(), task.frame);
  UnitPath path;
  path.segments.add(first);
  for (std::size_t i = 0; i < inner.count; ++i) path.segments.add(inner.list[i]);
  path.segments.add(last);
  path.length = task.windings.length() + length_of(inner);
  return path;
}

/// The shortest path found: of task number `which`, with a word or without one.
struct Answer {
  double length = infinite;
  std::size_t which = 0;
  std::optional<FoundWord> word;
};

/// The shortest path by the quick search, which looks for words up to the cutoff.
Answer quick_answer(const WordSolver& solver, const QueryTasks& all, double cutoff) {
  Answer answer;
  for (std::size_t i = 0; i < all.count; ++i) {
    const WordTask& task = all.tasks[i];
    const double wound = task.windings.length();
    if (are_equal_poses(task.frame) && wound < answer.length) answer = {wound, i, std::nullopt};
  }
  const auto shortest = shortest_word(solver, {all.tasks.data(), all.count},
                                      std::min(answer.length, cutoff), all.breadth);
  if (shortest) answer = {shortest->length, shortest->task, shortest->found};
  return answer;
}

Answer thorough_answer(const WordSolver& solver, const QueryTasks& all, DirectTask& direct,
                       double cutoff) {
  Answer answer = quick_answer(solver, all, cutoff);
  // No shortest path is a whole turn longer than that of Reeds and Shepp [turning radii].
  const double longer = 2 + 6 * solver.turns().ramp();
  if (direct.is_at_least(std::min(answer.length, cutoff) - longer)) return answer;
  for (std::size_t i = 0; i < all.count; ++i) {  // all words, not only likely ones
    const Windings& windings = all.tasks[i].windings;
    for (const FoundWord& found : all_words(solver, all.tasks[i])) {
      const double length =
          windings.length() + found.word.length - saved_length(solver, found, windings);
      if (length < answer.length) answer = {length, i, found};
    }
  }
  if (answer.length == infinite) {
    answer.length = path_without_word(solver, all, 0).length;
  }
  return answer;
}

/// Alternatives to `stops` with fewer places where the curvature jumps.
std::array<Stops, 4> with_fewer(const Stops& stops) {
  return {Stops{}, {false, true, false}, {stops.start, true, false}, {false, true, stops.goal}};
}

/// The shortest path, and the tasks that its `which` counts.
struct TasksAndAnswer {
  QueryTasks tasks;
  Answer answer;
};

TasksAndAnswer best_answer(const WordSolver& solver, const UnitQuery& query, DirectTask& direct) {
  TasksAndAnswer best{tasks_of(solver, query, query.stops, direct), {}};
  const double cutoff = query.cutoff * (1 + 1e-9) + 1e-12;  // rounding excludes no path
  best.answer = thorough_answer(solver, best.tasks, direct, cutoff);
  // Jumps nearly always help, so fewer of them are tried only if the path is suspiciously long.
  constexpr double suspicious = 1.2;
  if (!query.stops.inside || std::min(best.answer.length, cutoff) <= suspicious * direct.length()) {
    return best;
  }
  const auto fewer = with_fewer(query.stops);
  for (std::size_t i = 0; i < fewer.size(); ++i) {
    if (i > 0 && fewer[i] == query.stops) break;
    const QueryTasks other = tasks_of(solver, query, fewer[i], direct);
    const Answer answer = i == 0 ? thorough_answer(solver, other, direct, cutoff)
                                 : quick_answer(solver, other, cutoff);
    if (answer.length < best.answer.length) best = {other, answer};
  }
  return best;
}

}  // namespace

std::optional<UnitPath> shortest_path(const WordSolver& solver, const UnitQuery& query) {
  DirectTask direct(query);
  const auto [tasks, answer] = best_answer(solver, query, direct);
  if (answer.length > query.cutoff) return std::nullopt;
  return answer.word ? path_with(solver, tasks, answer.which, *answer.word)
                     : path_without_word(solver, tasks, answer.which);
}

double shortest_length(const WordSolver& solver, const UnitQuery& query) {
  DirectTask direct(query);
  const bool has_cutoff = query.cutoff < infinite;
  if (has_cutoff && direct.length() > query.cutoff * (1 + 1e-9) + 1e-12) return infinite;
  const double length = best_answer(solver, query, direct).answer.length;
  return length > query.cutoff ? infinite : length;
}

std::vector<UnitPath> all_paths(const WordSolver& solver, const UnitQuery& query) {
  std::vector<UnitPath> paths;
  const auto take = [&](const UnitPath& path) {
    if (path.length <= query.cutoff) paths.push_back(path);
  };
  DirectTask direct(query);
  const QueryTasks all = tasks_of(solver, query, query.stops, direct);
  for (std::size_t i = 0; i < all.count; ++i) {
    WordTask task = all.tasks[i];
    take(path_without_word(solver, all, i));
    if (are_equal_poses(task.frame)) continue;
    for (const FoundWord& found : all_words(solver, task)) take(path_with(solver, all, i, found));
    if (!query.stops.inside) continue;
    task.stops = {};
    for (const FoundWord& found : all_words(solver, task)) take(path_with(solver, all, i, found));
  }
  return paths;
}

void for_priced_paths(const WordSolver& solver, std::span<const PricedQuery> queries,
                      const PathPrices& prices, int gear_changes, double cutoff,
                      const TakePath& take) {
  std::vector<PricedTask> tasks;
  struct Origin {
    std::size_t query, which;
  };
  std::vector<Origin> origins;
  std::vector<QueryTasks> all;
  double to_undercut = cutoff;
  for (const PricedQuery& priced : queries) {
    DirectTask direct(priced.query);
    const QueryTasks& made =
        all.emplace_back(tasks_of(solver, priced.query, priced.query.stops, direct));
    for (std::size_t i = 0; i < made.count; ++i) {
      if (are_equal_poses(made.tasks[i].frame)) {
        const bool changes = made.windings[i].first.length * made.windings[i].last.length < 0;
        if (gear_changes != (changes ? 1 : 0)) continue;
        to_undercut =
            std::min(to_undercut, take(all.size() - 1, path_without_word(solver, made, i)));
        continue;
      }
      // After a winding a word may begin, and before one end, in any gear.
      const bool begins = priced.query.start_curvature == 0;
      const bool goes_over = priced.query.goal_curvature == 0;
      tasks.push_back({made.tasks[i], begins ? priced.first_gear : 0,
                       goes_over ? priced.last_gear : 0, begins ? prices.before : 0,
                       goes_over ? prices.after : 0});
      origins.push_back({all.size() - 1, i});
    }
  }
  for_priced_words(solver, tasks, prices.word, gear_changes, to_undercut,
                   [&](std::size_t i, const FoundWord& found) {
                     const auto [query, which] = origins[i];
                     return take(query, path_with(solver, all[query], which, found));
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

}  // namespace vandplan::steering::continuous
