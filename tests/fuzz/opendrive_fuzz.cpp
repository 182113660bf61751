// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a map of OpenDRIVE.

#include <string>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  RoadMap map{.file = fuzz::folder().put("map.xodr", fuzz::text_of(data, size)),
              .vehicle = vehicle_named("tpcap-car"),
              .start = {5, -1.75, 0},
              .goal = {15, -1.75, 0}};
  fuzz::may_refuse([&] {
    const ScenarioFile file = read_opendrive(map).file;
    (void)make_problem(file.scenario);
    (void)scenario_from_yaml(to_yaml(file), "again.yaml");
  });
  map.rules = {.both_ways = true, .open_edges = true};
  fuzz::may_refuse([&] { (void)read_opendrive(map); });
  return 0;
}
