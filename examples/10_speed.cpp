// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How fast can my truck drive a path, and where is it when?

#include <vandplan/motion.h>

#include <cmath>
#include <cstdio>

int main() {
  vandplan::Vehicle truck;  // lengths and width are the defaults
  truck.limits.max_speed = {.forward = 3.0, .reverse = 1.5};
  truck.limits.max_acceleration = 0.8;
  truck.limits.max_steering_rate = 0.4;

  // Straight on, a clothoid into a left turn, the turn, then back with the wheels straight.
  const vandplan::Path path{{0, 0, 0}, {{0, 10}, {0, 2, 0.07}, {0.14, 5}, {0, -8}}};
  const vandplan::SpeedProfile profile = vandplan::speed_profile(path, truck);
  std::printf("%.2f s, standing %.2f s\n", profile.duration, profile.standing);

  for (const vandplan::Motion& motion : vandplan::sampled(path, truck, profile, 1.0)) {
    std::printf("t %5.2f  x %6.2f  y %5.2f  v %5.2f m/s  steering %5.2f rad\n", motion.t,
                motion.pose.x, motion.pose.y, motion.v, motion.steering_angle);
  }

  const vandplan::Motion end = vandplan::motion_at(path, truck, profile, profile.duration);
  return end.v == 0 && std::abs(end.s - 25) < 1e-9 ? 0 : 1;
}
