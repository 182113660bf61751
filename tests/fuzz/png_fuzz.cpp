// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any bytes as a PNG image; check sums are put right, so that what they guard is reached.

#include <zlib.h>

#include <algorithm>

#include "fuzz/image.h"
#include "io/png_image.h"

using namespace vandplan;

namespace {

/// The bytes with a check sum that fits behind every chunk.
std::string sealed(std::string bytes) {
  constexpr std::size_t signature = 8;
  const auto byte = [&](std::size_t i) {
    return std::size_t{static_cast<unsigned char>(bytes[i])};
  };
  for (std::size_t at = signature; at + 12 <= bytes.size();) {
    const std::size_t length =
        byte(at) << 24U | byte(at + 1) << 16U | byte(at + 2) << 8U | byte(at + 3);
    if (length > bytes.size() - at - 12) break;
    const auto* const begin = reinterpret_cast<const Bytef*>(bytes.data() + at + 4);
    const uLong sum = crc32(0, begin, static_cast<uInt>(length + 4));
    for (std::size_t i = 0; i < 4; ++i) {
      bytes[at + 8 + length + i] = static_cast<char>(sum >> (24 - 8 * i) & 0xFFU);
    }
    at += length + 12;
  }
  return bytes;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = sealed(fuzz::text_of(data, size));
  for (const io::Alpha alpha : {io::Alpha::marked, io::Alpha::ignored}) {
    fuzz::may_refuse([&] {
      fuzz::expect_an_image(true, [&](const io::TakeRow& take_row) {
        io::FileReader file(bytes, "fuzz.png");
        io::read_png(file, alpha, take_row);
      });
    });
  }
  return 0;
}
