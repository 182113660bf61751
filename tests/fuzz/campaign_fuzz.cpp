// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as what an evaluation reads: words that call planners, settings, kept options.

#include <sstream>
#include <string>

#include "evaluation/options_json.h"
#include "fuzz/fuzz.h"
#include "support/yard.h"
#include "vandplan/evaluation.h"

using namespace vandplan;

/// Lines: planners called, then settings as NAME VALUE.
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScenarioFile yard = scenario_from_yaml(vandplan::yard(), "yard.yaml");
  const std::string text = fuzz::text_of(data, size);
  fuzz::may_refuse([&] { (void)evaluation::options_from_json(text); });
  std::istringstream lines(text);
  std::string word;
  std::getline(lines, word);
  fuzz::may_refuse([&] {
    evaluation::Campaign campaign{.scenarios = {{yard, "yard.yaml"}},
                                  .planners = evaluation::planners_called(word)};
    for (std::string name, value; lines >> name >> value;) {
      campaign.settings.push_back({name, value});
    }
    fuzz::expect(!evaluation::explain_runs(campaign).empty(), "a campaign has runs");
  });
  return 0;
}
