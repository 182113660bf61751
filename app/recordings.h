// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which file does --record write?

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace vandplan::app {

/// Adds --record to a command. `about` says what is recorded.
void add_record(CLI::App& command, std::optional<std::string>& file, const std::string& about);

/// Throws InputError if a recording cannot be written to the file: the ending is that of another
/// kind of file, the file cannot be written, or it is "-", where the summary goes.
void expect_recording(const std::string& file);

}  // namespace vandplan::app
