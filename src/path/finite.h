// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are all numbers of a path finite?

#include "vandplan/path.h"

namespace vandplan::path {

/// Throws an InputError that names the first segment with a number, or with a curvature at its end,
/// that is not finite.
void check_finite(const Path& path);

}  // namespace vandplan::path
