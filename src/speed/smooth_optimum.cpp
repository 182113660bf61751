// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "speed/smooth_optimum.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace vandplan::speed {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

}  // namespace

SmoothOptimum::SmoothOptimum(std::vector<double> s, std::vector<double> most,
                             const DrivingLimits& limits)
    : gain_(limits.max_acceleration),
      loss_(limits.max_braking.value_or(limits.max_acceleration)),
      jerk_(*limits.max_jerk) {
  for (std::size_t i = 0; i < s.size(); ++i) places_.push_back({s[i], most[i]});
  // From standstill with full jerk: s = j t^3 / 6 and v = j t^2 / 2.
  const auto from_rest = [&](double way) {
    const double t = std::cbrt(6 * way / jerk_);
    return jerk_ * t * t / 2 * (jerk_ * t * t / 2);
  };
  places_[1].most = std::min(places_[1].most, from_rest(width(0)));
  places_[last() - 1].most = std::min(places_[last() - 1].most, from_rest(width(last() - 1)));
  ways_.resize(last());
  rows_.resize(places_.size());
  step_.resize(places_.size());
}

void SmoothOptimum::set(const std::vector<double>& u) {
  u_ = u;
  double v = 0.0;
  for (std::size_t i = 0; i < last(); ++i) {
    const double next = i + 1 < last() ? std::sqrt(u[i + 1]) : 0.0;
    const double h = width(i);
    Way& way = ways_[i];
    way.a = (u[i + 1] - u[i]) / (2 * h);
    const double both = v + next;
    if (i == 0) {
      way = {3 * h / next, way.a, 0.0, -1.5 * h / (next * next * next)};
    } else if (i + 1 == last()) {
      way = {3 * h / v, way.a, -1.5 * h / (v * v * v), 0.0};
    } else {
      way = {2 * h / both, way.a, -h / (both * both * v), -h / (both * both * next)};
    }
    v = next;
  }
}

double SmoothOptimum::share_of_jerk(std::size_t i) const {
  return (ways_[i].a - ways_[i - 1].a) / (jerk_ * time_between(i - 1));
}

/// Objective: duration plus barriers [s]; infinite outside the limits.
double SmoothOptimum::value(double mu) const {
  double t = ways_[0].t;
  double product = 1.0;
  double logarithms = 0.0;
  for (std::size_t i = 1; i < last(); ++i) {
    const double share = share_of_jerk(i);
    const double left[] = {1 - u_[i] / places_[i].most, 1 - share, 1 + share,
                           1 - ways_[i].a / gain_, 1 + ways_[i].a / loss_};
    t += ways_[i].t;
    for (const double one : left) {
      if (!(one > 0.0)) return infinite;
      product *= one;
    }
    if (product < 1e-200) {
      logarithms += std::log(product);
      product = 1.0;
    }
  }
  return t - mu * (logarithms + std::log(product));
}

void SmoothOptimum::add(double weight, double left, std::size_t at,
                        const std::array<double, 3>& slope) {
  const double pull = weight / left;
  const double bend = pull / left;
  for (std::size_t i = 0; i < 3; ++i) {
    Row& row = rows_[at + i];
    row.gradient -= pull * slope[i];
    for (std::size_t j = i; j < 3; ++j) row.diagonals[j - i] += bend * slope[i] * slope[j];
  }
}

void SmoothOptimum::add_barriers(double mu) {
  for (std::size_t i = 1; i < last(); ++i) {
    const double most = places_[i].most;
    const double left = most - u_[i];
    rows_[i].gradient += mu / left;
    rows_[i].diagonals[0] += mu / (left * left);
    const Way& before = ways_[i - 1];
    const Way& after = ways_[i];
    const double slope = 1 / (2 * width(i));
    const double up = mu / (gain_ - after.a);
    const double down = mu / (loss_ + after.a);
    const double pull = (up - down) * slope;
    const double bend = (up * up + down * down) / mu * slope * slope;
    rows_[i].gradient -= pull;
    rows_[i + 1].gradient += pull;
    rows_[i].diagonals[0] += bend;
    rows_[i + 1].diagonals[0] += bend;
    rows_[i].diagonals[1] -= bend;
    // The second derivatives of the jerk are left out, so that the model stays convex.
    const double change = jerk_ * time_between(i - 1);
    const double share = (after.a - before.a) / change;
    const double by_before = share * jerk_ * share_after(i - 1) / change;
    const double by_after = share * jerk_ * share_before(i) / change;
    const double first = 1 / (2 * width(i - 1) * change);
    const double second = slope / change;
    const std::array<double, 3> by = {
        first - by_before * before.first,
        -first - second - by_before * before.last - by_after * after.first,
        second - by_after * after.last};
    add(mu, 1 - share, i - 1, {-by[0], -by[1], -by[2]});
    add(mu, 1 + share, i - 1, by);
  }
}

