// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// (internal) Which files does a comparison leave in its folder?

#include <string>

#include "evaluation/report.h"
#include "evaluation/store.h"

namespace vandplan::evaluation {

/// The file of the store in a folder.
[[nodiscard]] std::string store_file(const std::string& folder);

/// Throws InputError if there cannot be a folder of that name.
void make_folder(const std::string& folder);

/// The store in a folder; both are made if they are not there. Throws InputError if that fails.
[[nodiscard]] Store store_in(const std::string& folder);

/// Writes the reports into a folder.
[[nodiscard]] Comparison write_report(const Report& report, const std::string& folder);

}  // namespace vandplan::evaluation
