// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which stretches of a path are free of moving obstacles, and when?
//
// Method: docs/algorithms/moving.md; proof: docs/proofs/moving.md.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "moving/encounters.h"

namespace vandplan::moving {

/// End of a span without end [s].
inline constexpr double forever = std::numeric_limits<double>::infinity();

/// Closed span of time [s].
struct TimeSpan {
  double begin = 0.0;
  double end = 0.0;
};

/// Limits of the work of `Occupied`.
struct BoxLimits {
  std::int64_t most_boxes = 200'000;
  /// Least motion from the middle to the sides of a box that is still halved [m].
  double finest = 0.05;
};

/// Time spans in which moving obstacles may hinder a vehicle on a path, for each row of the path. A
/// row is the stretch between two neighbouring stations. Times that count as free are proven free.
/// When a row is occupied, an obstacle is nearer than the margin at some place of it. The begin and
/// end of an occupied span have an error that matches a motion of four times `BoxLimits::finest`.
/// Nothing is known for times at which the vehicle cannot be in the row.
class Occupied {
 public:
  /// `stations` [m] increase from 0 to the length of the path; row `i` begins at station `i`. The
  /// vehicle can be in row `i` within the span `when[i]`. Begins and ends of `when` never decrease.
  /// Times that are not proven free within `limits` count as occupied.
  Occupied(const Encounters& encounters, std::vector<double> stations, std::vector<TimeSpan> when,
           const BoxLimits& limits);

  /// Whether row `i` is free from `begin` to `end` [s].
  [[nodiscard]] bool is_free(std::size_t i, double begin, double end) const noexcept;
  /// Whether row `i` is free from `begin` on for ever [s].
  [[nodiscard]] bool is_free_from(std::size_t i, double begin) const noexcept {
    return is_free(i, begin, forever);
  }
  /// First time >= `begin` from which row `i` is free for `length` seconds [s]; `forever`: none.
  [[nodiscard]] double next_free(std::size_t i, double begin, double length) const noexcept;
  /// Number of examined boxes; a box is a stretch of the path times a span of time.
  [[nodiscard]] std::int64_t boxes() const noexcept { return boxes_; }
  /// Time after which every row stays free or occupied for ever [s].
  [[nodiscard]] double last_change() const noexcept;

 private:
  struct Box;

  void add(const Box& box);
  void mark(std::size_t first, std::size_t last, const TimeSpan& span);
  [[nodiscard]] bool is_out_of_time(const Box& box) const noexcept;
  [[nodiscard]] bool is_known(const Box& box) const noexcept;
  void sort_rows();

  const Encounters& encounters_;
  std::vector<double> stations_;
  std::vector<TimeSpan> when_;
  std::vector<std::vector<TimeSpan>> rows_;
  BoxLimits limits_;
  std::int64_t boxes_ = 0;
};

}  // namespace vandplan::moving
