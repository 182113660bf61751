// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which stretch of the way is free when?
//
// Method and proof: docs/algorithms/moving.md.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "moving/encounters.h"

namespace vandplan::moving {

inline constexpr double forever = std::numeric_limits<double>::infinity();  ///< [s]

/// From a time to another one, both included [s].
struct TimeSpan {
  double begin = 0.0;
  double end = 0.0;
};

/// How hard `Occupied` tries to prove places and times free.
struct BoxLimits {
  std::int64_t most_boxes = 200'000;
  double finest = 0.05;  ///< motion within half a box that is not cut any further [m]
};

/// The way cut into rows, and for each row when something that moves may be in the way of a vehicle
/// that is anywhere in it. What is free here is proven free; what is occupied is nearer than the
/// margin at some place of the row within that time, give or take four times `BoxLimits::finest`.
/// Nothing is known of a row before the vehicle can be in it, and after it can.
class Occupied {
 public:
  /// `stations` increase from 0 to the length of the way; row i lies between stations i and i + 1.
  /// The vehicle can be in it at the times `when[i]`, which neither begin nor end earlier than
  /// those of the row before. What is not proven free within the limits counts as occupied.
  Occupied(const Encounters& encounters, std::vector<double> stations, std::vector<TimeSpan> when,
           const BoxLimits& limits);

  /// Whether row `i` is free all the time.
  [[nodiscard]] bool is_free(std::size_t i, double begin, double end) const noexcept;
  /// Whether row `i` is free for ever from then on.
  [[nodiscard]] bool is_free_from(std::size_t i, double begin) const noexcept {
    return is_free(i, begin, forever);
  }
  /// The first time from `begin` on from which row `i` is free for `length` seconds; `forever`:
  /// none.
  [[nodiscard]] double next_free(std::size_t i, double begin, double length) const noexcept;
  /// How many boxes of places and times were looked at.
  [[nodiscard]] std::int64_t boxes() const noexcept { return boxes_; }
  /// When nothing begins or ceases to be occupied any more [s].
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
