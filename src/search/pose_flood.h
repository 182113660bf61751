// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How far is it at least, for a body that has to turn between the obstacles? A proven bound.
//
// A path leads from box to box of poses (pose_boxes.h), none of which may need a longer path. Two
// floods, from the start and from the goal, go to the box of the least length that they touch: no
// path is shorter than the greatest one that a flood has come to. Where all paths go through a
// narrow place, boxes near it need what leads through that (pose_cut.h).
// docs/algorithms/anytime.md, "The bound".

#include <array>
#include <cstdint>
#include <memory>
#include <queue>
#include <vector>

#include "search/pose_boxes.h"
#include "search/pose_cut.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Boxes of several sizes follow each other, from coarse to fine. The bound only rises.
class PoseFlood {
 public:
  /// The paths are in the gear `only`; 0: in both gears. The task outlives the flood.
  explicit PoseFlood(const Task& task, GearSign only = 0);

  /// Goes on, about 20 microseconds of work. Takes no notice of paths that are longer than
  /// `longest` [m]. False when the bound is final.
  bool step(double longest);

  /// Length of no path is below this [m].
  [[nodiscard]] double bound() const noexcept { return bound_; }

 private:
  struct Entry {
    float length;
    PoseBoxes::Id box;
    PoseCut::Index by = PoseCut::none;  // the best box of the cut, as far as is known
    bool knows_cut = false;             // the length does
    bool operator<(const Entry& other) const {
      return length != other.length ? length > other.length : box > other.box;
    }
  };
  using Queue = std::priority_queue<Entry>;
  enum class Use { unknown, some, none };

  bool begin(double longest);
  void begin_floods();
  void begin_cut();
  void prepare();
  void prepare_cut();
  void reach(PoseBoxes::Id box, std::size_t flood, PoseCut::Index by);
  bool spread(std::size_t flood);
  [[nodiscard]] std::size_t next_flood();
  bool next_boxes();
  [[nodiscard]] std::int64_t work() const;

  const Task& task_;
  GearSign only_;
  double side_;  // of a cell [m]
  double longest_ = 0.0;
  std::unique_ptr<PoseBoxes> boxes_;
  bool is_prepared_ = false;
  std::unique_ptr<PoseCut> cut_;
  bool is_cut_prepared_ = false;
  double uncut_bound_ = 0.0;  // what was known without it [m]
  Use use_of_cuts_ = Use::unknown;
  std::array<Queue, 2> open_;
  std::vector<std::uint8_t> reached_;  // by the one flood: 1, by the other: 2
  std::array<float, 2> levels_{};      // that they have come to [m]
  std::size_t leader_ = 0;             // which one came further before
  std::int64_t visits_ = 0;            // of boxes
  double bound_ = 0.0;
};

}  // namespace vandplan::search
