// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any text as a scenario file: refused, or kept word for word by writing and reading it.

#include <string>

#include "fuzz/fuzz.h"
#include "io/document.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  fuzz::may_refuse([&] {
    const io::Document quick = io::parse_yaml(text, "fuzz.yaml");
    fuzz::expect(quick.root() == io::parse_yaml_slowly(text, "fuzz.yaml").root(),
                 "lists of numbers mean the same whoever reads them");
  });
  fuzz::may_refuse([&] {
    const ScenarioFile file = scenario_from_yaml(text, "fuzz.yaml");
    if (!file.scenario.map) (void)make_problems(file);
    const std::string written = to_yaml(file);
    const ScenarioFile again = scenario_from_yaml(written, "again.yaml", file.scenario.map);
    fuzz::expect(to_yaml(again) == written, "what is written reads back");
  });
  return 0;
}
