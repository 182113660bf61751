// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I use the steering functions alone: shortest paths on open ground?

#include <vandplan/steering.h>

#include <cmath>
#include <cstdio>

int main() {
  const vandplan::Pose from{0, 0, 0};
  const vandplan::Pose to{-3, 4, 1.5};
  const double radius = 7;  // turning radius [m]

  const vandplan::Piece shortest = vandplan::reeds_shepp(from, to, radius);
  std::printf("both gears: %.3f m; forward only: %.3f m\n", shortest.length,
              vandplan::dubins_length(from, to, radius));

  vandplan::Pose pose = from;
  for (const vandplan::Segment& segment : shortest.view()) {
    pose = vandplan::advance(pose, segment);
    std::printf("curvature %6.3f, driven %7.3f m: x %6.3f  y %6.3f  heading %6.3f\n",
                segment.curvature, segment.length, pose.x, pose.y, pose.heading);
  }

  // All words that lead from `from` to `to`, with their lengths.
  std::size_t longer = 0;
  for (const vandplan::Piece& word : vandplan::reeds_shepp_words(from, to, radius)) {
    longer += word.length > shortest.length ? 1 : 0;
  }
  std::printf("%zu words are longer\n", longer);

  const bool arrives = std::hypot(pose.x - to.x, pose.y - to.y) < 1e-9;
  return arrives && shortest.length < vandplan::dubins_length(from, to, radius) ? 0 : 1;
}
