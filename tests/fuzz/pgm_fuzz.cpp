// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any bytes as a grey map.

#include "fuzz/fuzz.h"
#include "io/pgm.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::may_refuse([&] {
    std::int32_t rows = 0;
    std::int32_t expected = 0;
    io::read_pgm(fuzz::text_of(data, size), "fuzz.pgm",
                 [&](const io::ImageShape& shape, std::span<const std::uint32_t> row) {
                   ++rows;
                   expected = shape.rows;
                   fuzz::expect(row.size() == static_cast<std::size_t>(shape.columns),
                                "a whole row");
                   for (const std::uint32_t pixel : row) {
                     fuzz::expect(pixel <= shape.white, "no pixel is brighter than white");
                   }
                 });
    fuzz::expect(rows > 0 && rows == expected, "all rows are there");
  });
  return 0;
}
