// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include "version_text.h"

#include <string_view>

#include "commit.h"
#include "vandplan/version.h"

namespace vandplan::app {

std::string version_text() {
  constexpr std::string_view commit = VANDPLAN_COMMIT;
  std::string text = "vandplan " + std::string(build_info().version);
  if (!commit.empty()) text += " (" + std::string(commit) + ")";
  return text;
}

}  // namespace vandplan::app
