// SPDX-License-Identifier: MIT
// What must hold for any bytes that the mechanism reader is given?
// A mechanism whose Phi can be evaluated, or a ParseError with faults in the text.
//
// Shared by the fuzz target and by the test that replays its corpus.
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include "moivre/mechanism/phi.h"
#include "moivre/mechanism/read.h"

namespace moivre {

/// The dense Jacobian of a larger mechanism would slow the search for faults and find none more.
inline constexpr Eigen::Index kMaximumCoordinates = 60;

/// The law that a mechanism breaks, if any. Values may be NaN (a root of a negative number), sizes
/// may not differ.
inline std::optional<std::string> broken_phi_law(const Mechanism& mechanism) {
  const Phi phi(mechanism);
  if (phi.dimension() > kMaximumCoordinates) return std::nullopt;
  const Eigen::VectorXd q = initial_guess(mechanism);
  if (q.size() != phi.dimension()) return "a guess of another size than q";
  if (phi.value(q, 0).size() != phi.size()) return "another number of rows than names";
  const Eigen::MatrixXd J = phi.jacobian(q, 0.5);
  if (J.rows() != phi.size() || J.cols() != phi.dimension()) return "a Jacobian of another size";
  if (phi.acceleration_rhs(q, q, 0.5).size() != phi.size()) return "a gamma of another size";
  if ((phi.term_magnitudes(q, 0).array() < 0).any()) return "a negative sum of magnitudes";
  return std::nullopt;
}

/// The law that the bytes break, if any.
inline std::optional<std::string> broken_mechanism_law(const std::string& bytes) {
  const Source source{"fuzz", bytes};
  try {
    return broken_phi_law(read_mechanism(source));
  } catch (const ParseError& error) {
    if (error.diagnostics().empty()) return "a ParseError without a fault";
    for (const Diagnostic& fault : error.diagnostics()) {
      if (fault.at.offset > bytes.size() || fault.message.empty())
        return "a fault outside the text";
      if (after({}, std::string_view(bytes).substr(0, fault.at.offset)) != fault.at) {
        return "a fault whose line and column are not those of its offset: " + fault.message;
      }
    }
  }
  return std::nullopt;
}

}  // namespace moivre
