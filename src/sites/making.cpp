// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Tables of sites are made, and repaired where the site changes.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "sites/data.h"
#include "sites/field.h"
#include "sites/ground_changes.h"
#include "sites/key.h"
#include "sites/site.h"
#include "sites/way.h"
#include "vandplan/input_error.h"
#include "vandplan/site_table.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using sites::GroundChange, sites::SeenGround, sites::Site, sites::SiteField, sites::SiteLayer;

/// The table of these numbers.
SiteTable table_of(const sites::SiteKey& key, const sites::SiteGrid& grid,
                   const std::vector<SiteLayer>& layers,
                   std::span<const std::string_view> numbers) {
  const auto bytes =
      std::make_shared<const std::string>(sites::site_to_bytes(key, grid, layers, numbers));
  return site_table_from_bytes(*bytes, bytes, "site");
}

/// Calls `work(i)` for each goal until `is_over`, and tells of it. False if it was over early.
bool for_goals(std::size_t count, const SiteTableOptions& table,
               const std::function<bool()>& is_over, const std::function<void(std::size_t)>& work) {
  parallel_in_order(
      count, table.threads,
      [&](std::size_t i) {
        if (!is_over()) work(i);
      },
      [&](std::size_t i) {
        if (table.progress) table.progress(i + 1);
      });
  return !is_over();
}

}  // namespace

std::optional<SiteTable> make_site_table(const Problem& problem, std::span<const Pose> goals,
                                         const PlanOptions& options,
                                         const SiteTableOptions& table) {
  const Site site = sites::site_of(problem, goals, options, table);
  std::vector<SiteLayer> layers;
  for (const Pose& goal : goals) layers.push_back({.goal = goal});
  std::vector<std::string> numbers(goals.size());
  const auto is_over = [&table] { return table.stop.stop_requested(); };
  const bool is_made = for_goals(goals.size(), table, is_over, [&](std::size_t i) {
    SiteField field(site.grid, site.box, site.tasks[i], options);
    if (field.spread(is_over)) field.write(numbers[i], layers[i]);
  });
  if (!is_made) return std::nullopt;
  const std::vector<std::string_view> views(numbers.begin(), numbers.end());
  return table_of(sites::site_key(*problem.world(), problem.vehicle(), options), site.grid, layers,
                  views);
}

SiteTable SiteTable::with_goals(std::span<const Pose> goals) const {
  sites::require(!goals.empty(), "goals", "at least one");
  if (std::equal(goals.begin(), goals.end(), goals_.begin(), goals_.end())) return *this;
  std::vector<SiteLayer> layers;
  std::vector<std::string_view> numbers;
  for (std::size_t i = 0; i < goals.size(); ++i) {
    expect_goal(goals[i], sites::place_in("goals", i));
    layers.push_back(data_->layers[*sites::number_of(goals_, goals[i])]);
    numbers.push_back(data_->numbers(layers.back()));
  }
  return table_of(data_->key, data_->grid, layers, numbers);
}

// ---- sites that change ----

class ChangingSiteTable::Impl {
 public:
  Impl(const Problem& problem, std::span<const Pose> goals, const PlanOptions& options,
       const SiteTableOptions& table)
      : options_(options),
        wanted_(table),
        vehicle_(sites::site_key(*problem.world(), problem.vehicle(), options).vehicle),
        seen_(*problem.world()),
        goals_(goals.begin(), goals.end()) {
    begin_anew(problem);
    const auto is_over = [stop = table.stop] { return stop.stop_requested(); };
    if (!bring_up_to_date(problem, all_goals(), is_over)) {
      throw InputError("stop", "the table was stopped before it was whole");
    }
    wanted_.stop = {};
    wanted_.progress = {};
  }

  bool repair(const Problem& problem, std::span<const std::size_t> goals,
              const std::function<bool()>& is_over) {
    const sites::SiteKey key = sites::site_key(*problem.world(), problem.vehicle(), options_);
    if (key.vehicle != vehicle_ || !problem.task().moving.empty()) {
      throw InputError("problem", "expected the vehicle of the table, and no moving obstacles");
    }
    for (const std::size_t goal : goals) {
      sites::require(goal < goals_.size(), "goals", "numbers of goals of the table");
    }
    if (const auto changes = seen_.look(*problem.world())) {
      for (Ways& ways : ways_) ways.take(*changes);
    } else {
      begin_anew(problem);
    }
    std::vector<std::size_t> each(goals.begin(), goals.end());  // once, as threads share them
    std::ranges::sort(each);
    each.erase(std::unique(each.begin(), each.end()), each.end());
    return bring_up_to_date(problem, each, is_over);
  }

  void repair(const Problem& problem) {
    (void)repair(problem, all_goals(), [] { return false; });
  }

