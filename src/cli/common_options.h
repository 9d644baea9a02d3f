// SPDX-License-Identifier: MIT
// Which options do several commands share? The file, seed and threads, and where results go.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "moivre/polynomial/system.h"
#include "moivre/start/choose_start.h"

namespace moivre {

void add_file(CLI::App& command, std::string& file);
void add_mechanism_file(CLI::App& command, std::string& file);
/// A mechanism, or a polynomial system.
void add_any_file(CLI::App& command, std::string& file);

struct StartChoice {
  std::string kind = "auto";
  std::uint64_t seed = 1;
};
/// Throws ParseError, and std::invalid_argument also for a mechanism file, with the commands that
/// take one.
System read_polynomial_file(const std::string& file);

void add_start_options(CLI::App& command, StartChoice& choice);
/// Throws std::invalid_argument when there is no such start system.
void require_known(const StartChoice& choice);
/// Of a known choice.
StartKind kind_of(const StartChoice& choice);

void add_json_option(CLI::App& command, std::string& path);
/// "--threads" of a command that solves.
void add_threads_option(CLI::App& command, int& threads);
/// "--at" of a mechanism.
void add_time_option(CLI::App& command, double& at);
void add_quiet_flag(CLI::App& command, bool& quiet);

/// A sentence when the text is an integer below 0 or beyond 64 bits, which CLI11 would wrap around
/// or cut; else empty.
std::string not_64_bits(const std::string& number);

/// "--time-limit" of a command that may run long.
void add_time_limit_option(CLI::App& command, std::optional<double>& seconds);

/// Runs every check. What they refuse by std::invalid_argument is thrown as one, a line each.
void require_all(const std::vector<std::function<void()>>& checks);

/// Throws std::invalid_argument when no run can have so many.
void require_threads(int threads);

/// Examples at the end of a command's --help.
void add_examples(CLI::App& command, const std::vector<std::string>& examples);

}  // namespace moivre
