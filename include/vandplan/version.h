// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which version and build am I running?

#include <string>
#include <string_view>

namespace vandplan {

/// Version of the library and how it was compiled.
struct BuildInfo {
  std::string_view version;     ///< version of the library, such as "0.1.0"
  std::string_view compiler;    ///< name and version of the compiler, such as "GNU 12.2.0"
  std::string_view build_type;  ///< build type of CMake, such as "Release"
};

/// Version and build of the library that is linked.
[[nodiscard]] BuildInfo build_info() noexcept;

}  // namespace vandplan
