// SPDX-License-Identifier: MIT
// How are a Newton run, a mobility and a list of guesses reported? As text for people, as JSON and
// CSV for programs.
//
// JSON: docs/json.md. CSV of newton: one row per iterate; CSV of guesses: one row per guess. Angles
// in radians, lengths in the file's unit, but for the text, which has angles in the file's unit.
#pragma once

#include <string>

#include "moivre/closure_report/angles.h"
#include "moivre/closures/guesses.h"
#include "moivre/closures/mobility_kinds.h"
#include "moivre/kinematics/mobility.h"
#include "moivre/kinematics/newton.h"

namespace moivre {

/// What the reports say beside the results.
struct KinematicsHeading {
  std::string file;
  double time = 0;  ///< of the drivers
  std::vector<MobilityKind>
      kinds;  ///< of the closures, where there was no guess; the generic one first
};

std::string newton_text(const NewtonResult& result, const Mechanism& mechanism,
                        const KinematicsHeading& heading);
std::string newton_json(const NewtonResult& result, const Mechanism& mechanism,
                        const KinematicsHeading& heading);
std::string newton_csv(const NewtonResult& result, const Mechanism& mechanism,
                       const AngleForm& form = {});

/// Whether the pose that the run led to is an assembled one, or one within Mechanism::fit.
bool is_taken(const Mobility& mobility, const NewtonResult& pose);

/// `pose`: the Newton run that led to the pose.
std::string mobility_text(const Mobility& mobility, const NewtonResult& pose,
                          const Mechanism& mechanism, const KinematicsHeading& heading);
std::string mobility_json(const Mobility& mobility, const NewtonResult& pose,
                          const Mechanism& mechanism, const KinematicsHeading& heading);

/// Whether these are all, and what the solve said of it.
struct Completeness {
  bool complete = false;
  std::string message;
};

/// As [guess] blocks of a mechanism file, angles in the file's unit.
std::string guesses_text(const InitialGuesses& guesses, const Completeness& completeness,
                         const Mechanism& mechanism, const KinematicsHeading& heading);
/// `complete`: of the solve; whether every path was decided.
std::string guesses_json(const InitialGuesses& guesses, const Completeness& completeness,
                         const KinematicsHeading& heading);
std::string guesses_csv(const InitialGuesses& guesses, const Mechanism& mechanism,
                        const AngleForm& form = {});

}  // namespace moivre
