// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/delay.h"

#include <cmath>
#include <cstddef>
#include <limits>

#include "speed/driven.h"
#include "vandplan/vehicle.h"

namespace vandplan::planning {
namespace {

constexpr double forever = std::numeric_limits<double>::infinity();
constexpr double look_interval = 0.3;  // time between looks at moving obstacles [s]
constexpr double least_delay = 1.0;    // time that a drive which meets somebody loses at least [s]
/// Time that a drive loses for each second in which its fastest drive meets somebody. The estimate
/// is so large that going around is cheaper where there is room, and it falls where a path meets
/// somebody for a shorter time.
constexpr double delay_per_second = 4.0;

/// States along a path, asked for in order.
class Driver {
 public:
  Driver(const Task& task, const Path& path)
      : vehicle_(task.vehicle), path_(path), state_(start_state(task)) {}

  [[nodiscard]] State state_at(double s) {
    const auto& segments = path_.segments;
    for (; next_ < segments.size(); ++next_) {
      const double length = std::abs(segments[next_].length);
      if (s < begin_ + length) {
        return advance(vehicle_, state_, part_of(segments[next_], 0.0, s - begin_));
      }
      state_ = advance(vehicle_, state_, segments[next_]);
      begin_ += length;
    }
    return state_;
  }

 private:
  const Vehicle& vehicle_;
  const Path& path_;
  State state_;           // state where the next segment begins
  double begin_ = 0.0;    // place where it begins [m]
  std::size_t next_ = 0;  // its index
};

}  // namespace

Delay::Delay(const Task& task)
    : task_(task), movers_({{task.start, {}}, task.vehicle}, task.moving, task.least_margin) {}

bool Delay::meets_anybody(const State& state, double t) const {
  for (std::size_t i = 0; i < movers_.size(); ++i) {
    if (movers_.leaves(i).value_or(forever) <= t) continue;
    if (movers_.gap(i, state, t, 0.0) <= 0.0) return true;
  }
  return false;
}

double Delay::of(const Path& path, const SpeedProfile& drive) const {
  Driver driver(task_, path);
  int meetings = 0;
  for (int look = 0; look * look_interval < drive.duration; ++look) {
    const double t = look * look_interval;
    if (meets_anybody(driver.state_at(speed::driven_at(drive, t)), t)) ++meetings;
  }
  return meetings == 0 ? 0.0 : least_delay + delay_per_second * meetings * look_interval;
}

}  // namespace vandplan::planning
