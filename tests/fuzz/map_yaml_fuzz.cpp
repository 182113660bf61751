// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a map file beside an image of 3 x 2 pixels.

#include <string>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const std::string image =
      fuzz::folder().put("m.pgm", std::string("P5 3 2 255\n") + "\xFF\xCD\x80\x01\xFE\x20");
  const std::string file = fuzz::folder().put("map.yaml", fuzz::text_of(data, size));
  fuzz::may_refuse([&] { (void)is_map(file); });
  fuzz::may_refuse([&] {
    const OccupancyGrid grid = read_map(file);
    fuzz::expect(grid.cells->size() == 6, "all cells are there");
    check_map(grid);
  });
  return 0;
}
