// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any bytes as a grey map.

#include "fuzz/image.h"
#include "io/pgm.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::may_refuse([&] {
    fuzz::expect_an_image(false, [&](const io::TakeRow& take_row) {
      io::FileReader file(fuzz::text_of(data, size), "fuzz.pgm");
      io::read_pgm(file, take_row);
    });
  });
  return 0;
}
