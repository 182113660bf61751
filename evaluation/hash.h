// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// A fingerprint of some bytes, to tell contents apart (not against malice).

#include <cstdint>
#include <string_view>

namespace vandplan {

/// FNV-1a, 64 bits (Fowler, Noll, Vo).
constexpr std::uint64_t hash_of(std::string_view bytes) noexcept {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * 0x100000001b3;
  return hash;
}

}  // namespace vandplan
