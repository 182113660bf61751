// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which speeds along a stretch take the least time when the jerk is limited?

#include <array>
#include <cstddef>
#include <vector>

#include "vandplan/vehicle.h"

namespace vandplan::speed {

/// Minimizes the duration from stop to stop over the squared speeds u at places of a stretch.
///
/// A way leads from one place to the next. Its acceleration is half the slope of u. From one way to
/// the next it changes by at most the jerk limit times the time between their middles. The method
/// is an interior-point method. Newton's method minimizes the duration less mu times the logarithms
/// of the distances to each limit, while mu falls.
class SmoothOptimum {
 public:
  /// `s` increases [m]; `most` has the largest u at these places [m^2/s^2]. The first and the last
  /// place are the stops.
  SmoothOptimum(std::vector<double> s, std::vector<double> most, const DrivingLimits& limits);

  /// Improves `u` [m^2/s^2], after slowing it down until it is within the limits. False if it never
  /// is.
  [[nodiscard]] bool improve(std::vector<double>& u);

  /// Divides the largest u at place i by `divisor`.
  void lower(std::size_t i, double divisor) { places_[i].most /= divisor; }

  /// Duration of the way from place i to place i + 1 [s].
  [[nodiscard]] double time(std::size_t i) const { return ways_[i].t; }
  /// Time from the moment of mean acceleration on way i to that on way i + 1 [s].
  [[nodiscard]] double time_between(std::size_t i) const {
    return share_after(i) * ways_[i].t + share_before(i + 1) * ways_[i + 1].t;
  }
  /// Share of the duration of way i before its moment of mean acceleration: a half. From standstill
  /// it is three quarters, to standstill one quarter.
  [[nodiscard]] double share_before(std::size_t i) const {
    return i == 0 ? 0.75 : i + 1 == last() ? 0.25 : 0.5;
  }
  [[nodiscard]] double share_after(std::size_t i) const { return 1 - share_before(i); }
  /// Mean acceleration on way i [m/s^2].
  [[nodiscard]] double acceleration(std::size_t i) const { return ways_[i].a; }

 private:
  struct Place {
    double s;
    double most;
  };
  /// Drive from a place to the next one.
  struct Way {
    double t, a;         // duration [s] and mean acceleration [m/s^2]
    double first, last;  // derivatives of t by u at the begin and the end of the way
  };
  /// Row of Newton's equations: gradient, and three upper diagonals of the second derivatives.
  /// Factorization overwrites the diagonals.
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
  std::vector<double> u_;  // squared speeds for which `ways_` are computed [m^2/s^2]
  std::vector<Way> ways_;
  std::vector<Row> rows_;
  std::vector<double> step_;
};

}  // namespace vandplan::speed
