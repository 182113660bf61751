// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a list of starts and goals.

#include <cmath>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string file = fuzz::folder().put("poses.csv", fuzz::text_of(data, size));
  fuzz::may_refuse([&] {
    const PosePairs read = read_pose_pairs(file);
    fuzz::expect(!read.pairs.empty(), "there is a pair");
    for (const PosePair& pair : read.pairs) {
      fuzz::expect(std::isfinite(pair.start.x + pair.goal.heading), "poses are finite");
    }
  });
  return 0;
}
