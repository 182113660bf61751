// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors

// How do I add a source of paths of my own to the default planner? This one proposes the path of
// yesterday.

#include <vandplan/planner.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

namespace {

using namespace vandplan;

/// A source that proposes one path, and prints each best path that it hears of.
class Yesterday final : public PathSource {
 public:
  explicit Yesterday(LocalPath path) : path_(std::move(path)) {}

  std::optional<LocalPath> propose() override { return std::exchange(path_, std::nullopt); }
  [[nodiscard]] bool has_work() const override { return path_.has_value(); }
  void hear(const LocalPath& best, double cost) override {
    std::printf("  best so far: %.2f m, %zu segments\n", cost, best.segments.size());
  }

 private:
  std::optional<LocalPath> path_;
};

}  // namespace

int main() {
  Scenario yard;
  yard.bounds = {-30, 60, -40, 40};
  yard.goal = {40, 0, 0};
  yard.obstacles = {{{15, -20}, {17, -20}, {17, 20}, {15, 20}}};
  PlanOptions options;
  options.budget.max_iterations = 20'000;
  const PlanResult yesterday = plan(yard, options);
  if (!yesterday.path) return 1;
  std::printf("yesterday: %.2f m\n", yesterday.cost);

  // Today the goal has moved a little, and there is hardly any time.
  yard.goal = {40, 1, 0.1};
  options.budget.max_iterations = 150;
  const Problem today = make_problem(yard);
  const auto make = [path = *yesterday.path](const Task& task, const PlanOptions&) {
    return std::make_unique<Yesterday>(LocalPath{to_local(*task.world, path.start), path.segments});
  };
  const PlanResult with = plan(today, with_sources({{.name = "yesterday", .make = make}}), options);
  const PlanResult without = plan(today, options);
  std::printf("today with it: %.2f m, without it: %.2f m\n", with.cost, without.cost);
  return with.path && (!without.path || with.cost <= without.cost) ? 0 : 1;
}
