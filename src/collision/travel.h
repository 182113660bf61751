// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where along a segment does the vehicle travel in a direction?

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "vandplan/path.h"

namespace vandplan::collision {

/// Direction of travel along a segment: `first` + `curvature` s + `rate` s^2 / 2 after s metres
/// [rad].
struct Travel {
  /// `gear`: direction of travel in time, 1 or -1.
  Travel(const Pose& from, const Segment& segment, int gear)
      : first(from.heading + (gear < 0 ? std::numbers::pi : 0.0)),
        curvature(segment.length < 0 ? -segment.curvature : segment.curvature),
        rate(segment.length < 0 ? -segment.curvature_rate : segment.curvature_rate),
        length(std::abs(segment.length)) {}

  [[nodiscard]] double at(double s) const { return first + s * (curvature + rate * s / 2); }

  /// Adds the places where the direction is `angle` but for whole turns [m].
  void add_places(double angle, std::vector<double>& places) const {
    constexpr double full_turn = 2 * std::numbers::pi;
    double least = std::min(first, at(length)), most = std::max(first, at(length));
    const double vertex = rate != 0.0 ? -curvature / rate : -1.0;
    if (vertex > 0 && vertex < length) {
      least = std::min(least, at(vertex));
      most = std::max(most, at(vertex));
    }
    double wanted = angle + full_turn * std::ceil((least - angle) / full_turn);
    for (; wanted <= most; wanted += full_turn) add_roots(wanted - first, places);
  }

  /// Begin, end, and the places between them where the vehicle travels along a line of a direction,
  /// either way. Between two of them the axle moves to one side of such lines only.
  [[nodiscard]] std::vector<double> places_along(double direction) const {
    std::vector<double> places{0.0, length};
    add_places(direction, places);
    add_places(direction + std::numbers::pi, places);
    std::sort(places.begin(), places.end());
    return places;
  }

  double first, curvature, rate, length;

 private:
  /// Adds the places where the vehicle has turned by `turn`.
  void add_roots(double turn, std::vector<double>& places) const {
    const double square = std::max(0.0, curvature * curvature + 2 * rate * turn);
    const double sum = curvature + std::copysign(std::sqrt(square), curvature);
    for (const double s : {sum != 0.0 ? 2 * turn / sum : -1.0, rate != 0.0 ? -sum / rate : -1.0}) {
      if (s > 0 && s < length) places.push_back(s);
    }
  }
};

/// Place between `begin` and `end` where a monotonic function changes its sign. It has the values
/// `first` and `last` there, of different signs. Regula falsi after Dowell and Jarratt 1971, with
/// halvings that make the interval short from both sides.
template <typename Height>
double crossing(double begin, double end, double first, double last, const Height& height) {
  constexpr int most_steps = 120;
  constexpr double close_enough = 1e-7;  // a straight line between the ends is exact then [m]
  double weight_of_first = 1.0, weight_of_last = 1.0;
  int replaced_last = 0;  // end that the last step moved: -1 begin, 1 end
  for (int i = 0; i < most_steps && end - begin > close_enough; ++i) {
    const double a = weight_of_first * first, b = weight_of_last * last;
    const double share = i % 4 == 3 ? 0.5 : a / (a - b);
    const double middle = begin + (end - begin) * share;
    const double there = height(middle);
    if (there == 0.0) return middle;
    if ((there < 0) == (first < 0)) {
      begin = middle;
      first = there;
      weight_of_last = replaced_last == -1 ? weight_of_last / 2 : 1.0;
      weight_of_first = 1.0;
      replaced_last = -1;
    } else {
      end = middle;
      last = there;
      weight_of_first = replaced_last == 1 ? weight_of_first / 2 : 1.0;
      weight_of_last = 1.0;
      replaced_last = 1;
    }
  }
  return begin + (end - begin) * (first == last ? 0.5 : first / (first - last));
}

}  // namespace vandplan::collision
