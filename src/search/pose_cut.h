// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is a path at least that has to pass a narrow place?
//
// At some distance from the start the ways are narrowest. All paths cross that distance in one of
// few boxes. So a path through a box beyond needs at least the way to the best of these boxes and
// on from there. The goal's side is symmetric. Proof: docs/proofs/anytime_bounds.md.

#include <cstdint>
#include <span>
#include <vector>

#include "search/pose_boxes.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Boxes where paths cross one distance from the start, and lower bounds through them.
class PoseCut {
 public:
  /// Number of a box of the cut.
  using Index = std::uint16_t;
  static constexpr Index none = 0xffff;

  /// Task and boxes must outlive the cut; the boxes must be prepared.
  PoseCut(const Task& task, PoseBoxes& boxes);

  /// Does some of the search for the distance and its boxes. True when it is finished.
  bool prepare();
  /// Whether a cut was found and has few boxes.
  [[nodiscard]] bool is_usable() const noexcept { return is_usable_; }

  /// Whether the cut may give a better bound for a box than the box's own least length.
  [[nodiscard]] bool is_near(PoseBoxes::Id id) const;
  /// Lower bound on the length of paths through an open box [m] if it is above `enough`; otherwise
  /// some length up to `enough`. `by`: on entry a guess of the best box of the cut, on return the
  /// best one known.
  [[nodiscard]] float length_lower_bound(PoseBoxes::Id id, double enough, Index& by);
  /// Number of Reeds-Shepp lengths computed so far.
  [[nodiscard]] std::int64_t lengths() const noexcept { return lengths_; }

 private:
  /// Middles of boxes, relative to the start.
  struct Poses {
    std::vector<float> x, y, heading;
    void add(const Pose& pose);
  };
  /// Largest total distance of two poses from the middles of their boxes: way and turn [m].
  struct Play {
    double shift, turn;
  };
  /// Lower bounds on paths from the start and to the goal [m].
  struct Needs {
    double from_start, to_goal;
  };
  /// Boxes of a cell with consecutive headings, and the least bounds among them.
  struct Group {
    std::size_t first, end;
    Needs needs;
    PoseBoxes::Range way_to_goal;
  };
  /// Box in question; its middle is relative to the start.
  struct Target {
    Pose middle;
    PoseBoxes::Range way_to_goal;
    double way;      // Distance from the cut [m].
    bool is_beyond;  // Whether the box lies on the goal's side of the cut.
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
  double distance_ = 0.0;  // Distance of the cut from the start [m].
  bool is_usable_ = true;
  /// Row of cells handled next: first all rows to choose the distance, then all to find boxes.
  std::int32_t row_ = 0;
  std::vector<std::int32_t> places_;        // Number of places at each distance.
  std::vector<PoseBoxes::Crossing> cells_;  // Cells whose boxes are not found yet.
  PoseBoxes::Id heading_ = 0;  // Heading in the last of `cells_` where the work goes on.
  std::vector<Needs> needs_;
  Poses poses_;
  std::vector<Index> group_of_;
  std::vector<Group> groups_;
  Poses group_poses_;
  /// Reeds-Shepp lengths to a target on open ground [m].
  std::vector<float> from_boxes_, from_groups_;
  std::int64_t lengths_ = 0;
};

}  // namespace vandplan::search
