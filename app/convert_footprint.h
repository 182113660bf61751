// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// vandplan convert footprint: how does the footprint of a robot become a vehicle?

#include <CLI/CLI.hpp>

namespace vandplan::app {

/// Adds the format to the command `convert`.
void add_footprint(CLI::App& convert);

}  // namespace vandplan::app
