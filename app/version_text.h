// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which version and commit is this program?

#include <string>

namespace vandplan::app {

/// Version of the program, such as "vandplan 0.2.0 (1a2b3c4d5e)". The commit is missing if it is
/// not known, and has "+changes" if the tree had uncommitted changes.
[[nodiscard]] std::string version_text();

}  // namespace vandplan::app
