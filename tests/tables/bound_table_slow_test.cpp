// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/bound_law.h"

namespace vandplan {
namespace {

TEST(BoundTable, HoldsAHundredMillionRandomPairs) { expect_all_inside(2, 100'000'000); }

}  // namespace
}  // namespace vandplan
