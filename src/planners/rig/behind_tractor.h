// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a rig follow a path that was planned for its tractor alone?
//
// Method: docs/algorithms/trailers.md.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "planners/path_search.h"
#include "planners/rig/chain_source.h"

namespace vandplan::rig {

/// A path of the tractor, and what the trailer does behind it.
class Follower;

/// Plans paths of the tractor alone, one after the other, and follows each. The first one is the
/// way of a table of the site, if there is one. Where the rig cannot
/// follow, searches replace parts of the path.
class BehindTractor final : public ChainSource {
 public:
  /// `first_work`: most iterations of planning the first path, and most expansions of following it.
  BehindTractor(std::shared_ptr<const Setting> setting, std::int64_t first_work,
                std::uint64_t seed);
  ~BehindTractor() override;
  BehindTractor(const BehindTractor&) = delete;

  [[nodiscard]] anytime::Found work(std::int64_t most, const search::Budget& budget) override;
  [[nodiscard]] anytime::Counts counts() const override { return counts_; }

 private:
  void begin(const search::Budget& budget);
  bool follow_table();
  void follow_way(std::span<const Segment> way, AllowedGears gears);
  std::int64_t plan(std::int64_t most);
  [[nodiscard]] std::optional<anytime::Drive> follow();

  std::shared_ptr<const Setting> setting_;
  std::int64_t most_work_;
  std::uint64_t seed_;
  bool has_asked_table_ = false;                // whether the way of the table was looked for
  bool has_led_to_drive_ = false;               // whether the last path led to a drive of the rig
  std::size_t paths_ = 0;                       // paths begun so far
  std::int64_t work_left_ = 0;                  // work left for the path, or for following it
  std::optional<Task> alone_;                   // task of the tractor
  PlanOptions options_;                         // options of the path at hand
  std::unique_ptr<planning::PathSearch> path_;  // plans the path; null while none is planned
  std::unique_ptr<Follower> follower_;          // follows the path; null while none is followed
  anytime::Counts counts_;
};

}  // namespace vandplan::rig
