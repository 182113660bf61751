// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How soon can a drive reach the end of a path among moving obstacles, at the earliest?
//
// Method: docs/algorithms/moving.md.

#include <cstddef>
#include <span>
#include <vector>

#include "moving/occupied.h"

namespace vandplan::moving {

/// Station between two rows, with times of the fastest drive.
struct StationTimes {
  double left = 0.0;   ///< least time from leaving the station to the end of the path [s]
  double pause = 0.0;  ///< least time that the vehicle stands at the station [s]
};

/// Lower bounds on the time of arrival at the end of a path. They hold for a vehicle that stops and
/// reaches full speed at once, hence also for a real one.
class Arrivals {
 public:
  /// `times` belong to the stations of `occupied`, which is kept by reference.
  Arrivals(const Occupied& occupied, std::span<const StationTimes> times);

  /// Earliest time at which a drive can be at the end and stay there [s], if it leaves station `i`
  /// at time `t` or later; infinity: never.
  [[nodiscard]] double earliest(std::size_t i, double t) const noexcept;

 private:
  [[nodiscard]] double& at(std::size_t i, std::size_t bin) { return arrivals_[i * bins_ + bin]; }
  [[nodiscard]] double begin_of(std::size_t bin) const noexcept;
  [[nodiscard]] bool may_pass(std::size_t i, std::size_t bin) const;
  [[nodiscard]] bool may_stay(std::size_t i, std::size_t bin) const;

  const Occupied& occupied_;
  std::vector<StationTimes> times_;
  double first_;                  // arrival of the fastest drive [s]
  double step_;                   // width of a bin of arrival times [s]
  std::size_t bins_;              // number of bins of arrival times; the last one has no end
  std::vector<double> arrivals_;  // earliest arrivals, by station and bin [s]
};

}  // namespace vandplan::moving
