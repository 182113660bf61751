// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is wrong with a command line, and what was meant?

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace vandplan::app {

/// One line about an error of parsing `arguments`, which do not include the name of the program.
[[nodiscard]] std::string usage_problem(const CLI::App& app, const CLI::ParseError& error,
                                        const std::vector<std::string>& arguments);

}  // namespace vandplan::app
