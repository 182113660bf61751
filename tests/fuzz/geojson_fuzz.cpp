// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a site.

#include <string>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  GeoJsonSite site{.file = fuzz::folder().put("site.geojson", fuzz::text_of(data, size)),
                   .vehicle = vehicle_named("tpcap-car")};
  fuzz::may_refuse([&] {
    const Scenario scenario = read_geojson(site).scenario;
    (void)make_problem(scenario);
    (void)scenario_from_yaml(to_yaml(scenario), "again.yaml");
  });
  site.is_in_metres = true;
  site.start = Pose{0, 0, 0};
  site.goal = Pose{9, 9, 1};
  fuzz::may_refuse([&] { (void)read_geojson(site); });
  return 0;
}
