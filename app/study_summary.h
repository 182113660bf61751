// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026, the Vändplan authors
#pragma once
// What is the result of a study, as text for people and as JSON for programs?

#include <nlohmann/json.hpp>
#include <string>

#include "studies/accuracy.h"
#include "studies/growth.h"
#include "studies/range.h"
#include "studies/searches.h"
#include "studies/sites.h"
#include "studies/steering.h"
#include "studies/symmetry.h"

namespace vandplan::app {

using namespace studies;

[[nodiscard]] std::string summary_of(const RangeStudy& study);
[[nodiscard]] std::string summary_of(const AccuracyStudy& study);
[[nodiscard]] std::string summary_of(const GrowthStudy& study);
[[nodiscard]] std::string summary_of(const SymmetryStudy& study);
[[nodiscard]] std::string summary_of(const SteeringStudy& study);
[[nodiscard]] std::string summary_of(const SearchesStudy& study);
[[nodiscard]] std::string summary_of(const SitesStudy& study);

[[nodiscard]] nlohmann::ordered_json json_of(const RangeStudy& study);
[[nodiscard]] nlohmann::ordered_json json_of(const AccuracyStudy& study);
[[nodiscard]] nlohmann::ordered_json json_of(const GrowthStudy& study);
[[nodiscard]] nlohmann::ordered_json json_of(const SymmetryStudy& study);
[[nodiscard]] nlohmann::ordered_json json_of(const SteeringStudy& study);
[[nodiscard]] nlohmann::ordered_json json_of(const SearchesStudy& study);
[[nodiscard]] nlohmann::ordered_json json_of(const SitesStudy& study);

}  // namespace vandplan::app
