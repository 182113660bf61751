// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Tables of small sites.

#include <memory>
#include <string>
#include <vector>

#include "vandplan/input_error.h"
#include "vandplan/planner.h"
#include "vandplan/site_table.h"

namespace vandplan::sites {

inline constexpr Bounds area{-40, 40, -40, 40};
inline const SiteTableOptions coarse{.headings = 24, .cell = 0.25};

inline PlanOptions drivers_options() { return complete(default_planner()); }

inline PlanOptions length_options() {
  return complete(default_planner(), {.style = Style::shortest});
}

inline SiteTable table_to(const Problem& problem, const PlanOptions& options,
                          const SiteTableOptions& table = coarse) {
  return make_site_table(problem, std::vector{problem.goal()}, options, table).value();
}

/// Options with a table of the site.
inline PlanOptions using_site(const SiteTable& table, PlanOptions options = {}) {
  options.site = std::make_shared<const SiteTable>(table);
  return options;
}

/// What a call refuses.
std::string refusal(const auto& call) {
  try {
    call();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no refusal";
}

}  // namespace vandplan::sites