void SmoothOptimum::add_duration() {
  for (std::size_t i = 0; i < last(); ++i) {
    const Way& way = ways_[i];
    Row& row = rows_[i];
    Row& next = rows_[i + 1];
    row.gradient += way.first;
    next.gradient += way.last;
    if (i == 0) {
      next.diagonals[0] -= 1.5 * way.last / u_[i + 1];
    } else if (i + 1 == last()) {
      row.diagonals[0] -= 1.5 * way.first / u_[i];
    } else {
      const double a = std::sqrt(u_[i]);
      const double b = std::sqrt(u_[i + 1]);
      row.diagonals[0] -= way.first * (1 / ((a + b) * a) + 1 / (2 * u_[i]));
      next.diagonals[0] -= way.last * (1 / ((a + b) * b) + 1 / (2 * u_[i + 1]));
      row.diagonals[1] -= way.first / ((a + b) * b);
    }
  }
}

/// Computes the step to the minimum of the model, by Cholesky's method for five diagonals. Returns
/// the derivative of the objective along the step.
double SmoothOptimum::find_step() {
  for (std::size_t i = 1; i < last(); ++i) {
    Row& row = rows_[i];
    step_[i] = -row.gradient;
    // Eliminates the two rows above.
    for (std::size_t k = 1; k <= 2 && k < i; ++k) {
      const Row& above = rows_[i - k];
      const double share = above.diagonals[k] / above.diagonals[0];
      row.diagonals[0] -= share * above.diagonals[k];
      if (k == 1) row.diagonals[1] -= share * above.diagonals[2];
      step_[i] -= share * step_[i - k];
    }
  }
  double slope = 0.0;
  for (std::size_t i = last() - 1; i >= 1; --i) {
    const Row& row = rows_[i];
    if (i + 1 < last()) step_[i] -= row.diagonals[1] * step_[i + 1];
    if (i + 2 < last()) step_[i] -= row.diagonals[2] * step_[i + 2];
    step_[i] /= row.diagonals[0];
    slope += step_[i] * row.gradient;
  }
  return slope;
}

/// Makes one step of Newton's method. False if there is little left to gain.
bool SmoothOptimum::newton(double mu, std::vector<double>& u) {
  const double before = value(mu);
  std::fill(rows_.begin(), rows_.end(), Row{});
  add_barriers(mu);
  add_duration();
  const double slope = find_step();
  if (!(slope < -mu)) return false;
  std::vector<double> next = u;
  for (double part = 1.0; part > 1e-4; part /= 2) {
    bool is_positive = true;
    for (std::size_t i = 1; i < last(); ++i) {
      next[i] = u[i] + part * step_[i];
      is_positive = is_positive && next[i] > 0.0;
    }
    if (!is_positive) continue;
    set(next);
    if (value(mu) <= before + 0.1 * part * slope) {
      u.swap(next);
      return true;
    }
  }
  set(u);
  return false;
}

bool SmoothOptimum::improve(std::vector<double>& u) {
  constexpr int most_steps = 100;
  constexpr int most_tries = 50;
  int tries = 0;
  for (set(u); !(value(0.0) < infinite); set(u)) {
    if (++tries > most_tries) return false;
    for (double& square : u) square *= 0.9;
  }
  for (double& square : u) square *= 0.98;
  set(u);
  double duration = 0.0;
  for (const Way& way : ways_) duration += way.t;
  // The duration exceeds the optimum by about mu times the number of limits.
  const double limits = 5 * static_cast<double>(last());
  int steps = 0;
  for (double mu = 0.02 * duration / limits; mu > 1e-4 * duration / limits; mu *= 0.05) {
    while (steps < most_steps && newton(mu, u)) ++steps;
  }
  set(u);
  return true;
}

}  // namespace vandplan::speed
