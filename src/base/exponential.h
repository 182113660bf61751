// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is e to the power of x, the same on every processor?

namespace vandplan::base {

/// e to the power of x, within 2 units in the last place for |x| <= 700; 0 below -700, infinity
/// above 700, NaN for NaN.
[[nodiscard, gnu::const]] double exponential(double x) noexcept;

}  // namespace vandplan::base
