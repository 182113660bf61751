// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "moving/arrivals.h"

#include <algorithm>
#include <cmath>

namespace vandplan::moving {
namespace {

constexpr double finest_step = 0.25;  // least width of a bin of arrival times [s]
constexpr double most_steps = 800;
constexpr double rounding = 1e-9;  // rounding error of sums of times [s]

}  // namespace

// A bin holds the vehicles that would arrive within it if they waited no more. A vehicle that
// drives on stays in its bin; a vehicle that waits gets into the next one.
Arrivals::Arrivals(const Occupied& occupied, std::span<const StationTimes> times)
    : occupied_(occupied),
      times_(times.begin(), times.end()),
      first_(times.front().left + times.front().pause),
      step_(std::max(finest_step, occupied.last_change() / most_steps)),
      bins_(static_cast<std::size_t>(occupied.last_change() / step_) + 2),
      arrivals_(times.size() * bins_, forever) {
  const std::size_t last = times_.size() - 1;
  for (std::size_t bin = bins_; bin-- > 0;) {
    const bool is_last_bin = bin + 1 == bins_;
    const double end = is_last_bin ? occupied.last_change() + first_ : begin_of(bin + 1);
    if (occupied.is_free_from(last - 1, end + rounding)) at(last, bin) = begin_of(bin);
  }
  for (std::size_t i = last; i-- > 0;) {
    for (std::size_t bin = bins_; bin-- > 0;) {
      double arrival = forever;
      if (may_pass(i, bin)) arrival = at(i + 1, bin);
      if (may_stay(i, bin)) arrival = std::min(arrival, at(i, bin + 1));
      at(i, bin) = arrival;
    }
  }
}

double Arrivals::begin_of(std::size_t bin) const noexcept {
  return first_ + static_cast<double>(bin) * step_;
}

// Whether a vehicle of the bin may find row `i` free for as long as it needs to pass.
bool Arrivals::may_pass(std::size_t i, std::size_t bin) const {
  const StationTimes& here = times_[i];
  const StationTimes& next = times_[i + 1];
  const double needed = std::max(here.left - next.left - next.pause - rounding, 0.0);
  const double begin = begin_of(bin) - here.left - rounding;
  const double end = bin + 1 == bins_ ? forever : begin + step_ + 2 * rounding;
  const double free = occupied_.next_free(i, begin, needed);
  return free <= end && free != forever;
}

// Whether a vehicle of the bin may stand at station `i` when the next bin begins.
bool Arrivals::may_stay(std::size_t i, std::size_t bin) const {
  if (bin + 1 == bins_) return false;
  const double t = begin_of(bin + 1) - times_[i].left;
  const auto is_free = [&](std::size_t row) {
    return occupied_.next_free(row, t - rounding, 0.0) <= t + rounding;
  };
  return is_free(i) || (i > 0 && is_free(i - 1));
}

double Arrivals::earliest(std::size_t i, double t) const noexcept {
  const double unhindered = t + times_[i].left;
  const double step = std::max((unhindered - first_ - rounding) / step_, 0.0);
  const std::size_t bin = std::min(static_cast<std::size_t>(step), bins_ - 1);
  return std::max(unhindered, arrivals_[i * bins_ + bin]);
}

}  // namespace vandplan::moving
