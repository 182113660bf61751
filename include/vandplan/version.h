// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which version and build am I running?

#include <string>
#include <string_view>

namespace vandplan {

struct BuildInfo {
  std::string_view version;     ///< "0.1.0"
  std::string_view compiler;    ///< "GNU 12.2.0"
  std::string_view build_type;  ///< "Release"
};

[[nodiscard]] BuildInfo build_info() noexcept;

}  // namespace vandplan
