// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
// How is the table of a site read?

#include <memory>
#include <string>

#include "io/input_file.h"
#include "vandplan/files.h"
#include "vandplan/site_table.h"

namespace vandplan {

SiteTable read_site_table(const std::string& file) {
  io::InputFile input(file);
  if (const auto mapped = input.mapped()) {
    input.expect_at_most(mapped->bytes.size(), largest_site_table);
    return site_table_from_bytes(mapped->bytes, mapped->owner, input.name());
  }
  auto bytes = std::make_shared<std::string>();
  while (input.append_to(*bytes, largest_site_table)) {
  }
  return site_table_from_bytes(*bytes, bytes, input.name());
}

}  // namespace vandplan
