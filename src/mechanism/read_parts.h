// SPDX-License-Identifier: MIT
// Which reader fills which part of a Mechanism? One function a section of the file; all note faults
// in the Reading.
#pragma once

#include "moivre/mechanism/mechanism.h"
#include "toml_reading.h"

namespace moivre {

/// Throws ParseError where the text is no TOML.
toml::table parse_toml(const Reading& reading);
/// Throws ParseError with all faults, if there are any.
void throw_faults(Reading& reading);

/// What one unit of an angle in the file is in radians.
double angle_unit(const Mechanism& mechanism);

/// `tolerance` in this table: a number from 0; nothing where there is none, or a fault.
std::optional<double> read_tolerance(Reading& reading, const toml::table& in);

/// [ground.points], [body.NAME.points], and their tolerances
void read_bodies(Reading& reading, const toml::table& document, Mechanism& mechanism);
/// [[joint]]
void read_joints(Reading& reading, const toml::table& document, Mechanism& mechanism);
/// [unknowns], [constants], [equations]
void read_equations(Reading& reading, const toml::table& document, Mechanism& mechanism);
/// [[driver]]
void read_drivers(Reading& reading, const toml::table& document, Mechanism& mechanism);
/// [guess]
void read_guess(Reading& reading, const toml::table& document, Mechanism& mechanism);

/// Faults that no single entry shows: bodies that nothing holds, cycles of welds, links of no
/// length, too many drivers.
void check_structure(Reading& reading, Mechanism& mechanism);
/// A warning where one body has a shared point elsewhere than the others, in a file typed from one
/// drawing.
void warn_of_mistyped_point(Mechanism& mechanism);

/// The body's number; nothing and a fault at `at` where there is none of that name.
std::optional<std::size_t> find_body(Reading& reading, const Mechanism& mechanism,
                                     const std::string& name, const SourcePosition& at);
/// "body.point"
std::optional<PointOf> find_point(Reading& reading, const Mechanism& mechanism,
                                  const std::string& name, const SourcePosition& at);
std::vector<std::string> body_names(const Mechanism& mechanism);

}  // namespace moivre
