// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "evaluation/metrics.h"

#include <cmath>

#include "vandplan/input_error.h"

namespace vandplan::evaluation {

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
    metrics.turning += std::abs(segment.curvature * segment.length);
    metrics.curvature_changes += i > 0 && segment.curvature != segments[i - 1].curvature;
  }
  if (metrics.length > 0.0) metrics.reverse_share = reverse / metrics.length;
  metrics.driving_time = metrics.length / style.speed + metrics.gear_changes * style.pause;
  return metrics;
}

}  // namespace vandplan::evaluation
