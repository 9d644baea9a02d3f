// SPDX-License-Identifier: MIT
// How does a trusted integrator follow a path? SUNDIALS CVODE on J x' = [-H_t dt/ds; 0], with a Newton projection.
//
//   y: real state of 2N (real and imaginary parts in turn), s: contour parameter, as independent variable
//   method bdf_projection: variable-order BDF, and after every step CVODE's projection call puts y
//     back on H(y, t(s)) = 0 by Newton's method; a step from which Newton does not contract is taken again, shorter
//   method bdf, adams: the integrator alone (Newton only at the end), to compare. CVODE refuses a projection with Adams
//     ("CVodeSetProjFn: projection is only supported with BDF"), so there is no adams_projection.
//   iteration fixed_point: the implicit formula of each step is solved by substitution, two right-hand sides or so
//   iteration newton: by modified Newton, d x'/d x dense and by difference quotients: 2N right-hand sides, each with a
//     factorization, whenever CVODE renews it. For paths that are stiff, where substitution does not contract.
//
// The loose default tolerance is enough because Newton corrects every step: docs/decisions has the measurements.
// Weights are relative per complex coordinate, with the floor of tracker/path_system.h.
// Edges: no SUNDIALS type leaves the module; one CVODE memory per session. Not supported: sparse or iterative linear solvers.
// Source: [SUNDIALS], [EichCvodeProjection93] for integrating with coordinate projection.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "moivre/tracker/tracker.h"

namespace moivre {

enum class CvodeMethod { bdf_projection, bdf, adams };
std::string to_string(CvodeMethod method);

/// How the implicit formula of one step is solved.
enum class CvodeIteration { fixed_point, newton };
std::string to_string(CvodeIteration iteration);

struct CvodeOptions {
  CvodeMethod method = CvodeMethod::bdf_projection;
  CvodeIteration iteration = CvodeIteration::fixed_point;
  double rtol = 1e-2;                  ///< relative local error per step, in (0, 0.5]
  std::int64_t maximum_steps = 20000;  ///< accepted and rejected steps of one segment
};

/// Every broken rule as a sentence; empty when the options can be used.
std::vector<std::string> validate(const CvodeOptions& options);

/// Throws std::invalid_argument with all sentences of validate().
std::unique_ptr<Tracker> make_cvode_tracker(const CvodeOptions& options = {});

}  // namespace moivre
