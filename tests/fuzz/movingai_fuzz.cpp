// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any two texts, divided by a line of dashes, as a MovingAI map and its problems.

#include <string>

#include "fuzz/fuzz.h"
#include "vandplan/files.h"

using namespace vandplan;

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text = fuzz::text_of(data, size);
  const std::string divider = "\n---\n";
  const std::size_t middle = std::min(text.find(divider), text.size());
  const std::string problems = middle < text.size() ? text.substr(middle + divider.size()) : "";
  const std::string map = fuzz::folder().put("a.map", text.substr(0, middle));
  const std::string scen = fuzz::folder().put("a.map.scen", problems);
  for (const int number : {1, 2}) {
    fuzz::may_refuse([&] {
      const Scenario scenario = read_movingai({map, scen, number, 0.5});
      fuzz::expect(scenario.map.has_value(), "there is a map");
    });
  }
  return 0;
}
