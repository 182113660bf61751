// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Newton's method for the three lengths of a word.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "steering/continuous/word_solver.h"

namespace vandplan::steering::continuous {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Vector& a, const Vector& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

/// Offset (x, y, heading) from the end of a word to the goal, and derivatives of the end by the
/// three lengths.
struct Residual {
  Vector offset{};
  std::array<Vector, 3> slopes{};

  [[nodiscard]] double largest() const {
    return std::max({std::abs(offset[0]), std::abs(offset[1]), std::abs(offset[2])});
  }
};

/// The turns of a word as they are driven, and the length of its line.
struct DrivenParts {
  const Turned &first, &inner, &next_inner, &last;
  double line;
  const Turned* dip;  ///< turn in place of a line of negative length between turns to the same side
};

/// Place reached while a word is driven; `turned` is the change of heading so far.
struct Reached {
  double x = 0, y = 0, sin, cos, turned = 0;
};

/// End of a step, and the derivative of the end (x, y, heading) by the length of the step.
struct StepEnd {
  double x, y;
  Vector slope;
};

/// Index of the length that a step of a formula has: 0 to 2, or 3 for a quarter turn.
constexpr std::size_t length_index(const Steps& steps, std::size_t i) {
  const std::size_t part = steps.list[i].part;
  const bool has_line = steps.list[1].part == 2 || steps.list[2].part == 2;
  return part == 0 ? 0 : part == 3 ? 2 : part == 1 && has_line ? 3 : 1;
}

inline StepEnd turn(Reached& c, const Turned& t, double gear, double side) {
  const double ahead = gear * t.x, aside = side * t.y;
  c.x += c.cos * ahead - c.sin * aside;
  c.y += c.sin * ahead + c.cos * aside;
  const double sense = gear * side;
  c.turned += sense * t.angle;
  const double slope_ahead = gear * t.slope_x, slope_aside = side * t.slope_y;
  const StepEnd after{c.x,
                      c.y,
                      {c.cos * slope_ahead - c.sin * slope_aside,
                       c.sin * slope_ahead + c.cos * slope_aside, sense * t.angle_slope}};
  const double turn_sin = sense * t.sin;
  const double next = c.cos * t.cos - c.sin * turn_sin;
  c.sin = c.sin * t.cos + c.cos * turn_sin;
  c.cos = next;
  return after;
}

inline StepEnd line(Reached& c, double length, double gear) {
  const double x = gear * c.cos, y = gear * c.sin;
  c.x += length * x;
  c.y += length * y;
  return {c.x, c.y, {x, y, 0}};
}

template <Formula formula, std::size_t i>
inline StepEnd drive(Reached& c, const DrivenParts& d) {
  constexpr const Steps& steps = all_steps[static_cast<std::size_t>(formula)];
  constexpr Step step = steps.list[i];
  if constexpr (step.part == 0) return turn(c, d.first, step.gear, step.turn);
  if constexpr (step.part == 3) return turn(c, d.last, step.gear, step.turn);
  if constexpr (step.part == 2) {
    if (d.dip != nullptr) return turn(c, *d.dip, step.gear, steps.list[i - 1].turn);
    return line(c, d.line, step.gear);
  }
  if constexpr (step.part == 1) {
    return turn(c, i == 1 ? d.inner : d.next_inner, step.gear, step.turn);
  }
}

/// The residual after all steps of a formula, from the first to the second pose of a frame.
template <Formula formula, std::size_t... i>
Residual residual_of_steps(const DrivenParts& d, const WordFrame& frame, double turn,
                           std::index_sequence<i...> /*all*/) {
  constexpr const Steps& steps = all_steps[static_cast<std::size_t>(formula)];
  Reached c{.sin = -frame.s, .cos = frame.c};
  const std::array<StepEnd, sizeof...(i)> all{drive<formula, i>(c, d)...};
  Residual residual{{frame.x - c.x, frame.y - c.y, turn - c.turned}, {}};
  const auto add = [&](const StepEnd& after, std::size_t of) {
    if (of == 3) return;
    const double bend = after.slope[2];  // everything after a turn swings with it
    residual.slopes[of][0] += after.slope[0] - bend * (c.y - after.y);
    residual.slopes[of][1] += after.slope[1] + bend * (c.x - after.x);
    residual.slopes[of][2] += bend;
  };
  (add(all[i], length_index(steps, i)), ...);
  return residual;
}

template <Formula formula>
Residual residual_of(const DrivenParts& d, const WordFrame& frame, double turn) {
  constexpr std::size_t count = all_steps[static_cast<std::size_t>(formula)].count;
  return residual_of_steps<formula>(d, frame, turn, std::make_index_sequence<count>());
}

using ResidualOf = Residual (*)(const DrivenParts&, const WordFrame&, double);

constexpr std::array<ResidualOf, 11> residual_of_formula = {
    residual_of<Formula::lsl>,   residual_of<Formula::lsr>,       residual_of<Formula::l_r_l>,
    residual_of<Formula::r_lr>,  residual_of<Formula::lr_lr>,     residual_of<Formula::r_lr_l>,
    residual_of<Formula::r_lsr>, residual_of<Formula::r_lsl>,     residual_of<Formula::r_lsr_l>,
    residual_of<Formula::lrl>,   residual_of<Formula::r_lr_wide>,
};

/// The equations that the lengths of a word solve.
class Equations {
 public:
  /// `turn`: wanted change of heading, whole turns included [rad].
  Equations(const SharpTurns& turns, const SolvedWord& word, const WordFrame& frame, double turn)
      : turns_(turns),
        shape_(shape_of(word.formula, word.stops)),
        frame_(frame),
        turn_(turn),
        residual_of_(residual_of_formula[static_cast<std::size_t>(word.formula)]) {
    if (shape_.quarters > 0) quarter_ = turns_.turn(word.quarter, shape_.ends[1]);
    if (shape_.quarters > 1) next_quarter_ = turns_.turn(word.quarter, shape_.ends[3]);
  }

