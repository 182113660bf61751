// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long is a path at least, for a body that has to turn between obstacles? A proven lower bound.
//
// A path leads from box to box of poses (pose_boxes.h); none of its boxes may need a longer path.
// Two floods, from the start and from the goal, always expand the reached box of the least length.
// They enter boxes only in senses that one-way streets leave open (one_way.h).
// No path is shorter than the largest length that a flood has expanded. If all paths pass a narrow
// place, boxes near it get a better bound (pose_cut.h). Proof: docs/proofs/anytime_bounds.md.

#include <array>
#include <cstdint>
#include <memory>
#include <queue>
#include <vector>

#include "search/pose_boxes.h"
#include "search/pose_cut.h"
#include "vandplan/problem.h"

namespace vandplan::search {

/// Lower bound by floods of boxes, with cells that become smaller. The bound only rises.
class PoseFlood {
 public:
  /// `only`: gear of all paths, 0 for both. The task must outlive the flood.
  explicit PoseFlood(const Task& task, GearSign only = 0);

  /// Does about 20 microseconds of work. Ignores paths longer than `longest` [m]. False when the
  /// bound is final.
  bool step(double longest);

  /// Lower bound on the length of all paths [m].
  [[nodiscard]] double bound() const noexcept { return bound_; }

 private:
  struct Entry {
    float length;
    PoseBoxes::Id box;
    PoseCut::Index by = PoseCut::none;  // Best box of the cut known so far.
    bool knows_cut = false;             // Whether `length` includes the bound of the cut.
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
  double side_;  // Side of a cell [m].
  double longest_ = 0.0;
  std::unique_ptr<PoseBoxes> boxes_;
  bool is_prepared_ = false;
  std::unique_ptr<PoseCut> cut_;
  bool is_cut_prepared_ = false;
  double uncut_bound_ = 0.0;  // Bound reached without the cut [m].
  Use use_of_cuts_ = Use::unknown;
  std::array<Queue, 2> open_;
  /// Floods that reached each box: bit 0 from the start, bit 1 from the goal.
  std::vector<std::uint8_t> reached_;
  std::array<float, 2> levels_{};  // Greatest length that each flood has expanded [m].
  std::size_t leader_ = 0;         // Flood that came further with the boxes before.
  std::int64_t visits_ = 0;        // Number of boxes expanded.
  double bound_ = 0.0;
};

}  // namespace vandplan::search
