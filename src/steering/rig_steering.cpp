// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/steering.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/trigonometry.h"
#include "steering/rig_search.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace steering;

constexpr double least_limit = 0.05, most_limit = 3.0;  // range of `max_hitch_angle` [rad]

double half_tangent(double angle) noexcept {
  const auto [sin, cos] = base::sin_cos(angle);
  return sin / (1 + cos);
}

double checked_length(const char* where, double value) {
  if (value > 0 && std::isfinite(value)) return value;
  throw InputError(where, "must be finite and more than 0");
}

std::array<double, 3> shape_of(const Vehicle& vehicle) {
  if (!vehicle.trailer) throw InputError("trailers", "there must be one");
  const double radius = checked_length("min_turning_radius", vehicle.min_turning_radius);
  const double wheelbase = checked_length("trailers wheelbase", vehicle.trailer->wheelbase);
  if (!(std::abs(vehicle.hitch) < wheelbase)) {
    throw InputError("hitch", "must be nearer to the rear axle than the trailer's axle to it");
  }
  const double most = vehicle.max_hitch_angle;
  if (!(most >= least_limit && most <= most_limit)) {
    throw InputError("max_hitch_angle", "must be from 0.05 to 3 to steer");
  }
  return {wheelbase / radius, vehicle.hitch / radius, half_tangent(most)};
}

void check_state(const char* where, const State& state, double most) {
  const Pose& pose = state.pose;
  if (!std::isfinite(pose.x) || !std::isfinite(pose.y) || !std::isfinite(pose.heading)) {
    throw InputError(where, "must be finite");
  }
  constexpr double rounding = 1e-9;
  if (std::abs(state.hitch_angle) <= most + rounding) return;
  throw InputError(where, "its hitch angle " + std::to_string(state.hitch_angle) +
                              " must be at most " + std::to_string(most));
}

void check_prices(const RigPrices& prices) {
  checked_length("reverse_weight", prices.reverse_weight);
  if (!(prices.gear_change_cost >= 0) || !std::isfinite(prices.gear_change_cost)) {
    throw InputError("gear_change_cost", "must be finite and at least 0");
  }
  if (std::isnan(prices.cutoff)) throw InputError("cutoff", "must be a number");
}

/// Two states in their mean frame, at unit radius.
RigEnds ends_of(const State& from, const State& to, double radius, double most) {
  const auto u = [&](const State& state) {
    return std::clamp(half_tangent(state.hitch_angle), -most, most);
  };
  return {mean_frame(from.pose, to.pose, radius), u(from), u(to)};
}

Piece scaled(Piece piece, double radius) noexcept {
  for (std::size_t i = 0; i < piece.count; ++i) {
    Segment& s = piece.segments[i];
    s.curvature =
        std::abs(s.curvature) == 1 ? std::copysign(1 / radius, s.curvature) : s.curvature / radius;
    s.length *= radius;
  }
  piece.length = length(piece.view());
  return piece;
}

RigPrices at_unit_radius(const RigPrices& prices, double radius) noexcept {
  return {prices.reverse_weight, prices.gear_change_cost / radius, prices.cutoff / radius};
}

}  // namespace

double price_of(const RigPrices& prices, std::span<const Segment> segments) noexcept {
  double sum = prices.gear_change_cost * gear_changes(segments);
  for (const Segment& s : segments) {
    sum += s.length < 0 ? -s.length * prices.reverse_weight : s.length;
  }
  return sum;
}

RigSteering::RigSteering(const Vehicle& vehicle)
    : radius_(vehicle.min_turning_radius),
      max_hitch_angle_(vehicle.max_hitch_angle),
      shape_(shape_of(vehicle)) {}

std::optional<Piece> RigSteering::steer(const State& from, const State& to) const {
  return steer(from, to, {});
}

std::optional<Piece> RigSteering::steer(const State& from, const State& to,
                                        const RigPrices& prices) const {
  check_state("from", from, max_hitch_angle_);
  check_state("to", to, max_hitch_angle_);
  check_prices(prices);
  const RigWordSolver solver(HitchTurn(shape_[0], shape_[1], shape_[2]));
  const auto piece = least_rig_path(solver, ends_of(from, to, radius_, shape_[2]),
                                    at_unit_radius(prices, radius_));
  if (!piece) return std::nullopt;
  return scaled(*piece, radius_);
}

std::optional<Piece> RigSteering::steer_quickly(const State& from, const State& to) const {
  check_state("from", from, max_hitch_angle_);
  check_state("to", to, max_hitch_angle_);
  const RigWordSolver solver(HitchTurn(shape_[0], shape_[1], shape_[2]));
  const auto piece = likely_rig_path(solver, ends_of(from, to, radius_, shape_[2]));
  if (!piece) return std::nullopt;
  return scaled(*piece, radius_);
}

std::vector<Piece> RigSteering::candidates(const State& from, const State& to,
                                           const RigPrices& prices) const {
  check_state("from", from, max_hitch_angle_);
  check_state("to", to, max_hitch_angle_);
  check_prices(prices);
  const RigWordSolver solver(HitchTurn(shape_[0], shape_[1], shape_[2]));
  std::vector<Piece> pieces;
  for (const Piece& piece : all_rig_paths(solver, ends_of(from, to, radius_, shape_[2]),
                                          at_unit_radius(prices, radius_))) {
    pieces.push_back(scaled(piece, radius_));
  }
  return pieces;
}

}  // namespace vandplan
