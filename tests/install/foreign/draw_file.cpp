// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
//
// Reads a scenario and draws it, with installed headers only.
#include <vandplan/draw.h>
#include <vandplan/files.h>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  const vandplan::Scenario scenario = vandplan::read_scenario(argv[1]);
  const vandplan::Drawing drawing{.scenario = &scenario, .caption = scenario.name};
  vandplan::write_file(argv[2], vandplan::draw(drawing, vandplan::picture_format(argv[2]), 400));
}
