// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does the judge word what it finds?

#include <array>
#include <cstdio>
#include <string>

namespace vandplan::judge {

/// Text that `printf` would write, cut off after 199 characters.
std::string text(const char* format, auto... values) {
  std::array<char, 200> buffer;
  std::snprintf(buffer.data(), buffer.size(), format, values...);
  return buffer.data();
}

}  // namespace vandplan::judge
