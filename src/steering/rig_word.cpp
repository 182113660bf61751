// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "steering/rig_word.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/trigonometry.h"

namespace vandplan::steering {
namespace {

constexpr double full_turn = 2 * std::numbers::pi;
/// Letters shorter than this are rounding [turning radii].
constexpr double least_length = 1e-12;

/// Drives an arc or a line; the heading is not wrapped.
void drive_arc(RigPlace& place, double curvature, double way) noexcept {
  if (curvature == 0) {
    place.x += way * place.cos;
    place.y += way * place.sin;
    return;
  }
  place.heading += curvature * way;
  const auto [sin, cos] = base::sin_cos(place.heading);
  const double radius = 1 / curvature;
  place.x += (sin - place.sin) * radius;
  place.y -= (cos - place.cos) * radius;
  place.sin = sin;
  place.cos = cos;
}

double wrapped(double angle) noexcept {
  return angle - full_turn * std::floor(angle / full_turn + 0.5);
}

}  // namespace

/// Derivative of the place reached by the length of a letter.
struct RigWordSolver::Slope {
  double x = 0.0, y = 0.0, heading = 0.0, u = 0.0;
};

/// The gap of a word between the chains from both ends (x, y, heading, u), and its derivatives by
/// the four lengths.
struct RigWordSolver::Mismatch {
  std::array<double, 4> value{};
  std::array<Slope, 4> slopes{};

