// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Prints a hash of the bits of 10^5 steering results; same_on_every_processor compares them.

#include <bit>
#include <cstdint>
#include <cstdio>

#include "base/random.h"
#include "support/pose_pairs.h"
#include "vandplan/dubins.h"
#include "vandplan/path.h"
#include "vandplan/reeds_shepp.h"

namespace {

/// FNV-1a over the bytes of the doubles it is given.
class Hash {
 public:
  void add(double value) {
    for (auto bits = std::bit_cast<std::uint64_t>(value), i = std::uint64_t{8}; i > 0; --i) {
      value_ = (value_ ^ (bits & 0xff)) * 0x100000001b3;
      bits >>= 8;
    }
  }
  void add(const vandplan::Pose& from, const vandplan::Piece& piece) {
    vandplan::Pose pose = from;
    add(piece.length);
    for (const vandplan::Segment& segment : piece.view()) {
      pose = vandplan::advance(pose, segment);
      for (const double v : {segment.curvature, segment.length, pose.x, pose.y, pose.heading}) {
        add(v);
      }
    }
  }
  [[nodiscard]] unsigned long long value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace

int main() {
  vandplan::base::Rng rng(1);
  Hash hash;
  for (int i = 0; i < 100'000; ++i) {
    const auto [from, to] = vandplan::any_pair(7, rng);
    hash.add(from, vandplan::reeds_shepp(from, to, 7));
    hash.add(from, vandplan::dubins(from, to, 7));
  }
  std::printf("%016llx\n", hash.value());
}
