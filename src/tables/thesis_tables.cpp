// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#include <cassert>
#include <span>

#include "hlut_1.h"
#include "hlut_2.h"
#include "hlut_3.h"
#include "hlut_4.h"
#include "vandplan/tables.h"

namespace vandplan {

HeuristicTable thesis_table(int number) {
  const HeuristicTableOptions options = thesis_table_options(number);
  switch (number) {
    case 1:
      return {options, std::span<const float>(hlut_1::entries)};
    case 2:
      return {options, std::span<const float>(hlut_2::entries)};
    case 3:
      return {options, std::span<const float>(hlut_3::entries)};
    default:
      return {options, std::span<const float>(hlut_4::entries)};
  }
}

}  // namespace vandplan