  [[nodiscard]] const SiteTable& table() const noexcept { return *table_; }
  [[nodiscard]] const Point& origin() const noexcept { return seen_.origin(); }

 private:
  /// Ways to one goal.
  struct Ways {
    SiteLayer layer = {};
    std::unique_ptr<SiteField> field = {};   // null until it is needed
    std::vector<GroundChange> changes = {};  // since the field last looked at its ground
    bool is_current = false;                 // whether the numbers are those of the ground
    std::string numbers = {};

    void take(const std::vector<GroundChange>& more) {
      if (more.empty() || !field) return;
      changes.insert(changes.end(), more.begin(), more.end());
      is_current = false;
    }
  };

  [[nodiscard]] std::vector<std::size_t> all_goals() const {
    std::vector<std::size_t> all(goals_.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    return all;
  }

  /// Forgets all ways, as the ground differs in what concerns all places.
  void begin_anew(const Problem& problem) {
    Site site = sites::site_of(problem, goals_, options_, wanted_);
    seen_ = SeenGround(*problem.world());
    grid_ = site.grid;
    box_ = site.box;
    ways_.clear();
    for (const Pose& goal : goals_) ways_.push_back({.layer = {.goal = goal}});
  }

  bool bring_up_to_date(const Problem& problem, std::span<const std::size_t> goals,
                        const std::function<bool()>& is_over) {
    const bool is_whole = for_goals(goals.size(), wanted_, is_over,
                                    [&](std::size_t i) { renew(problem, goals[i], is_over); });
    const auto is_current = [this](std::size_t i) { return ways_[i].is_current; };
    if (!is_whole && !std::all_of(goals.begin(), goals.end(), is_current)) return false;
    show(problem);
    return true;
  }

  void renew(const Problem& problem, std::size_t goal, const std::function<bool()>& is_over) {
    Ways& ways = ways_[goal];
    if (ways.is_current) return;
    if (!ways.field) {
      const Task task = sites::task_to(problem, goals_[goal], goal, options_);
      ways.field = std::make_unique<SiteField>(grid_, box_, task, options_);
    } else if (!ways.changes.empty()) {
      const Task task = sites::task_to(problem, goals_[goal], goal, options_);
      ways.field->renew(task, ways.changes);
      ways.changes.clear();
    }
    if (!ways.field->spread(is_over)) return;
    ways.field->write(ways.numbers, ways.layer);
    ways.is_current = true;
  }

  /// Makes the table of the ways that are those of the problem's world.
  void show(const Problem& problem) {
    const std::string none = sites::empty_numbers(grid_);
    std::vector<SiteLayer> layers;
    std::vector<std::string_view> numbers;
    for (const Ways& ways : ways_) {
      layers.push_back(ways.is_current ? ways.layer : SiteLayer{.goal = ways.layer.goal});
      numbers.push_back(ways.is_current ? ways.numbers : none);
    }
    table_ = table_of(sites::site_key(*problem.world(), problem.vehicle(), options_), grid_, layers,
                      numbers);
  }

  PlanOptions options_;
  SiteTableOptions wanted_;
  std::uint64_t vehicle_;  // fingerprint
  SeenGround seen_;
  std::vector<Pose> goals_;
  sites::SiteGrid grid_;
  Bounds box_;
  std::vector<Ways> ways_;
  std::optional<SiteTable> table_;
};

ChangingSiteTable::ChangingSiteTable(const Problem& problem, std::span<const Pose> goals,
                                     const PlanOptions& options, const SiteTableOptions& table)
    : impl_(std::make_unique<Impl>(problem, goals, options, table)) {}

ChangingSiteTable::~ChangingSiteTable() = default;
ChangingSiteTable::ChangingSiteTable(ChangingSiteTable&&) noexcept = default;
ChangingSiteTable& ChangingSiteTable::operator=(ChangingSiteTable&&) noexcept = default;

void ChangingSiteTable::repair(const Problem& problem) { impl_->repair(problem); }

void ChangingSiteTable::repair(const Scenario& scenario) {
  const auto world = std::make_shared<const World>(surroundings(scenario), origin());
  const Problem problem = make_problem(world, scenario.vehicle, scenario.start, scenario.start);
  impl_->repair(with_moving(problem, scenario.moving));
}

bool ChangingSiteTable::repair(const Problem& problem, std::span<const std::size_t> goals,
                               const std::function<bool()>& is_over) {
  return impl_->repair(problem, goals, is_over);
}

const SiteTable& ChangingSiteTable::table() const noexcept { return impl_->table(); }

Point ChangingSiteTable::origin() const noexcept { return impl_->origin(); }

}  // namespace vandplan
