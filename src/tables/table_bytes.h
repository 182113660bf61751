// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How are the bytes of a table file laid out?
//
// A header of 96 bytes, then the entries; everything little-endian. Layout: docs/formats.md.

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

/// Kind of table in a file. The texts are written to the file, 16 characters each.
struct Kind {
  std::string_view content;
  std::string_view units;
  std::size_t entry_size;  ///< Size of one entry [bytes].
};
inline constexpr Kind lengths{"reeds-shepp-4d  ", "metre radian    ", 4};
inline constexpr Kind bounds{"reeds-shepp-bnds", "radius radian   ", 8};

struct Head {
  const Kind* kind = &lengths;
  /// Parameters of the table; their meaning depends on `kind`.
  std::array<std::uint64_t, 4> parameters{};
  std::uint64_t count = 0;  ///< Number of entries.
  std::uint64_t checksum = 0;
};

/// Header of a file as bytes, with a checksum of zero.
[[nodiscard]] std::string start_of(const Head& head);

/// Computes the checksum of all bytes and writes it into the header.
void seal(std::string& bytes);

/// Reads the header alone. Throws InputError naming `file` if it is not the header of a table file.
[[nodiscard]] Head head_of(std::string_view bytes, const std::string& file);

/// Reads the header and checks size and checksum of the whole file. Throws InputError naming
/// `file`.
[[nodiscard]] Head checked_head(std::string_view bytes, const std::string& file);

[[nodiscard]] std::uint64_t checksum(std::string_view bytes) noexcept;

using base::append, base::read_at;

}  // namespace vandplan::tables::table_bytes
