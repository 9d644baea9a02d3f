// SPDX-License-Identifier: MIT
// Which results are judged in these tests? Those of tests/check/results, each beside its system.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "moivre/check/check.h"

namespace moivre::test {

using Json = nlohmann::json;

/// The system of results/`name`.phc.
System system_of_result(const std::string& name);
/// The text of results/`file`.
std::string result_text(const std::string& file);
/// The result of results/`name`.json.
Json honest(const std::string& name);

/// `result`, a JSON or a list as text, judged by the system of that name.
Judgement judged(const std::string& system, const std::string& result);
Judgement judged(const std::string& system, const Json& result);

/// Every finding as a line "root 3, accuracy: ...".
std::string lines(const std::vector<Finding>& findings);
bool refutes(const Judgement& judgement, ClaimKind claim, std::size_t root = 0);

}  // namespace moivre::test
