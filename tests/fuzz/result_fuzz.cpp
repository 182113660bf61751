// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a result file, of one result or of many; what can be read is judged.

#include <string>

#include "fuzz/fuzz.h"
#include "support/yard.h"
#include "vandplan/path_check.h"
#include "vandplan/result_file.h"
#include "vandplan/scenario_file.h"

using namespace vandplan;

namespace {

/// Short enough for the judge to walk it at once [m].
constexpr double longest = 1000;

void look_at(const Problem& problem, const ResultRecord& record) {
  if (!record.result.path || !(length(*record.result.path) < longest)) return;
  const PathCheck check = check_path(problem, *record.result.path, record.claims);
  fuzz::expect(check.valid == check.reason.empty(), "a verdict has a reason, or needs none");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScenarioFile yard = scenario_from_yaml(
      replaced(vandplan::yard(), "{x: 20, y: 5, heading: 0}", "{x: 1, y: 0.1, heading: 0.1}"),
      "yard.yaml");
  static const Problem problem = make_problem(yard.scenario);
  const std::string file = fuzz::folder().put("result.json", fuzz::text_of(data, size));
  fuzz::may_refuse([&] {
    for (const ResultRecord& record : read_results(file, yard)) look_at(problem, record);
  });
  fuzz::may_refuse([&] {
    ResultReader reader(file, yard);
    if (!reader.has_pairs()) return;
    while (const std::optional<PairRecord> pair = reader.next()) look_at(problem, pair->record);
  });
  return 0;
}
