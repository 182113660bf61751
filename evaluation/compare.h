// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Which files does a comparison write into its folder?

#include <string>

#include "evaluation/report.h"
#include "evaluation/store.h"

namespace vandplan::evaluation {

/// Path of the store's file in a folder.
[[nodiscard]] std::string store_file(const std::string& folder);

/// Makes a folder if it does not exist. Throws InputError if that fails.
void make_folder(const std::string& folder);

/// Opens the store in a folder. Makes folder and store if they do not exist. Throws InputError if
/// that fails.
[[nodiscard]] Store store_in(const std::string& folder);

/// Writes page, text and gallery of a report into a folder. Returns their paths and the headline.
[[nodiscard]] Comparison write_report(const Report& report, const std::string& folder);

}  // namespace vandplan::evaluation
