// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/rig/improver.h"

#include <utility>

#include "vandplan/random.h"

namespace vandplan::rig {
namespace {

/// Trials between two checks whether a drive may become the best one.
constexpr std::int64_t trials_of_check = 128;
/// A drive is hopeless if so many times its last gain would not make it the best one.
constexpr double hope = 6.0;

}  // namespace

Improver::Improver(const Setting& setting, const anytime::Drive& drive, std::uint64_t seed)
    : setting_(setting), seed_(seed), wheels_(drive.wheels) {
  drive_.emplace(setting.wheels[wheels_], setting.pricing.rule(), drive.commands,
                 stream_seed(seed_, wheels_), setting.pricing.measure());
  before_ = drive_->cost();
}

bool Improver::step(double best) {
  if (drive_->is_stalled()) return soften();
  (void)drive_->step();
  if (setting_.pricing.counts_time() || drive_->trials() % trials_of_check != 0) return true;
  const double gain = before_ - drive_->cost();
  before_ = drive_->cost();
  return before_ - hope * gain <= best;
}

// Bends the drive for the next softer wheels. False if there are none or they cannot follow.
bool Improver::soften() {
  if (wheels_ + 1 == setting_.wheels.size()) return false;
  const Task& task = setting_.wheels[wheels_ + 1];
  const auto commands = commands::obeyed(task, drive_->commands());
  if (!commands) return false;
  checks_ += drive_->checks();
  drive_.emplace(task, setting_.pricing.rule(), *commands, stream_seed(seed_, ++wheels_),
                 setting_.pricing.measure());
  return true;
}

anytime::Drive Improver::drive() const {
  return {.commands = drive_->commands(),
          .segments = drive_->segments(),
          .cost = drive_->cost(),
          .wheels = wheels_};
}

}  // namespace vandplan::rig
