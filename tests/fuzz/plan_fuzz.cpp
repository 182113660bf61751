// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any scenario that the reader accepts is planned, and a second judge looks at the path.

#include <string>

#include "fuzz/fuzz.h"
#include "nasty/naive_judge.h"
#include "vandplan/files.h"
#include "vandplan/planner.h"

using namespace vandplan;

namespace {

void plan_and_judge(const Scenario& scenario, const Planner& planner, std::int64_t iterations) {
  PlanOptions options;
  options.budget.max_iterations = iterations;
  if (honours(planner, "max_nodes")) options.planner.set("max_nodes", std::int64_t{200});
  const PlanResult result = plan(make_problem(scenario), planner, options);
  fuzz::expect(result.status != PlanStatus::rejected, planner.name + ": " + result.reason);
  if (!result.path) return;
  const std::string flaw = nasty::naive_flaw(scenario, *result.path);
  fuzz::expect(flaw.empty(), planner.name + ", says the naive judge: " + flaw);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  const std::size_t choice = size;
  fuzz::may_refuse([&] {
    const ScenarioFile file = scenario_from_yaml(text, "fuzz.yaml");
    const Scenario scenario = scenario_at(file, choice % file.size());
    plan_and_judge(scenario, default_planner(), 64);
    plan_and_judge(scenario, planners()[choice % planners().size()], 30);
  });
  return 0;
}
