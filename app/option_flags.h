// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which options of planners can be typed, and what is made of them?
//
// Flags and keys are collected first and given to the planner once it is known: whether an option
// is honoured, and what it may be, depends on it.

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
  std::string typed;   ///< how errors call it: "--max-nodes", or the key of --set
  std::string option;  ///< its name
  std::string value;
};

/// Adds --time, --max-iterations, --max-nodes, --seed, --threads, --region and --set to a command.
/// What is typed is added to `typed`, in that order, which has to live as long as the command.
void add_option_flags(CLI::App& command, std::vector<TypedOption>& typed);

/// Adds --seed to a command. A minus is refused, which CLI11 would turn into a large number.
CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed, const std::string& about);

/// "KEY=VALUE" as it stands behind --set. Throws InputError for anything else.
[[nodiscard]] TypedOption typed_setting(const std::string& setting);

/// What a file wants as far as the planner honours it, and above that what was typed. Throws
/// InputError naming what was typed when the planner does not honour it or the value is no good.
[[nodiscard]] PlanOptions options_for(const Planner& planner,
                                      std::span<const Setting> wanted_by_file,
                                      const std::vector<TypedOption>& typed);

/// Sets what was typed above the options that there are. Throws as `options_for`.
void set_typed(PlanOptions& options, const Planner& planner, const std::vector<TypedOption>& typed);

/// A line for each option that all planners have.
[[nodiscard]] std::string help_on_common_options();

/// A line for each of the planner's own options.
[[nodiscard]] std::string help_on_options_of(const Planner& planner);

/// Lines for the own options of all planners, family by family.
[[nodiscard]] std::string help_on_own_options();

/// The part of the work that "2/8" means. Throws InputError for what is not I/N with I from 1 to N.
[[nodiscard]] evaluation::Shard shard_in(const std::string& text);

}  // namespace vandplan::app
