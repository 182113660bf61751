// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/steering.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "steering/continuous/paths.h"
#include "steering/continuous/query_tasks.h"
#include "steering/continuous/word_solver.h"
#include "vandplan/input_error.h"

namespace vandplan {
namespace {

using namespace steering::continuous;

double checked(const char* where, double value) {
  if (!(value > 0) || !std::isfinite(value)) {
    throw InputError(where, "must be finite and more than 0");
  }
  return value;
}

void check(const char* where, const Pose& pose) {
  if (std::isfinite(pose.x) && std::isfinite(pose.y) && std::isfinite(pose.heading)) return;
  throw InputError(where, "must be finite");
}

void check_curvature(const char* where, double curvature, double radius) {
  if (std::abs(curvature) * radius <= 1 + 1e-12) return;
  throw InputError(where, std::to_string(curvature) + " must be at most 1/radius, " +
                              std::to_string(1 / radius));
}

}  // namespace

ContinuousSteering::ContinuousSteering(double radius, double curvature_rate, Continuity continuity)
    : radius_(checked("radius", radius)),
      curvature_rate_(checked("curvature_rate", curvature_rate)),
      continuity_(continuity) {
  const double sharpness = curvature_rate * radius * radius;
  const auto& [least, most] = supported_sharpness;
  if (!(sharpness >= least && sharpness <= most)) {
    throw InputError("curvature_rate", "times radius^2 is " + std::to_string(sharpness) +
                                           ", must be from 0.0001 to 1e9");
  }
  turns_ = SharpTurns(sharpness).constants();
}

Piece ContinuousSteering::steer(const Pose& from, const Pose& to) const {
  return *steer(from, to, {});
}

double ContinuousSteering::length(const Pose& from, const Pose& to) const {
  return length(from, to, {});
}

namespace {

/// The query at unit radius, in a frame with the first pose at the origin. Throws InputError.
UnitQuery checked_query(const ContinuousSteering& steering, const Pose& from, const Pose& to,
                        const ContinuousQuery& query) {
  const double radius = steering.radius();
  check("from", from);
  check("to", to);
  check_curvature("start_curvature", query.start_curvature, radius);
  check_curvature("goal_curvature", query.goal_curvature, radius);
  if (std::isnan(query.cutoff)) throw InputError("cutoff", "must be a number");
  return unit_query(steering, from, to, query);
}

}  // namespace

std::optional<Piece> ContinuousSteering::steer(const Pose& from, const Pose& to,
                                               const ContinuousQuery& query) const {
  const UnitQuery unit = checked_query(*this, from, to, query);
  const std::optional<UnitPath> path = shortest_path(WordSolver(SharpTurns(turns_)), unit);
  if (!path) return std::nullopt;
  return scaled(*path, radius_);
}

double ContinuousSteering::length(const Pose& from, const Pose& to,
                                  const ContinuousQuery& query) const {
  const UnitQuery unit = checked_query(*this, from, to, query);
  return shortest_length(WordSolver(SharpTurns(turns_)), unit) * radius_;
}

std::vector<Piece> ContinuousSteering::candidates(const Pose& from, const Pose& to,
                                                  const ContinuousQuery& query) const {
  const UnitQuery unit = checked_query(*this, from, to, query);
  std::vector<Piece> pieces;
  for (const UnitPath& path : all_paths(WordSolver(SharpTurns(turns_)), unit)) {
    pieces.push_back(scaled(path, radius_));
  }
  return pieces;
}

}  // namespace vandplan