  [[nodiscard]] double squared() const {
    return value[0] * value[0] + value[1] * value[1] + value[2] * value[2] + value[3] * value[3];
  }
};

struct RigWordSolver::Letter {
  int turn;
  double way;  ///< negative in reverse
};

/// The parts of a letter: `lock` at the curvature of the letter, `hold` at the curvature that holds
/// the largest hitch angle. A part that is not driven has length 0.
struct RigWordSolver::Parts {
  Segment lock, hold;
  HitchTurn::After end;
};

RigPlace rig_place(double x, double y, double heading, double u) noexcept {
  const auto [sin, cos] = base::sin_cos(heading);
  return {x, y, heading, u, sin, cos};
}

RigWordSolver::RigWordSolver(const HitchTurn& hitch) noexcept
    : hitch_(hitch),
      hold_(hitch.hold_curvature(hitch.most())),
      hold_radius_(1 / std::min(1.0, hold_)) {}

double price_of(const RigWord& word, const WordPrices& prices) noexcept {
  double sum = 0.0;
  double gear = 0.0;
  for (const double length : word.lengths) {
    if (std::abs(length) < least_length) continue;
    sum += length < 0 ? -length * prices.reverse : length * prices.forward;
    if (gear * length < 0) sum += prices.gear_change;
    gear = length;
  }
  return sum;
}

/// Works out the two parts of a letter and the hitch angle at its end (6); false if the rig cannot
/// hold the limit.
bool RigWordSolver::divide(const RigPlace& place, const Letter& letter,
                           Parts& parts) const noexcept {
  const double most = hitch_.most();
  parts.end = hitch_.after(letter.turn, place.u, letter.way);
  if (parts.end.slope > 0 && std::abs(parts.end.u) <= most) {  // false for NaN
    parts.lock = {double(letter.turn), letter.way};
    parts.hold = {};
    return true;
  }
  const double gear = letter.way < 0 ? -1 : 1;
  const double rate = gear * hitch_.rate(letter.turn, place.u);
  const double limit = rate > 0 ? most : -most;
  const double hold = rate > 0 ? hold_ : -hold_;
  if (hold_ > 1) return false;
  const bool is_there = std::abs(place.u) >= most * (1 - 1e-13) && place.u * rate > 0;
  const double way = is_there ? 0.0 : hitch_.way_between(letter.turn, place.u, limit);
  if (!(way * gear >= 0)) return false;
  const double first = std::abs(way) < std::abs(letter.way) ? way : letter.way;
  parts.lock = {double(letter.turn), first};
  parts.hold = {hold, letter.way - first};
  parts.end = {limit, 0.0};
  return true;
}

/// Drives a letter. `slopes` has the derivatives by `count` letters before, and gets that by this
/// letter. False if the letter cannot be driven.
bool RigWordSolver::drive(RigPlace& place, const Letter& letter, Slope* slopes,
                          std::size_t count) const noexcept {
  Parts parts;
  if (!divide(place, letter, parts)) return false;
  const auto& [lock, hold, end] = parts;
  const RigPlace start = place;
  drive_arc(place, lock.curvature, lock.length);
  const RigPlace middle = place;
  const bool holds = hold.length != 0.0;
  if (holds) drive_arc(place, hold.curvature, hold.length);
  place.u = end.u;
  for (std::size_t i = 0; i < count; ++i) {
    Slope& s = slopes[i];
    s.x -= s.heading * (place.y - start.y);
    s.y += s.heading * (place.x - start.x);
    if (holds && lock.length != 0.0) {  // another u at the start moves where the limit is reached
      const double later = -s.u / hitch_.rate(letter.turn, start.u);
      const double turn = (lock.curvature - hold.curvature) * later;
      s.x -= turn * (place.y - middle.y);
      s.y += turn * (place.x - middle.x);
      s.heading += turn;
    }
    s.u *= end.slope;
  }
  slopes[count] = {place.cos, place.sin, holds ? hold.curvature : lock.curvature,
                   holds ? 0.0 : hitch_.rate(letter.turn, place.u)};
  return true;
}

/// Drives the first `meeting` letters from the start, the others from the goal backwards.
bool RigWordSolver::evaluate(const Task& task, const RigWord& word, std::size_t meeting,
                             Mismatch& mismatch) const noexcept {
  RigPlace ahead = task.start, back = task.goal;
  std::array<Slope, 4> to_goal, to_start;
  for (std::size_t i = 0; i < meeting; ++i) {
    if (!drive(ahead, {word.turns[i], word.lengths[i]}, to_goal.data(), i)) return false;
  }
  std::size_t count = 0;
  for (std::size_t i = RigWord::letters; i-- > meeting; ++count) {
    if (!drive(back, {word.turns[i], -word.lengths[i]}, to_start.data(), count)) return false;
  }
  mismatch.value = {ahead.x - back.x, ahead.y - back.y, wrapped(ahead.heading - back.heading),
                    ahead.u - back.u};
  for (std::size_t i = 0; i < meeting; ++i) mismatch.slopes[i] = to_goal[i];
  // No change of sign: these letters are driven backwards, and their end is subtracted.
  for (std::size_t i = 0; i < count; ++i) {
    mismatch.slopes[RigWord::letters - 1 - i] = to_start[i];
  }
  return true;
}

std::optional<RigSegments> RigWordSolver::segments_of(const Task& task, const RigWord& word,
                                                      std::size_t meeting) const noexcept {
  RigSegments result;
  const auto add = [&](const Segment& s) {
    if (std::abs(s.length) < least_length) return;
    Segment* const last = result.count > 0 ? &result.list[result.count - 1] : nullptr;
    if (last != nullptr && last->curvature == s.curvature && last->length * s.length > 0) {
      last->length += s.length;
    } else {
      result.list[result.count++] = s;
    }
  };
  RigPlace place = task.start;
  Parts parts;
  for (std::size_t i = 0; i < meeting; ++i) {
    if (!divide(place, {word.turns[i], word.lengths[i]}, parts)) return std::nullopt;
    add(parts.lock);
    add(parts.hold);
    place.u = parts.end.u;
  }
  place = task.goal;
  std::array<Parts, RigWord::letters> back{};
  for (std::size_t i = RigWord::letters; i-- > meeting;) {
    if (!divide(place, {word.turns[i], -word.lengths[i]}, back[i])) return std::nullopt;
    place.u = back[i].end.u;
  }
  for (std::size_t i = meeting; i < RigWord::letters; ++i) {
    add({back[i].hold.curvature, -back[i].hold.length});
    add({back[i].lock.curvature, -back[i].lock.length});
  }
  return result;
}

RigPlace RigWordSolver::after(const RigPlace& place,
                              std::span<const Segment> segments) const noexcept {
  RigPlace end = place;
  for (const Segment& s : segments) {
    end.u = hitch_.after_arc(s.curvature, end.u, s.length).u;
    drive_arc(end, s.curvature, s.length);
  }
  return end;
}

bool RigWordSolver::leads(const Task& task, std::span<const Segment> segments) const noexcept {
  constexpr double slack = 1e-11, close = 2e-11, most_growth = 1e4;
  RigPlace end = task.is_backwards ? task.goal : task.start;
  const RigPlace& goal = task.is_backwards ? task.start : task.goal;
  double growth = task.is_rounded ? 1.0 : 0.0;  // growth of the rounding errors so far
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& s = segments[task.is_backwards ? segments.size() - 1 - i : i];
    const double way = task.is_backwards ? -s.length : s.length;
    const HitchTurn::After driven = hitch_.after_arc(s.curvature, end.u, way);
    if (growth > 0 || s.curvature != 0 || end.u != 0) growth = (1 + growth) * driven.slope;
    drive_arc(end, s.curvature, way);
    end.u = driven.u;
    if (!(std::abs(end.u) <= hitch_.most() + slack) || !(growth < most_growth)) return false;
  }
  const double off =
      std::max({std::abs(end.x - goal.x), std::abs(end.y - goal.y),
                std::abs(wrapped(end.heading - goal.heading)), std::abs(end.u - goal.u)});
  return off <= std::max(close, task.tolerance * 8);
}

