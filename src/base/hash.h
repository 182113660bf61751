// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is the fingerprint of some bytes?
//
// It is FNV-1a, 64 bits (Fowler, Noll, Vo), to tell contents apart, not against malice. Every step
// is a bijection of the state, so a single altered byte never goes unseen.

#include <cstdint>
#include <string_view>

namespace vandplan::base {

/// The hash of no bytes.
inline constexpr std::uint64_t empty_hash = 0xcbf29ce484222325U;

/// What the hash is multiplied by with each byte.
inline constexpr std::uint64_t hash_prime = 0x100000001b3U;

/// The hash of `bytes`. With the hash of other bytes as `before`, it is the hash of these other
/// bytes followed by `bytes`.
[[nodiscard]] constexpr std::uint64_t hash_of(std::string_view bytes,
                                              std::uint64_t before = empty_hash) noexcept {
  std::uint64_t hash = before;
  for (const char byte : bytes) hash = (hash ^ static_cast<unsigned char>(byte)) * hash_prime;
  return hash;
}

}  // namespace vandplan::base
