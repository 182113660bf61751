// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which table does a word on the command line mean, and what does it hold?

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "vandplan/table_file.h"

namespace vandplan::app {

inline constexpr const char* bounds_name = "bounds";

/// 1 to 4 for "hlut-1" to "hlut-4".
[[nodiscard]] std::optional<int> thesis_number(const std::string& name);

/// A table of the library or of a file, whole and with a checksum that fits.
struct TableSource {
  std::string name;
  std::string bytes;
  TableFileHead head;
};

/// By the name of a table of the library, else by a file.
[[nodiscard]] TableSource table_source(const std::string& name);

/// Adds --table to a command; what is typed lives as long as the command.
void add_table_flag(CLI::App& command, std::optional<std::string>& table);

/// The table of lengths behind --table, by its name or file; null if there is none. Throws
/// InputError when a file holds no such table.
[[nodiscard]] std::shared_ptr<const HeuristicTable> table_of_user(
    const std::optional<std::string>& table);

/// "pi/12".
[[nodiscard]] std::string heading_step_text(const HeuristicTableOptions& options);

[[nodiscard]] std::string checksum_text(const TableFileHead& head);

/// What a table holds, for people and for programs.
[[nodiscard]] std::string text_of(const TableFileHead& head);
[[nodiscard]] nlohmann::ordered_json json_of(const TableFileHead& head);

}  // namespace vandplan::app
