// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a problem of dynobench.

#include <string>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string file = fuzz::folder().put("problem.yaml", fuzz::text_of(data, size));
  fuzz::may_refuse([&] {
    const Scenario scenario = read_dynobench(file, "tpcap-car");
    (void)make_problem(scenario);
    (void)scenario_from_yaml(to_yaml(scenario), "again.yaml");
  });
  return 0;
}
