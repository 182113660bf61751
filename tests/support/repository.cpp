// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "support/shared_files.h"

namespace vandplan {

std::filesystem::path repository() { return VANDPLAN_REPOSITORY; }

}  // namespace vandplan
