// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "speed/way.h"

#include <algorithm>
#include <cmath>

namespace vandplan::speed {

Way::Way(const Path& path)
    : origin_{std::round(path.start.x), std::round(path.start.y)},
      segments_(merged(path.segments)) {
  // Poses are accumulated relative to the rounded start, like those of the path.
  Pose pose{path.start.x - origin_.x, path.start.y - origin_.y, path.start.heading};
  double s = 0.0;
  for (const Segment& segment : segments_) {
    begins_.push_back({s, pose});
    pose = advance(pose, segment);
    s += std::abs(segment.length);
  }
  begins_.push_back({s, pose});
}

PathPoint Way::at(double s, bool is_next) const {
  if (segments_.empty()) return {0.0, to_path(begins_.front().pose), 0.0, Gear::forward};
  const auto later = is_next ? std::ranges::upper_bound(begins_, s, {}, &Begin::s)
                             : std::ranges::lower_bound(begins_, s, {}, &Begin::s);
  const auto after = static_cast<std::size_t>(later - begins_.begin());
  const std::size_t i = std::clamp<std::size_t>(after, 1, segments_.size()) - 1;
  const Segment& segment = segments_[i];
  const double driven = std::clamp(s - begins_[i].s, 0.0, std::abs(segment.length));
  return {s, to_path(advance(begins_[i].pose, part_of(segment, 0.0, driven))),
          curvature_at(segment, driven), segment.gear()};
}

}  // namespace vandplan::speed
