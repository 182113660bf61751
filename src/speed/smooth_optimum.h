// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which speeds at places along a stretch take the least time when the acceleration may not jump?

#include <array>
#include <cstddef>
#include <vector>

#include "vandplan/driving_limits.h"

namespace vandplan::speed {

/// The least time from stop to stop over the squared speeds u at places of a stretch.
///
/// The acceleration between two places is half the slope of u; from one way to the next it changes
/// by no more than the jerk times the time between their middles. An interior-point method:
/// Newton's method on the duration less mu times the logarithms of what is left to each limit,
/// while mu falls.
class SmoothOptimum {
 public:
  /// `s` increases, `most` is the largest u at these places; the first and the last are the stops.
  SmoothOptimum(std::vector<double> s, std::vector<double> most, const DrivingLimits& limits);

  /// Goes on from `u`, which is made slower until it is within the limits. False if it never is.
  [[nodiscard]] bool improve(std::vector<double>& u);

  /// Divides the largest u at a place.
  void lower(std::size_t i, double divisor) { places_[i].most /= divisor; }

  /// How long the way from place i to the next takes [s].
  [[nodiscard]] double time(std::size_t i) const { return ways_[i].t; }
  /// How long from the moment on it that has its mean acceleration to that of the next way [s].
  [[nodiscard]] double time_between(std::size_t i) const {
    return share_after(i) * ways_[i].t + share_before(i + 1) * ways_[i + 1].t;
  }
  /// The share of the way's time before that moment: a half, but from standing three quarters.
  [[nodiscard]] double share_before(std::size_t i) const {
    return i == 0 ? 0.75 : i + 1 == last() ? 0.25 : 0.5;
  }
  [[nodiscard]] double share_after(std::size_t i) const { return 1 - share_before(i); }
  /// The mean acceleration on it [m/s^2].
  [[nodiscard]] double acceleration(std::size_t i) const { return ways_[i].a; }

 private:
  struct Place {
    double s;
    double most;
  };
  /// From a place to the next one.
  struct Way {
    double t, a;         // how long, and the acceleration
    double first, last;  // slopes of t by u at its ends
  };
  /// Gradient and the three upper diagonals of the second derivatives, then of their factors.
  struct Row {
    double gradient = 0.0;
    std::array<double, 3> diagonals{};
  };

  [[nodiscard]] std::size_t last() const { return places_.size() - 1; }
  [[nodiscard]] double width(std::size_t i) const { return places_[i + 1].s - places_[i].s; }

  void set(const std::vector<double>& u);
  [[nodiscard]] double value(double mu) const;
  [[nodiscard]] double share_of_jerk(std::size_t i) const;
  void add_barriers(double mu);
  void add_duration();
  void add(double weight, double left, std::size_t at, const std::array<double, 3>& slope);
  [[nodiscard]] double find_step();
  [[nodiscard]] bool newton(double mu, std::vector<double>& u);

  std::vector<Place> places_;
  double gain_, loss_, jerk_;
  std::vector<double> u_;  // where `ways_` are known
  std::vector<Way> ways_;
  std::vector<Row> rows_;
  std::vector<double> step_;
};

}  // namespace vandplan::speed
