// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/towing.h"

#include <algorithm>
#include <cmath>

#include "base/trigonometry.h"
#include "drive/controllers.h"
#include "drive/linear_quadratic.h"
#include "vandplan/vehicle.h"

namespace vandplan::driving {
namespace {

constexpr double longest_step = 0.1;  // largest length of a step [m]
constexpr int steps_to_settle = 400;  // iterations of Riccati's equation beyond the end of a stroke

// Cost of a metre with errors, in units of the fading distance. It sums the squared lateral errors
// of both rear axles, the squared heading errors of both bodies, and `towing_effort` times the
// squared change of curvature.
constexpr double towing_effort = 2e-3;
// Factor of the tractor's heading error in reverse. There the tractor swings its front to steer the
// trailer, and the front touches obstacles first.
constexpr double swing = 8.0;

/// Linear dynamics of the errors in a step around a planned state, and their cost.
LinearStep<4> step_around(const Vehicle& vehicle, double hitch_angle, double curvature,
                          int direction, double length) {
  const double hitch = vehicle.hitch;
  const double wheelbase = vehicle.trailer->wheelbase;
  const auto [sin, cos] = base::sin_cos(hitch_angle);
  LinearStep<4> step;
  // 1. Derivatives per driven metre in gear g: e' = g h, h' = g k. The derivative of the hitch
  // angle, a' = g (k - (sin a + c k cos a) / l), is linearized.
  const double g = direction;
  Matrix<4> rate{};
  rate[0][1] = g;
  rate[1][3] = g;
  rate[2][2] = -g * (cos - hitch * curvature * sin) / wheelbase;
  rate[2][3] = g * (1 - hitch * cos / wheelbase);
  // 2. Motion over the step: the first terms of the matrix exponential.
  Matrix<4> power = {{{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}};
  double factor = 1.0;
  for (int n = 1; n <= 4; ++n) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) step.motion[i][j] += factor * power[i][j];
      step.input[i] += factor * length / n * power[i][3];
    }
    power = product(rate, power);
    factor *= length / n;
  }
  // 3. Cost of the step.
  const double a = fading_distance(vehicle);
  const RigError rows[] = {{1 / a, 0, 0, 0},
                           {0, direction < 0 ? swing : 1, 0, 0},
                           {cos / a, (hitch * cos - wheelbase) / a, wheelbase / a, 0},
                           {0, 1, -1, 0}};
  for (const RigError& row : rows) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4; ++j) step.price[i][j] += length * row[i] * row[j];
    }
  }
  step.effort = length * towing_effort * a * a * a * a;
  return step;
}

}  // namespace

Towing::Towing(const Stroke& stroke, const Vehicle& vehicle, double hitch_angle)
    : vehicle_(vehicle), direction_(stroke.direction()) {
  const double count = std::max(std::ceil(stroke.length() / longest_step), 1.0);
  size_ = std::max(stroke.length() / count, 1e-9);
  State state{stroke.at(0).pose, hitch_angle};
  for (double i = 0; i < count; ++i) {
    const double middle = stroke.curvature_at((i + 0.5) * size_);
    steps_.push_back({{middle, direction_ * size_}, state.hitch_angle, {}});
    state = advance(vehicle, state, steps_.back().arc);
  }
  steps_.push_back({{}, state.hitch_angle, {}});
  Matrix<4> cost{};
  for (std::size_t i = steps_.size(); i-- > 0;) {
    const double curvature = stroke.curvature_at(static_cast<double>(i) * size_);
    const bool is_last = i + 1 == steps_.size();
    const LinearStep<4> step = step_around(vehicle, steps_[i].hitch_angle, curvature, direction_,
                                           is_last ? longest_step : size_);
    for (int n = is_last ? steps_to_settle : 0; n > 0; --n) cost = cost_before(step, cost);
    steps_[i].gains = feedback(step, cost).gains;
    cost = cost_before(step, cost);
  }
}

const Towing::Step& Towing::before(double s) const noexcept {
  const double i = std::clamp(s / size_, 0.0, static_cast<double>(steps_.size() - 1));
  return steps_[static_cast<std::size_t>(i)];
}

double Towing::hitch_angle_at(double s) const noexcept {
  const Step& step = before(s);
  if (step.arc.length == 0.0 || s <= 0.0) return step.hitch_angle;
  const double driven = s - size_ * static_cast<double>(&step - steps_.data());
  return hitch_angle_after(vehicle_, step.hitch_angle, {step.arc.curvature, direction_ * driven});
}

double Towing::correction(double s, const RigError& error) const noexcept {
  return -dot(before(s).gains, error);
}

}  // namespace vandplan::driving
