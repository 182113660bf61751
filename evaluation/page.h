// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is the report's page made of? The files of page/ and Debian's D3, put in by the build.

#include <string_view>

namespace vandplan::page {

extern const std::string_view html;
extern const std::string_view css;
extern const std::string_view js;
extern const std::string_view d3;
extern const std::string_view d3_licence;

}  // namespace vandplan::page
