// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/metrics.h"

#include <cmath>

#include "vandplan/input_error.h"

namespace vandplan::evaluation {

namespace {

double length_of(const Segment& segment) { return std::abs(segment.length); }

/// Sum of the absolute changes of heading along a segment [rad].
double turning_of(const Segment& segment) {
  const double length = length_of(segment);
  if (segment.curvature_rate == 0.0) return std::abs(segment.curvature * length);
  const double first = segment.curvature;
  const double last = curvature_at(segment, length);
  if (first * last >= 0.0) return std::abs(first + last) / 2 * length;
  return (first * first + last * last) / std::abs(segment.curvature_rate) / 2;
}

/// Whether the wheel has to be turned between two segments. The end of a clothoid has rounding
/// errors.
bool jumps(const Segment& before, const Segment& segment) {
  const double jump = std::abs(curvature_at(before, length_of(before)) - segment.curvature);
  const bool is_rounded = before.curvature_rate != 0.0 || segment.curvature_rate != 0.0;
  // Rounding error of the curvature at the end of a clothoid [1/m].
  constexpr double rounding = 1e-9;
  return jump > (is_rounded ? rounding : 0.0);
}

}  // namespace

void validate(const DrivingStyle& style) {
  if (!(style.speed > 0.0 && std::isfinite(style.speed)))
    throw InputError("speed", "must be > 0 [m/s]");
  if (!(style.pause >= 0.0 && std::isfinite(style.pause)))
    throw InputError("pause", "must be >= 0 [s]");
}

PathMetrics metrics_of(const Path& path, const DrivingStyle& style) {
  validate(style);
  const std::vector<Segment> segments = merged(path.segments);
  PathMetrics metrics{.length = length(segments), .gear_changes = gear_changes(segments)};
  double reverse = 0.0;
  for (std::size_t i = 0; i < segments.size(); ++i) {
    const Segment& segment = segments[i];
    if (segment.length < 0.0) reverse -= segment.length;
    metrics.turning += turning_of(segment);
    metrics.curvature_changes += segment.curvature_rate != 0.0;
    metrics.curvature_changes += i > 0 && jumps(segments[i - 1], segment);
  }
  if (metrics.length > 0.0) metrics.reverse_share = reverse / metrics.length;
  metrics.driving_time = metrics.length / style.speed + metrics.gear_changes * style.pause;
  return metrics;
}

}  // namespace vandplan::evaluation
