// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do the primitives of other programs become ours?
//
// Their files hold sampled poses; what is read are exact segments that pass by those.
// docs/algorithms/lattice.md, "Files of others".

#include <memory>
#include <string>

#include "vandplan/primitives.h"

namespace vandplan {

/// Reads the primitives of Nav2 (a file that ends in ".json", of its lattice_primitives) or of SBPL
/// (".mprim"). Nav2's are taken in reverse as well. Throws InputError "file:line: what is wrong,
/// what was expected".
[[nodiscard]] std::shared_ptr<const search::Primitives> read_primitives(const std::string& file);

}  // namespace vandplan
