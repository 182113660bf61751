// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the nodes of a result mean, ours or somebody else's? (docs/formats.md)

#include <vector>

#include "io/document.h"
#include "io/result_lists.h"
#include "vandplan/result_file.h"

namespace vandplan::io {

/// The result of a file that holds one, or one for each goal of a row. `lists` has taken its long
/// lists. Throws InputError naming the node that is wrong; so do the others.
[[nodiscard]] std::vector<ResultRecord> records_from(const Document& file,
                                                     const ScenarioFile& scenario,
                                                     ListTaker& lists);

/// One result of many. `radius` is that of the words left and right [m].
[[nodiscard]] PairRecord pair_record_from(const Document& file, double radius, ListTaker& lists);

/// What results have in common whose shared keys these are: which run it was, and what paths are
/// held to, as claims. The cost of the claims waits for that of a result.
[[nodiscard]] ResultRecord pattern_from(const Document& head);

}  // namespace vandplan::io
