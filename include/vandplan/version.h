// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which version and build am I running?

#include <string>
#include <string_view>

namespace vandplan {

/// Which version of the library runs, and how it was compiled.
struct BuildInfo {
  std::string_view version;     ///< such as "0.1.0"
  std::string_view compiler;    ///< such as "GNU 12.2.0"
  std::string_view build_type;  ///< of CMake, such as "Release"
};

/// Version and build of the library that is linked.
[[nodiscard]] BuildInfo build_info() noexcept;

}  // namespace vandplan
