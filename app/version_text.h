// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which version and commit is this program?

#include <string>

namespace vandplan::app {

/// "vandplan 0.2.0 (1a2b3c4d5e)": the version, and the commit that was built if it is known, with
/// "+changes" if the tree had some.
[[nodiscard]] std::string version_text();

}  // namespace vandplan::app
