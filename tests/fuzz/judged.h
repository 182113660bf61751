// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What does the judge say of a result that was read, whatever its format?

#include "fuzz/fuzz.h"
#include "vandplan/judge.h"
#include "vandplan/result_file.h"

namespace vandplan::fuzz {

/// Judges the path of a result, if it has one that is short enough to be walked at once.
inline void look_at(const Problem& problem, const ResultRecord& record) {
  constexpr double longest = 1000;  // [m]
  if (!record.result.path || !(length(*record.result.path) < longest)) return;
  const PathCheck check = check_path(problem, *record.result.path, record.claims);
  expect(check.valid == check.reason.empty(), "a verdict has a reason, or needs none");
}

}  // namespace vandplan::fuzz
