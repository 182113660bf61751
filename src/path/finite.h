// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Are all numbers of a path finite?

#include "vandplan/path.h"

namespace vandplan::path {

/// Throws InputError that names the first segment with a number that is not finite, or that ends
/// with a curvature that is not.
void check_finite(const Path& path);

}  // namespace vandplan::path
