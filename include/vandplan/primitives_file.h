// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do the primitives of other programs become ours?
//
// Their files hold sampled poses. Exact segments that pass by those poses are read from them:
// docs/algorithms/lattice.md, "Files of others".

#include <memory>
#include <string>

#include "vandplan/primitives.h"

namespace vandplan {

/// Reads the primitives of Nav2 (".json", of its lattice_primitives) or of SBPL (".mprim"). Those
/// of Nav2 are taken in reverse as well. Throws InputError "file:line: what is wrong, what was
/// expected".
[[nodiscard]] std::shared_ptr<const search::Primitives> read_primitives(const std::string& file);

}  // namespace vandplan
