// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How many random cases does a law run through, and which one broke it?

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <initializer_list>
#include <iterator>
#include <string>

#include "vandplan/path.h"
#include "vandplan/random.h"

namespace vandplan {

/// Whether sanitizers make every step slow. g++ says so by macros, clang by features, CMake where
/// they watch the command line alone.
#if defined(VANDPLAN_SANITIZED) || defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool is_sanitized = true;
#elif defined(__has_feature)
inline constexpr bool is_sanitized =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool is_sanitized = false;
#endif

/// `n`, or a fiftieth of it where sanitizers make every step slow.
inline int cases(int n) { return is_sanitized ? std::max(1, n / 50) : n; }

/// Calls `law(rng)` for `cases(n)` cases, each with its own stream of `seed`, and stops at the
/// first case that fails, naming it.
template <typename Law>
void for_each_case(std::uint64_t seed, int n, Law law) {
  for (int i = 0; i < cases(n) && !testing::Test::HasFailure(); ++i) {
    SCOPED_TRACE("seed " + std::to_string(seed) + ", case " + std::to_string(i));
    Rng rng(stream_seed(seed, static_cast<std::uint64_t>(i)));
    law(rng);
  }
}

// Values as C++ that can be pasted into a test.

inline std::string as_code(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.17g", value);
  return text;
}

inline std::string braced(std::initializer_list<double> values) {
  std::string text;
  for (const double value : values) text.append(text.empty() ? "{" : ", ").append(as_code(value));
  return text.append("}");
}

inline std::string as_code(const Point& p) { return braced({p.x, p.y}); }

inline std::string as_code(const Pose& p) { return braced({p.x, p.y, p.heading}); }

inline std::string as_code(const Segment& segment) {
  if (segment.curvature_rate == 0) return braced({segment.curvature, segment.length});
  return braced({segment.curvature, segment.length, segment.curvature_rate});
}

template <typename Range>
requires requires(const Range& range) { as_code(*std::begin(range)); }
std::string as_code(const Range& range) {
  std::string text;
  for (const auto& value : range) text += (text.empty() ? "{" : ", ") + as_code(value);
  return text.empty() ? "{}" : text + "}";
}

inline std::string as_code(const Path& path) {
  return "Path{" + as_code(path.start) + ", " + as_code(path.segments) + "}";
}

}  // namespace vandplan
