// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "replanning/known_site.h"

#include <numeric>
#include <string>
#include <utility>

#include "base/decimal.h"
#include "sites/data.h"
#include "sites/key.h"
#include "sites/way.h"
#include "vandplan/input_error.h"

namespace vandplan::replanning {
namespace {

/// The table for the same ground in a world whose frame has that origin.
SiteTable in_frame(const SiteTable& table, const sites::SiteKey& key, const Point& origin) {
  auto data = std::make_shared<sites::SiteData>(table.data());
  data->key = key;
  data->grid.corner.x = base::moved(data->grid.corner.x, -origin.x);
  data->grid.corner.y = base::moved(data->grid.corner.y, -origin.y);
  for (sites::SiteLayer& layer : data->layers) {
    layer.goal.x = base::moved(layer.goal.x, -origin.x);
    layer.goal.y = base::moved(layer.goal.y, -origin.y);
  }
  return SiteTable(std::move(data));
}

}  // namespace

KnownSite::KnownSite(std::shared_ptr<ChangingSiteTable> table, const Scenario& scenario,
                     const PlanOptions& options)
    : table_(std::move(table)),
      vehicle_(scenario.vehicle),
      start_(scenario.start),
      options_(options),
      ground_(surroundings(scenario), table_->origin()) {
  vehicle_.trailer.reset();  // a table is that of the tractor alone
  const sites::SiteKey& made_for = table_->table().data().key;
  sites::SiteKey wanted = sites::site_key(*ground_.world(), vehicle_, options_);
  wanted.world = made_for.world;  // a repair sees to it
  sites::expect_equal(made_for, wanted);
}

/// Numbers of the goals whose ways are needed; none if the table lacks the only goal.
std::vector<std::size_t> KnownSite::goals_of(const Problem& problem, bool has_vias) const {
  const std::vector<Pose>& goals = table_->table().goals();
  if (!has_vias && problem.goal_set().empty()) {
    const auto goal = sites::number_of(goals, problem.goal());
    return goal ? std::vector{*goal} : std::vector<std::size_t>{};
  }
  std::vector<std::size_t> all(goals.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  return all;
}

/// Makes the ways to some goals those of the ground. False if that is not possible until `end`.
bool KnownSite::is_repaired(const std::vector<std::size_t>& goals, const Deadline& end) {
  reason_ = "the time was over before the table of the site was repaired";
  try {
    const Problem here = make_problem(ground_.world(), vehicle_, start_, start_);
    return table_->repair(here, goals, [&end] { return end.is_over(); });
  } catch (const InputError& error) {
    reason_ = std::string("the table of the site cannot be repaired: ") + error.what();
  }
  return false;
}

std::shared_ptr<const SiteTable> KnownSite::to_goals_of(const Problem& problem, bool has_vias,
                                                        const KnownGround& local,
                                                        const Deadline& end) {
  const std::vector<std::size_t> goals = goals_of(problem, has_vias);
  if (local_ && goals == goals_ && version_ == ground_.version()) return local_;
  local_.reset();
  reason_ = "the table of the site has no such goal";
  if (goals.empty()) return nullptr;
  if (!is_repaired(goals, end)) return nullptr;
  const sites::SiteKey key = sites::site_key(*local.world(), vehicle_, options_);
  local_ = std::make_shared<const SiteTable>(in_frame(table_->table(), key, local.origin()));
  goals_ = goals;
  version_ = ground_.version();
  reason_.clear();
  return local_;
}

}  // namespace vandplan::replanning
