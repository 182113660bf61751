// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the bytes of a table file laid out?
//
// A head of 96 bytes, then the entries; everything little-endian. Layout: docs/formats.md.

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "base/bytes.h"

namespace vandplan::tables::table_bytes {

inline constexpr std::size_t head_size = 96;
inline constexpr std::uint64_t most_entries = std::uint64_t{1} << 28;

/// What kind of table the file holds, as written in it: 16 characters each.
struct Kind {
  std::string_view content;
  std::string_view units;
  std::size_t entry_size;  ///< [bytes]
};
inline constexpr Kind lengths{"reeds-shepp-4d  ", "metre radian    ", 4};
inline constexpr Kind bounds{"reeds-shepp-bnds", "radius radian   ", 8};

struct Head {
  const Kind* kind = &lengths;
  std::array<std::uint64_t, 4> parameters{};  ///< what they mean depends on the kind
  std::uint64_t count = 0;                    ///< of entries
  std::uint64_t checksum = 0;
};

/// The first bytes of a file, with a checksum of zero.
[[nodiscard]] std::string start_of(const Head& head);

/// Puts the checksum of all bytes in its place.
void seal(std::string& bytes);

/// Reads the head alone. Throws InputError naming `file` for one that is not ours.
[[nodiscard]] Head head_of(std::string_view bytes, const std::string& file);

/// The head of a file that is whole; throws InputError naming `file` if it is not.
[[nodiscard]] Head checked_head(std::string_view bytes, const std::string& file);

[[nodiscard]] std::uint64_t checksum(std::string_view bytes) noexcept;

using base::append, base::read_at;

}  // namespace vandplan::tables::table_bytes
