// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// Tables of sites are made, and repaired where the site changes.
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "sites/data.h"
#include "sites/field.h"
#include "sites/ground_changes.h"
#include "sites/key.h"
#include "sites/site.h"
#include "vandplan/input_error.h"
#include "vandplan/site_table.h"
#include "vandplan/vehicle.h"

namespace vandplan {
namespace {

using sites::GroundChange, sites::SeenGround, sites::Site, sites::SiteField, sites::SiteLayer;

std::vector<SiteLayer> empty_layers(std::span<const Pose> goals) {
  std::vector<SiteLayer> layers;
  for (const Pose& goal : goals) layers.push_back({.goal = goal});
  return layers;
}

/// The table of these numbers, for the world of a problem.
SiteTable table_of(const Problem& problem, const PlanOptions& options, const sites::SiteGrid& grid,
                   const std::vector<SiteLayer>& layers, const std::vector<std::string>& numbers) {
  const sites::SiteKey key = sites::site_key(*problem.world(), problem.vehicle(), options);
  const auto bytes =
      std::make_shared<const std::string>(sites::site_to_bytes(key, grid, layers, numbers));
  return site_table_from_bytes(*bytes, bytes, "site");
}

/// Calls `work(i)` for each goal, and tells of it. False if the work was stopped.
bool for_goals(std::size_t count, const SiteTableOptions& table,
               const std::function<void(std::size_t)>& work) {
  parallel_in_order(
      count, table.threads,
      [&](std::size_t i) {
        if (!table.stop.stop_requested()) work(i);
      },
      [&](std::size_t i) {
        if (table.progress) table.progress(i + 1);
      });
  return !table.stop.stop_requested();
}

}  // namespace

std::optional<SiteTable> make_site_table(const Problem& problem, std::span<const Pose> goals,
                                         const PlanOptions& options,
                                         const SiteTableOptions& table) {
  const Site site = sites::site_of(problem, goals, options, table);
  std::vector<SiteLayer> layers = empty_layers(goals);
  std::vector<std::string> numbers(goals.size());
  const bool is_made = for_goals(goals.size(), table, [&](std::size_t i) {
    SiteField field(site.grid, site.box, site.tasks[i], options);
    if (field.spread(table.stop)) field.write(numbers[i], layers[i]);
  });
  if (!is_made) return std::nullopt;
  return table_of(problem, options, site.grid, layers, numbers);
}

// ---- sites that change ----

class ChangingSiteTable::Impl {
 public:
  Impl(const Problem& problem, std::vector<Pose> goals, const PlanOptions& options,
       const SiteTableOptions& table)
      : goals_(std::move(goals)),
        options_(options),
        wanted_(table),
        vehicle_(problem.vehicle()),
        seen_(*problem.world()) {
    make(problem);
    wanted_.stop = {};  // a repair is done as a whole
    wanted_.progress = {};
  }

  void repair(const Problem& problem) {
    if (!(problem.vehicle() == vehicle_) || !problem.task().moving.empty()) {
      throw InputError("problem", "expected the vehicle of the table, and no moving obstacles");
    }
    const auto changes = seen_.look(*problem.world());
    if (!changes) return make(problem);
    std::vector<Task> tasks;
    for (std::size_t i = 0; i < goals_.size(); ++i) {
      tasks.push_back(sites::task_to(problem, goals_[i], i, options_));
    }
    update(problem, [&](std::size_t i) { fields_[i]->renew(tasks[i], *changes); });
  }

  [[nodiscard]] const SiteTable& table() const noexcept { return *table_; }

 private:
  void make(const Problem& problem) {
    Site site = sites::site_of(problem, goals_, options_, wanted_);
    seen_ = SeenGround(*problem.world());
    grid_ = site.grid;
    layers_ = empty_layers(goals_);
    numbers_.assign(goals_.size(), {});
    fields_.clear();
    fields_.resize(goals_.size());
    update(problem, [&](std::size_t i) {
      fields_[i] = std::make_unique<SiteField>(grid_, site.box, site.tasks[i], options_);
    });
  }

  void update(const Problem& problem, const std::function<void(std::size_t)>& renew) {
    const bool is_made = for_goals(goals_.size(), wanted_, [&](std::size_t i) {
      renew(i);
      if (fields_[i]->spread(wanted_.stop)) fields_[i]->write(numbers_[i], layers_[i]);
    });
    if (!is_made) throw InputError("stop", "the table was stopped before it was whole");
    table_ = table_of(problem, options_, grid_, layers_, numbers_);
  }

  std::vector<Pose> goals_;
  PlanOptions options_;
  SiteTableOptions wanted_;
  Vehicle vehicle_;
  SeenGround seen_;
  sites::SiteGrid grid_;
  std::vector<std::unique_ptr<SiteField>> fields_;
  std::vector<SiteLayer> layers_;
  std::vector<std::string> numbers_;
  std::optional<SiteTable> table_;
};

ChangingSiteTable::ChangingSiteTable(const Problem& problem, std::span<const Pose> goals,
                                     const PlanOptions& options, const SiteTableOptions& table)
    : impl_(std::make_unique<Impl>(problem, std::vector<Pose>(goals.begin(), goals.end()), options,
                                   table)) {}

ChangingSiteTable::~ChangingSiteTable() = default;
ChangingSiteTable::ChangingSiteTable(ChangingSiteTable&&) noexcept = default;
ChangingSiteTable& ChangingSiteTable::operator=(ChangingSiteTable&&) noexcept = default;

void ChangingSiteTable::repair(const Problem& problem) { impl_->repair(problem); }

const SiteTable& ChangingSiteTable::table() const noexcept { return impl_->table(); }

}  // namespace vandplan