/// Determinant of the matrix with these columns, by minors of its upper and lower half (Laplace).
double RigWordSolver::determinant(const Slope& a, const Slope& b, const Slope& c,
                                  const Slope& d) noexcept {
  const auto upper = [](const Slope& p, const Slope& q) { return p.x * q.y - p.y * q.x; };
  const auto lower = [](const Slope& p, const Slope& q) {
    return p.heading * q.u - p.u * q.heading;
  };
  return upper(a, b) * lower(c, d) - upper(a, c) * lower(b, d) + upper(a, d) * lower(b, c) +
         upper(b, c) * lower(a, d) - upper(b, d) * lower(a, c) + upper(c, d) * lower(a, b);
}

/// The Newton step by Cramer's rule; nothing if the matrix is nearly singular.
std::optional<std::array<double, 4>> RigWordSolver::newton_step(const Mismatch& here) noexcept {
  constexpr double singular = 1e-14;
  const auto& [a, b, c, d] = here.slopes;
  const double whole = determinant(a, b, c, d);
  if (!(std::abs(whole) > singular)) return std::nullopt;
  const Slope wanted{-here.value[0], -here.value[1], -here.value[2], -here.value[3]};
  const double inverse = 1 / whole;
  return std::array<double, 4>{
      inverse * determinant(wanted, b, c, d), inverse * determinant(a, wanted, c, d),
      inverse * determinant(a, b, wanted, d), inverse * determinant(a, b, c, wanted)};
}

std::optional<RigSegments> RigWordSolver::solve(const Task& task, RigWord& guess) const noexcept {
  constexpr int usual_steps = 12, most_steps = 40, most_trials = 2;
  constexpr double longest_step = 1.0;
  const double longest_turn = full_turn * hold_radius_;
  // Approximate cost of closing a gap of one radian or radius.
  const double dearest = 2 * std::max(task.prices.forward, task.prices.reverse);
  std::size_t meeting = 0;
  while (meeting < RigWord::letters && guess.lengths[meeting] >= 0) ++meeting;
  Mismatch here, there;
  if (!evaluate(task, guess, meeting, here)) return std::nullopt;
  double squared = here.squared();
  const double small = task.tolerance * task.tolerance;
  for (int step = 0; squared > small; ++step) {
    if (step == most_steps) return std::nullopt;
    const double before = squared;
    // 1. Newton's step, no turn changed by more than a radian.
    const auto change = newton_step(here);
    if (!change) return std::nullopt;
    double largest = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (guess.turns[i] != 0) largest = std::max(largest, std::abs((*change)[i]));
    }
    double share = largest > longest_step ? longest_step / largest : 1.0;
    // 2. Shorter steps, until one ends nearer.
    RigWord next = guess;
    bool is_nearer = false;
    for (int trial = 0; trial < most_trials && !is_nearer; ++trial, share *= 0.4) {
      for (std::size_t i = 0; i < 4; ++i) next.lengths[i] = guess.lengths[i] + share * (*change)[i];
      if (!evaluate(task, next, meeting, there)) continue;
      const double now = there.squared();
      is_nearer = now < squared * (1 - 0.1 * share) || now <= small;
      if (is_nearer) squared = now;
    }
    if (!is_nearer) return std::nullopt;
    guess = next;
    std::swap(here, there);
    // 3. Give up a word that closes no better than by halves, makes a long detour or gets too dear.
    if (step >= usual_steps && squared > before / 2) return std::nullopt;
    for (std::size_t i = 0; i < 4; ++i) {
      if (guess.turns[i] != 0 && std::abs(guess.lengths[i]) > 1.5 * longest_turn)
        return std::nullopt;
    }
    const double most_change = dearest * std::sqrt(squared);
    if (price_of(guess, task.prices) > task.cutoff + most_change) return std::nullopt;
  }
  // 4. Accept only turns within a whole one and prices within the cutoff; drive the word once more.
  for (std::size_t i = 0; i < 4; ++i) {
    if (guess.turns[i] != 0 && std::abs(guess.lengths[i]) > longest_turn) return std::nullopt;
  }
  if (!(price_of(guess, task.prices) <= task.cutoff)) return std::nullopt;
  const auto segments = segments_of(task, guess, meeting);
  if (!segments || !leads(task, segments->view())) return std::nullopt;
  return segments;
}

}  // namespace vandplan::steering
