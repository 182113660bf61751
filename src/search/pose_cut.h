// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does a path need at least that has to go through a narrow place?
//
// At some distance from the start the ways are narrowest. All paths cross it there, in one of few
// boxes. So a path through a box beyond needs at least what leads to the best of them and on to the
// box; likewise to the goal. docs/algorithms/anytime.md, "The bound", says why.

#include <cstdint>
#include <span>
#include <vector>

#include "search/pose_boxes.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// The boxes where paths cross that distance.
class PoseCut {
 public:
  /// One of them.
  using Index = std::uint16_t;
  static constexpr Index none = 0xffff;

  /// Task and boxes outlive it; the boxes are prepared.
  PoseCut(const Task& task, PoseBoxes& boxes);

  /// Looks for the place and its boxes, some work. True when that is done.
  bool prepare();
  /// Whether there is such a place, and few boxes there.
  [[nodiscard]] bool is_usable() const noexcept { return is_usable_; }

  /// Whether the cut may say more of a box than its own least length.
  [[nodiscard]] bool is_near(PoseBoxes::Id id) const;
  /// No path through an open box is shorter [m]. Once it is known to be at most `enough` it may be
  /// any such length. `by` is a box of the cut that may be the best one; then it is.
  [[nodiscard]] float least_length(PoseBoxes::Id id, double enough, Index& by);
  /// How many lengths it has worked out.
  [[nodiscard]] std::int64_t lengths() const noexcept { return lengths_; }

 private:
  /// Middles of boxes, from the start.
  struct Poses {
    std::vector<float> x, y, heading;
    void add(const Pose& pose);
  };
  /// How far two poses are from the middles of their boxes, in all: the way and the turn [m].
  struct Play {
    double shift, turn;
  };
  /// What is needed from the start and to the goal [m].
  struct Needs {
    double from_start, to_goal;
  };
  /// Boxes of a cell whose headings follow each other, and the least that one of them needs.
  struct Group {
    std::size_t first, end;
    Needs needs;
    PoseBoxes::Range way_to_goal;
  };
  /// A box that is asked for, its middle from the start.
  struct Target {
    Pose middle;
    PoseBoxes::Range way_to_goal;
    double way;  // from the cut
    bool is_beyond;
  };

  [[nodiscard]] Pose seen(const Pose& pose) const;
  void count(std::int32_t row);
  void choose_distance();
  void add_group(const PoseBoxes::Crossing& cell, PoseBoxes::Id heading);
  [[nodiscard]] double turning_length(const Target& target, const Poses& poses, std::size_t i,
                                      float length_of_middles, const Play& play) const;
  [[nodiscard]] double length_by(const Target& target, const Group& group, const Needs& needs,
                                 double turning) const;
  [[nodiscard]] double least_of(const Target& target, const Group& group, double least, Index& by);

  const Task& task_;
  PoseBoxes& boxes_;
  double radius_;
  Play play_, group_play_;
  double distance_ = 0.0;  // from the start [m]
  bool is_usable_ = true;
  std::int32_t row_ = 0;              // of cells: looked at once to choose, once to find the boxes
  std::vector<std::int32_t> places_;  // how many there are, by distance
  std::vector<PoseBoxes::Crossing> cells_;  // whose boxes are yet to be found,
  PoseBoxes::Id heading_ = 0;               // in the last one from here on
  std::vector<Needs> needs_;
  Poses poses_;
  std::vector<Index> group_of_;
  std::vector<Group> groups_;
  Poses group_poses_;
  std::vector<float> from_boxes_, from_groups_;  // lengths to a pose, on open ground
  std::int64_t lengths_ = 0;
};

}  // namespace vandplan::search
