// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Which runs of a campaign belong to one of its shards, and what does its store say of
// itself?

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "evaluation/campaign.h"
#include "evaluation/run_record.h"

namespace vandplan::evaluation {

/// What a store says of itself that holds a shard of a campaign.
struct StoredShard {
  Shard shard;
  int runs = 0;          ///< that belong to it
  std::string campaign;  ///< what the whole campaign is made of, as a JSON object
  bool operator==(const StoredShard&) const = default;
};

/// "2/8".
[[nodiscard]] std::string text_of(const Shard& shard);

/// Whether no run of a campaign is limited by time: then every machine finds the same.
[[nodiscard]] bool is_repeatable(const Campaign& campaign);

/// Program and machine that runs of a campaign are kept under: of shards whose runs every machine
/// repeats the program alone, so that a shard may move to another machine half-way.
[[nodiscard]] Environment environment_of(const Campaign& campaign);

/// Tells which runs belong to the campaign's shard, by a hash of scenario, goal, planner, region,
/// options and seed; all of them when it has none.
class ShardFilter {
 public:
  explicit ShardFilter(const Campaign& campaign) : campaign_(campaign) {}
  [[nodiscard]] bool holds(const RunSpec& run);

 private:
  std::uint64_t hash_of_shared(const RunSpec& run);

  const Campaign& campaign_;
  /// A hash, and the options that it is of: as long as they are kept nobody else has their address.
  struct Known {
    std::uint64_t hash;
    SharedOptions options;
  };
  // What many runs share is hashed once.
  std::map<std::tuple<std::size_t, std::size_t, Region, const void*>, Known> known_;
};

/// What the store of the campaign's shard, with so many runs, says of itself.
[[nodiscard]] StoredShard stored_shard(const Campaign& campaign, int runs);

/// The first thing in which two campaigns differ, as "max_iterations: 100, not 200"; empty if there
/// is none.
[[nodiscard]] std::string difference(const std::string& campaign, const std::string& other);

}  // namespace vandplan::evaluation
