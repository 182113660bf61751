// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do the files of a study become pictures?

#include <string>

#include "studies/study_files.h"

namespace vandplan::app {

using namespace studies;

/// Throws InputError unless every file of a study can be written to the folder, which is made if
/// it is not there.
void expect_writable_folder(const std::string& folder, const StudyFiles& files);

/// Writes data, script and, if gnuplot is installed, pictures. False without gnuplot.
/// Throws std::runtime_error with what gnuplot says if it fails.
[[nodiscard]] bool write_study(const std::string& folder, const StudyFiles& files);

}  // namespace vandplan::app
