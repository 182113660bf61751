// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/shared_options.h"

namespace vandplan::planning {

OptionInfo region_option() {
  return {.name = "region",
          .summary = "where samples are drawn",
          .standard = std::string("bounds"),
          .words = {"bounds", "scene"}};
}

Region region_of(const PlanOptions& options) {
  return options.planner.word("region") == "scene" ? Region::scene : Region::bounds;
}

}  // namespace vandplan::planning
