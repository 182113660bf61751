// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What do the nodes of a result mean, if vandplan or another program wrote it? (docs/formats.md)

#include <vector>

#include "io/document.h"
#include "io/result_lists.h"
#include "vandplan/result_file.h"

namespace vandplan::io {

/// The result of a file, or one for each goal of a row. `lists` must hold the long lists. Throws
/// InputError naming the wrong node, as all functions here do.
[[nodiscard]] std::vector<ResultRecord> records_from(const Document& file,
                                                     const ScenarioFile& scenario,
                                                     ListTaker& lists);

/// One result of a file with many. `radius`: turning radius of the words left and right [m].
[[nodiscard]] PairRecord pair_record_from(const Document& file, double radius, ListTaker& lists);

/// The record that the keys shared by all results describe: the run, and the rules of its paths as
/// claims. The stated cost is still 0.
[[nodiscard]] ResultRecord pattern_from(const Document& head);

}  // namespace vandplan::io
