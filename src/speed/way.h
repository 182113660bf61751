// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// At which pose is a vehicle after a driven distance, asked many times for one path?

#include <vector>

#include "vandplan/path.h"

namespace vandplan::speed {

/// Path with the begin of each segment precomputed.
class Way {
 public:
  explicit Way(const Path& path);

  /// Point of the path after `s` metres. Where two segments meet, `is_next` chooses the later one.
  [[nodiscard]] PathPoint at(double s, bool is_next) const;

  /// Segments of the path; neighbours that continue each other are merged.
  [[nodiscard]] const std::vector<Segment>& segments() const noexcept { return segments_; }

 private:
  struct Begin {
    double s;
    Pose pose;  // pose relative to `origin_`
  };

  [[nodiscard]] Pose to_path(const Pose& pose) const {
    return {pose.x + origin_.x, pose.y + origin_.y, pose.heading};
  }

  Point origin_;
  std::vector<Segment> segments_;
  std::vector<Begin> begins_;  // begins of the segments, then the end of the path
};

}  // namespace vandplan::speed
