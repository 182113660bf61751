// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How soon can a drive along a way arrive at its end, if others are in the way now and then?
//
// Method: docs/algorithms/moving.md.

#include <cstddef>
#include <span>
#include <vector>

#include "moving/occupied.h"

namespace vandplan::moving {

/// A place between two rows, and how fast the fastest drive is from there on.
struct Passage {
  double left = 0.0;   ///< time from leaving the place to the end, at least [s]
  double pause = 0.0;  ///< how long the vehicle stands there at least [s]
};

/// Lower bounds on arrivals of vehicles that may stop at once and are at full speed at once: such a
/// vehicle is at the end no later than one that has to brake and to speed up.
class Arrivals {
 public:
  /// `passages` are the stations of the rows. `occupied` is kept by reference.
  Arrivals(const Occupied& occupied, std::span<const Passage> passages);

  /// No drive that leaves station `i` at time `t` or later is at the end before that time, to stay
  /// there [s]; infinity: none gets there.
  [[nodiscard]] double earliest(std::size_t i, double t) const noexcept;

 private:
  [[nodiscard]] double& at(std::size_t i, std::size_t bin) { return arrivals_[i * bins_ + bin]; }
  [[nodiscard]] double begin_of(std::size_t bin) const noexcept;
  [[nodiscard]] bool may_pass(std::size_t i, std::size_t bin) const;
  [[nodiscard]] bool may_stay(std::size_t i, std::size_t bin) const;

  const Occupied& occupied_;
  std::vector<Passage> passages_;
  double first_;                  // time at which the fastest drive arrives [s]
  double step_;                   // of arrivals without waiting from then on [s]
  std::size_t bins_;              // steps; the last one has no end
  std::vector<double> arrivals_;  // of each station and each step
};

}  // namespace vandplan::moving
