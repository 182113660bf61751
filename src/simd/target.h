// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which vector instructions do the kernels use on this machine?

#include <string_view>

namespace vandplan::simd {

/// Name of the vector instructions, such as "AVX2"; "scalar" in a build without vector kernels.
[[nodiscard]] std::string_view simd_target() noexcept;

}  // namespace vandplan::simd
