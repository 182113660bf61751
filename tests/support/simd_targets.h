// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does a kernel give the same bits on every vector target of this machine?

#include <gtest/gtest.h>
#include <hwy/targets.h>

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>
#include <vector>

#include "simd/target.h"
#include "support/cases.h"
#include "vandplan/random.h"

namespace vandplan {

/// Makes the kernels run on one target as long as it lives.
class ForcedTarget {
 public:
  explicit ForcedTarget(std::int64_t target) { hwy::SetSupportedTargetsForTest(target); }
  ~ForcedTarget() { hwy::SetSupportedTargetsForTest(0); }
  ForcedTarget(const ForcedTarget&) = delete;
  ForcedTarget& operator=(const ForcedTarget&) = delete;
};

inline bool same_bits(const std::vector<float>& a, const std::vector<float>& b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(float)) == 0);
}

/// Calls `law(count, rng)` on every target with sizes around those of a vector and of a block, and
/// many others.
template <typename Law>
void on_every_target(Law law) {
  for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
    const ForcedTarget forced(target);
    SCOPED_TRACE(hwy::TargetName(target));
    ASSERT_EQ(simd::simd_target(), std::string_view(hwy::TargetName(target)));
    Rng rng(11);
    for (std::size_t i = 0; i < static_cast<std::size_t>(cases(1000)); ++i) {
      const std::size_t count = i < 300 ? i : rng() % 1000;
      SCOPED_TRACE("case " + std::to_string(i));
      law(count, rng);
      if (testing::Test::HasFailure()) return;
    }
  }
}

}  // namespace vandplan
