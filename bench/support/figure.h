// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a table say that there is no figure?

#include <cmath>
#include <cstddef>
#include <cstdio>
#include <string>

namespace vandplan {

/// A number in a format such as "%9.2f"; a dash of the same width for one that is not finite:
/// nothing was solved, or there is nothing to compare with.
inline std::string figure(const char* format, double value) {
  const bool is_known = std::isfinite(value);
  std::string text(64, ' ');
  const int length = std::snprintf(text.data(), text.size(), format, is_known ? value : 0.0);
  text.resize(static_cast<std::size_t>(length));
  if (is_known) return text;
  const std::size_t width = text.find_first_not_of(' ') > 0 ? text.size() : 1;
  return std::string(width - 1, ' ') + "-";
}

}  // namespace vandplan
