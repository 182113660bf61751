// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "vandplan/version.h"

namespace vandplan {

BuildInfo build_info() noexcept {
  return {VANDPLAN_VERSION, VANDPLAN_COMPILER, VANDPLAN_BUILD_TYPE};
}

}  // namespace vandplan
