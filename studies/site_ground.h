// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is a studied site made of: its world, its goals, and the tables to them?

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "vandplan/planner.h"
#include "vandplan/problem.h"
#include "vandplan/random.h"
#include "vandplan/site_table.h"

namespace vandplan::studies {

/// Resolutions of tables; the first one is the usual one.
struct Resolution {
  int headings;
  double cell;  ///< [turning radii]
};
inline constexpr std::array resolutions = {Resolution{36, 0.12}, Resolution{36, 0.25},
                                           Resolution{36, 0.5},  Resolution{18, 0.12},
                                           Resolution{18, 0.5},  Resolution{9, 1.0}};

/// Sets the option that runs are asked for, as KEY=VALUE, beside style `shortest` and arcs and
/// lines. Nothing is asked for by an empty text.
void ask(PlanOptions& options, const Planner& planner, const std::string& asked);

/// A site in the making: its world with a first problem, free goals, and its tables.
class SiteGround {
 public:
  /// Makes a table of each resolution, and one of the usual resolution for each of the options
  /// `asked` for. Throws InputError naming the site if it has no table.
  SiteGround(const std::string& name, const Scenario& scenario,
             const std::vector<std::string>& asked);

  /// Start and goal of a run: the first start is the scenario's, the others are random and free.
  [[nodiscard]] std::pair<Pose, Pose> ends(int number, Rng& rng) const;

  /// Problem from the scenario's start to the first goal.
  [[nodiscard]] const Problem& problem() const { return problem_; }
  [[nodiscard]] const SiteTable& table(std::size_t resolution) const { return tables_[resolution]; }
  [[nodiscard]] const SiteTable& table(const std::string& asked) const {
    return asked.empty() ? tables_.front() : asked_tables_.at(asked);
  }
  /// Size of a table to one goal [MB].
  [[nodiscard]] double megabytes(std::size_t resolution) const;

 private:
  Problem problem_;
  std::vector<Pose> goals_;
  std::vector<SiteTable> tables_;
  std::map<std::string, SiteTable> asked_tables_;
};

}  // namespace vandplan::studies
