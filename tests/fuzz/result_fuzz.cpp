// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a result file, of one result or of many; what can be read is judged.

#include <string>

#include "fuzz/judged.h"
#include "support/yard.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScenarioFile yard = scenario_from_yaml(
      replaced(vandplan::yard(), "{x: 20, y: 5, heading: 0}", "{x: 1, y: 0.1, heading: 0.1}"),
      "yard.yaml");
  static const Problem problem = make_problem(yard.scenario);
  const std::string file = fuzz::folder().put("result.json", fuzz::text_of(data, size));
  fuzz::may_refuse([&] {
    for (const ResultRecord& record : read_results(file, yard)) fuzz::look_at(problem, record);
  });
  fuzz::may_refuse([&] {
    ResultReader reader(file, yard);
    if (!reader.has_pairs()) return;
    while (const std::optional<PairRecord> pair = reader.next())
      fuzz::look_at(problem, pair->record);
  });
  return 0;
}
