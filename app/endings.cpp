// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "endings.h"

#include <algorithm>
#include <cctype>
#include <filesystem>

#include "vandplan/input_error.h"

namespace vandplan::app {
namespace {

/// Endings that promise a format.
constexpr std::string_view known_endings[] = {
    ".bmp",   ".csv",    ".db",     ".gif",  ".html", ".jpeg", ".jpg", ".json",
    ".jsonl", ".md",     ".ndjson", ".pdf",  ".pgm",  ".png",  ".svg", ".toml",
    ".tsv",   ".sqlite", ".xls",    ".xlsx", ".xml",  ".yaml", ".yml"};

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

}  // namespace

void expect_ending(const std::string& file, const FileKind& kind) {
  const std::string ending = std::filesystem::path(file).extension().string();
  const auto has = [&](const auto& endings) {
    return std::ranges::find(endings, lower(ending)) != std::ranges::end(endings);
  };
  if (!has(known_endings) || has(kind.endings)) return;
  throw InputError(file, "ends in " + ending + ", but " + std::string(kind.name) +
                             ", expected a name that ends in " + std::string(kind.endings.front()));
}

}  // namespace vandplan::app
