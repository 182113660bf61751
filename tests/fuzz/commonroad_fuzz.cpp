// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a scenario of CommonRoad.

#include <string>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const CommonRoadCase one{.file = fuzz::folder().put("case.xml", fuzz::text_of(data, size))};
  fuzz::may_refuse([&] {
    const ScenarioFile file = read_commonroad(one).file;
    (void)make_problem(file.scenario);
    (void)scenario_from_yaml(to_yaml(file), "again.yaml");
    PlanResult result;
    result.path = Path{file.scenario.start, {Segment{0, 20, 0}}};
    (void)commonroad_solution(one, result);
  });
  return 0;
}
