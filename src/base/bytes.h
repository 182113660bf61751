// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do whole numbers become bytes of a file? The lowest byte comes first on every machine.

#include <cstddef>
#include <string>
#include <string_view>

namespace vandplan::base {

template <class Unsigned>
void append(std::string& bytes, Unsigned value) {
  for (std::size_t i = 0; i < sizeof value; ++i) {
    bytes.push_back(static_cast<char>((value >> (8 * i)) & 0xFFU));
  }
}

/// The number whose bytes begin at `at`, all of which must be there.
template <class Unsigned>
[[nodiscard]] Unsigned read_at(std::string_view bytes, std::size_t at) {
  Unsigned value = 0;
  for (std::size_t i = 0; i < sizeof value; ++i) {
    value |= static_cast<Unsigned>(static_cast<Unsigned>(static_cast<unsigned char>(bytes[at + i]))
                                   << (8 * i));
  }
  return value;
}

}  // namespace vandplan::base
