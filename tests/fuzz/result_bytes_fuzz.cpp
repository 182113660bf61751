// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Any bytes as a binary result file; what can be read is judged. A check sum is put right, so that
// whole files are met.

#include <string>

#include "base/bytes.h"
#include "base/hash.h"
#include "fuzz/judged.h"
#include "support/yard.h"
#include "vandplan/files.h"

using namespace vandplan;

namespace {

std::string sealed(std::string bytes) {
  constexpr std::size_t size = sizeof(std::uint64_t);
  if (bytes.size() < size) return bytes;
  bytes.resize(bytes.size() - size);
  base::append(bytes, base::hash_of(bytes));
  return bytes;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const ScenarioFile yard = scenario_from_yaml(vandplan::yard(), "yard.yaml");
  static const Problem problem = make_problem(yard.scenario);
  const std::string bytes = sealed(fuzz::text_of(data, size));
  fuzz::may_refuse([&] {
    ResultReader reader(fuzz::folder().put("result.vpr", bytes), yard);
    if (!reader.has_pairs()) {
      for (const ResultRecord& record : reader.all()) fuzz::look_at(problem, record);
      return;
    }
    while (const std::optional<PairRecord> pair = reader.next()) {
      fuzz::look_at(with_poses(problem, pair->poses.start, pair->poses.goal), pair->record);
    }
  });
  return 0;
}