  [[nodiscard]] const WordShape& shape() const { return shape_; }

  /// Scale of the task: a residual is small if it is small beside this number.
  [[nodiscard]] double size() const { return 1 + std::abs(frame_.x) + std::abs(frame_.y); }

  [[nodiscard]] Residual residual(const Vector& lengths) const {
    const auto& ends = shape_.ends;
    const std::size_t end = shape_.steps.count - 1;
    const Turned first = turns_.turn(lengths[0], ends[0]);
    const Turned last = turns_.turn(lengths[2], ends[end]);
    if (shape_.has_line) {
      const DrivenParts driven{first, quarter_, next_quarter_, last, lengths[1], nullptr};
      return shape_.may_dip && lengths[1] < 0 ? residual_with_dip(driven)
                                              : residual_of_(driven, frame_, turn_);
    }
    const Turned inner = turns_.turn(lengths[1], ends[1]);
    if (end < 3 || ends[2] == ends[1]) {
      return residual_of_({first, inner, inner, last, 0, nullptr}, frame_, turn_);
    }
    const Turned next_inner = turns_.turn(lengths[1], ends[2]);
    return residual_of_({first, inner, next_inner, last, 0, nullptr}, frame_, turn_);
  }

 private:
  [[nodiscard]] Residual residual_with_dip(DrivenParts driven) const {
    const Turned dip = turns_.turn(driven.line, TurnEnds::rolling);
    driven.dip = &dip;
    return residual_of_(driven, frame_, turn_);
  }

  const SharpTurns& turns_;
  const WordShape& shape_;
  const WordFrame& frame_;
  double turn_;
  ResidualOf residual_of_;
  Turned quarter_, next_quarter_;
};

/// Change of the lengths that removes the linearised residual; nothing if the derivatives are
/// dependent.
std::optional<Vector> newton_step(const Residual& residual) {
  const auto& [a, b, c] = residual.slopes;
  const Vector bc = cross(b, c);
  const double det = dot(a, bc);
  if (det == 0) return std::nullopt;
  const double scale = 1 / det;
  return Vector{dot(residual.offset, bc) * scale, dot(residual.offset, cross(c, a)) * scale,
                dot(residual.offset, cross(a, b)) * scale};
}

/// Largest component of the linearised residual that a change of the lengths leaves. It is
/// rounding, unless the equations are nearly dependent.
double left_by(const Residual& residual, const Vector& change) {
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& [a, b, c] = residual.slopes;
    const double moved = change[0] * a[i] + change[1] * b[i] + change[2] * c[i];
    most = std::max(most, std::abs(residual.offset[i] - moved));
  }
  return most;
}

/// New length of a turn that never reaches full lock, for a Newton step taken in its angle. Beside
/// a line the residual is nearly linear in the angle, which is as the square of the length.
double by_angle(double length, double change) {
  const double square = length * (length + 2 * change);
  if (length < 0) return square > 0 ? -std::sqrt(square) : std::sqrt(-square);
  return square > 0 ? std::sqrt(square) : -std::sqrt(-square);
}

}  // namespace

void WordSolver::drop_vanishing_parts(SolvedWord& word, const WordFrame& frame,
                                      double turn) const noexcept {
  constexpr double vanishing = 1e-6;  // [turning radii]; turns this short hardly change the heading
  for (std::size_t i = 0; i < 3; ++i) {
    if (word.lengths[i] == 0 || std::abs(word.lengths[i]) > vanishing) continue;
    SolvedWord rest = word;
    rest.lengths[i] = 0;
    if (find_root_without(i, rest, frame, turn) && is_drivable(rest)) word = rest;
  }
}

