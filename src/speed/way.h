// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Where is the vehicle after so many metres, asked again and again?

#include <vector>

#include "vandplan/path.h"

namespace vandplan::speed {

/// The drive along one path: the segments with what lies before them.
class Way {
 public:
  explicit Way(const Path& path);

  /// The place after `s` metres. Where two segments meet `is_next` chooses the later one.
  [[nodiscard]] PathPoint at(double s, bool is_next) const;

  /// The segments of the path, neighbours joined where they go on.
  [[nodiscard]] const std::vector<Segment>& segments() const noexcept { return segments_; }

 private:
  struct Begin {
    double s;
    Pose pose;  // beside the origin
  };

  [[nodiscard]] Pose to_path(const Pose& pose) const {
    return {pose.x + origin_.x, pose.y + origin_.y, pose.heading};
  }

  Point origin_;
  std::vector<Segment> segments_;
  std::vector<Begin> begins_;  // of the segments, and the end of the path
};

}  // namespace vandplan::speed
