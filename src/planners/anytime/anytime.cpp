// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/anytime.h"

#include "planners/anytime/run.h"
#include "vandplan/search.h"

namespace vandplan::anytime {
namespace {

Run begin(const Task& task, const PlanOptions& options, double time_price, const Given& given) {
  const search::Budget budget(options.budget);
  return {compose(task, options, time_price, given), budget, options.budget};
}

class RunSearch final : public planning::PathSearch {
 public:
  explicit RunSearch(Run run) : run_(std::move(run)) {}

  bool advance(std::int64_t most) override {
    run_.pause_after(most);
    return run_.advance();
  }
  [[nodiscard]] std::optional<std::vector<Segment>> path() override { return run_.path(); }
  [[nodiscard]] std::int64_t iterations() const override { return run_.iterations(); }
  [[nodiscard]] PlannerAnswer answer() override { return run_.answer(); }
  [[nodiscard]] planning::LeastLength least_length() const override { return run_.least_length(); }

 private:
  Run run_;
};

}  // namespace

PlannerAnswer plan_anytime(const Task& task, const PlanOptions& options, const Given& given) {
  Run run = begin(task, options, 0.0, given);
  while (run.advance()) {
  }
  return run.answer();
}

std::unique_ptr<planning::PathSearch> drive_search(const Task& task, const PlanOptions& options,
                                                   double time_price, const Given& given) {
  return std::make_unique<RunSearch>(begin(task, options, time_price, given));
}

}  // namespace vandplan::anytime