bool WordSolver::find_root_without(std::size_t part, SolvedWord& word, const WordFrame& frame,
                                   double turn) const noexcept {
  constexpr int max_steps = 4;
  constexpr double exact = 1e-12;  // relative residual; a tiny part at small curvature adds no more
  const Equations equations(turns_, word, frame, turn);
  const std::size_t i = (part + 1) % 3;
  const std::size_t j = (part + 2) % 3;
  for (int step = 0; step < max_steps; ++step) {
    const Residual residual = equations.residual(word.lengths);
    if (residual.largest() <= exact * equations.size()) return true;
    // Three equations for two lengths: least squares.
    const Vector& a = residual.slopes[i];
    const Vector& b = residual.slopes[j];
    const Vector normal = cross(a, b);
    const double square = dot(normal, normal);
    word.lengths[i] += dot(cross(residual.offset, b), normal) / square;
    word.lengths[j] += dot(cross(a, residual.offset), normal) / square;
    if (!(std::abs(word.lengths[i]) + std::abs(word.lengths[j]) < 1e100)) return false;
  }
  return false;
}

bool WordSolver::is_hopeless(const SolvedWord& word, const WordShape& shape, double moved,
                             const NewtonLimits& limits) const noexcept {
  // Both numbers are measured: with smaller ones, words are lost.
  constexpr double near = 0.3;  // share of a turn or clothoid; the steps after it are far smaller
  constexpr double steps = 2;   // how far lengths may still move, in steps like the last
  const double ramp = turns_.ramp();
  const double inner = shape.has_line ? 0 : std::abs(word.lengths[1]);
  const double turn = std::max({std::abs(word.lengths[0]), inner, std::abs(word.lengths[2])});
  if (moved > near * std::min(turn, ramp)) return false;
  double length = shape.quarters * word.quarter;
  for (std::size_t i = 0; i < 3; ++i) {
    length += shape.counts[i] * word.lengths[i];
    const double least = shape.min_lengths[i] * ramp - 1e-6;  // vanishing parts are left out later
    if (word.lengths[i] + 2 * steps * moved < least) return true;
  }
  double bonus = 0;
  const double at_most = 2 * steps * moved;
  if (word.lengths[0] + at_most >= limits.first.min_length) bonus += limits.first.longer;
  if (word.lengths[2] + at_most >= limits.last.min_length) bonus += limits.last.longer;
  const bool may_vanish = std::min(word.lengths[0], word.lengths[2]) - at_most < 1e-6;
  if (may_vanish) bonus = std::max(bonus, limits.if_one_vanishes);
  return length - steps * moved > limits.max_length + bonus + 1e-9;
}

double WordSolver::take_step(SolvedWord& word, const WordShape& shape,
                             const std::array<double, 3>& change, double part) const noexcept {
  double moved = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double& length = word.lengths[i];
    const bool is_small = shape.has_line && i != 1 && std::abs(length) < turns_.ramp() / 2 &&
                          std::abs(change[i]) > 0.1 * std::abs(length);
    const double next = is_small ? by_angle(length, part * change[i]) : length + part * change[i];
    moved = std::max(moved, std::abs(next - std::exchange(length, next)));
  }
  return moved;
}

bool WordSolver::find_root(SolvedWord& word, const WordFrame& frame, double turn,
                           const NewtonLimits& limits) const noexcept {
  const Equations equations(turns_, word, frame, turn);
  const WordShape& shape = equations.shape();
  const double rounding = 1e-13 * equations.size();
  const bool gives_up = limits.max_length < std::numeric_limits<double>::infinity();
  double best = std::numeric_limits<double>::infinity();
  Vector best_lengths{};
  for (int step = 0; step < limits.max_steps; ++step) {
    const Residual residual = equations.residual(word.lengths);
    const double error = residual.largest();
    if (!(error < 1e100)) return false;
    if (error < best) {
      best = error;
      best_lengths = word.lengths;
    } else if (best <= rounding) {
      break;
    }
    const auto change = newton_step(residual);
    if (!change) break;
    double largest = 0, part = 1;
    for (std::size_t i = 0; i < 3; ++i) {
      const double size = std::abs((*change)[i]);
      largest = std::max(largest, size);
      if (i == 1 && shape.has_line) continue;
      const double limit = 0.5 * turns_.ramp() + std::abs(word.lengths[i]);
      if (size * part > limit) part = limit / size;
    }
    if (largest <= small_step_) {
      // A tiny step far from the goal: these lengths cannot lead there.
      if (error > 1e-6 * equations.size()) return false;
      if (left_by(residual, *change) <= rounding) {
        for (std::size_t i = 0; i < 3; ++i) word.lengths[i] += (*change)[i];
        return !gives_up || !is_hopeless(word, shape, largest, limits);
      }
    }
    const double moved = take_step(word, shape, *change, part);
    if (gives_up &&
        (part < 1 ? step >= limits.max_limited_steps : is_hopeless(word, shape, moved, limits))) {
      return false;
    }
  }
  word.lengths = best_lengths;
  return best <= rounding;
}

}  // namespace vandplan::steering::continuous
