// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// How do replanners in Python share a table that changes?

#include "bindings/python/core/alone.h"
#include "vandplan/site_table.h"

namespace vandplan::python {

/// Table of a site that one thread at a time may repair.
struct SharedSiteTable {
  ChangingSiteTable table;
  Alone alone = Alone("ChangingSiteTable");
};

}  // namespace vandplan::python
