// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a result become a picture file?

#include <string>
#include <vector>

#include "vandplan/io.h"

namespace vandplan {

/// Throws InputError if a picture can surely not be written to this file.
void expect_picture(const std::string& file);

/// Draws what was planned, a row of goals as a sheet of pictures; without records the scene alone.
void write_picture(const std::string& file, const Scenario& scenario,
                   const std::vector<ResultRecord>& records);

}  // namespace vandplan
