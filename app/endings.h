// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Does the name of a file promise what is written into it?

#include <string>
#include <string_view>
#include <vector>

namespace vandplan::app {

/// A kind of file that is written, and the endings that names of such files have.
struct FileKind {
  std::string_view name;  ///< clause for errors, such as "a scenario is YAML"
  std::vector<std::string_view> endings;
};

inline const FileKind result_file = {"a result is JSON, binary or GeoJSON",
                                     {".json", ".vpr", ".geojson"}};
inline const FileKind result_lines_file = {"results of --poses are JSON Lines or binary",
                                           {".jsonl", ".vpr", ".ndjson", ".json"}};
inline const FileKind scenario_file = {"a scenario is YAML", {".yaml", ".yml"}};

/// Whether the name of a file has one of the endings of that kind.
[[nodiscard]] bool has_ending(const std::string& file, const FileKind& kind);

/// Throws InputError when the ending of a file's name stands for another kind of file, such as
/// ".csv" for a result. Unknown endings, and names without an ending, are accepted.
void expect_ending(const std::string& file, const FileKind& kind);

}  // namespace vandplan::app
