// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it at least, for a body that has to turn between the obstacles? A proven bound.
//
// A path leads from box to box of poses (pose_boxes.h), none of which may need a longer path. Two
// floods, from the start and from the goal, go to the box of the least length that they touch: no
// path is shorter than the greatest one that a flood has come to. docs/algorithms/anytime.md, "The
// bound".

#include <array>
#include <cstdint>
#include <memory>
#include <queue>
#include <vector>

#include "search/pose_boxes.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Boxes of several sizes follow each other, from coarse to fine. The bound only rises.
class PoseFlood {
 public:
  /// The task outlives it.
  explicit PoseFlood(const Task& task);

  /// Goes on, about 20 microseconds of work. Takes no notice of paths that are longer than
  /// `longest` [m]. False when the bound is final.
  bool step(double longest);

  /// Length of no path is below this [m].
  [[nodiscard]] double bound() const noexcept { return bound_; }

 private:
  struct Entry {
    float length;
    PoseBoxes::Id box;
    bool operator<(const Entry& other) const {
      return length != other.length ? length > other.length : box > other.box;
    }
  };
  using Queue = std::priority_queue<Entry>;

  bool begin(double longest);
  void reach(PoseBoxes::Id box, std::size_t flood);
  bool spread(std::size_t flood);

  const Task& task_;
  double side_;  // of a cell [m]
  double longest_ = 0.0;
  std::unique_ptr<PoseBoxes> boxes_;
  bool is_prepared_ = false;
  std::array<Queue, 2> open_;
  std::vector<std::uint8_t> reached_;  // by the one flood: 1, by the other: 2
  std::size_t turn_ = 0;               // which flood goes on
  double bound_ = 0.0;
};

}  // namespace vandplan::search
