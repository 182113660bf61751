// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How does a drive become a file?

#include <string>
#include <vector>

#include "endings.h"
#include "vandplan/motion.h"

namespace vandplan::app {

inline const FileKind motions_file = {"a drive is CSV, or YAML for a nav_msgs/Path",
                                      {".csv", ".yaml", ".yml"}};

/// Writes the motions of a drive to a file, whole or not at all. The file is a table with a row per
/// motion (CSV). If its name ends in .yaml or .yml, it is a nav_msgs/Path with a pose per motion
/// and the frame_id `frame`.
void write_motions(const std::string& output, const std::vector<Motion>& motions,
                   const std::string& frame);

}  // namespace vandplan::app
