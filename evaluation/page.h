// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// Which files make the report's page? Those of page/, and Debian's D3; the build embeds them.

#include <string_view>

namespace vandplan::page {

extern const std::string_view html;
extern const std::string_view css;
extern const std::string_view d3;
extern const std::string_view d3_licence;

// Parts of the JavaScript program, in order.
extern const std::string_view js_data;
extern const std::string_view js_methods;
extern const std::string_view js_tables;
extern const std::string_view js_overview;
extern const std::string_view js_searches;
extern const std::string_view js_scenario;
extern const std::string_view js_charts;
extern const std::string_view js_motion;
extern const std::string_view js_pictures;
extern const std::string_view js_runs;
extern const std::string_view js_frame;
extern const std::string_view js_page;

}  // namespace vandplan::page
