// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "endings.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "vandplan/input_error.h"

namespace vandplan::app {
namespace {

/// Endings that stand for a known format.
constexpr std::string_view known_endings[] = {
    ".bmp",   ".csv",    ".db",  ".geojson", ".gif",  ".html", ".jpeg", ".jpg", ".json",
    ".jsonl", ".mcap",   ".md",  ".ndjson",  ".pdf",  ".pgm",  ".png",  ".svg", ".toml",
    ".tsv",   ".sqlite", ".vpr", ".xls",     ".xlsx", ".xml",  ".yaml", ".yml"};

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string ending_of(const std::string& file) {
  return std::filesystem::path(file).extension().string();
}

}  // namespace

bool has_ending(const std::string& file, const FileKind& kind) {
  return std::ranges::find(kind.endings, lower(ending_of(file))) != kind.endings.end();
}

void expect_ending(const std::string& file, const FileKind& kind) {
  const std::string ending = ending_of(file);
  const bool is_known = std::ranges::find(known_endings, lower(ending)) != std::end(known_endings);
  if (!is_known || has_ending(file, kind)) return;
  throw InputError(file, "ends in " + ending + ", but " + std::string(kind.name) +
                             ", expected a name that ends in " + std::string(kind.endings.front()));
}

}  // namespace vandplan::app
