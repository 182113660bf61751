// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which questions does one world answer?

#include <memory>

#include "bindings/web/core/site.h"
#include "bindings/web/core/values.h"
#include "vandplan/motion.h"

namespace vandplan::web {

/// Rows t, s, x, y, heading, curvature, v of the fastest drive, at most `step` seconds apart.
[[nodiscard]] val rows_of_drive(const Path& path, const Vehicle& vehicle,
                                const SpeedOptions& options, double step);

/// Scenario whose world is built once. Start, goal and vehicle may differ in each query.
class Yard {
 public:
  explicit Yard(const val& scenario);

  /// Plans with {planner, options, warm_start}, and {start, goal, via, vehicle} if they are given.
  [[nodiscard]] val plan(const val& query);

  /// Checks a path with the judge: {path, margin, margin_ramp, steering, gears, start, goal, via,
  /// vehicle}.
  [[nodiscard]] val check(const val& query) const;

  /// `rows_of_drive` of a path, with the speeds of zones and masks and the stops of vias: {path,
  /// step, start, goal, via, vehicle}.
  [[nodiscard]] val drive(const val& query) const;

  /// Whether vehicle and trailer are free at a pose and keep the margin: {pose, vehicle, margin}.
  [[nodiscard]] val is_free(const val& query) const;

  /// Bytes of a table of the site: {goals, vehicle, options, headings, cell}. `progress` is called
  /// with the number of goals that are done, or is undefined.
  [[nodiscard]] val site_table(const val& query, const val& progress) const;

  /// Such a table, which can be repaired.
  [[nodiscard]] ChangingSiteTable changing_site_table(const val& query, const val& progress) const;

 private:
  [[nodiscard]] Problem problem_of(const val& query) const;
  [[nodiscard]] Problem site_problem_of(const val& query) const;

  Scenario scenario_;
  Problem problem_;
  std::shared_ptr<const World> world_;
  SiteReader site_;
};

}  // namespace vandplan::web
