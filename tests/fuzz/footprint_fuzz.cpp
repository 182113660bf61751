// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a footprint, and as a vehicle file.

#include <string>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string file = fuzz::folder().put("footprint.yaml", fuzz::text_of(data, size));
  fuzz::may_refuse([&] {
    const FootprintVehicle made =
        read_footprint({.file = file, .wheelbase = 0.2, .min_turning_radius = 0.3});
    const std::string again = fuzz::folder().put("vehicle.yaml", to_yaml(made.vehicle));
    fuzz::expect(read_vehicle(again) == made.vehicle, "a vehicle reads back exactly");
  });
  fuzz::may_refuse([&] { (void)read_vehicle(file); });
  return 0;
}
