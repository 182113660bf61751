// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which options of planners can be typed, and how are they applied?
//
// Flags and keys are collected first, and applied once the planner is known: it decides which
// options are honoured and which values are allowed.

#include <CLI/CLI.hpp>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "vandplan/evaluation.h"
#include "vandplan/planner.h"

namespace vandplan::app {

/// An option of a planner that somebody typed.
struct TypedOption {
  std::string typed;   ///< name in errors: "--max-nodes", or the key of --set
  std::string option;  ///< name of the option
  std::string value;   ///< value as it was typed
};

/// Adds --time, --max-iterations, --max-nodes, --seed, --threads, --region and --set to a command.
/// Typed options are appended to `typed`, in their order. `typed` outlives the command.
void add_option_flags(CLI::App& command, std::vector<TypedOption>& typed);

/// Adds --seed to a command. Negative numbers are refused: CLI11 would turn them into large ones.
CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed, const std::string& about);

/// The option of a text "KEY=VALUE" behind --set. Throws InputError for any other text.
[[nodiscard]] TypedOption typed_setting(const std::string& setting);

/// Options of a file that the planner honours, overridden by typed options. Throws InputError
/// naming a typed option that the planner does not honour, or whose value is wrong.
[[nodiscard]] PlanOptions options_for(const Planner& planner,
                                      std::span<const Setting> wanted_by_file,
                                      const std::vector<TypedOption>& typed);

/// Overrides options by typed options. Throws as `options_for`.
void set_typed(PlanOptions& options, const Planner& planner, const std::vector<TypedOption>& typed);

/// Help: a line for each option of the table that all planners share.
[[nodiscard]] std::string help_on_common_options();

/// Help: a line for each of the planner's own options.
[[nodiscard]] std::string help_on_options_of(const Planner& planner);

/// Help: the own options of all planners, those of several families first, each once.
[[nodiscard]] std::string help_on_own_options();

/// The shard of a text such as "2/8". Throws InputError unless the text is I/N with I from 1 to N.
[[nodiscard]] evaluation::Shard shard_in(const std::string& text);

}  // namespace vandplan::app
