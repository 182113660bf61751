// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// Tables of the thesis in a small build. Each is computed at its first use; its entries equal those
// of the stored tables.
#include "vandplan/tables.h"

namespace vandplan {

HeuristicTable thesis_table(int number) {
  switch (number) {
    case 1: {
      static const HeuristicTable table(thesis_table_options(1));
      return table;
    }
    case 2: {
      static const HeuristicTable table(thesis_table_options(2));
      return table;
    }
    case 3: {
      static const HeuristicTable table(thesis_table_options(3));
      return table;
    }
    default: {
      static const HeuristicTable table(thesis_table_options(4));
      return table;
    }
  }
}

}  // namespace vandplan
