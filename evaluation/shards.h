// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Which runs belong to a shard of a campaign, and how does a store describe its shard?

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <tuple>

#include "evaluation/campaign.h"
#include "evaluation/run_record.h"

namespace vandplan::evaluation {

/// Description of the shard that a store holds.
struct StoredShard {
  Shard shard;
  int runs = 0;          ///< number of runs that belong to the shard
  std::string campaign;  ///< contents of the whole campaign, as a JSON object
  bool operator==(const StoredShard&) const = default;
};

/// Text of a shard: "2/8".
[[nodiscard]] std::string text_of(const Shard& shard);

/// Whether no run of a campaign has a time limit, so that every machine finds the same.
[[nodiscard]] bool is_repeatable(const Campaign& campaign);

/// Environment under which runs of a campaign are stored. For shards whose runs every machine
/// repeats it names the program alone, so that a shard may move to another machine.
[[nodiscard]] Environment environment_of(const Campaign& campaign);

/// Decides which runs belong to the campaign's shard, by a hash of scenario, goal, planner, region,
/// options and seed. Without a shard all runs belong.
class ShardFilter {
 public:
  explicit ShardFilter(const Campaign& campaign) : campaign_(campaign) {}
  [[nodiscard]] bool holds(const RunSpec& run);

 private:
  std::uint64_t hash_of_shared(const RunSpec& run);

  const Campaign& campaign_;
  /// Hash with its options. They are kept so that no other options get the same address.
  struct Known {
    std::uint64_t hash;
    SharedOptions options;
  };
  // Hashes of what many runs share: scenario, planner, region and options.
  std::map<std::tuple<std::size_t, std::size_t, Region, const void*>, Known> known_;
};

/// Description of the campaign's shard, which has `runs` runs.
[[nodiscard]] StoredShard stored_shard(const Campaign& campaign, int runs);

/// First difference of two campaigns, such as "max_iterations: 100, not 200"; empty if there is
/// none.
[[nodiscard]] std::string difference(const std::string& campaign, const std::string& other);

}  // namespace vandplan::evaluation
