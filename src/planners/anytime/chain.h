// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which route keeps to the way of a known path?

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "search/route.h"
#include "vandplan/random.h"
#include "vandplan/search.h"

namespace vandplan::anytime {

using namespace search;

/// Pieces from place to place along an old path, from the task's start to its goal. Some pieces may
/// be blocked by obstacles.
class Chain {
 public:
  /// `old` is in the frame of the task; its ends need not be those of the task.
  Chain(const Task& task, Connector& connector, const Path& old, std::uint64_t seed);

  /// Steers anew between all places; false if two of them cannot be joined.
  bool join();
  /// Keeps the pieces of the old path that the vehicle can drive, steers the other pieces anew, and
  /// leaves out places near both ends. False if two places cannot be joined.
  bool take_over();
  /// One trial to free a blocked leg: moves or adds a place near the old path, at random.
  void repair();
  [[nodiscard]] bool is_free() const;
  [[nodiscard]] Route route() const;

 private:
  /// Place of the old path where the wheels are straight or the gear changes.
  struct Via {
    LocalPose pose;
    double s;       // position on the old path [m]
    GearSign next;  // gear driven onward, if it changes here; otherwise 0
  };
  /// Piece to a place.
  struct Link {
    Piece piece;
    Via to;
    bool is_free;
  };

  [[nodiscard]] static std::vector<Via> vias_of(const Path& path);
  [[nodiscard]] const Via& begin_of(std::size_t i) const {
    return i == 0 ? vias_.front() : links_[i - 1].to;
  }
  [[nodiscard]] DrivenBeside driven_beside(std::size_t first, std::size_t last) const;
  [[nodiscard]] std::optional<std::vector<Link>> linked(std::span<const Via> vias,
                                                        const DrivenBeside& around,
                                                        bool keeps_old = false);
  [[nodiscard]] Via beside(double s, GearSign next);
  [[nodiscard]] std::optional<Piece> old_piece(const Via& from, const Via& to, Driven before) const;
  [[nodiscard]] double clearance_cost(std::size_t first, std::size_t last) const;
  void span_links(std::size_t first, std::size_t last);
  void leave_out();

  const Task& task_;
  Connector& connector_;
  const Path& old_;
  std::vector<double> begins_;  // position where each segment of the old path begins [m]
  Rng rng_;
  std::vector<Via> vias_;  // places of the old path, with both ends
  std::vector<Link> links_;
};

/// A free route along a path, which is in the frame of the task; its ends need not be those of the
/// task. Blocked places are moved at random for some trials. None if no free route is found.
[[nodiscard]] std::optional<Route> route_along(const Task& task, Connector& connector,
                                               const Path& path, std::uint64_t seed);

}  // namespace vandplan::anytime
