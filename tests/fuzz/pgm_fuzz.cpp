// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any bytes as a grey map.

#include "fuzz/fuzz.h"
#include "io/pgm.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::may_refuse([&] {
    const io::Image image = io::image_from_pgm(fuzz::text_of(data, size), "fuzz.pgm");
    const auto columns = static_cast<std::size_t>(image.columns);
    fuzz::expect(image.pixels.size() == columns * static_cast<std::size_t>(image.rows),
                 "all pixels are there");
    for (const std::uint32_t pixel : image.pixels) {
      fuzz::expect(pixel <= image.white, "no pixel is brighter than white");
    }
  });
  return 0;
}
