// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "planners/anytime/adapt.h"

#include <utility>

namespace vandplan::anytime {
namespace {

constexpr std::size_t most_relaxed_paths = 4;
constexpr int most_repairs = 40;

}  // namespace

Adapter::Adapter(const Task& task, const CostRule& rule, std::uint64_t seed)
    : task_(task), connector_(task, rule), seed_(seed) {}

void Adapter::offer(const Route& relaxed) {
  if (!kinds_.is_new(relaxed, connector_.radius())) return;
  if (waiting_.size() == most_relaxed_paths) waiting_.erase(waiting_.begin());
  waiting_.push_back(path_of(relaxed));
}

void Adapter::begin() {
  path_ = std::move(waiting_.back());
  waiting_.pop_back();
  chain_.emplace(task_, connector_, path_, stream_seed(seed_, begun_++));
  trials_ = 0;
  if (!chain_->take_over()) chain_.reset();
}

bool Adapter::step() {
  if (!chain_) {
    if (waiting_.empty()) return false;
    begin();
  } else {
    chain_->repair();
    ++trials_;
  }
  if (!chain_) return false;
  if (!chain_->is_free()) {
    if (trials_ == most_repairs) chain_.reset();
    return false;
  }
  route_ = chain_->route();
  chain_.reset();
  return true;
}

}  // namespace vandplan::anytime
