// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which table does a word on the command line mean, and what does it hold?

#include <CLI/CLI.hpp>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "vandplan/tables.h"

namespace vandplan::app {

inline constexpr const char* bounds_name = "bounds";

/// Number of the thesis' table with that name: 1 to 4 for "hlut-1" to "hlut-4", otherwise none.
[[nodiscard]] std::optional<int> thesis_number(const std::string& name);

/// A table of the library or of a file, whose size and checksum were checked.
struct TableSource {
  std::string name;
  std::string bytes;
  TableFileHead head;
};

/// The table of that name: a table of the library if it has the name, otherwise a file.
[[nodiscard]] TableSource table_source(const std::string& name);

/// Adds --table to a command. `table` outlives the command.
void add_table_flag(CLI::App& command, std::optional<std::string>& table);

/// The table of lengths that --table names; null without --table. Throws InputError when the file
/// holds no table of lengths.
[[nodiscard]] std::shared_ptr<const HeuristicTable> table_of_user(
    const std::optional<std::string>& table);

/// Step of the headings of a table as text, such as "pi/12".
[[nodiscard]] std::string heading_step_text(const HeuristicTableOptions& options);

[[nodiscard]] std::string checksum_text(const TableFileHead& head);

/// Content of a table, as text for people and as JSON for programs.
[[nodiscard]] std::string text_of(const TableFileHead& head);
[[nodiscard]] nlohmann::ordered_json json_of(const TableFileHead& head);

}  // namespace vandplan::app
