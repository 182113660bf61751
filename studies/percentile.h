// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which value is larger than a given share of a sample?

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <span>

namespace vandplan::studies {

/// Value of rank round(percent / 100 * (n - 1)). Reorders the values; needs at least one.
inline double percentile(std::span<double> values, double percent) {
  assert(!values.empty());
  const double rank = percent / 100.0 * static_cast<double>(values.size() - 1);
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank + 0.5);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

}  // namespace vandplan::studies
