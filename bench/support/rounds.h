// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How long did a round take, and what do many rounds say?

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <limits>
#include <vector>

namespace vandplan {

/// Nanoseconds per call of `work`, which does `count` of them.
template <typename Work>
double nanoseconds(std::size_t count, Work work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - begin;
  return time.count() / static_cast<double>(count);
}

/// The middle value, the upper one of an even number; not a number where there is none.
inline double median(std::vector<double> values) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace vandplan
