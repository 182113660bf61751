// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "drive/controllers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "base/nearest_word.h"
#include "base/trigonometry.h"
#include "drive/preview.h"
#include "vandplan/input_error.h"

namespace vandplan::driving {
namespace {

/// Distance that the vehicle drives until the end of the control period [m].
double way_ahead(const Sight& sight) { return sight.state.v * control_period; }

/// Error of the direction of motion [rad]: the lateral error grows by its sine per driven metre, in
/// either gear.
double slant(const Sight& sight) { return sight.stroke.direction() * sight.offset.heading; }

/// Rear-axle feedback of Paden et al. 2016, section V-A: the yaw rate divided by the speed.
double rear_axle_feedback(const Sight& sight) noexcept {
  const double a = fading_distance(sight.vehicle);
  const double e = sight.offset.lateral;
  const double h = slant(sight);
  const auto [sin, cos] = base::sin_cos(h);
  const double curvature = sight.stroke.curvature_at(sight.offset.place.s + way_ahead(sight));
  const double sin_ratio = std::abs(h) < 1e-6 ? 1.0 : sin / h;
  // Inside of a turn the parallel curve is tighter.
  const double along = curvature * cos / std::max(1 - curvature * e, 0.2);
  const double wanted = along - 2 / a * h - 1 / (a * a) * e * sin_ratio;
  return steering_angle(sight.vehicle, wanted);
}

/// Linear-quadratic feedback for a rig: the hitch angle is another error (`Towing`).
double tow(const Sight& sight) noexcept {
  const Towing& towing = *sight.towing;
  const double s = sight.offset.place.s;
  const auto [sin, cos] = base::sin_cos(sight.state.steering_angle);
  const double bent = sin / cos / sight.vehicle.wheelbase - sight.stroke.curvature_at(s);
  const double folded = wrap_angle(sight.state.hitch_angle - towing.hitch_angle_at(s));
  const double change =
      towing.correction(s, {sight.offset.lateral, sight.offset.heading, folded, bent});
  const double way = way_ahead(sight);
  return steering_angle(sight.vehicle, sight.stroke.curvature_at(s + way) + bent + change * way);
}

double lqr(const Sight& sight) noexcept {
  if (sight.towing != nullptr) return tow(sight);
  const PreviewGains& gains = preview_gains();
  const double a = fading_distance(sight.vehicle);
  const auto [sin, cos] = base::sin_cos(sight.state.steering_angle);
  const double curvature = sin / cos / sight.vehicle.wheelbase;
  // All quantities are in units of the fading distance.
  double change = -(gains.lateral * sight.offset.lateral / a + gains.heading * slant(sight) +
                    gains.curvature * curvature * a);
  double s = sight.offset.place.s + preview_step * a / 2;
  for (const double gain : gains.ahead) {
    change += gain * a * sight.stroke.curvature_at(s);
    s += preview_step * a;
  }
  return steering_angle(sight.vehicle, curvature + change / (a * a) * way_ahead(sight));
}

/// Pure pursuit of Coulter 1992: the circle through the rear axle, tangent to the vehicle, to a
/// place ahead on the path.
double pure_pursuit(const Sight& sight) noexcept {
  const double ahead = sight.vehicle.wheelbase / 2 + 0.5 * sight.state.v;
  const StrokePlace target = sight.stroke.at(sight.offset.place.s + ahead);
  const Pose seen = relative(sight.state.pose, target.pose);
  const double square = seen.x * seen.x + seen.y * seen.y;
  return steering_angle(sight.vehicle, square > 0.0 ? 2 * seen.y / square : 0.0);
}

/// Controller of Hoffmann et al. 2007 (Stanley). It follows the planned path of the front axle.
double stanley(const Sight& sight) noexcept {
  constexpr double gain = 1.0;     // gain from the lateral error to the speed across the path [1/s]
  constexpr double slowest = 0.5;  // keeps the gain finite at low speeds [m/s]
  const double wheelbase = sight.vehicle.wheelbase;
  const StrokePlace& rear = sight.offset.place;
  const double planned = steering_angle(sight.vehicle, rear.curvature);
  const auto front_of = [&](const Pose& pose) {
    const auto [sin, cos] = base::sin_cos(pose.heading);
    return Point{pose.x + wheelbase * cos, pose.y + wheelbase * sin};
  };
  const Point front = front_of(rear.pose);
  const Point real = front_of(sight.state.pose);
  const auto [sin, cos] = base::sin_cos(rear.pose.heading + planned);
  const double left = (real.y - front.y) * cos - (real.x - front.x) * sin;
  const double ahead =
      steering_angle(sight.vehicle, sight.stroke.curvature_at(rear.s + way_ahead(sight)));
  return ahead - sight.offset.heading - base::atan_2(gain * left, slowest + sight.state.v);
}

/// Planned speed at `s` metres [m/s]. A vehicle that began before the stroke gets half of the
/// planned acceleration over twice the distance.
double planned_speed(const Sight& sight, double s) {
  return sight.stroke.speed_at(s < sight.behind ? (s + sight.behind) / 2 : s);
}

/// Largest speed with which the wheels reach the wanted angle within half a metre [m/s]. At full
/// speed with wrong wheels, the vehicle soon is too far from the path for any controller.
double speed_for_wheels(const Sight& sight, double wanted_steering) {
  constexpr double usual = 0.4;    // usual time of a correction, which does not limit the speed [s]
  constexpr double way = 0.5;      // distance within which the wheels reach the wanted angle [m]
  constexpr double slowest = 0.2;  // least speed limit [m/s]
  const double largest = largest_steering_angle(sight.vehicle);
  const double turn =
      std::abs(std::clamp(wanted_steering, -largest, largest) - sight.state.steering_angle);
  const double time = turn / sight.vehicle.limits.max_steering_rate;
  return time <= usual ? std::numeric_limits<double>::infinity() : std::max(way / time, slowest);
}

constexpr std::array all = {
    Controller{{"rear-axle-feedback", "feedback on the rear axle, both gears", true, false},
               rear_axle_feedback},
    Controller{{"lqr", "linear-quadratic with preview, both gears", true, true}, lqr},
    Controller{{"pure-pursuit", "arc to a point ahead on the path, both gears", true, false},
               pure_pursuit},
    Controller{{"stanley", "feedback on the front axle, forward only", false, false}, stanley},
};

constexpr auto infos = [] {
  std::array<ControllerInfo, all.size()> result{};
  for (std::size_t i = 0; i < all.size(); ++i) result[i] = all[i].info;
  return result;
}();

}  // namespace

const Controller& controller_named(std::string_view name) {
  const auto found =
      std::ranges::find_if(all, [&](const Controller& each) { return each.info.name == name; });
  if (found != all.end()) return *found;
  throw InputError("controller",
                   "\"" + std::string(name) + "\" is unknown, " +
                       base::expected_one_of(name, controllers(), &ControllerInfo::name));
}

double acceleration(const Sight& sight, double wanted_steering) noexcept {
  const DrivingLimits& limits = sight.vehicle.limits;
  const double braking = limits.max_braking.value_or(limits.max_acceleration);
  const double v = sight.state.v;
  const double s = sight.offset.place.s;
  const double left = sight.stroke.length() - s;
  if (left <= 0.0) return -braking;
  // 1. Does the vehicle come to stand within the period?
  if (2 * left <= v * control_period) return std::max(-v * v / (2 * left), -braking);
  // 2. The highest speed at the end of the period that the plan and the wheels allow there.
  const double most = speed_for_wheels(sight, wanted_steering);
  double low = std::max(v - braking * control_period, 0.0);
  double high = v + limits.max_acceleration * control_period;
  const auto is_allowed = [&](double next) {
    return next <= std::min(most, planned_speed(sight, s + (v + next) / 2 * control_period));
  };
  if (is_allowed(high)) return limits.max_acceleration;
  constexpr int halvings = 40;
  for (int i = 0; i < halvings; ++i) {
    const double next = (low + high) / 2;
    (is_allowed(next) ? low : high) = next;
  }
  return (low - v) / control_period;
}

}  // namespace vandplan::driving

namespace vandplan {

std::span<const ControllerInfo> controllers() noexcept { return driving::infos; }

std::string_view usual_controller(const Vehicle& vehicle) noexcept {
  return vehicle.trailer ? "lqr" : "rear-axle-feedback";
}

}  // namespace vandplan
