// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any words as options: the planner by its number in the first byte, then NAME=VALUE lines.

#include <string>

#include "evaluation/options_json.h"
#include "fuzz/fuzz.h"
#include "vandplan/planner.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const Planner& planner = planners()[data[0] % planners().size()];
  std::string rest = fuzz::text_of(data + 1, size - 1);
  PlanOptions options;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string line = rest.substr(0, end);
    rest.erase(0, end + 1);
    const std::size_t equals = std::min(line.find('='), line.size());
    const std::string value = equals < line.size() ? line.substr(equals + 1) : "";
    fuzz::may_refuse([&] {
      PlanOptions changed = options;
      set_option(changed, planner, line.substr(0, equals), value);
      options = changed;
    });
  }
  validate(options);      // what was taken is in range
  fuzz::may_refuse([&] {  // what does not go together
    const PlanOptions all = complete(planner, options);
    PlanOptions again = evaluation::options_from_json(evaluation::options_to_json(all));
    again.budget.seed = all.budget.seed;
    fuzz::expect(complete(planner, again) == all, "options read back as they were");
  });
  return 0;
}
