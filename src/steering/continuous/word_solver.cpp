// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/continuous/word_solver.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/trigonometry.h"

namespace vandplan::steering::continuous {
namespace {

bool has_line(const Steps& steps) { return steps.list[1].part == 2 || steps.list[2].part == 2; }

WordShape made_shape(const Steps& steps, const Stops& stops) {
  WordShape shape;
  shape.steps = steps;
  shape.has_line = has_line(steps);
  for (std::size_t i = 0; i < steps.count; ++i) {
    const double gear = steps.list[i].gear;
    const bool before = i == 0 ? stops.start : stops.inside && steps.list[i - 1].gear != gear;
    const bool after =
        i + 1 == steps.count ? stops.goal : stops.inside && steps.list[i + 1].gear != gear;
    shape.ends[i] = before ? (after ? TurnEnds::stands_at_both : TurnEnds::stands_before)
                           : (after ? TurnEnds::stands_after : TurnEnds::rolling);
    const std::size_t part = steps.list[i].part;
    if (part == 1) shape.inner = i;
    const std::size_t turn = part == 0 ? 0 : part == 3 ? 2 : 1;
    shape.senses[turn] += steps.list[i].gear * steps.list[i].turn;
    shape.length_of[i] = part == 0 ? 0 : part == 3 ? 2 : part == 1 && has_line(steps) ? 3 : 1;
    if (steps.list[i].turn == 0) {
      shape.may_dip = steps.list[i - 1].turn == steps.list[i + 1].turn;
    }
  }
  const auto rolls_on = [&](std::size_t i) {
    return steps.list[i].gear == steps.list[i + 1].gear &&
           steps.list[i].turn * steps.list[i + 1].turn != 0;
  };
  shape.may_cut_first = stops.start && rolls_on(0);
  shape.may_cut_last = stops.goal && rolls_on(steps.count - 2);
  for (std::size_t i = 0; i < steps.count; ++i) {
    ++(shape.length_of[i] < 3 ? shape.counts[shape.length_of[i]] : shape.quarters);
  }
  shape.min_lengths = {shape.may_cut_first ? -1.0 : 0.0, shape.may_dip ? -2.0 : 0.0,
                       shape.may_cut_last ? -1.0 : 0.0};
  return shape;
}

template <typename Word>
auto& length_of(Word& word, std::size_t step) {
  const Steps& steps = steps_of(word.formula);
  switch (steps.list[step].part) {
    case 0:
      return word.lengths[0];
    case 3:
      return word.lengths[2];
    case 2:
      return word.lengths[1];
    default:
      return has_line(steps) ? word.quarter : word.lengths[1];
  }
}

}  // namespace

void UnitSegments::add(const Segment& segment) noexcept {
  constexpr double rounding = 2e-12;
  if (segment.length == 0) return;
  const auto follows = [](const Segment& last, const Segment& next) {
    const double end = curvature_at(last, std::abs(last.length));
    return last.length * next.length > 0 && std::abs(end - next.curvature) < 1e-9;
  };
  if (count > 1 && std::abs(list[count - 1].length) < rounding &&
      follows(list[count - 2], segment)) {
    --count;
  }
  if (count > 0) {
    Segment& last = list[count - 1];
    // Equal rates are enough: a clothoid may pass curvature 0, and none goes on beyond full lock.
    if (last.curvature_rate == segment.curvature_rate && follows(last, segment)) {
      last.length += segment.length;
      return;
    }
  }
  list[count++] = segment;
}

const WordShape& shape_of(Formula formula, const Stops& stops) noexcept {
  static const auto shapes = [] {
    std::array<std::array<WordShape, 8>, formula_count> all;
    for (std::size_t i = 0; i < formula_count; ++i) {
      for (std::size_t j = 0; j < 8; ++j) {
        const Stops at{(j & 4) != 0, (j & 2) != 0, (j & 1) != 0};
        all[i][j] = made_shape(steps_of(static_cast<Formula>(i)), at);
      }
    }
    return all;
  }();
  const std::size_t j = (stops.start ? 4U : 0U) + (stops.inside ? 2U : 0U) + (stops.goal ? 1U : 0U);
  return shapes[static_cast<std::size_t>(formula)][j];
}

WordSolver::WordSolver(const SharpTurns& turns) noexcept
    : turns_(turns), small_step_(1e-8 / std::sqrt(1 + turns.sharpness())) {}

double WordSolver::radius_of(double angle) const noexcept {
  const double bounded = std::clamp(angle, 1e-12, std::numbers::pi);
  const Turned t = turns_.turn(turns_.length_of(bounded, TurnEnds::rolling), TurnEnds::rolling);
  return std::sqrt(t.x * t.x + t.y * t.y) / (2 * base::sin_cos(bounded / 2).sin);
}

std::optional<SolvedWord> WordSolver::at_full_lock(Formula formula, const Stops& stops,
                                                   const Arcs& arcs) const noexcept {
  constexpr double noise = 1e-13;
  const WordShape& shape = shape_of(formula, stops);
  SolvedWord word{formula, stops, {}, 0, 0};
  const auto turn_of = [&](double angle, std::size_t step, double& length) {
    const double ramps = turns_.ramps_of(shape.ends[step]);
    if (angle < ramps / 2 - noise) return false;
    length = std::max(angle, ramps / 2) + ramps / 2;
    return true;
  };
  if (shape.has_line) {
    if (arcs.line < -noise) return std::nullopt;
    word.lengths[1] = std::max(arcs.line, 0.0);
  }
  double& inner = shape.has_line ? word.quarter : word.lengths[1];
  if (!turn_of(arcs.first, 0, word.lengths[0]) ||
      !turn_of(arcs.last, shape.steps.count - 1, word.lengths[2]) ||
      (shape.inner != 0 && !turn_of(arcs.inner, shape.inner, inner))) {
    return std::nullopt;
  }
  for (std::size_t i = 0; i < shape.steps.count; ++i) word.length += length_of(word, i);
  return word;
}

std::optional<SolvedWord> WordSolver::solve(Formula formula, const Stops& stops,
                                            const WordFrame& frame, const Arcs& arcs,
                                            const NewtonLimits& limits) const noexcept {
  const WordShape& shape = shape_of(formula, stops);
  const std::size_t last = shape.steps.count - 1;
  SolvedWord word{formula, stops, {}, 0, 0};
  // Beside a line even tiny angles are nearly right; elsewhere turns need some length to move.
  const double min_guess = shape.has_line ? 1e-14 : 1e-6;
  const auto guessed = [&](double angle, std::size_t step) {
    return turns_.length_of(std::max(angle, min_guess), shape.ends[step]);
  };
  word.lengths[0] = guessed(arcs.first, 0);
  word.lengths[2] = guessed(arcs.last, last);
  const double inner = arcs.inner > 0 ? guessed(arcs.inner, shape.inner) : 0;
  (shape.has_line ? word.quarter : word.lengths[1]) = inner;
  if (shape.has_line) {
    word.lengths[1] =
        shape.may_dip ? std::max(arcs.line, -turns_.ramp()) : std::max(arcs.line, 0.0);
  }
  const double guess =
      shape.senses[0] * arcs.first + shape.senses[1] * arcs.inner + shape.senses[2] * arcs.last;
  const double turn = 2 * frame.a + full_turn * std::round((guess - 2 * frame.a) / full_turn);
  if (!find_root(word, frame, turn, limits) || !is_drivable(word)) return std::nullopt;
  drop_vanishing_parts(word, frame, turn);
  return word;
}

bool WordSolver::is_drivable(SolvedWord& word) const noexcept {
  constexpr double noise = 1e-13;
  const WordShape& shape = shape_of(word.formula, word.stops);
  const Steps& steps = shape.steps;
  word.length = 0;
  bool vanishes = false;
  if (shape.has_line) {  // a turn by next to nothing is made part of the line
    constexpr double nothing = 1e-14;
    const auto give = [&](double& length, std::size_t step, std::size_t beside) {
      if (steps.list[beside].part != 2 || shape.ends[step] == TurnEnds::stands_at_both) return;
      if (length >= 0 || turns_.sharpness() * length * length > nothing) return;
      word.lengths[1] += length;
      length = 0;
    };
    give(word.lengths[0], 0, 1);
    give(word.lengths[2], steps.count - 1, steps.count - 2);
  }
  for (std::size_t i = 0; i < steps.count; ++i) {
    double& length = length_of(word, i);
    if (std::abs(length) < noise) length = 0;
    vanishes = vanishes || length == 0;
    word.length += length;
    if (length >= 0) continue;
    if (steps.list[i].part == 2) {
      if (!shape.may_dip) return false;
      const double cut = -length / 2;
      if (cut > ramp_of(word, i - 1) || cut > ramp_of(word, i + 1)) return false;
    } else if (steps.list[i].part == 0) {
      if (!shape.may_cut_first || -length > ramp_of(word, 1)) return false;
    } else if (steps.list[i].part == 3) {
      if (!shape.may_cut_last || -length > ramp_of(word, i - 1)) return false;
    } else {
      return false;
    }
  }
  return !vanishes || jumps_at_stops(word);
}

bool WordSolver::jumps_at_stops(const SolvedWord& word) const noexcept {
  const WordShape& shape = shape_of(word.formula, word.stops);
  const Steps& steps = shape.steps;
  const auto bends_at = [&](std::size_t step, TurnEnds end) {
    return shape.ends[step] == end || shape.ends[step] == TurnEnds::stands_at_both;
  };
  std::size_t last = steps.count;  // last step that is driven; none yet
  for (std::size_t i = 0; i < steps.count; ++i) {
    if (length_of(word, i) <= 0) continue;
    const bool bends_before = bends_at(i, TurnEnds::stands_before);
    if (last == steps.count) {
      if (bends_before && !word.stops.start) return false;
    } else if (steps.list[i].gear == steps.list[last].gear &&
               (bends_before || bends_at(last, TurnEnds::stands_after))) {
      // Two strokes in one gear with nothing between them.
      const bool is_one =
          steps.list[i].turn == steps.list[last].turn && ramp_of(word, i) == ramp_of(word, last);
      if (!is_one || !bends_before || !bends_at(last, TurnEnds::stands_after)) return false;
    }
    last = i;
  }
  return last == steps.count || word.stops.goal || !bends_at(last, TurnEnds::stands_after);
}

UnitSegments WordSolver::segments_of(const SolvedWord& word) const noexcept {
  const WordShape& shape = shape_of(word.formula, word.stops);
  const Steps& steps = shape.steps;
  // What parts of negative length take from the clothoids at each joint.
  std::array<double, 7> taken{};  // joint before step i: [i], joint after step i: [i + 1]
  for (std::size_t i = 0; i < steps.count; ++i) {
    const double length = length_of(word, i);
    if (length >= 0) continue;
    const double cut = steps.list[i].part == 2 ? -length / 2 : -length;
    taken[i] = taken[i + 1] = cut;
  }
  UnitSegments segments;
  for (std::size_t i = 0; i < steps.count; ++i) {
    const Step& step = steps.list[i];
    const double length = length_of(word, i);
    if (length <= 0) continue;
    if (step.part == 2) {
      segments.add({0, step.gear * length, 0});
      continue;
    }
    const double rate = step.turn * turns_.sharpness();
    const TurnEnds ends = shape.ends[i];
    const bool rises = ends == TurnEnds::rolling || ends == TurnEnds::stands_after;
    const bool falls = ends == TurnEnds::rolling || ends == TurnEnds::stands_before;
    const double ramps = (rises ? 1 : 0) + (falls ? 1 : 0);
    const double ramp = ramps == 0 ? 0 : std::min(turns_.ramp(), length / ramps);
    const bool is_full = ramp == turns_.ramp() || ramps == 0;
    const double peak = step.turn * (is_full ? 1 : std::min(1.0, turns_.sharpness() * ramp));
    if (rises) {
      const double cut = std::min(taken[i], ramp);
      segments.add({rate * cut, step.gear * (ramp - cut), rate});
    }
    if (is_full) segments.add({peak, step.gear * (length - ramps * ramp), 0});
    if (falls) {
      segments.add({peak, step.gear * (ramp - std::min(taken[i + 1], ramp)), -rate});
    }
  }
  return segments;
}

double WordSolver::step_length(const SolvedWord& word, std::size_t step) const noexcept {
  return length_of(word, step);
}

double WordSolver::ramp_of(const SolvedWord& word, std::size_t step) const noexcept {
  const WordShape& shape = shape_of(word.formula, word.stops);
  return turns_.peak(length_of(word, step), shape.ends[step]) * turns_.ramp();
}

}  // namespace vandplan::steering::continuous
